//! Errors, collected so that all of them are reported together.

use std::collections::BTreeSet;

use proc_macro2::{Span, TokenStream};
use quote::ToTokens;

/// The errors found so far.
///
/// What is used twice, such as the place of a body in both of its energies, is wrong once.
#[derive(Default)]
pub(crate) struct Diagnostics {
    errors: Option<syn::Error>,
    /// The places and messages of those.
    seen: BTreeSet<String>,
}

impl Diagnostics {
    /// Adds an error at `tokens`.
    pub(crate) fn error(&mut self, tokens: impl ToTokens, message: impl core::fmt::Display) {
        self.add(syn::Error::new_spanned(tokens, message));
    }

    /// Adds an error at `span`.
    pub(crate) fn error_at(&mut self, span: Span, message: impl core::fmt::Display) {
        self.add(syn::Error::new(span, message));
    }

    /// Adds an error that was made elsewhere.
    pub(crate) fn add(&mut self, error: syn::Error) {
        for error in error {
            if !self.seen.insert(format!("{:?} {error}", error.span())) {
                continue;
            }
            match &mut self.errors {
                Some(errors) => errors.combine(error),
                None => self.errors = Some(error),
            }
        }
    }

    /// How many there are.
    pub(crate) fn count(&self) -> usize {
        self.seen.len()
    }

    /// Adds the errors of a model that this one brings with it, with these words behind them.
    pub(crate) fn add_with(&mut self, errors: Self, words: &str) {
        for error in errors.errors.into_iter().flatten() {
            let message = format!("{error}; {words}");
            self.add(syn::Error::new(error.span(), message));
        }
    }

    /// Whether there are none.
    pub(crate) fn is_empty(&self) -> bool {
        self.errors.is_none()
    }

    /// The errors as items that the compiler reports.
    pub(crate) fn to_compile_errors(&self) -> TokenStream {
        self.errors
            .as_ref()
            .map(syn::Error::to_compile_error)
            .unwrap_or_default()
    }
}

/// The name among `names` that `written` is probably misspelled for, if one is near.
pub(crate) fn similar<'a>(
    written: &str,
    names: impl IntoIterator<Item = &'a str>,
) -> Option<&'a str> {
    names
        .into_iter()
        .map(|name| (distance(written, name), name))
        .filter(|(distance, name)| *distance * 3 <= name.chars().count().max(3) && name.len() > 1)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, name)| name)
}

/// What is written in place of a word that is none of these names: the one that was probably meant, or so many of them.
pub(crate) fn hint(written: &str, names: &[impl AsRef<str>], many: &str) -> String {
    let all: Vec<&str> = names.iter().map(AsRef::as_ref).collect();
    match similar(written, all.iter().copied()) {
        Some(meant) => format!("did you mean `{meant}`?"),
        None => format!("write {many} of `{}`", all.join("`, `")),
    }
}

/// The edit distance of two words: how many insertions, deletions, substitutions and transpositions of adjacent letters
/// lead from one to the other (Damerau, A technique for computer detection and correction of spelling errors, 1964), in
/// its restricted form, the optimal string alignment.
fn distance(from: &str, to: &str) -> usize {
    let (from, to): (Vec<char>, Vec<char>) = (from.chars().collect(), to.chars().collect());
    let mut table = vec![vec![0; to.len() + 1]; from.len() + 1];
    for i in 0..=from.len() {
        for j in 0..=to.len() {
            table[i][j] = if i == 0 || j == 0 {
                i + j
            } else {
                let replaced = table[i - 1][j - 1] + usize::from(from[i - 1] != to[j - 1]);
                let shorter = (table[i - 1][j] + 1).min(table[i][j - 1] + 1);
                let swapped =
                    i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1];
                let best = replaced.min(shorter);
                if swapped {
                    best.min(table[i - 2][j - 2] + 1)
                } else {
                    best
                }
            };
        }
    }
    table[from.len()][to.len()]
}
