//! Models whose accelerations are differentiated by parameters.

use nalgebra::SMatrix;

use super::quantities::Quantities;
use super::state::State;
use crate::scalar::Scalar;

/// A model whose declaration has the clause `sensitivities`: the derivatives of q̈ by `P` components of parameters.
///
/// From M q̈ = f follows M ∂q̈/∂π = −∂(M q̈ − f)/∂π at fixed q̈, which is solved with the factors by which q̈ is solved
/// for. [`StateTransition`](crate::StateTransition) has the derivatives of a whole motion by parameters.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no derivatives by parameters",
    note = "write the clause `sensitivities`, or `sensitivities(m, l)` with some parameters, in its declaration"
)]
pub trait Sensitivities<const N: usize, const P: usize, S: Scalar = f64>: Quantities<N, S> {
    /// The names of the parameters, component by component.
    const PARAMETERS: [&'static str; P];

    /// [`Lagrangian::sensitivities`](crate::Lagrangian::sensitivities) under these inputs.
    fn sensitivities(&self, state: &State<S, N>, inputs: &Self::Inputs) -> SMatrix<S, N, P>;
}
