//! Inputs: forces, torques and other quantities that a controller sets.

use nalgebra::{SMatrix, SVector};

use super::generalized_coordinates::GeneralizedCoordinates;
use super::lagrangian::Lagrangian;
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

/// A model under other, constant inputs; made by [`Lagrangian::with_inputs`](crate::Lagrangian::with_inputs).
#[derive(Debug)]
pub struct WithInputs<'a, M: ?Sized, S: Scalar, const U: usize> {
    model: &'a M,
    inputs: SVector<S, U>,
}

impl<'a, M: ?Sized, S: Scalar, const U: usize> WithInputs<'a, M, S, U> {
    pub(super) const fn new(model: &'a M, inputs: SVector<S, U>) -> Self {
        Self { model, inputs }
    }
}

impl<M, S, const N: usize, const U: usize> GeneralizedCoordinates<N> for WithInputs<'_, M, S, U>
where
    M: Inputs<N, U, S> + ?Sized,
    S: Scalar,
{
    const COORDINATES: [&'static str; N] = M::COORDINATES;
    const ANGLES: [bool; N] = M::ANGLES;
    const PERIODS: [u32; N] = M::PERIODS;
    const IGNORABLE: [bool; N] = M::IGNORABLE;
    const SINGULARITIES: [&'static [usize]; N] = M::SINGULARITIES;
    const STAYS_REGULAR: bool = M::STAYS_REGULAR;
    const POLES: &'static [usize] = M::POLES;
}

impl<M, S, const N: usize, const U: usize> Lagrangian<N, S> for WithInputs<'_, M, S, U>
where
    M: Inputs<N, U, S>,
    S: Scalar,
{
    type Model = M;

    fn model(&self) -> &M {
        self.model
    }

    #[inline]
    fn inputs(&self) -> SVector<S, U> {
        self.inputs
    }
}
