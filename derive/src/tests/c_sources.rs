//! The models of the repository in C, compiled by the system's `cc` without warnings.

use std::path::Path;
use std::process::Command;
use std::{env, fs};

use proc_macro2::TokenStream;
use quote::{ToTokens as _, quote};
use syn::{Expr, ImplItem, Item, ItemStruct, Lit};

use super::operations::{FOLDERS, declarations};
use crate::expand::expand_within;
use crate::limits::MethodLimits;

const LIMITS: MethodLimits = MethodLimits::OF_EXPANSIONS;

/// As if there were many coordinates: with matrices column by column.
const BY_COLUMNS: MethodLimits = MethodLimits {
    costliest_mass_matrix: 0,
    costliest_derivatives: 0,
    ..LIMITS
};

/// The sources, headers and external functions in an expansion: of the model, and of its reduced model.
fn sources(declaration: TokenStream, limits: MethodLimits) -> Vec<[String; 3]> {
    let items = expand_within(declaration, limits);
    let file: syn::File = syn::parse2(items).expect("the expansion is of items");
    let mut found = Vec::new();
    for item in file.items {
        let Item::Impl(item) = item else { continue };
        let text_of = |name: &str| {
            item.items.iter().find_map(|item| match item {
                ImplItem::Const(constant) if constant.ident == name => match &constant.expr {
                    Expr::Lit(literal) => match &literal.lit {
                        Lit::Str(text) => Some(text.value()),
                        _ => None,
                    },
                    _ => None,
                },
                _ => None,
            })
        };
        if let [Some(source), Some(header), Some(casadi)] =
            ["C_SOURCE", "C_HEADER", "C_CASADI"].map(text_of)
        {
            found.push([source, header, casadi]);
        }
    }
    found
}

/// What a compiler says of a source, unless there is none; nothing if it is content.
fn complaints([source, header, casadi]: &[String; 3], folder: &Path) -> Option<String> {
    let include = source.split("#include \"").nth(1)?;
    let header_name = include.split('"').next()?;
    fs::create_dir_all(folder).expect("a folder");
    fs::write(folder.join(header_name), header).expect("a file");
    let sources = [("model.c", source), ("casadi.c", casadi)];
    let complaints = sources.map(|(name, text)| complaints_of(&folder.join(name), text));
    complaints.into_iter().flatten().next()
}

fn complaints_of(file: &Path, text: &str) -> Option<String> {
    fs::write(file, text).expect("a file");
    let mut command = Command::new("cc");
    command.args([
        "-std=c99",
        "-O1",
        "-Wall",
        "-Wextra",
        "-Werror",
        "-pedantic",
    ]);
    let output = command
        .arg("-c")
        .arg(file)
        .arg("-o")
        .arg(file.with_extension("o"))
        .output();
    let output = output.ok()?;
    (!output.status.success()).then(|| String::from_utf8_lossy(&output.stderr).into_owned())
}

fn driven_pendulum() -> TokenStream {
    quote! {
        #[lagrangian(
            coordinates(theta),
            kinetic = 0.5 * m * (l * dot(theta)).powi(2),
            potential = -m * g * l * cos(theta),
            force(theta = torque),
            c,
        )]
        struct Pendulum { m: f64, g: f64, l: f64, #[lagrangian(input)] torque: f64 }
    }
}

#[test]
fn a_source_is_the_same_each_time() {
    let [first, second] = [(); 2].map(|()| sources(driven_pendulum(), LIMITS));
    assert_eq!(first.len(), 1);
    assert_eq!(first, second);
    let [source, header, _] = &first[0];
    assert!(source.contains("\nvoid pendulum_step("));
    assert!(header.contains("\nvoid pendulum_step("));
    // What is not called is not there.
    assert!(!source.contains("pendulum_elimination"));
}

#[test]
fn models_without_the_clause_have_no_source() {
    let declaration = driven_pendulum().to_string().replace(", c ,", ",");
    let declaration: TokenStream = declaration.parse().expect("tokens");
    assert!(sources(declaration, LIMITS).is_empty());
}

#[test]
#[ignore = "it derives and compiles all models of the repository; run with `--include-ignored`"]
fn sources_of_all_declarations_compile_without_warnings() {
    if Command::new("cc").arg("--version").output().is_err() {
        println!("skipped: there is no compiler `cc`");
        return;
    }
    let repository = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
    let folder = env::temp_dir().join(format!("lagrangian-c-sources-{}", std::process::id()));
    let (mut compiled, mut failed) = (0, 0);
    for (name, declaration) in declarations(repository, &FOLDERS) {
        // Of ready models matrices column by column, too.
        let both = [LIMITS, BY_COLUMNS];
        let count = if name.starts_with("models/") { 2 } else { 1 };
        for limits in both.into_iter().take(count) {
            for both in sources(with_clause(declaration.clone()), limits) {
                compiled += 1;
                if let Some(complaints) = complaints(&both, &folder) {
                    failed += 1;
                    println!("{name}: {complaints}");
                }
            }
        }
    }
    fs::remove_dir_all(&folder).expect("the folder is there");
    println!("{compiled} sources");
    assert!(compiled > 100);
    assert_eq!(failed, 0);
}

/// In each folder within the one that the variable names is a declaration, `model.rs`, beside which its source is written.
#[test]
#[ignore = "for `tests/adversarial/generator c`, which sets LAGRANGIAN_C_FOLDER"]
fn sources_of_a_folder() {
    let Some(folder) = env::var_os("LAGRANGIAN_C_FOLDER") else {
        println!("skipped: LAGRANGIAN_C_FOLDER names no folder");
        return;
    };
    for entry in fs::read_dir(folder).expect("a folder") {
        let folder = entry.expect("a folder").path();
        let text = fs::read_to_string(folder.join("model.rs")).expect("a declaration");
        let items = syn::parse_file(&text).expect("Rust").items;
        for item in items {
            let Item::Struct(declaration) = item else {
                continue;
            };
            let found = sources(with_clause(declaration), LIMITS);
            // The reduced model comes behind the full one.
            if let Some(files) = found.first() {
                let names = ["model.c", "model.h", "model_casadi.c"];
                for (name, text) in names.into_iter().zip(files) {
                    fs::write(folder.join(name), text).expect("a file");
                }
            }
        }
    }
}

/// A declaration with the clause `c`.
fn with_clause(mut declaration: ItemStruct) -> TokenStream {
    let has_it = declaration.attrs.iter().any(|attribute| {
        let tokens = attribute.meta.to_token_stream().to_string();
        tokens.ends_with(", c)") || tokens.contains(", c ,") || tokens.contains(", c,")
    });
    if !has_it {
        declaration.attrs.push(syn::parse_quote!(#[lagrangian(c)]));
    }
    declaration.into_token_stream()
}
