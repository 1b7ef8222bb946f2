//! The equations of several models as they are printed: `golden/pages/….rs` becomes `….txt` and, in LaTeX, `….tex`.
//!
//! After a change, write them anew with `GOLDEN=overwrite cargo test -p lagrangian-derive pages`, and read the
//! difference.

use std::path::Path;
use std::{env, fs};

use proc_macro2::TokenStream;

use crate::expand::expand;
use crate::tests::arms::arm;

const MODELS: [&str; 9] = [
    "symmetric_top",
    "general_top",
    "body",
    "double_pendulum",
    "cart_pole",
    "springs",
    "bodies",
    "robot_arm",
    "chain",
];

/// The value of a constant of the model.
fn constant(expansion: &TokenStream, name: &str) -> String {
    let file: syn::File = syn::parse2(expansion.clone()).expect("the expansion is of items");
    let items = file.items.iter().filter_map(|item| match item {
        syn::Item::Impl(item) => Some(&item.items),
        _ => None,
    });
    let mut found = items.flatten().filter_map(|item| match item {
        syn::ImplItem::Const(item) if item.ident == name => Some(&item.expr),
        _ => None,
    });
    match found.next() {
        Some(syn::Expr::Lit(syn::ExprLit {
            lit: syn::Lit::Str(text),
            ..
        })) => text.value(),
        _ => panic!("no text {name}"),
    }
}

#[test]
fn pages_are_those_that_were_committed() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("golden/pages");
    let mut models: Vec<_> = MODELS
        .into_iter()
        .map(|name| {
            let path = folder.join(name).with_extension("rs");
            let declaration = fs::read_to_string(path).expect("the declaration is there");
            (name, declaration.parse().expect("it is of tokens"))
        })
        .collect();
    models.push(("arm", arm(6)));
    for (name, declaration) in models {
        let expansion = expand(declaration);
        for (item, extension) in [("EQUATIONS", "txt"), ("LATEX", "tex")] {
            let page = constant(&expansion, item);
            // Two pages of a book; LaTeX has twice as many characters.
            let most = if item == "LATEX" { 9000 } else { 4500 };
            assert!(page.len() < most, "{name}: {} bytes", page.len());
            let path = folder.join(name).with_extension(extension);
            if env::var_os("GOLDEN").is_some_and(|value| value == "overwrite") {
                fs::write(&path, &page).expect("the page can be written");
            }
            let committed = fs::read_to_string(&path).unwrap_or_default();
            assert!(
                committed == page,
                "{name} differs, see the top of this file:\n{page}"
            );
        }
    }
}
