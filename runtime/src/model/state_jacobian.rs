//! Models whose accelerations are differentiated by the state.

use super::linearization::Linearization;
use super::quantities::Quantities;
use super::state::State;
use crate::scalar::Scalar;

/// A model without constraints: its accelerations have derivatives with respect to each component of the state.
#[diagnostic::on_unimplemented(
    message = "the coordinates of `{Self}` are constrained, and not all of them can be perturbed",
    note = "linearize in independent coordinates: `TangentSpace::at(&model, &state)` chooses them for `StateSpace::reduced`, and \
            `EquilibriumSearch::constrained(&model)` finds equilibria"
)]
pub trait StateJacobian<const N: usize, S: Scalar = f64>: Quantities<N, S> {
    /// [`Lagrangian::linearize`](crate::Lagrangian::linearize) at these inputs, which are held.
    fn linearize(&self, state: &State<S, N>, inputs: &Self::Inputs) -> Linearization<S, N>;
}
