//! The equations of motion of a system with a Lagrangian.

use nalgebra::{SMatrix, SVector};

use super::equations_of_motion::EquationsOfMotion;
use super::generalized_coordinates::GeneralizedCoordinates;
use super::linearization::Linearization;
use super::state::State;
use crate::linalg::Factorization;
use crate::scalar::Scalar;

/// A system that moves by Lagrange's equations d/dt (∂L/∂q̇) − ∂L/∂q = Q (4.6).
///
/// `#[derive(Lagrangian)]` implements it; a model can also be written by hand against it. All
/// methods are functions of the state alone, evaluate without allocating, and return what is not a
/// number where the declaration has no value.
pub trait Lagrangian<const N: usize, S: Scalar = f64>: GeneralizedCoordinates<N> {
    /// What depends on the parameters alone; `()` for a model written by hand that prepares nothing.
    type Prepared: Clone + core::fmt::Debug;

    /// The Lagrangian function L = T − V.
    fn lagrangian(&self, state: &State<S, N>) -> S;

    /// The energy function h = Σ pᵢ q̇ᵢ − L: conserved where L does not contain the time and no
    /// generalized force does work. It is T + V only for T quadratic in q̇ and V free of it.
    fn energy(&self, state: &State<S, N>) -> S;

    /// The generalized momenta p = ∂L/∂q̇.
    fn momenta(&self, state: &State<S, N>) -> SVector<S, N>;

    /// The mass matrix M = ∂²L/∂q̇².
    fn mass_matrix(&self, state: &State<S, N>) -> SMatrix<S, N, N>;

    /// The forcing f in M q̈ = f: everything of the equations of motion but M q̈.
    fn forcing(&self, state: &State<S, N>) -> SVector<S, N>;

    /// The generalized forces Q: what the declaration says under `force` and `dissipation`.
    fn generalized_forces(&self, state: &State<S, N>) -> SVector<S, N>;

    /// The accelerations q̈.
    fn accelerations(&self, state: &State<S, N>) -> SVector<S, N>;

    /// Computes what depends on the parameters alone, for
    /// [`accelerations_prepared`](Self::accelerations_prepared). An integration does it once, in
    /// [`dynamics`](Self::dynamics).
    fn prepare(&self) -> Self::Prepared;

    /// The accelerations q̈, from what [`prepare`](Self::prepare) gave for the same parameters.
    fn accelerations_prepared(
        &self,
        state: &State<S, N>,
        _prepared: &Self::Prepared,
    ) -> SVector<S, N> {
        self.accelerations(state)
    }

    /// The forces M q̈ − f that would have to act besides Q for the system to accelerate so.
    fn inverse_dynamics(&self, state: &State<S, N>, accelerations: &SVector<S, N>)
    -> SVector<S, N>;

    /// The derivatives of the accelerations with respect to q, q̇ and t.
    ///
    /// As first-order equations x = (q, q̇), ẋ = A x + B u near an equilibrium, they are the lower rows of A, below
    /// (0 1); those of B, below 0, are [`Inputs::input_jacobian`](crate::Inputs::input_jacobian).
    ///
    /// For more than a few coupled coordinates they are solved for with a factorization of M in numbers.
    /// Near a singularity of M they then lose as much as [`Factorization`]'s relative pivots say.
    fn linearize(&self, state: &State<S, N>) -> Linearization<S, N>;

    /// For each coordinate, how much is left of a relative accuracy of 1 where M q̈ = f is solved: near 1 if
    /// nothing is lost, 0 or not a number if M is singular. Its inverse estimates the factor by which the
    /// rounding errors of M grow in [`accelerations`](Self::accelerations); those of the forcing are not
    /// part of it.
    ///
    /// Where M is positive definite it is the pivot of the factorization of M relative to what its rounding error is
    /// proportional to; where M is indefinite and regular, as for ẋ ẏ, the reciprocal of (|M⁻¹| |M|)ᵢᵢ.
    fn relative_pivots(&self, state: &State<S, N>) -> SVector<S, N> {
        Factorization::new(self.mass_matrix(state)).relative_pivots()
    }

    /// The equations of motion as an integrator takes them.
    fn dynamics(&self) -> EquationsOfMotion<'_, Self, S, N>
    where
        Self: Sized,
    {
        EquationsOfMotion::new(self)
    }
}

/// The energies of a system that is declared by them.
pub trait Energies<const N: usize, S: Scalar = f64>: Lagrangian<N, S> {
    /// The kinetic energy T.
    fn kinetic_energy(&self, state: &State<S, N>) -> S;

    /// The potential energy V, generalized if it contains velocities.
    fn potential_energy(&self, state: &State<S, N>) -> S;
}
