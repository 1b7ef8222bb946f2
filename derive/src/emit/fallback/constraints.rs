//! The impl of `Constraints` without equations, and its constants.

use proc_macro2::TokenStream;

use super::Fallback;
use crate::emit::constraints;
use crate::emit::on_another_scalar::scalar_parameter;
use crate::plan::Interface;
use crate::syntax::names::constant_name;

impl Fallback<'_> {
    /// The constants of constraints, unless the names of some are taken.
    pub(super) fn constraint_constants(&self) -> TokenStream {
        let mut taken = self.taken.clone();
        let names = self.lowered.constraints.names();
        let mut names = names.iter().map(|(name, ..)| constant_name(name));
        if names.all(|name| taken.insert(name)) {
            constraints::constants(self.declaration, &self.lowered.constraints)
        } else {
            TokenStream::new()
        }
    }

    pub(super) fn constraints(&self) -> TokenStream {
        let constraints = &self.lowered.constraints;
        if constraints.len() == 0 {
            return TokenStream::new();
        }
        let count = constraints.len();
        let signatures = self.signatures();
        let (root, scalar, dimension) = (&self.declaration.root, &self.scalar, &self.dimension);
        let (state, vector) = (signatures.state(), signatures.vector());
        let prepared = &signatures.prepared;
        let items = quote::quote! {
            const CONSTRAINTS: [&'static str; #count] = [""; #count];
            const HOLONOMIC: usize = 0;
            const INTEGRABLE: [bool; #count] = [false; #count];
            fn constrained_response(
                &self,
                _: #state,
                _: &#prepared,
                _: (&#vector, &#root::__private::SVector<#scalar, #count>),
                _: &[::core::primitive::bool; #dimension],
                _: ::core::primitive::usize,
            ) -> #vector {
                ::core::unreachable!()
            }
        };
        let mut constraints = self.interface(Interface::Constraints, &items);
        let parameter = scalar_parameter(&self.declaration.generics, scalar);
        if scalar.is_generic() || parameter.is_some() {
            let methods = signatures.directional_derivatives(
                |_, arguments| quote::quote!(let _ = (#arguments); ::core::unreachable!()),
            );
            let interface = quote::quote!(#root::quantities::DirectionalDerivatives::<#dimension, #count, #scalar>);
            constraints.extend(self.implement(&interface, Some(scalar), &methods));
        }
        constraints
    }
}
