//! The bodies of the methods that compute matrices column by column, in loops of the runtime.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::writer::Writer;
use crate::limits::DIRECTIONS_AT_ONCE;
use crate::plan::{Columns, EmittedMethod};

impl Writer<'_> {
    /// The body of such a method.
    pub(super) fn by_columns(&self, columns: Columns) -> TokenStream {
        match columns {
            Columns::MassMatrix => self.mass_matrix_by_columns(),
            Columns::Linearization => self.linearization_by_columns(),
            Columns::InputJacobian => self.input_jacobian_by_columns(),
        }
    }

    fn mass_matrix_by_columns(&self) -> TokenStream {
        let root = &self.emitter.declaration.root;
        let momenta = self.call(EmittedMethod::Momenta);
        quote!(#root::__private::mass_matrix_by_columns(state, |state| #momenta))
    }

    fn linearization_by_columns(&self) -> TokenStream {
        let root = &self.emitter.declaration.root;
        let accelerations = self.call(EmittedMethod::Accelerations);
        let (factors, on_duals) = (self.factors_by_methods(), self.quantities_on_duals());
        quote! {
            let accelerations = #accelerations;
            let factors = #factors;
            let prepared = #on_duals::prepare(self);
            let inputs = #root::__private::constants(inputs);
            #root::__private::linearization_by_columns(
                state,
                &accelerations,
                &factors,
                |state, accelerations| #on_duals::inverse_dynamics(self, state, &inputs, accelerations, &prepared),
            )
        }
    }

    /// Forces of inputs do not depend on the accelerations.
    fn input_jacobian_by_columns(&self) -> TokenStream {
        let root = &self.emitter.declaration.root;
        let (n, dual) = (self.emitter.coordinates(), self.dual());
        let (factors, on_duals) = (self.factors_by_methods(), self.quantities_on_duals());
        quote! {
            let factors = #factors;
            let prepared = #on_duals::prepare(self);
            let state = #root::__private::constant_state(state);
            let accelerations = #root::__private::SVector::<#dual, #n>::zeros();
            #root::__private::input_jacobian_by_columns(
                inputs,
                &factors,
                |inputs| #on_duals::inverse_dynamics(self, &state, inputs, &accelerations, &prepared),
            )
        }
    }

    /// The dual numbers, on the scalar.
    fn dual(&self) -> TokenStream {
        let root = &self.emitter.declaration.root;
        let (scalar, directions) = (
            &self.emitter.scalar,
            Literal::usize_unsuffixed(DIRECTIONS_AT_ONCE),
        );
        quote!(#root::Dual<#scalar, #directions>)
    }

    /// The trait with the methods on dual numbers.
    fn quantities_on_duals(&self) -> TokenStream {
        let root = &self.emitter.declaration.root;
        let (n, dual) = (self.emitter.coordinates(), self.dual());
        quote!(#root::quantities::Quantities::<#n, #dual>)
    }
}
