//! Checks of the clause `reflect`.

use crate::diagnostics::Diagnostics;
use crate::syntax::declaration::Declaration;
use crate::syntax::scalar::computes_on_f64;

/// A model is made from numbers `f64`.
pub(super) fn check(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let Some(keyword) = &declaration.clauses.reflect else {
        return;
    };
    if !computes_on_f64(declaration) {
        let message =
            "a model is made from numbers `f64`: write `scalar = f64`, or leave `reflect` out";
        diagnostics.error(keyword, message);
    }
}
