//! The functions that differentiate the accelerations by the inputs and by parameters. A column has a row for each unknown: behind
//! the accelerations the multipliers, which are left out.

use super::Export;
use super::body::Body;
use super::derivatives::unless;
use super::methods::are_positive;
use crate::plan::{
    DerivativeOutputs, InputJacobianOutputs, Method, OutputSlice, ParameterSource, Residuals,
};

impl Export<'_> {
    /// The function for the derivatives by the inputs.
    pub(super) fn input_jacobian(&self, method: &Method, outputs: &InputJacobianOutputs) -> String {
        let inputs = self.emitter.model.inputs as usize;
        if inputs == 0 {
            return String::new();
        }
        let of_multipliers = |i: usize| self.is_of_multiplier(i);
        let mut body;
        match outputs {
            InputJacobianOutputs::Symbolic {
                pivots,
                derivatives,
                residuals,
            } => {
                body = self.body(method, &[(derivatives, &of_multipliers)]);
                let pivots = body.compute(pivots);
                let parts = (derivatives, residuals.as_ref());
                self.columns_or_solved(&mut body, &pivots, parts, inputs);
            }
            InputJacobianOutputs::Numerical { mass, residuals } => {
                body = self.body(method, &[]);
                self.factors(&mut body, mass, ParameterSource::Fields);
                self.solved_columns(&mut body, residuals, inputs);
            }
        }
        body.into_function("static void $_input_jacobian_at(const $_point *at, double *x)")
    }

    /// The function for the derivatives by parameters.
    pub(super) fn sensitivities(
        &self,
        method: &Method,
        outputs: &DerivativeOutputs<OutputSlice>,
    ) -> String {
        let count = self.sensitive_parameters().len();
        if count == 0 {
            return String::new();
        }
        let reads = self.body(method, &[]).reads_accelerations();
        let of_multipliers = |i: usize| self.is_of_multiplier(i);
        let mut body;
        match outputs {
            DerivativeOutputs::Symbolic {
                pivots,
                accelerations,
                derivatives,
                residuals,
            } => {
                let mut unneeded: Vec<_> = unless(reads, accelerations).into_iter().collect();
                unneeded.push((derivatives, &of_multipliers));
                body = self.body(method, &unneeded);
                let pivots = self.pivots(&mut body, pivots, accelerations);
                let residuals = residuals.as_ref().and_then(|residuals| match residuals {
                    Residuals::Columns(columns) => Some(columns),
                    Residuals::AlongVariation(_) => None,
                });
                self.columns_or_solved(&mut body, &pivots, (derivatives, residuals), count);
            }
            DerivativeOutputs::Numerical {
                mass,
                forcing,
                residuals,
            } => {
                body = self.body(method, unless(reads, forcing).as_slice());
                self.system(&mut body, mass, forcing);
                self.solved_columns(&mut body, residuals, count);
            }
        }
        body.into_function("static void $_sensitivities_at(const $_point *at, double *x)")
    }

    /// Writes columns where all pivots are positive, and elsewhere what is solved for numerically.
    fn columns_or_solved(
        &self,
        body: &mut Body<'_>,
        pivots: &[String],
        (derivatives, residuals): (&OutputSlice, Option<&OutputSlice>),
        count: usize,
    ) {
        let k = self.emitter.unknowns();
        let elements = body.compute_some(derivatives, |i| !self.is_of_multiplier(i));
        if !pivots.is_empty() {
            body.line(&format!("if ({}) {{", are_positive(pivots)));
        }
        let rows = elements.into_iter().enumerate();
        let rows = rows.filter(|(i, _)| !self.is_of_multiplier(*i));
        let rows = rows.map(|(i, value)| ((i % k) * count + i / k, value));
        body.assign("x", rows.collect::<Vec<_>>());
        if !pivots.is_empty() {
            body.line("} else {");
            if let Some(residuals) = residuals {
                self.factors_by_methods(body, ParameterSource::Fields);
                self.solved_columns(body, residuals, count);
            }
            body.line("}");
        }
    }

    /// Writes −M⁻¹ times so many columns.
    fn solved_columns(&self, body: &mut Body<'_>, residuals: &OutputSlice, count: usize) {
        let k = self.emitter.unknowns();
        let elements = body.compute(residuals);
        body.line(&format!("double column[{k}];"));
        body.line("int i;");
        for (j, column) in elements.chunks(k).enumerate() {
            self.solved_column(body, column, &format!("x[i * {count} + {j}]"));
        }
    }

    /// Whether an element of a matrix with a row for each unknown, column by column, is in the row of a multiplier.
    fn is_of_multiplier(&self, index: usize) -> bool {
        index % self.emitter.unknowns() >= self.emitter.coordinates()
    }
}
