//! Impls of `MotionSeries` without a recurrence.

use proc_macro2::TokenStream;
use quote::quote;

use super::Fallback;

impl Fallback<'_> {
    pub(super) fn taylor_series(&self) -> TokenStream {
        if self.declaration.clauses.taylor.is_none() {
            return TokenStream::new();
        }
        let root = &self.declaration.root;
        let (n, scalar) = (&self.dimension, &self.scalar);
        let (state, inputs) = (self.signatures().state(), self.signatures().inputs());
        let items = quote! {
            fn taylor_series<const HALF: usize>(
                &self,
                _: #state,
                _: &[#inputs],
                _: &[#scalar; 0],
                _: #scalar,
                _: &mut #root::TaylorCoefficients<#root::Phase<#scalar, #n>, HALF>,
                _: ::core::option::Option<&mut #root::SeriesMemory>,
            ) {
                ::core::unreachable!()
            }
        };
        let interface = quote!(#root::quantities::MotionSeries<#n, #scalar>);
        self.implement(&interface, Some(scalar), &items)
    }
}
