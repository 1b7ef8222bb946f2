//! The bodies of the methods that differentiate the accelerations: by q, q̇ and t, by inputs, and by parameters.

use proc_macro2::TokenStream;
use quote::quote;

use super::emitter::Emitter;
use super::methods::is_zero;
use super::writer::{Writer, joined};
use crate::plan::{DerivativeOutputs, OutputSlice, Residuals, StateJacobian};

/// Columns of derivatives, as a method returns them.
pub(super) trait Columns {
    /// The statements that compute the columns, and the value that they make.
    fn derivatives(&self, writer: &mut Writer<'_>) -> (TokenStream, TokenStream);

    /// The same of −M⁻¹ times the columns, where `factors` are those of M.
    fn solved(&self, writer: &mut Writer<'_>) -> (TokenStream, TokenStream);
}

impl StateJacobian {
    fn depends_on_time(&self, writer: &Writer<'_>) -> bool {
        let mut outputs = self.time.operands(&writer.method.program).iter();
        !outputs.all(is_zero)
    }
}

impl Columns for StateJacobian {
    fn derivatives(&self, writer: &mut Writer<'_>) -> (TokenStream, TokenStream) {
        let root = &writer.emitter.declaration.root;
        let (statements, position) = writer.compute(&self.position);
        let (_, velocity) = writer.compute(&self.velocity);
        let (_, time) = writer.compute(&self.time);
        let (position, velocity) = (writer.matrix(&position), writer.matrix(&velocity));
        let time = if self.depends_on_time(writer) {
            writer.vector(&time)
        } else {
            quote!(#root::__private::SVector::zeros())
        };
        let value = quote! {
            #root::Linearization {
                position: #position,
                velocity: #velocity,
                time: #time,
            }
        };
        (statements, value)
    }

    /// All columns are solved for at once, but for ∂/∂t where the time does not occur.
    fn solved(&self, writer: &mut Writer<'_>) -> (TokenStream, TokenStream) {
        let root = &writer.emitter.declaration.root;
        let (statements, mut elements) = writer.compute(&self.position);
        elements.extend(writer.compute(&self.velocity).1);
        if self.depends_on_time(writer) {
            elements.extend(writer.compute(&self.time).1);
        }
        let columns = writer.matrix(&elements);
        let value = quote!(#root::__private::linearization(&factors, &#columns));
        (statements, value)
    }
}

impl Columns for OutputSlice {
    fn derivatives(&self, writer: &mut Writer<'_>) -> (TokenStream, TokenStream) {
        let (statements, columns) = writer.compute(self);
        (statements, writer.columns(&columns))
    }

    fn solved(&self, writer: &mut Writer<'_>) -> (TokenStream, TokenStream) {
        let (statements, columns) = writer.compute(self);
        let columns = writer.columns(&columns);
        (statements, quote!(-factors.solve(&#columns)))
    }
}

impl Writer<'_> {
    /// The derivatives of the accelerations by q, q̇ and t, by parameters, or by inputs.
    pub(super) fn acceleration_derivatives<C: Columns>(
        &mut self,
        outputs: &DerivativeOutputs<C>,
    ) -> TokenStream {
        match outputs {
            DerivativeOutputs::Symbolic {
                pivots,
                accelerations,
                derivatives,
                residuals,
            } => {
                let (statements, pivots) = self.compute(pivots);
                let is_used = self.reads_accelerations() || !pivots.is_empty();
                let accelerations = accelerations.as_ref().filter(|_| is_used);
                let accelerations = accelerations.map(|accelerations| {
                    let (_, accelerations) = self.compute(accelerations);
                    self.if_positive(&pivots, &accelerations)
                });
                let (more, derivatives) = derivatives.derivatives(self);
                let behind = if let Some(residuals) = residuals {
                    let (others, solved) = self.solved_beside(residuals);
                    let factors = self.factors_by_methods();
                    let root = &self.emitter.declaration.root;
                    let value = quote! {
                        #root::__private::if_positive([#(#pivots),*], #derivatives, || {
                            let factors = #factors;
                            #solved
                        })
                    };
                    joined([more, others, value])
                } else {
                    joined([more, derivatives])
                };
                let accelerations = self.solution_before(accelerations, &behind);
                joined([statements, accelerations, behind])
            }
            DerivativeOutputs::Numerical {
                mass,
                forcing,
                residuals,
            } => {
                let (statements, factors) = self.factors(mass);
                let solution = forcing.as_ref().map(|forcing| {
                    let (_, forcing) = self.compute(forcing);
                    let forcing = self.vector(&forcing);
                    quote!(factors.solve(&#forcing))
                });
                let (more, solved) = residuals.solved(self);
                let behind = joined([more, solved]);
                let accelerations = self.solution_before(solution, &behind);
                joined([statements, factors, accelerations, behind])
            }
        }
    }

    /// The statement that names the parts of a solution, if there is one, before those that read them.
    fn solution_before(&self, solution: Option<TokenStream>, behind: &TokenStream) -> TokenStream {
        let parts = |solution| self.emitter.parts_of_solution(&solution, behind);
        solution.map(parts).unwrap_or_default()
    }

    /// The statements before −M⁻¹ times the derivatives of M q̈ − f, and this, where `factors` are those of M.
    fn solved_beside<C: Columns>(
        &mut self,
        residuals: &Residuals<C>,
    ) -> (TokenStream, TokenStream) {
        let variation = match residuals {
            Residuals::Columns(columns) => return columns.solved(self),
            Residuals::AlongVariation(variation) => variation,
        };
        let Emitter {
            declaration,
            scalar,
            ..
        } = self.emitter;
        let root = &declaration.root;
        let count = 2 * self.emitter.coordinates() + 1;
        let (statements, column) = self.compute(variation);
        let column = self.vector(&column);
        let solved = quote! {
            #root::__private::linearization_along(&factors, |variation: [#scalar; #count]| {
                #statements #column
            })
        };
        (TokenStream::new(), solved)
    }

    /// The derivatives of the accelerations, and with constraints of the multipliers, by parameters.
    pub(super) fn sensitivities(
        &mut self,
        outputs: &DerivativeOutputs<OutputSlice>,
    ) -> TokenStream {
        let root = &self.emitter.declaration.root;
        let parts = quote! {
            (
                #root::__private::rows_of_accelerations(&derivatives),
                #root::__private::rows_of_multipliers(&derivatives),
            )
        };
        self.parts_of_derivatives(outputs, &parts)
    }

    /// The derivatives of the accelerations by the inputs.
    pub(super) fn input_jacobian(
        &mut self,
        outputs: &DerivativeOutputs<OutputSlice>,
    ) -> TokenStream {
        let root = &self.emitter.declaration.root;
        let parts = quote!(#root::__private::rows_of_accelerations(&derivatives));
        self.parts_of_derivatives(outputs, &parts)
    }

    /// The derivatives of the accelerations; with constraints these parts of the `derivatives` of accelerations and multipliers.
    fn parts_of_derivatives(
        &mut self,
        outputs: &DerivativeOutputs<OutputSlice>,
        parts: &TokenStream,
    ) -> TokenStream {
        let derivatives = self.acceleration_derivatives(outputs);
        if !self.emitter.is_constrained() {
            return derivatives;
        }
        quote! {
            let derivatives = { #derivatives };
            #parts
        }
    }
}
