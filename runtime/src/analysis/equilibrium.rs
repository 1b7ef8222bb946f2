//! What a search for equilibria finds.

use nalgebra::SVector;

use crate::model::State;
use crate::scalar::Scalar;

/// A variable that a search may change: a coordinate, a velocity or an input, by its index.
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
    /// The state; velocities of ignorable coordinates are those of a steady motion.
    pub state: State<S, N>,
    /// The inputs; none if they were held.
    pub inputs: SVector<S, U>,
    /// What the search did.
    pub report: SearchReport,
}

/// What a search did.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SearchReport {
    /// How many Newton steps were taken.
    pub iterations: usize,
    /// How many steps of the descent by Levenberg and Marquardt were taken, if Newton's method from the guess had failed;
    /// [`iterations`](Self::iterations) are those after it.
    pub descent_steps: usize,
    /// How many steps were shortened, so that the next correction became less.
    pub step_reductions: usize,
    /// How often accelerations were evaluated.
    pub evaluations: usize,
    /// The largest acceleration that is left, or difference of a momentum that was to be kept.
    pub residual: f64,
    /// The rank of the Jacobian by the unknowns at the last iterate. Where it is less than the count of unknowns, the solution is one of
    /// a family.
    pub rank: usize,
    /// The ratio of the largest singular value of the Jacobian to the smallest that is not zero, with variables measured
    /// in their sizes.
    pub condition: f64,
}
