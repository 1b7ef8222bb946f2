//! Impacts.

use nalgebra::SVector;

use super::constraints::Constraints;
use super::quantities::Quantities;
use super::state::State;
use crate::linalg::Factorization;
use crate::scalar::Scalar;

/// A model that declares events: where the function of an event vanishes, two bodies may touch, and
/// [`Lagrangian::impact`](crate::Lagrangian::impact) has the state after the impact.
///
/// ```
/// use lagrangian::prelude::*;
///
/// /// A trolley with a hanging load runs against a bumper.
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     coordinates(x, theta),
///     define(load = [x + l * sin(theta), -l * cos(theta)]),
///     kinetic = 0.5 * trolley * dot(x).powi(2) + 0.5 * m * dot(load).norm_squared(),
///     potential = m * g * load.y,
///     event(bumper = end - x),
/// )]
/// struct Crane { trolley: f64, m: f64, l: f64, g: f64, end: f64 }
///
/// let crane = Crane { trolley: 2.0, m: 1.0, l: 0.5, g: 9.81, end: 1.0 };
/// let before = State::new(0.0, [1.0, 0.3], [2.0, 0.1]);
/// let after = crane.impact(&before, Crane::BUMPER, 1.0);
/// // The trolley returns, and the load is thrown up. The momentum of θ and the energy are kept.
/// assert_eq!(after.v[0], -2.0);
/// assert!(after.v[1] > 7.0);
/// assert!((crane.momenta(&after)[1] - crane.momenta(&before)[1]).abs() < 1e-15);
/// assert!((crane.energy(&after) - crane.energy(&before)).abs() < 1e-14);
/// ```
///
/// With constraints:
///
/// ```
/// use lagrangian::prelude::*;
///
/// /// A ball on a rod falls onto a table beside the pivot.
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     coordinates(x, y),
///     kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
///     potential = m * g * y,
///     constraint(rod = x.powi(2) + y.powi(2) - l.powi(2)),
///     event(table = y + height),
/// )]
/// struct Flail { m: f64, g: f64, l: f64, height: f64 }
///
/// let flail = Flail { m: 1.0, g: 9.81, l: 1.0, height: 0.5 };
/// let start = State::new(0.0, [1.0, 0.0], [0.0, 0.0]);
/// let end = Problem::new(&flail, start)
///     .on([Flail::TABLE])
///     .falling()
///     .then(|x| *x = flail.impact(x, Flail::TABLE, 0.8))
///     .solve(2.0, Dop853::new())?;
/// // Energy is lost at each impact, and the rod keeps its length.
/// assert!(flail.energy(&end) < 0.0);
/// assert!((end.q[0].hypot(end.q[1]) - 1.0).abs() < 1e-15);
/// # Ok::<(), IntegrationError>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no impacts: it declares no events, or one that depends on an external function without a derivative",
    note = "write the clause `event(name = expression)` with the distance of the two bodies in its declaration"
)]
pub trait Impacts<const N: usize, S: Scalar = f64>: Quantities<N, S> {
    /// The gradient ∂φ/∂q of an event function, and ∂φ/∂t.
    fn event_gradient(
        &self,
        state: &State<S, N>,
        inputs: &Self::Inputs,
        event: &usize,
        prepared: &Self::Prepared,
    ) -> (SVector<S, N>, S);

    /// The change δ of the velocities by a generalized impulse p: M δ = p, or with constraints M δ = p + Gᵀ λ and G δ = 0. By
    /// default there are no constraints.
    fn impulse_response(
        &self,
        state: &State<S, N>,
        prepared: &Self::Prepared,
        impulse: &SVector<S, N>,
    ) -> SVector<S, N> {
        Factorization::new(self.mass_matrix(state, prepared)).solve(impulse)
    }
}

/// The change of the velocities of a model with constraints by an impulse, for emitted code.
pub fn constrained_impulse_response<M, S, const N: usize, const C: usize>(
    model: &M,
    state: &State<S, N>,
    prepared: &M::Prepared,
    impulse: &SVector<S, N>,
) -> SVector<S, N>
where
    M: Constraints<N, C, S>,
    S: Scalar,
{
    let residuals = SVector::from_element(S::zero());
    model.constrained_response(state, prepared, (impulse, &residuals), &[false; N], C)
}

/// Returns the state after an impact at which the function of an event has this gradient, by Newton's law of restitution.
///
/// The impulse is j ∂φ/∂q, with the impulses Gᵀ p of the constraints: M (v⁺ − v⁻) = j ∂φ/∂q + Gᵀ p and G v⁺ = G v⁻, with j
/// such that φ̇⁺ = −e φ̇⁻ (F. Pfeiffer & C. Glocker, *Multibody Dynamics with Unilateral Contacts* (1996), 8.2).
pub(super) fn impact<M, S, const N: usize>(
    model: &M,
    state: &State<S, N>,
    event: usize,
    restitution: S,
) -> State<S, N>
where
    M: Impacts<N, S> + ?Sized,
    S: Scalar,
{
    let prepared = model.prepare();
    let (gradient, rate) = model.event_gradient(state, &model.inputs(), &event, &prepared);
    let response = model.impulse_response(state, &prepared, &gradient);
    let dot = |x: &SVector<S, N>| (0..N).fold(S::zero(), |sum, i| sum + gradient[i] * x[i]);
    let approach = dot(&state.v) + rate;
    let impulse = -(S::one() + restitution) * approach / dot(&response);
    let mut behind = *state;
    behind.v += response.map(|x| x * impulse);
    behind
}
