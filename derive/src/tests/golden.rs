//! Expansions to look at: `golden/…/declaration.rs` becomes `golden/…/expansion.rs`, byte for byte;
//! one model is written as if it were long, too.
//!
//! The committed files were written by other processes than the one that compares, so that the
//! comparison is also a test of determinism. The package `lagrangian-tests` compiles and runs them.
//! After a change of the emitted code, write them anew with `GOLDEN=overwrite cargo test -p
//! lagrangian-derive golden`, and read the difference.

use std::path::{Path, PathBuf};
use std::{env, fs};

use proc_macro2::TokenStream;

use crate::expand::expand_within;
use crate::limits::MethodLimits;

const LIMITS: MethodLimits = MethodLimits::OF_EXPANSIONS;

/// As if every method were long: with variables that are assigned, or in pieces of eight statements.
const FEW_SCOPES: MethodLimits = MethodLimits {
    most_scopes: 8,
    ..LIMITS
};

/// As if there were many coordinates: with matrices column by column.
const BY_COLUMNS: MethodLimits = MethodLimits {
    costliest_mass_matrix: 0,
    costliest_derivatives: 0,
    ..LIMITS
};

/// The models, the files with their expansions, and the limits on the form of their methods.
const EXPANSIONS: [(&str, &str, MethodLimits); 6] = [
    ("heavy_top", "expansion.rs", LIMITS),
    ("heavy_top", "in_few_scopes.rs", FEW_SCOPES),
    ("heavy_top", "by_columns.rs", BY_COLUMNS),
    ("driven_pendulum", "expansion.rs", LIMITS),
    ("driven_pendulum", "by_columns.rs", BY_COLUMNS),
    ("slider", "expansion.rs", LIMITS),
];

fn folder(model: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("golden")
        .join(model)
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The items that the derive emits for a file with one struct.
fn expansion(model: &str, limits: MethodLimits) -> TokenStream {
    let declaration = read(&folder(model).join("declaration.rs"));
    let declaration = declaration.parse().expect("the declaration is of tokens");
    expand_within(declaration, limits)
}

fn printed(tokens: TokenStream) -> String {
    let items = syn::parse2(tokens).expect("the expansion is of items");
    prettyplease::unparse(&items)
}

#[test]
fn expansions_are_those_that_were_committed() {
    for (model, file, limits) in EXPANSIONS {
        let path = folder(model).join(file);
        let expansion = printed(expansion(model, limits));
        if env::var_os("GOLDEN").is_some_and(|value| value == "overwrite") {
            fs::write(&path, &expansion).expect("the golden file can be written");
        }
        let committed = read(&path);
        let differing = committed
            .lines()
            .zip(expansion.lines())
            .position(|(committed, expanded)| committed != expanded);
        assert!(
            committed == expansion,
            "{model}/{file} differs from line {} on; see the top of this file",
            differing.unwrap_or_else(|| committed.lines().count().min(expansion.lines().count()))
                + 1
        );
    }
}

#[test]
fn a_declaration_expands_to_the_same_tokens_each_time() {
    for (model, _, limits) in EXPANSIONS {
        assert_eq!(
            expansion(model, limits).to_string(),
            expansion(model, limits).to_string(),
            "{model}"
        );
    }
}
