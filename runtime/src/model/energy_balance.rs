//! The balance of the energy function along a motion.

use super::quantities::Quantities;
use super::state::State;
use crate::scalar::Scalar;

/// A model whose declaration has the clause `energy_balance`: dh/dt = Q·q̇ − ∂L/∂t.
#[diagnostic::on_unimplemented(
    message = "the rate of the energy of `{Self}` is not known",
    note = "write the clause `energy_balance` in its declaration"
)]
pub trait EnergyBalance<const N: usize, S: Scalar = f64>: Quantities<N, S> {
    /// [`Lagrangian::energy_rate`](crate::Lagrangian::energy_rate) under these inputs.
    fn energy_rate(&self, state: &State<S, N>, inputs: &Self::Inputs) -> S;
}
