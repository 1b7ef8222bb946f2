//! Where the emitted code finds the values of symbols.

use lagrangian_symbolic::Symbol;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::Implementation;
use crate::body::Source;
use crate::declaration::Role;

/// Where the values of inputs come from.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum InputsFrom {
    Fields,
    Argument,
}

/// Reads the symbols of a model.
pub(super) struct Reader<'a> {
    pub(super) implementation: &'a Implementation<'a>,
    pub(super) inputs: InputsFrom,
}

impl Source for Reader<'_> {
    fn read(&self, symbol: Symbol) -> TokenStream {
        let field = |role, i: u32| {
            let fields = self.implementation.declaration.fields_with(role);
            let field = fields.into_iter().nth(i as usize);
            field.map_or_else(TokenStream::new, |field| self.implementation.field(field))
        };
        match symbol {
            Symbol::Time => quote!(state.t),
            Symbol::Coordinate(i) => element(&quote!(state.q), i),
            Symbol::Velocity(i) => element(&quote!(state.v), i),
            Symbol::Acceleration(i) => element(&quote!(accelerations), i),
            Symbol::Parameter(i) => field(Role::Parameter, i),
            Symbol::Input(i) if self.inputs == InputsFrom::Argument => element(&quote!(inputs), i),
            Symbol::Input(i) => field(Role::Input, i),
            Symbol::Prepared(i) => element(&quote!(prepared), i),
        }
    }
}

fn element(vector: &TokenStream, index: u32) -> TokenStream {
    let index = Literal::u32_unsuffixed(index);
    quote!(#vector[#index])
}
