//! The results of a search for equilibria.

use nalgebra::SVector;

use crate::model::State;
use crate::scalar::Scalar;

/// A variable that a search may change: a coordinate, a velocity or an input, given by its index.
///
/// The indices are the constants of the model, such as `Top::PHI`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variable {
    /// A coordinate qᵢ.
    Coordinate(usize),
    /// The velocity q̇ᵢ of an ignorable coordinate.
    Velocity(usize),
    /// An input uᵢ.
    Input(usize),
}

/// An equilibrium or a steady motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Equilibrium<S: Scalar, const N: usize, const U: usize> {
    /// The state; in a steady motion, the ignorable coordinates have velocities.
    pub state: State<S, N>,
    /// The inputs; empty if they were held.
    pub inputs: SVector<S, U>,
    /// A report on the search.
    pub report: SearchReport,
}

/// A report on a search.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SearchReport {
    /// The number of Newton steps.
    pub iterations: usize,
    /// The number of Levenberg–Marquardt steps that were taken if Newton's method had failed from the guess;
    /// [`iterations`](Self::iterations) counts only the Newton steps after them.
    pub descent_steps: usize,
    /// The number of steps that were shortened to make the next correction smaller.
    pub step_reductions: usize,
    /// The number of evaluations of the accelerations.
    pub evaluations: usize,
    /// The largest remaining acceleration, or difference of a momentum from its prescribed value.
    pub residual: f64,
    /// The rank of the Jacobian by the unknowns at the last iterate. If it is less than the number of unknowns, the
    /// solution is one of a family.
    pub rank: usize,
    /// The ratio of the largest singular value of the Jacobian to the smallest nonzero one, with variables measured in
    /// their sizes.
    pub condition: f64,
}
