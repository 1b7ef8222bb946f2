//! The names of emitted items.

use proc_macro2::Ident;
use quote::format_ident;

use crate::syntax::declaration::Declaration;
use crate::syntax::external_function::FunctionDeclaration;
use crate::syntax::names::{hygienic_ident, hygienic_span, unraw};

/// The name of the struct that holds a model's outputs.
pub(super) fn outputs_name(declaration: &Declaration) -> Ident {
    let name = &declaration.name;
    hygienic_ident(&format!("{}Outputs", unraw(name)), name)
}

/// The method that computes the value of a function, hygienic.
pub(super) fn value_name(function: &FunctionDeclaration) -> Ident {
    let name = unraw(&function.name);
    Ident::new(&format!("__value_of_{name}"), hygienic_span(&function.name))
}

/// The method that computes a derivative of a function.
pub(super) fn derivative_name(function: &FunctionDeclaration, argument: usize) -> Ident {
    let name = unraw(&function.name);
    format_ident!(
        "__derivative_of_{name}_by_{argument}",
        span = hygienic_span(&function.name)
    )
}
