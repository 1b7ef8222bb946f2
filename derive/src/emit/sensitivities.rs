//! The body of the method that differentiates the accelerations by parameters.

use proc_macro2::TokenStream;
use quote::quote;

use super::writer::Writer;
use crate::plan::SensitivityOutputs;

impl Writer<'_> {
    /// The derivatives of the accelerations by parameters.
    pub(super) fn sensitivities(&mut self, outputs: &SensitivityOutputs) -> TokenStream {
        let root = &self.emitter.declaration.root;
        match outputs {
            SensitivityOutputs::Symbolic {
                pivots,
                accelerations,
                derivatives,
                residuals,
            } => {
                let (statements, pivots) = self.compute(pivots);
                let (_, accelerations) = self.compute(accelerations);
                let accelerations = self.if_positive(&pivots, &accelerations);
                let is_used = self.reads_accelerations() || !pivots.is_empty();
                let accelerations = is_used.then(|| quote!(let accelerations = #accelerations;));
                let (more, derivatives) = self.compute(derivatives);
                let derivatives = self.matrix(&derivatives);
                let Some(residuals) = residuals else {
                    return quote!(#statements #accelerations #more #derivatives);
                };
                let (others, residuals) = self.compute(residuals);
                let residuals = self.matrix(&residuals);
                let factors = self.factors_of_mass_matrix();
                quote! {
                    #statements #accelerations #more #others
                    #root::__private::if_positive([#(#pivots),*], #derivatives, || {
                        -#factors.solve(&#residuals)
                    })
                }
            }
            SensitivityOutputs::Numerical {
                mass,
                forcing,
                residuals,
            } => {
                let (statements, factors) = self.factors(mass);
                let (_, forcing) = self.compute(forcing);
                let forcing = self.vector(&forcing);
                let (more, residuals) = self.compute(residuals);
                let residuals = self.matrix(&residuals);
                quote! {
                    #statements
                    #factors
                    let accelerations = factors.solve(&#forcing);
                    #more
                    -factors.solve(&#residuals)
                }
            }
        }
    }
}
