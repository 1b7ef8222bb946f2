//! Impls of `Inputs` and `Plant` without equations.

use proc_macro2::TokenStream;
use quote::quote;

use super::Fallback;
use crate::emit::signatures::InputsFrom;
use crate::plan::MethodRow;

impl Fallback<'_> {
    pub(super) fn inputs(&self) -> TokenStream {
        let root = &self.declaration.root;
        let u = self.lowered.quantities.inputs.len();
        if u == 0 {
            return TokenStream::new();
        }
        let (n, scalar) = (&self.dimension, &self.scalar);
        let inputs = self.signatures().inputs();
        let methods = self.methods_where(InputsFrom::Argument, MethodRow::is_of_inputs);
        let items = quote! {
            const INPUTS: [&'static str; #u] = [""; #u];
            fn inputs(&self) -> #inputs { ::core::unreachable!() }
            #methods
        };
        let interface = quote!(#root::Inputs<#n, #u, #scalar>);
        let inputs = self.implement(&interface, Some(scalar), &items);
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
