//! The struct of a model's outputs, and the impl of `Outputs`.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::Implementation;
use crate::declaration::Declaration;
use crate::names::{hygienic, placed, plain};

impl Implementation<'_> {
    pub(super) fn outputs(&self) -> TokenStream {
        let outputs = &self.declaration.clauses.outputs;
        if outputs.is_empty() {
            return TokenStream::new();
        }
        let n = self.coordinates();
        let scalar = &self.scalar;
        let names: Vec<_> = outputs.iter().map(|output| &output.name).collect();
        let (results, definition) = results(self.declaration, scalar, &names);
        let output = quote!(Self::Outputs);
        let method = self.method("outputs", &[], &output, &self.methods.outputs, |b| {
            b.outputs(&results, &names)
        });
        let implementation = self.implement(
            &quote!(::lagrangian::Outputs<#n, #scalar>),
            &quote!(type Outputs = #results<#scalar>; #method),
        );
        quote!(#definition #implementation)
    }
}

/// The struct that holds a model's outputs: its name, and its definition.
pub(crate) fn results(
    declaration: &Declaration,
    scalar: &Ident,
    outputs: &[&Ident],
) -> (Ident, TokenStream) {
    let name = &declaration.name;
    let visibility = &declaration.visibility;
    let results = placed(&format!("{}Outputs", plain(name)), name);
    let documentation = format!("The outputs of [`{name}`].");
    let fields = outputs.iter().map(|output| {
        let mut name = (*output).clone();
        name.set_span(hygienic(output));
        let text = format!("The output `{}`.", plain(output));
        quote!(#[doc = #text] #visibility #name: #scalar)
    });
    let definition = quote! {
        #[doc = #documentation]
        #[derive(
            ::core::clone::Clone,
            ::core::marker::Copy,
            ::core::fmt::Debug,
            ::core::cmp::PartialEq,
            ::core::cmp::Eq,
        )]
        #visibility struct #results<#scalar> {
            #(#fields),*
        }
    };
    (results, definition)
}
