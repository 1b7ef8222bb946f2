//! Checks of the scalar of a model.

use proc_macro2::Ident;

use crate::diagnostics::Diagnostics;
use crate::syntax::declaration::Declaration;
use crate::syntax::scalar::{is_name, is_scalar, scalar_parameters};

/// Checks that the fields' type parameters are one, and a scalar, and no other than is named.
pub(super) fn check(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    if let (Some(named), Some((used, _))) = (
        &declaration.clauses.scalar,
        scalar_parameters(declaration).next(),
    ) && !is_name(named, used)
    {
        let message =
            format!("parameters are of `{used}`: write `scalar = {used}`, or leave it out");
        return diagnostics.error(named, message);
    }
    let mut checked: Vec<&Ident> = Vec::new();
    for (parameter, ty) in scalar_parameters(declaration) {
        if checked.contains(&parameter) {
            continue;
        }
        let model = &declaration.name;
        if !is_scalar(&declaration.generics, parameter) {
            let message = format!(
                "`{parameter}` may be of any type: write `struct {model}<{parameter}: Scalar>`, with the trait \
                 `lagrangian::Scalar`"
            );
            diagnostics.error(ty, message);
        } else if let [first, ..] = checked[..] {
            let message = format!(
                "parameters are of one scalar, and others are of `{first}`: write `{first}`, or `f64`"
            );
            diagnostics.error(ty, message);
        }
        checked.push(parameter);
    }
}
