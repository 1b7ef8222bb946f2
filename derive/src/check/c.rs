//! Checks of the clause `c`.

use crate::diagnostics::Diagnostics;
use crate::syntax::declaration::Declaration;
use crate::syntax::scalar::computes_on_f64;

/// What is written in C has its whole source in the declaration, and computes on `double`.
pub(super) fn check(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let clauses = &declaration.clauses;
    let Some(keyword) = &clauses.c else {
        return;
    };
    if let Some(function) = clauses.functions.first() {
        let name = &function.name;
        let message = format!(
            "the external function `{name}` has no source in C: write it as an expression, under `define` or where it is used, or \
             leave `c` out"
        );
        diagnostics.error(keyword, message);
    }
    if !computes_on_f64(declaration) {
        let message = "functions in C are of `double`: write `scalar = f64`, or leave `c` out";
        diagnostics.error(keyword, message);
    }
}
