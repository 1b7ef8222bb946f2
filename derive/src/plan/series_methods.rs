//! What a model with the clause `taylor` has besides: the Taylor series of its motion, and of values along it.

use lagrangian_symbolic::{Equations, Model};

use super::methods::Methods;
use super::taylor_method::{NoTaylorSeries, TaylorMethod};
use super::value_series::{BranchSeries, EventSeries};

/// The methods for Taylor series.
pub(crate) struct SeriesMethods {
    pub(crate) motion: TaylorMethod,
    /// That of the event functions, if they have series.
    pub(crate) events: Option<EventSeries>,
    /// That of the switching functions of the equations of motion, if there are some.
    pub(crate) branches: Option<BranchSeries>,
}

impl SeriesMethods {
    /// The methods of a model; `branches` tells for each event the values at whose zeros it has another branch.
    pub(crate) fn derive(
        methods: &mut Methods,
        model: &mut Model,
        equations: &Equations,
        branches: Vec<Vec<usize>>,
    ) -> Result<Self, NoTaylorSeries> {
        Ok(Self {
            motion: methods.taylor_method(model, equations)?,
            events: methods.event_series(&model.graph, branches)?,
            branches: BranchSeries::derive(model, equations)?,
        })
    }
}
