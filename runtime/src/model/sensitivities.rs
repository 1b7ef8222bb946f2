//! Models whose accelerations are differentiated by parameters.

use nalgebra::{SMatrix, SVector};

use super::inputs::{Inputs, WithInputs};
use super::lagrangian::Lagrangian;
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
pub trait Sensitivities<const N: usize, const P: usize, S: Scalar = f64>: Lagrangian<N, S> {
    /// The names of the parameters, component by component.
    const PARAMETERS: [&'static str; P];

    /// The derivatives ∂q̈ᵢ/∂πⱼ in row i, column j, at fixed q, q̇, t and inputs.
    fn sensitivities(&self, state: &State<S, N>) -> SMatrix<S, N, P>;
}

/// The same under inputs that vary in time.
///
/// [`WithInputs`](crate::WithInputs) has them under constant inputs.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no derivatives by parameters",
    note = "write the clause `sensitivities`, or `sensitivities(m, l)` with some parameters, in its declaration"
)]
pub trait SensitivitiesWith<const N: usize, const U: usize, const P: usize, S: Scalar = f64>:
    Inputs<N, U, S> + Sensitivities<N, P, S>
{
    /// The derivatives ∂q̈ᵢ/∂πⱼ under these inputs.
    fn sensitivities_with(&self, state: &State<S, N>, inputs: &SVector<S, U>) -> SMatrix<S, N, P>;
}

impl<M, S, const N: usize, const U: usize, const P: usize> Sensitivities<N, P, S>
    for WithInputs<'_, M, S, U>
where
    M: SensitivitiesWith<N, U, P, S> + ?Sized,
    S: Scalar,
{
    const PARAMETERS: [&'static str; P] = M::PARAMETERS;

    fn sensitivities(&self, state: &State<S, N>) -> SMatrix<S, N, P> {
        self.model.sensitivities_with(state, &self.inputs)
    }
}
