//! The names of emitted items.

use proc_macro2::Ident;
use quote::format_ident;

use crate::syntax::declaration::Declaration;
use crate::syntax::function::Function;
use crate::syntax::names::{hygienic, placed, plain};

/// The name of the struct that holds a model's outputs.
pub(super) fn outputs_name(declaration: &Declaration) -> Ident {
    let name = &declaration.name;
    placed(&format!("{}Outputs", plain(name)), name)
}

/// The method that computes the value of a function, which meets none of the user's.
pub(super) fn value_name(function: &Function) -> Ident {
    let name = plain(&function.name);
    Ident::new(&format!("__value_of_{name}"), hygienic(&function.name))
}

/// The method that computes a derivative of a function.
pub(super) fn derivative_name(function: &Function, argument: usize) -> Ident {
    let name = plain(&function.name);
    format_ident!(
        "__derivative_of_{name}_by_{argument}",
        span = hygienic(&function.name)
    )
}
