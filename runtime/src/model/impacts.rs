//! Impacts of constrained models.

use nalgebra::SVector;

use super::constraints::Constraints;
use super::state::State;
use crate::scalar::Scalar;

/// A constrained model that declares events: where the function of an event vanishes, two bodies may touch.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no impacts: it declares no constraints, or no events",
    note = "a model without constraints changes its velocities by itself: write `.then(|x| x.v[0] *= -0.8)`"
)]
pub trait Impacts<const N: usize, const C: usize, S: Scalar = f64>: Constraints<N, C, S> {
    /// The gradient ∂φ/∂q of an event function, and ∂φ/∂t.
    fn event_gradient(
        &self,
        state: &State<S, N>,
        inputs: &Self::Inputs,
        event: &usize,
        prepared: &Self::Prepared,
    ) -> (SVector<S, N>, S);
}

/// Returns the state behind an impact at which the function of an event has this gradient, by Newton's law of restitution.
///
/// The impulse is j ∂φ/∂q, with the impulses Gᵀ p of the constraints: M (v⁺ − v⁻) = j ∂φ/∂q + Gᵀ p and G v⁺ = G v⁻, with j such that
/// φ̇⁺ = −e φ̇⁻ (F. Pfeiffer & C. Glocker, *Multibody Dynamics with Unilateral Contacts* (1996), 8.2).
pub(super) fn impact<M, S, const N: usize, const C: usize>(
    model: &M,
    state: &State<S, N>,
    event: usize,
    restitution: S,
) -> State<S, N>
where
    M: Impacts<N, C, S> + ?Sized,
    S: Scalar,
{
    let prepared = model.prepare();
    let (gradient, rate) = model.event_gradient(state, &model.inputs(), &event, &prepared);
    let rest = SVector::from_element(S::zero());
    let response = model.constrained_response(state, &prepared, (&gradient, &rest), &[false; N]);
    let dot = |x: &SVector<S, N>| (0..N).fold(S::zero(), |sum, i| sum + gradient[i] * x[i]);
    let approach = dot(&state.v) + rate;
    let impulse = -(S::one() + restitution) * approach / dot(&response);
    let mut behind = *state;
    behind.v += response.map(|x| x * impulse);
    behind
}
