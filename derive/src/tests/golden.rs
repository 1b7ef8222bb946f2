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
use crate::limits::MOST_SCOPES;

/// The models, the files with their expansions, and how many scopes these may nest.
const EXPANSIONS: [(&str, &str, usize); 4] = [
    ("heavy_top", "expansion.rs", MOST_SCOPES),
    // As if every method were long: with variables that are assigned, or in pieces of eight statements.
    ("heavy_top", "in_few_scopes.rs", 8),
    ("driven_pendulum", "expansion.rs", MOST_SCOPES),
    ("slider", "expansion.rs", MOST_SCOPES),
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
fn expansion(model: &str, most_scopes: usize) -> TokenStream {
    let declaration = read(&folder(model).join("declaration.rs"));
    let declaration = declaration.parse().expect("the declaration is of tokens");
    expand_within(declaration, most_scopes)
}

fn printed(tokens: TokenStream) -> String {
    let items = syn::parse2(tokens).expect("the expansion is of items");
    prettyplease::unparse(&items)
}

#[test]
fn expansions_are_those_that_were_committed() {
    for (model, file, most_scopes) in EXPANSIONS {
        let path = folder(model).join(file);
        let expansion = printed(expansion(model, most_scopes));
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
    for (model, _, most_scopes) in EXPANSIONS {
        assert_eq!(
            expansion(model, most_scopes).to_string(),
            expansion(model, most_scopes).to_string(),
            "{model}"
        );
    }
}
