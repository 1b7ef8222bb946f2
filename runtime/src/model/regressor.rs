//! Models that are linear in their unknown parameters.

use nalgebra::{SMatrix, SVector};

use super::quantities::Quantities;
use super::state::State;
use crate::scalar::Scalar;

/// A model whose declaration has the clause `regressor`: M q̈ − f = Y π + r.
///
/// π are the `B` base parameters: combinations of the unknown parameters that determine the equations of motion, of which
/// there are as few as possible, so that the columns of Y are linearly independent functions of the motion (Gautier and
/// Khalil, Direct calculation of minimum set of inertial parameters of serial robots, 1990). r is what known parameters and
/// inputs contribute. Along a motion on which the forces τ act besides Q, M q̈ − f = τ, so that Y π = τ − r are linear
/// equations for π, which [`Identification`](crate::identification::Identification) solves by least squares.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no regressor",
    note = "write the clause `regressor`, or `regressor(m, inertia)` with the unknown parameters, in its declaration"
)]
pub trait Regressor<const N: usize, const B: usize, S: Scalar = f64>: Quantities<N, S> {
    /// The base parameters as formulas in the parameters, such as `i₁ + m₂ l²`.
    const BASE_PARAMETERS: [&'static str; B];

    /// The unknown parameters on which no equation of motion depends.
    const WITHOUT_EFFECT: &'static [&'static str];

    /// [`Lagrangian::regressor`](crate::Lagrangian::regressor) under these inputs.
    fn regressor(
        &self,
        state: &State<S, N>,
        inputs: &Self::Inputs,
        accelerations: &SVector<S, N>,
    ) -> SMatrix<S, N, B>;

    /// [`Lagrangian::known_terms`](crate::Lagrangian::known_terms) under these inputs.
    fn known_terms(
        &self,
        state: &State<S, N>,
        inputs: &Self::Inputs,
        accelerations: &SVector<S, N>,
    ) -> SVector<S, N>;

    /// [`Lagrangian::base_parameters`](crate::Lagrangian::base_parameters).
    fn base_parameters(&self) -> SVector<S, B>;
}
