//! Models with constraints.

use nalgebra::{SMatrix, SVector};

use super::quantities::Quantities;
use super::state::State;
use crate::scalar::Scalar;

/// A model with `C` constraints, component by component: d/dt (∂L/∂q̇) − ∂L/∂q = Q + Gᵀ λ.
///
/// The first [`HOLONOMIC`](Self::HOLONOMIC) of them are holonomic, g(q, t) = 0, and hold for the velocities as w = ġ =
/// G q̇ + ∂g/∂t = 0; the others are nonholonomic, w = A(q, t) q̇ + a(q, t) = 0 with G = A. From either follows
/// G q̈ + γ = 0. With M q̈ = f + Gᵀ λ these are as many equations as there are accelerations and multipliers (E. T.
/// Whittaker, *Analytical Dynamics*, 4th edition (1937), 25 and 87).
///
/// Gᵀ λ are the generalized forces of the constraints, with the power λᵀ G q̇. The unit of λ is therefore the unit of power over the
/// unit of w. For a distance λ is a force, positive where it pushes the ends apart; for a loop that is closed by `tip - anchor`
/// it is the force on the body of the tip, in the axes of the vector; for the velocity of a point of contact it is the force of
/// friction on the rolling body, in the axes of the velocity. Where constraints depend on each other, λ is not unique: see
/// [`compliances`](Self::compliances).
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a model of {N} coordinates with constraints",
    note = "write the clause `constraint(name = …)` or `nonholonomic(name = …)` in its declaration"
)]
pub trait Constraints<const N: usize, const C: usize, S: Scalar = f64>: Quantities<N, S> {
    /// The names of the constraints, component by component, the holonomic ones first.
    const CONSTRAINTS: [&'static str; C];

    /// The number of holonomic constraints.
    const HOLONOMIC: usize;

    /// Whether each of the constraints restricts the coordinates: a holonomic one does, and a nonholonomic one that can be
    /// integrated to a relation of coordinates, alone or together with others (the theorem of Frobenius: R. L. Bryant et
    /// al., *Exterior Differential Systems* (1991), II.1). The latter is holonomic in disguise.
    const INTEGRABLE: [bool; C];

    /// For each coordinate, whether its column of G contains neither coordinates nor the time: it has the same value in every
    /// configuration. [`DegreesOfFreedom`](crate::assembly::DegreesOfFreedom) proposes such coordinates as dependent ones.
    const CONSTANT_COLUMNS: [bool; N] = [false; N];

    /// A lower bound of the degrees of freedom: the number of coordinates less the number of constraints that are independent at
    /// almost all coordinates. [`Lagrangian::degrees_of_freedom`](crate::Lagrangian::degrees_of_freedom) counts them at a
    /// state.
    const MIN_DEGREES_OF_FREEDOM: usize = N.saturating_sub(C);

    /// The accelerations q̈ and the multipliers λ under these inputs.
    fn accelerations_and_multipliers(
        &self,
        state: &State<S, N>,
        inputs: &Self::Inputs,
        prepared: &Self::Prepared,
    ) -> (SVector<S, N>, SVector<S, C>);

    /// g(q, t) of the holonomic constraints, and 0 for the others.
    fn constraint_positions(&self, state: &State<S, N>, prepared: &Self::Prepared)
    -> SVector<S, C>;

    /// w = G q̇ + a.
    fn constraint_velocities(
        &self,
        state: &State<S, N>,
        prepared: &Self::Prepared,
    ) -> SVector<S, C>;

    /// G = ∂w/∂q̇.
    fn constraint_jacobian(
        &self,
        state: &State<S, N>,
        prepared: &Self::Prepared,
    ) -> SMatrix<S, C, N>;

    /// The change δ of coordinates or of velocities with M δ = p + Gᵀ λ and G δ = −r, for an impulse p and residuals r of the first
    /// constraints, `count` in number, without a change of those that are held. Coordinates move freely along what only velocities are
    /// restricted by.
    fn constrained_response(
        &self,
        state: &State<S, N>,
        prepared: &Self::Prepared,
        impulse_and_residuals: (&SVector<S, N>, &SVector<S, C>),
        held: &[bool; N],
        count: usize,
    ) -> SVector<S, N>;

    /// The compliances cᵢ of the constraints, deformations per unit of λ; 1 by default. Where constraints depend on each other,
    /// λ is not unique: of all λ with equal generalized forces Gᵀ λ the one is returned for which Σ cᵢ λᵢ² is least.
    fn compliances(&self, prepared: &Self::Prepared) -> SVector<S, C> {
        let _ = prepared;
        SVector::from_element(S::one())
    }

    /// γ in G q̈ + γ = 0.
    fn constraint_rates(&self, state: &State<S, N>, prepared: &Self::Prepared) -> SVector<S, C>;
}
