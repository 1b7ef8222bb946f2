//! Numerical integration of ordinary differential equations ẋ = f(t, x).
//!
//! Nothing here knows about mass matrices or angles: a [`Dynamics`] has a derivative, an error scale and singularities.
//! A method ([`Integrator`]) starts a [`Stepper`]; a [`Problem`] says what is integrated, watched and kept.

mod dynamics;
mod component_name;
mod singularity;
mod projection;
mod projected;
mod error;
mod at;
mod bernstein;
mod step_polynomial;
mod stepper;
mod dense_output;
mod compensated;
mod passing;
mod runge_kutta;
mod dormand_prince;
mod tolerance;
mod binary_logarithm;
mod typical_sizes;
mod taylor;
mod event;
mod observer;
mod outcome;
mod partial;
#[cfg(feature = "alloc")]
mod dense_solution;
mod collector;
mod loop_state;
mod integration;
mod checkpoint;
mod part;
mod sample_times;
mod reactions;
mod driver;
mod integrator;
mod problem;
mod in_lanes;
mod ensemble;

pub use at::At;
pub use checkpoint::{Checkpoint, Resume};
pub use component_name::ComponentName;
pub use dense_output::{DenseOutput, Interpolant};
#[cfg(feature = "alloc")]
pub use dense_solution::DenseSolution;
pub use dormand_prince::{Dop853, Dop853Interpolant, Dop853Stepper};
pub use dynamics::Dynamics;
pub use ensemble::{Ends, Ensemble, EnsembleIntegrator};
pub use error::IntegrationError;
pub use event::{
    DeclaredEvent, EventDynamics, EventValues, MetConditions, Occurrence, SingleNumber, Watched,
};
pub use in_lanes::InLanes;
pub use integrator::Integrator;
pub use observer::{Flow, ObservationKind, Observer, Progress};
pub use outcome::StopReason;
pub use partial::Partial;
pub(crate) use problem::NothingWatched;
pub use problem::{DeclaredBy, End, Keep, Problem, Run, Solution, System, When};
#[cfg(feature = "alloc")]
pub use problem::{Dense, Every, StepEnds};
pub use projection::Projection;
pub use reactions::Reactions;
pub use runge_kutta::{
    ButcherTableau, CLASSICAL_FOURTH_ORDER, RungeKutta, RungeKuttaMemory, RungeKuttaStepper,
};
pub use singularity::Singularity;
pub use step_polynomial::StepPolynomial;
pub use stepper::{Advance, Statistics, Stepper};
pub use taylor::TaylorLanes;
pub use taylor::recurrences;
pub use taylor::{
    BranchVisitor, Series, SeriesMemory, SwitchingFunction, Taylor, TaylorCoefficients,
    TaylorInterpolant, TaylorStepper,
};
pub(crate) use taylor::{
    Convolutions, FewConvolutions, OnlineConvolutions, PairedConvolutions, UnrolledConvolutions,
};
#[doc(hidden)]
pub use taylor::{FactorPairs, PairSums};
pub use typical_sizes::{SetTypicalSizes, TypicalSizes, WithSizes};

#[cfg(test)]
mod tests {
    pub(super) mod order_conditions;
}
