//! Outputs: quantities that a declaration computes for the user.

use nalgebra::SVector;

use super::inputs::{Inputs, WithInputs};
use super::lagrangian::Lagrangian;
use super::state::State;
use crate::scalar::Scalar;

/// A system whose declaration has `output(name = expression, …)`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no outputs",
    note = "write the clause `output(name = expression)` in its declaration"
)]
pub trait Outputs<const N: usize, S: Scalar = f64>: Lagrangian<N, S> {
    /// A struct with one field for each output, named as declared.
    type Outputs;

    /// All outputs at a state. Accelerations in them are those of
    /// [`accelerations`](Lagrangian::accelerations).
    fn outputs(&self, state: &State<S, N>) -> Self::Outputs;
}

/// A system with outputs and inputs: the outputs under inputs that vary in time.
///
/// [`WithInputs`](crate::WithInputs) has the outputs under constant inputs.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no outputs",
    note = "write the clause `output(name = expression)` in its declaration"
)]
pub trait OutputsWith<const N: usize, const U: usize, S: Scalar = f64>:
    Inputs<N, U, S> + Outputs<N, S>
{
    /// All outputs at a state under these inputs.
    fn outputs_with(&self, state: &State<S, N>, inputs: &SVector<S, U>) -> Self::Outputs;
}

impl<M, S, const N: usize, const U: usize> Outputs<N, S> for WithInputs<'_, M, S, U>
where
    M: OutputsWith<N, U, S> + ?Sized,
    S: Scalar,
{
    type Outputs = M::Outputs;

    fn outputs(&self, state: &State<S, N>) -> Self::Outputs {
        self.model.outputs_with(state, &self.inputs)
    }
}
