//! The parts of a [`Problem`](crate::Problem), the traits of its settings, and what is kept of its solution.
//!
//! Programs name only a few of these: [`Every`], [`StepEnds`] and [`Dense`] to choose what is saved. The traits are
//! bounds of functions that are generic over problems.

pub use crate::integrate::{
    DeclaredBy, End, Ends, EnsembleIntegrator, Flow, Keep, Observer, Projection, Reactions, Run,
    System, Watched, When,
};
#[cfg(feature = "alloc")]
pub use crate::integrate::{Dense, DenseSolution, Every, StepEnds};
