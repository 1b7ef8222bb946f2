//! Outputs: quantities that a declaration computes for the user.

use super::quantities::Quantities;
use super::state::State;
use crate::scalar::Scalar;

/// A model whose declaration has `output(name = expression, …)`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no outputs",
    note = "write the clause `output(name = expression)` in its declaration"
)]
pub trait Outputs<const N: usize, S: Scalar = f64>: Quantities<N, S> {
    /// A struct with one field for each output, named as declared.
    type Outputs;

    /// [`Lagrangian::outputs`](crate::Lagrangian::outputs) under these inputs.
    fn outputs(&self, state: &State<S, N>, inputs: &Self::Inputs) -> Self::Outputs;
}
