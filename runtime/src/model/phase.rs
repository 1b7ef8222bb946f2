//! Coordinates and velocities, without the time.

use nalgebra::SVector;

use super::state::State;
use crate::integrate::{At, TypicalSizes};
use crate::linalg::lane_select::{is_zero, one_if_zero};
use crate::linalg::{
    ErrorTolerance, IntoVector, LaneStates, VectorSpace, lanes_by_fields, operations_by_fields,
};
use crate::scalar::{Lanes, Scalar};

/// Coordinates q and velocities q̇ of a system with `N` degrees of freedom, and additional states z: the state that an
/// integrator advances. Together with a time it is a [`State`].
///
/// A model by itself has no additional states; `z` is `()`. Under a controller with `K` states `z` is an
/// `SVector<S, K>`, under a sampled controller it is [`Sampled`](crate::laws::Sampled), and it also holds the
/// [ignorable coordinates](crate::Reconstruction) of a reduced model.
///
/// In the derivative of a phase, `q` holds the velocities and `v` the accelerations. The components are the
/// coordinates, the velocities, then the components of `z`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Phase<S: Scalar, const N: usize, Z = ()> {
    /// Coordinates q.
    pub q: SVector<S, N>,
    /// Velocities q̇.
    pub v: SVector<S, N>,
    /// Additional states that are integrated together with them.
    pub z: Z,
}

impl<S: Scalar, const N: usize> Phase<S, N> {
    /// Creates a phase from coordinates and velocities, given as arrays or vectors.
    pub fn new(q: impl IntoVector<S, N>, v: impl IntoVector<S, N>) -> Self {
        Self {
            q: q.into_vector(),
            v: v.into_vector(),
            z: (),
        }
    }

    /// Returns the coordinates and velocities with additional states.
    #[inline]
    pub(crate) fn with<Z>(self, z: Z) -> Phase<S, N, Z> {
        let Self { q, v, z: () } = self;
        Phase { q, v, z }
    }
}

impl<S: Scalar, const N: usize, Z> Phase<S, N, Z> {
    /// Returns the coordinates and velocities alone.
    #[inline]
    #[must_use]
    pub fn motion(&self) -> Phase<S, N> {
        Phase {
            q: self.q,
            v: self.v,
            z: (),
        }
    }

    /// Returns the state of the mechanical system at time `t`.
    #[inline]
    #[must_use]
    pub(crate) fn at_time(&self, t: S) -> State<S, N> {
        At {
            t,
            x: self.motion(),
        }
    }
}

impl<S: Scalar, const N: usize> From<State<S, N>> for Phase<S, N> {
    #[inline]
    fn from(state: State<S, N>) -> Self {
        state.x
    }
}

impl<S: Scalar, const N: usize, Z: VectorSpace<S>> VectorSpace<S> for Phase<S, N, Z> {
    operations_by_fields! { q, v, z }

    #[inline]
    fn components(&self) -> impl Iterator<Item = S> + '_ {
        // Slices, whose lengths the compiler knows, for the iterators of nalgebra are loops that it does not unroll.
        let (q, v) = (self.q.as_slice(), self.v.as_slice());
        q.iter().chain(v).copied().chain(self.z.components())
    }

    /// Updates first all coordinates, then all velocities: in vectors of both, coordinates would wait for
    /// accelerations.
    #[inline]
    fn add_multiples(&self, terms: &[(usize, f64)], sums: &mut [Self]) {
        for (index, factor) in terms {
            if let Some(sum) = sums.get_mut(*index) {
                sum.q.add_scaled(S::from_f64(*factor), &self.q);
            }
        }
        for (index, factor) in terms {
            if let Some(sum) = sums.get_mut(*index) {
                sum.v.add_scaled(S::from_f64(*factor), &self.v);
                sum.z.add_scaled(S::from_f64(*factor), &self.z);
            }
        }
    }

    #[inline]
    fn fold<T>(&self, start: T, mut function: impl FnMut(T, S) -> T) -> T {
        let motion = [&self.q, &self.v].into_iter().fold(start, |value, half| {
            let numbers = half.as_slice().iter();
            numbers.fold(value, |value, x| function(value, *x))
        });
        self.z.fold(motion, function)
    }

    #[inline]
    fn allowed_error(&self, tolerance: &ErrorTolerance<S>) -> Self {
        Self {
            q: self.q.map(|q| tolerance.of_coordinate(q.abs())),
            v: self.v.map(|v| tolerance.of_velocity(v.abs())),
            z: self.z.allowed_error(tolerance),
        }
    }

    fn rate(&self, sizes: &Self) -> Option<S> {
        Some(rate(self, sizes))
    }
}

/// Returns the largest of |q̇ᵢ|/sᵢ and √(|q̈ᵢ|/sᵢ) over all coordinates with a nonzero size sᵢ.
fn rate<S: Scalar, const N: usize, Z>(derivative: &Phase<S, N, Z>, sizes: &Phase<S, N, Z>) -> S {
    let largest = |slopes: &SVector<S, N>| {
        let pairs = slopes.iter().zip(sizes.q.iter());
        pairs.fold(S::zero(), |most, (slope, size)| {
            let sized = S::one() - is_zero(*size);
            most.max(slope.abs() / one_if_zero(*size) * sized)
        })
    };
    largest(&derivative.q).max(largest(&derivative.v).sqrt())
}

lanes_by_fields! {
    [const N: usize, Z: LaneStates<L>]
    Phase<Lanes<L>, N, Z> => Phase<f64, N, Z::Lane> { q, v, z }
}

impl<S: Scalar, const N: usize> TypicalSizes<Phase<S, N>> for [f64; N] {
    fn into_state(self) -> Phase<S, N> {
        let sizes = SVector::from(self.map(S::from_f64));
        Phase::new(sizes, sizes)
    }
}

/// The sizes of the coordinates, and of the additional components.
impl<S: Scalar, const N: usize, const K: usize> TypicalSizes<Phase<S, N, SVector<S, K>>>
    for ([f64; N], [f64; K])
{
    fn into_state(self) -> Phase<S, N, SVector<S, K>> {
        let (sizes, beside) = self;
        let phase: Phase<S, N> = sizes.into_state();
        phase.with(SVector::from(beside.map(S::from_f64)))
    }
}
