//! A singularity with the names of its coordinates.

use core::marker::PhantomData;

use super::generalized_coordinates::GeneralizedCoordinates;
use super::state::State;
use crate::integrate::Singularity;
use crate::scalar::Scalar;

/// Returns the report of a coordinate, with the coordinates on which the singularity of its block of the mass matrix
/// depends.
pub(super) fn named<M, S, const N: usize>(
    coordinate: usize,
    relative_pivot: f64,
    state: &State<S, N>,
) -> Singularity
where
    M: GeneralizedCoordinates<N> + ?Sized,
    S: Scalar,
{
    let dependencies = StaticNames::<M, N>::SINGULARITIES
        .get(coordinate)
        .copied()
        .unwrap_or_default();
    Singularity::new(
        relative_pivot,
        coordinate,
        StaticNames::<M, N>::COORDINATES,
        dependencies,
        |i| state.q.get(i).map_or(f64::NAN, |value| value.smallest()),
    )
}

/// The constants of a system as `'static` slices.
struct StaticNames<M: ?Sized, const N: usize>(PhantomData<M>);

impl<M: GeneralizedCoordinates<N> + ?Sized, const N: usize> StaticNames<M, N> {
    const COORDINATES: &'static [&'static str] = &M::COORDINATES;
    const SINGULARITIES: &'static [&'static [usize]] = &M::SINGULARITIES;
}
