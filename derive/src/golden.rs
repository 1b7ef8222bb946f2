//! Expansions to look at: `golden/…/declaration.rs` becomes `golden/…/expansion.rs`, byte for byte.
//!
//! The committed files were written by other processes than the one that compares, so that the
//! comparison is also a test of determinism. The package `lagrangian-tests` compiles and runs them.
//! After a change of the emitted code, write them anew with `GOLDEN=overwrite cargo test -p
//! lagrangian-derive golden`, and read the difference.

use std::path::{Path, PathBuf};
use std::{env, fs};

use proc_macro2::TokenStream;

use crate::expand::expand;

const MODELS: [&str; 3] = ["heavy_top", "driven_pendulum", "slider"];

fn folder(model: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("golden")
        .join(model)
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The items that the derive emits for a file with one struct.
fn expansion(model: &str) -> TokenStream {
    let declaration = read(&folder(model).join("declaration.rs"));
    expand(declaration.parse().expect("the declaration is of tokens"))
}

fn printed(tokens: TokenStream) -> String {
    let items = syn::parse2(tokens).expect("the expansion is of items");
    prettyplease::unparse(&items)
}

#[test]
fn expansions_are_those_that_were_committed() {
    for model in MODELS {
        let path = folder(model).join("expansion.rs");
        let expansion = printed(expansion(model));
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
            "the expansion of {model} differs from line {} on; see the top of this file",
            differing.unwrap_or_else(|| committed.lines().count().min(expansion.lines().count()))
                + 1
        );
    }
}

#[test]
fn a_declaration_expands_to_the_same_tokens_each_time() {
    for model in MODELS {
        assert_eq!(
            expansion(model).to_string(),
            expansion(model).to_string(),
            "{model}"
        );
    }
}
