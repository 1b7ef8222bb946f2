//! What is emitted for inputs: their constants, and the impl of `Inputs`.

use core::ops::Range;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::emitter::Emitter;
use crate::lower::quantities::Component;
use crate::plan::Interface;
use crate::syntax::names::{constant_name, hygienic_ident, unraw};

impl Emitter<'_> {
    pub(super) fn inputs(&self) -> TokenStream {
        if !self.has_inputs() {
            return TokenStream::new();
        }
        let u = self.model.inputs as usize;
        let names = quote!(const INPUTS: [&'static str; #u] = Self::INPUTS;);
        self.interface(Interface::Inputs, names)
    }

    /// The names of the inputs and the indices of each field of them, as constants of the type; and their values.
    pub(super) fn input_constants(&self) -> TokenStream {
        if !self.has_inputs() {
            return TokenStream::new();
        }
        let visibility = &self.declaration.visibility;
        let components = &self.lowered.quantities.inputs;
        let u = components.len();
        let names = components.iter().map(|input| input.label.to_string());
        let indices = input_indices(components).map(|(field, indices)| {
            let name = unraw(field);
            let text = match indices {
                Indices::One(_) => format!("The index of the input `{name}`."),
                Indices::Several(_) => {
                    format!("The indices of the components of the input `{name}`.")
                }
            };
            let constant = indices.constant(field);
            quote!(#[doc = #text] #visibility const #constant;)
        });
        let n = self.coordinates();
        let values = self.on_own_scalar(
            "The inputs as the fields have them.",
            &quote!(inputs),
            &quote!(quantities::Quantities::<#n, _>),
            u,
        );
        quote! {
            /// The names of the inputs, in order.
            #visibility const INPUTS: [&'static str; #u] = [#(#names),*];
            #(#indices)*
            #values
        }
    }
}

/// The indices of one field of inputs.
pub(crate) enum Indices {
    /// Of a number.
    One(usize),
    /// Of the components of an array, a vector or a matrix, which are numbered in a row.
    Several(Range<usize>),
}

impl Indices {
    /// `NAME: type = value` for the constant of the field.
    pub(crate) fn constant(&self, field: &Ident) -> TokenStream {
        let name = hygienic_ident(&constant_name(field), field);
        match self {
            Self::One(index) => quote!(#name: usize = #index),
            Self::Several(indices) => {
                let (indices, length) = (indices.clone(), indices.len());
                quote!(#name: [usize; #length] = [#(#indices),*])
            }
        }
    }
}

/// The fields that are inputs, with the indices of their components.
pub(crate) fn input_indices(inputs: &[Component]) -> impl Iterator<Item = (&Ident, Indices)> {
    let fields = inputs.chunk_by(|one, next| one.field == next.field);
    fields.scan(0, |next, components| {
        let start = *next;
        *next += components.len();
        let first = components.first()?;
        let indices = if first.label.indices.is_empty() {
            Indices::One(start)
        } else {
            Indices::Several(start..*next)
        };
        Some((&first.field, indices))
    })
}
