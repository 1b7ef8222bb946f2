//! The values of external functions, and the impl of `ExternalFunctions` without them.

use proc_macro2::TokenStream;
use quote::quote;

use super::Fallback;
use crate::emit::external_functions::{of_checks, signatures, values};
use crate::emit::implementation;

impl Fallback<'_> {
    pub(super) fn functions(&self) -> TokenStream {
        let declaration = self.declaration;
        if declaration.clauses.functions.is_empty() {
            return TokenStream::new();
        }
        let root = &declaration.root;
        let scalar = of_checks(&self.scalar);
        let generics = if self.scalar.is_generic() {
            declaration.generics.clone()
        } else {
            self.scalar.generics(&declaration.generics)
        };
        let signatures = signatures(declaration);
        let values = values(declaration, &self.scalar);
        let own = implementation::inherent(declaration, &generics, &values);
        let items = quote! {
            type Scalar = #scalar;
            #signatures
            fn function(&self, _: usize, _: &[#scalar]) -> #scalar { ::core::unreachable!() }
            fn derivative(
                &self, _: usize, _: usize, _: &[#scalar],
            ) -> ::core::option::Option<#scalar> { ::core::unreachable!() }
        };
        let interface = quote!(#root::ExternalFunctions);
        let implemented = implementation::of_trait(declaration, &generics, &interface, &items);
        quote!(#own #implemented)
    }
}
