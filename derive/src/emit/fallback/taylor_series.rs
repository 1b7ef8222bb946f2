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
        let state = self.signatures().state();
        let rest = quote! {
            _: &(),
            _: #scalar,
            _: &mut #root::TaylorCoefficients<#root::Phase<#scalar, #n>, HALF>,
        };
        let items = quote! {
            fn taylor_series<const HALF: usize>(&self, _: #state, #rest) {
                ::core::unreachable!()
            }
        };
        let interface = quote!(#root::MotionSeries<#n, #scalar>);
        let held = self.implement(&interface, Some(scalar), &items);
        let u = self.lowered.quantities.inputs.len();
        if u == 0 {
            return held;
        }
        let inputs = self.signatures().inputs();
        let items = quote! {
            fn taylor_series_with<const HALF: usize>(&self, _: #state, _: &[#inputs], #rest) {
                ::core::unreachable!()
            }
        };
        let interface = quote!(#root::MotionSeriesWith<#n, #u, #scalar>);
        let with_inputs = self.implement(&interface, Some(scalar), &items);
        quote!(#held #with_inputs)
    }
}
