//! Models that are linear in their unknown parameters.

use nalgebra::{SMatrix, SVector};

use super::inputs::{Inputs, WithInputs};
use super::lagrangian::Lagrangian;
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
pub trait Regressor<const N: usize, const B: usize, S: Scalar = f64>: Lagrangian<N, S> {
    /// The base parameters as formulas in the parameters, such as `i₁ + m₂ l²`.
    const BASE_PARAMETERS: [&'static str; B];

    /// The unknown parameters on which no equation of motion depends.
    const WITHOUT_EFFECT: &'static [&'static str];

    /// The regressor Y(q, q̇, q̈, t), whose columns belong to the base parameters.
    fn regressor(&self, state: &State<S, N>, accelerations: &SVector<S, N>) -> SMatrix<S, N, B>;

    /// r = M q̈ − f − Y π, which contains no unknown parameter.
    fn known_terms(&self, state: &State<S, N>, accelerations: &SVector<S, N>) -> SVector<S, N>;

    /// The base parameters π that the parameters of this model give.
    fn base_parameters(&self) -> SVector<S, B>;
}

/// A model with a regressor and inputs: both under inputs that vary in time.
///
/// [`WithInputs`](crate::WithInputs) has them under constant inputs.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no regressor",
    note = "write the clause `regressor`, or `regressor(m, inertia)` with the unknown parameters, in its declaration"
)]
pub trait RegressorWith<const N: usize, const U: usize, const B: usize, S: Scalar = f64>:
    Inputs<N, U, S> + Regressor<N, B, S>
{
    /// The regressor Y(q, q̇, q̈, t) under these inputs.
    fn regressor_with(
        &self,
        state: &State<S, N>,
        inputs: &SVector<S, U>,
        accelerations: &SVector<S, N>,
    ) -> SMatrix<S, N, B>;

    /// r = M q̈ − f − Y π under these inputs.
    fn known_terms_with(
        &self,
        state: &State<S, N>,
        inputs: &SVector<S, U>,
        accelerations: &SVector<S, N>,
    ) -> SVector<S, N>;
}

impl<M, S, const N: usize, const U: usize, const B: usize> Regressor<N, B, S>
    for WithInputs<'_, M, S, U>
where
    M: RegressorWith<N, U, B, S> + ?Sized,
    S: Scalar,
{
    const BASE_PARAMETERS: [&'static str; B] = M::BASE_PARAMETERS;
    const WITHOUT_EFFECT: &'static [&'static str] = M::WITHOUT_EFFECT;

    fn regressor(&self, state: &State<S, N>, accelerations: &SVector<S, N>) -> SMatrix<S, N, B> {
        self.model
            .regressor_with(state, &self.inputs, accelerations)
    }

    fn known_terms(&self, state: &State<S, N>, accelerations: &SVector<S, N>) -> SVector<S, N> {
        self.model
            .known_terms_with(state, &self.inputs, accelerations)
    }

    fn base_parameters(&self) -> SVector<S, B> {
        self.model.base_parameters()
    }
}
