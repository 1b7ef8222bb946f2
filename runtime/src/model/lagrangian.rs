//! Systems that have a Lagrangian.

use nalgebra::{SMatrix, SVector};

use super::equations_of_motion::EquationsOfMotion;
use super::generalized_coordinates::GeneralizedCoordinates;
use super::linearization::Linearization;
use super::owned_equations::OwnedEquations;
use super::state::State;
use crate::linalg::Factorization;
use crate::scalar::Scalar;

/// A system with the equations of motion of Lagrange, d/dt (∂L/∂q̇) − ∂L/∂q = Q (4.6).
///
/// `#[derive(Lagrangian)]` implements it; a model can also be written by hand against it. All
/// methods are functions of the state and the parameters, do not allocate, and return NaN or infinity
/// where the declaration has no value.
pub trait Lagrangian<const N: usize, S: Scalar = f64>: GeneralizedCoordinates<N> {
    /// Quantities that depend on parameters only; `()` for a model written by hand that has none.
    type Prepared: Clone + core::fmt::Debug;

    /// The Lagrangian function L = T − V.
    fn lagrangian(&self, state: &State<S, N>) -> S;

    /// The energy function h = Σ pᵢ q̇ᵢ − L: conserved where L does not contain the time and no
    /// generalized force does work. It is T + V only if T is quadratic in q̇ and V does not contain q̇.
    fn energy(&self, state: &State<S, N>) -> S;

    /// The generalized momenta p = ∂L/∂q̇.
    fn momenta(&self, state: &State<S, N>) -> SVector<S, N>;

    /// The mass matrix M = ∂²L/∂q̇².
    fn mass_matrix(&self, state: &State<S, N>) -> SMatrix<S, N, N>;

    /// The forcing f in M q̈ = f: all terms of the equations of motion but M q̈.
    fn forcing(&self, state: &State<S, N>) -> SVector<S, N>;

    /// The generalized forces Q, from the clauses `force` and `dissipation`.
    fn generalized_forces(&self, state: &State<S, N>) -> SVector<S, N>;

    /// The accelerations q̈.
    fn accelerations(&self, state: &State<S, N>) -> SVector<S, N>;

    /// Computes the quantities that depend on parameters only (invariants of the integration), for
    /// [`accelerations_prepared`](Self::accelerations_prepared) and
    /// [`inverse_dynamics_prepared`](Self::inverse_dynamics_prepared). [`dynamics`](Self::dynamics) calls it once.
    fn prepare(&self) -> Self::Prepared;

    /// The accelerations q̈, given the result of [`prepare`](Self::prepare) for the same parameters.
    fn accelerations_prepared(
        &self,
        state: &State<S, N>,
        _prepared: &Self::Prepared,
    ) -> SVector<S, N> {
        self.accelerations(state)
    }

    /// Inverse dynamics: the forces M q̈ − f that have to act in addition to Q for these accelerations.
    fn inverse_dynamics(&self, state: &State<S, N>, accelerations: &SVector<S, N>)
    -> SVector<S, N>;

    /// Inverse dynamics, given the result of [`prepare`](Self::prepare) for the same parameters: what a controller
    /// evaluates in its loop.
    fn inverse_dynamics_prepared(
        &self,
        state: &State<S, N>,
        accelerations: &SVector<S, N>,
        _prepared: &Self::Prepared,
    ) -> SVector<S, N> {
        self.inverse_dynamics(state, accelerations)
    }

    /// The derivatives of the accelerations with respect to q, q̇ and t.
    ///
    /// In the first-order form ẋ = A x + B u, x = (q, q̇), they are the lower rows of A, below
    /// (0 1); the lower rows of B are [`Inputs::input_jacobian`](crate::Inputs::input_jacobian).
    ///
    /// For more than a few coupled coordinates they are solved for with a numerical factorization of M.
    /// Near a singularity of M their accuracy is then what [`Factorization::relative_pivots`] says.
    fn linearize(&self, state: &State<S, N>) -> Linearization<S, N>;

    /// For each coordinate, a measure of the conditioning of M q̈ = f: near 1 if it is well-conditioned,
    /// 0 or NaN if M is singular. Its inverse estimates the factor by which the rounding errors of what is solved
    /// are amplified in [`accelerations`](Self::accelerations); those of the forcing are not part of it.
    ///
    /// It looks at how the accelerations are solved for: each pivot is compared with the terms whose rounding errors it has.
    /// Through quasi-velocities w = E q̇ the pivots are the determinants of the diagonal blocks of E, such as sin θ, and the
    /// pivots of their inertia; for articulated bodies those of the elimination along the tree; else those of the
    /// factorization of M. Of several pivots of one coordinate it is the product. Where M is indefinite and regular, as for
    /// ẋ ẏ, and is factored numerically, it is the reciprocal of (|M⁻¹| |M|)ᵢᵢ.
    fn relative_pivots(&self, state: &State<S, N>) -> SVector<S, N> {
        Factorization::new(self.mass_matrix(state)).relative_pivots()
    }

    /// The equations of motion, for an integrator.
    fn dynamics(&self) -> EquationsOfMotion<'_, Self, S, N>
    where
        Self: Sized,
    {
        EquationsOfMotion::new(self)
    }

    /// The equations of motion together with the model, so that a reaction to an event can change its parameters.
    fn into_dynamics(self) -> OwnedEquations<Self, S, N>
    where
        Self: Sized,
    {
        OwnedEquations::new(self)
    }
}

/// The energies T and V of a system that is declared by them.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no kinetic and potential energy apart",
    note = "declare `kinetic = …` and `potential = …` in place of `lagrangian = …`"
)]
pub trait Energies<const N: usize, S: Scalar = f64>: Lagrangian<N, S> {
    /// The kinetic energy T.
    fn kinetic_energy(&self, state: &State<S, N>) -> S;

    /// The potential energy V, generalized if it contains velocities.
    fn potential_energy(&self, state: &State<S, N>) -> S;
}
