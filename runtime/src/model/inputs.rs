//! Inputs: forces, torques and other quantities that a controller sets.

use nalgebra::{SMatrix, SVector};

use super::quantities::Quantities;
use super::state::State;
use crate::scalar::Scalar;

/// A model with `U` inputs: the fields that its declaration marks `#[lagrangian(input)]`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a model with {N} coordinates and {U} inputs",
    note = "inputs are the fields that are marked `#[lagrangian(input)]`; the linearization of a model without inputs is \
            `StateSpace::free(&model, &state)`"
)]
pub trait Inputs<const N: usize, const U: usize, S: Scalar = f64>:
    Quantities<N, S, Inputs = SVector<S, U>>
{
    /// The names of the inputs, in order.
    const INPUTS: [&'static str; U];

    /// [`Lagrangian::input_jacobian`](crate::Lagrangian::input_jacobian) at these inputs.
    fn input_jacobian(&self, state: &State<S, N>, inputs: &SVector<S, U>) -> SMatrix<S, N, U>;
}
