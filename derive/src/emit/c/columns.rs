//! The functions that differentiate the accelerations by the inputs and by parameters. A column has a row for each unknown: behind
//! the accelerations the multipliers, which are left out.

use super::Export;
use super::body::Body;
use super::derivatives::unless;
use super::methods::are_positive;
use crate::plan::{DerivativeOutputs, Method, OutputSlice, ParameterSource, Residuals};

impl Export<'_> {
    /// The function with this name that writes so many columns of derivatives, by the inputs or by parameters.
    pub(super) fn derivatives_by(
        &self,
        name: &str,
        method: &Method,
        outputs: &DerivativeOutputs<OutputSlice>,
        count: usize,
    ) -> String {
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
                let accelerations = accelerations.as_ref();
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
                let forcing = forcing.as_ref();
                body = self.body(method, unless(reads, forcing).as_slice());
                self.system(&mut body, mass, forcing);
                self.solved_columns(&mut body, residuals, count);
            }
        }
        body.into_function(&format!(
            "static void $_{name}_at(const $_point *at, double *x)"
        ))
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
