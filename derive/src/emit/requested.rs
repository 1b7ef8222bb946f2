//! The impls of what clauses ask for: `Hamiltonian`, `EnergyBalance`, `Sensitivities` and `Regressor`.

use lagrangian_symbolic::{Letters, Symbol};
use proc_macro2::TokenStream;
use quote::quote;

use super::emitter::Emitter;
use super::printed_names::printed_names;
use crate::lower::quantities::Quantities;
use crate::plan::Interface;

impl Emitter<'_> {
    /// The impls of what clauses ask for.
    pub(super) fn requested(&self) -> TokenStream {
        let requested = &self.methods.requested;
        let mut impls = TokenStream::new();
        if requested.momentum_rates.is_some() {
            impls.extend(self.interface(Interface::Hamiltonian, TokenStream::new()));
        }
        if requested.energy_rate.is_some() {
            impls.extend(self.interface(Interface::EnergyBalance, TokenStream::new()));
        }
        if let Some(sensitivities) = &requested.sensitivities {
            let count = sensitivities.parameters.len();
            let items = quote!(const PARAMETERS: [&'static str; #count] = Self::PARAMETERS;);
            impls.extend(self.interface(Interface::Sensitivities, items));
            if self.is_constrained() {
                let none = TokenStream::new();
                impls.extend(self.interface(Interface::MultiplierSensitivities, none));
            }
        }
        if let Some(regressor) = &requested.regressor {
            let count = regressor.values.len();
            let items = quote! {
                const BASE_PARAMETERS: [&'static str; #count] = Self::BASE_PARAMETERS;
                const WITHOUT_EFFECT: &'static [&'static str] = Self::WITHOUT_EFFECT;
            };
            impls.extend(self.interface(Interface::Regressor, items));
        }
        impls
    }

    /// The base parameters as they are printed.
    fn base_parameters(&self) -> Vec<String> {
        let letters = Letters::new(&printed_names(self.lowered));
        let regressor = self.methods.requested.regressor.iter();
        let values = regressor.flat_map(|regressor| &regressor.values);
        let graph = &self.model.graph;
        values
            .map(|value| graph.display_in(*value, &letters).to_string())
            .collect()
    }

    /// The lists of names as constants of the type, and the base parameters on the scalar of the parameters.
    pub(super) fn requested_constants(&self) -> TokenStream {
        let visibility = &self.declaration.visibility;
        let (n, requested) = (self.coordinates(), &self.methods.requested);
        let regressor = requested.regressor.as_ref().map(|regressor| {
            let names = self.base_parameters();
            let count = names.len();
            let lines: Vec<String> = names.iter().map(|name| format!("- `{name}`")).collect();
            let without = self::names(&self.lowered.quantities, &regressor.without_effect);
            let values = self.on_own_scalar(
                "The base parameters that the parameters of this model give.",
                &quote!(base_parameters),
                &quote!(quantities::Regressor::<#n, #count, _>),
                count,
            );
            let text = format!(
                "The base parameters of the regressor:\n\n{}",
                lines.join("\n")
            );
            quote! {
                #[doc = #text]
                #visibility const BASE_PARAMETERS: [&'static str; #count] = [#(#names),*];
                /// The unknown parameters on which no equation of motion depends.
                #visibility const WITHOUT_EFFECT: &'static [&'static str] = &[#(#without),*];
                #values
            }
        });
        let sensitivities = requested.sensitivities.as_ref().map(|sensitivities| {
            let names = names(&self.lowered.quantities, &sensitivities.parameters);
            let count = names.len();
            quote! {
                /// The parameters by which accelerations are differentiated, in order.
                #visibility const PARAMETERS: [&'static str; #count] = [#(#names),*];
            }
        });
        let c = self.c_constants();
        quote!(#regressor #sensitivities #c)
    }
}

/// The names of some parameters.
pub(super) fn names(quantities: &Quantities, parameters: &[Symbol]) -> Vec<String> {
    let names = parameters.iter().map(|symbol| match symbol {
        Symbol::Parameter(i) => {
            let component = quantities.parameters.get(*i as usize);
            component.map(|component| component.label.to_string())
        }
        _ => None,
    });
    names.map(Option::unwrap_or_default).collect()
}
