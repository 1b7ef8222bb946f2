//! The programs of the methods that only reduced models have.

use lagrangian_symbolic::Reduction;

use super::method::Method;
use super::outputs::{MethodOutputs, OutputSlice};
use super::taylor_method::NoTaylorSeries;
use super::value_series::ValueSeries;

/// The programs of the effective potential and of the velocities of the ignorable coordinates.
pub(crate) struct ReducedMethods {
    pub(crate) effective_potential: Method,
    pub(crate) ignorable_velocities: Method,
    /// Their Taylor series along a motion, with the clause `taylor`.
    pub(crate) series: Option<ValueSeries>,
}

impl ReducedMethods {
    /// Schedules them.
    pub(crate) fn schedule(reduction: &Reduction) -> Self {
        let model = &reduction.model;
        let potential = [reduction.effective_potential];
        let velocities = &reduction.ignorable_velocities;
        Self {
            effective_potential: Method::single(model, &potential, MethodOutputs::Scalar),
            ignorable_velocities: Method::single(model, velocities, MethodOutputs::Vector),
            series: None,
        }
    }

    /// The same with series.
    pub(crate) fn with_series(mut self, reduction: &Reduction) -> Result<Self, NoTaylorSeries> {
        let program = &self.ignorable_velocities.program;
        let values = OutputSlice::of_group(program, 0);
        let graph = &reduction.model.graph;
        self.series = Some(ValueSeries::of(graph, program, &values)?);
        Ok(self)
    }
}
