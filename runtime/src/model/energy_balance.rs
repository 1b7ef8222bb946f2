//! The balance of the energy function along a motion.

use nalgebra::SVector;

use super::inputs::{Inputs, WithInputs};
use super::lagrangian::Lagrangian;
use super::state::State;
use crate::scalar::Scalar;

/// A model whose declaration has the clause `energy_balance`: dh/dt = Q·q̇ − ∂L/∂t.
#[diagnostic::on_unimplemented(
    message = "the rate of the energy of `{Self}` is not known",
    note = "write the clause `energy_balance` in its declaration"
)]
pub trait EnergyBalance<const N: usize, S: Scalar = f64>: Lagrangian<N, S> {
    /// The rate Q·q̇ − ∂L/∂t of the energy function h along every motion: the power of the generalized forces, and what
    /// supports that move by themselves, and parameters that depend on time, put into the system (Whittaker, Analytical
    /// Dynamics, 1937, section 41).
    fn energy_rate(&self, state: &State<S, N>) -> S;

    /// The power Q·q̇ of the generalized forces.
    fn power(&self, state: &State<S, N>) -> S {
        self.generalized_forces(state).dot(&state.v)
    }
}

/// The same under inputs that vary in time.
///
/// [`WithInputs`](crate::WithInputs) has it under constant inputs.
#[diagnostic::on_unimplemented(
    message = "the rate of the energy of `{Self}` is not known",
    note = "write the clause `energy_balance` in its declaration"
)]
pub trait EnergyBalanceWith<const N: usize, const U: usize, S: Scalar = f64>:
    Inputs<N, U, S> + EnergyBalance<N, S>
{
    /// The rate Q·q̇ − ∂L/∂t of the energy function under these inputs, whose own rates are not part of it.
    fn energy_rate_with(&self, state: &State<S, N>, inputs: &SVector<S, U>) -> S;
}

impl<M, S, const N: usize, const U: usize> EnergyBalance<N, S> for WithInputs<'_, M, S, U>
where
    M: EnergyBalanceWith<N, U, S> + ?Sized,
    S: Scalar,
{
    fn energy_rate(&self, state: &State<S, N>) -> S {
        self.model.energy_rate_with(state, &self.inputs)
    }
}
