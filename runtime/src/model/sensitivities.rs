//! Models whose accelerations are differentiated by parameters.

use nalgebra::SMatrix;

use super::constraints::Constraints;
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

/// A model with constraints whose declaration has the clause `sensitivities`: the derivatives of q̈ and of the multipliers λ by `P`
/// components of parameters.
///
/// Both are one solution of the saddle point problem: with M q̈ = f + Gᵀ λ and G q̈ + γ = 0, the derivatives of these equations by π
/// at fixed q̈ and λ are the right-hand sides.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no multipliers that are differentiated by parameters",
    note = "write constraints and the clause `sensitivities`, or `sensitivities(m, l)` with some parameters, in its declaration"
)]
pub trait MultiplierSensitivities<const N: usize, const C: usize, const P: usize, S: Scalar = f64>:
    Sensitivities<N, P, S> + Constraints<N, C, S>
{
    /// ∂q̈/∂π and ∂λ/∂π under these inputs; see
    /// [`Lagrangian::multiplier_sensitivities`](crate::Lagrangian::multiplier_sensitivities).
    fn accelerations_and_multipliers_by_parameters(
        &self,
        state: &State<S, N>,
        inputs: &Self::Inputs,
    ) -> (SMatrix<S, N, P>, SMatrix<S, C, P>);
}

/// Returns the rows of the multipliers, the last ones.
#[inline]
pub fn rows_of_multipliers<S: Scalar, const C: usize, const K: usize, const P: usize>(
    matrix: &SMatrix<S, K, P>,
) -> SMatrix<S, C, P> {
    let first = K.saturating_sub(C);
    SMatrix::from_fn(|i, j| matrix[(first + i, j)])
}
