//! Impls of `Inputs` and `Plant` without equations.

use proc_macro2::TokenStream;
use quote::quote;

use super::Fallback;
use crate::plan::Interface;

impl Fallback<'_> {
    pub(super) fn inputs(&self) -> TokenStream {
        let root = &self.declaration.root;
        let u = self.lowered.quantities.inputs.len();
        if u == 0 {
            return TokenStream::new();
        }
        let n = &self.dimension;
        let names = quote!(const INPUTS: [&'static str; #u] = [""; #u];);
        let inputs = self.interface(Interface::Inputs, &names);
        let of_parameters = self.scalar.of_parameters();
        let scalar = (!self.scalar.is_generic()).then_some(&self.scalar);
        let plant = self.implement(
            &quote!(#root::Plant<#n, #u>),
            scalar,
            &quote!(type Scalar = #of_parameters;),
        );
        quote!(#inputs #plant)
    }
}
