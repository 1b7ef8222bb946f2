//! Models whose inputs differ from their fields.

use nalgebra::SVector;

use super::generalized_coordinates::GeneralizedCoordinates;
use super::inputs::Inputs;
use crate::scalar::Scalar;

/// A model under other, constant inputs; made by [`Lagrangian::with_inputs`](crate::Lagrangian::with_inputs).
#[derive(Debug)]
pub struct WithInputs<'a, M: ?Sized, S: Scalar, const U: usize> {
    pub(super) model: &'a M,
    pub(super) inputs: SVector<S, U>,
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
