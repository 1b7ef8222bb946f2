//! Checks of the clauses that name parameters.

use std::collections::BTreeSet;

use proc_macro2::Ident;

use crate::diagnostics::{Diagnostics, hint};
use crate::syntax::declaration::Declaration;
use crate::syntax::field::Role;
use crate::syntax::names::unraw;
use crate::syntax::parameter_list::ParameterList;

/// Each name is that of a field that is a parameter, and stands once.
pub(super) fn check(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let clauses = &declaration.clauses;
    for list in [&clauses.regressor, &clauses.sensitivities]
        .into_iter()
        .flatten()
    {
        check_list(list, declaration, diagnostics);
    }
}

fn check_list(list: &ParameterList, declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let keyword = &list.keyword;
    if declaration.fields_with(Role::Parameter).next().is_none() && declaration.names_fields {
        let message =
            format!("`{keyword}` is about parameters, and this model has none: leave it out");
        return diagnostics.error(keyword, message);
    }
    let mut seen = BTreeSet::new();
    for name in list.fields.iter().flatten() {
        if !seen.insert(unraw(name)) {
            diagnostics.error(
                name,
                format!("`{name}` stands in this list twice: keep one"),
            );
        } else if let Some(message) = objection(name, declaration) {
            diagnostics.error(name, message);
        }
    }
}

/// Why a name is not that of a parameter.
fn objection(name: &Ident, declaration: &Declaration) -> Option<String> {
    let written = unraw(name);
    let mut fields = declaration.fields.iter();
    let field = fields.find(|field| unraw(&field.name) == written);
    let message = match field.map(|field| field.role) {
        Some(Role::Parameter) => return None,
        Some(Role::Input) => format!(
            "`{name}` is an input, which is known at every time: name parameters, or leave the mark `input` out"
        ),
        Some(Role::Skipped) => {
            format!(
                "`{name}` is marked `skip`, so that the model does not know it: name parameters"
            )
        }
        None if !declaration.names_fields => return None,
        None => {
            let parameters = declaration.fields_with(Role::Parameter);
            let names: Vec<String> = parameters.map(|field| unraw(&field.name)).collect();
            let hint = hint(&written, &names, "some");
            format!("`{name}` is no parameter of the struct: {hint}")
        }
    };
    Some(message)
}
