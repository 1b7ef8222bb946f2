//! Impls without equations of what clauses ask for.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use super::Fallback;
use crate::emit::reflect;
use crate::emit::requested::names;
use crate::plan::Interface;
use crate::syntax::parameter_list::ParameterList;
use crate::syntax::scalar::computes_on_f64;

impl Fallback<'_> {
    /// The impls of what clauses ask for.
    pub(super) fn requested(&self) -> TokenStream {
        let clauses = &self.declaration.clauses;
        let none = TokenStream::new();
        let mut impls = TokenStream::new();
        if clauses.hamiltonian.is_some() {
            impls.extend(self.interface(Interface::Hamiltonian, &none));
        }
        if clauses.energy_balance.is_some() {
            impls.extend(self.interface(Interface::EnergyBalance, &none));
        }
        if clauses.sensitivities.is_some() {
            let count = self.parameters().len();
            let items = quote!(const PARAMETERS: [&'static str; #count] = [""; #count];);
            impls.extend(self.interface(Interface::Sensitivities, &items));
            if self.lowered.constraints.len() > 0 {
                impls.extend(self.interface(Interface::MultiplierSensitivities, &none));
            }
        }
        if clauses.regressor.is_some() {
            let (signatures, count) = (self.signatures(), base_parameters());
            let output = signatures.result(crate::plan::ResultType::BaseParameters);
            let items = quote! {
                const BASE_PARAMETERS: [&'static str; #count] = [""; #count];
                const WITHOUT_EFFECT: &'static [&'static str] = &[];
                fn base_parameters(&self) -> #output { ::core::unreachable!() }
            };
            impls.extend(self.interface(Interface::Regressor, &items));
        }
        impls
    }

    /// The impl of `Reflect` without fields.
    pub(super) fn reflect(&self) -> TokenStream {
        if self.declaration.clauses.reflect.is_none() || !computes_on_f64(self.declaration) {
            return TokenStream::new();
        }
        let root = &self.declaration.root;
        let items = quote! {
            const NAME: &'static ::core::primitive::str = "";
            const DOCUMENTATION: &'static ::core::primitive::str = "";
            const FIELDS: &'static [#root::quantities::FieldDescription] = &[];
            fn read_fields(
                _: &mut #root::quantities::FieldReader<'_>,
            ) -> ::core::result::Result<Self, #root::quantities::InvalidNumbers> {
                ::core::unreachable!()
            }
            fn numbers(&self, _: &mut dyn ::core::ops::FnMut(::core::primitive::f64)) {
                ::core::unreachable!()
            }
        };
        let (scalar, parameter) = (&self.scalar, self.dimension_parameter.as_ref());
        reflect::implementation(self.declaration, scalar, &self.dimension, parameter, &items)
    }

    /// The lists of names, as constants of the type. How many base parameters there are is not known.
    pub(super) fn requested_constants(&self) -> TokenStream {
        let (clauses, visibility) = (&self.declaration.clauses, &self.declaration.visibility);
        let regressor = clauses.regressor.is_some().then(|| {
            quote! {
                #visibility const BASE_PARAMETERS: [&'static str; 0] = [];
                #visibility const WITHOUT_EFFECT: &'static [&'static str] = &[];
            }
        });
        let sensitivities = clauses.sensitivities.is_some().then(|| {
            let count = self.parameters().len();
            quote!(#visibility const PARAMETERS: [&'static str; #count] = [""; #count];)
        });
        let c = clauses.c.is_some().then(|| {
            quote! {
                #visibility const C_SOURCE: &'static str = "";
                #visibility const C_HEADER: &'static str = "";
                #visibility const C_CASADI: &'static str = "";
            }
        });
        quote!(#regressor #sensitivities #c)
    }

    /// The names of the parameters by which accelerations are differentiated.
    pub(super) fn parameters(&self) -> Vec<String> {
        let quantities = &self.lowered.quantities;
        let list = self.declaration.clauses.sensitivities.as_ref();
        let symbols = list.map(|list: &ParameterList| match &list.fields {
            Some(fields) => quantities.symbols_of(fields),
            None => quantities.parameter_symbols(),
        });
        names(quantities, &symbols.unwrap_or_default())
    }
}

/// The parameter of impls that stands for the number of base parameters.
pub(super) fn base_parameters() -> Ident {
    Ident::new("__B", Span::mixed_site())
}
