//! Coordinates and velocities, without the time.

use nalgebra::SVector;

use super::state::State;
use super::vector_pair::vector_pair;
use crate::integrate::{At, TypicalSizes};
use crate::linalg::lane_select::{is_zero, one_if_zero};
use crate::linalg::{ErrorTolerance, IntoVector, LaneStates, VectorSpace};
use crate::scalar::{Lanes, Scalar};

/// Coordinates q and velocities q̇ of a system with `N` degrees of freedom: the state that
/// an integrator steps. With a time it is a [`State`].
///
/// As the derivative of a phase, `q` holds the velocities and `v` the accelerations. Its components
/// are the coordinates, then the velocities.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "S: serde::Serialize",
        deserialize = "S: serde::Deserialize<'de>"
    ))
)]
pub struct Phase<S: Scalar, const N: usize> {
    /// Coordinates q.
    pub q: SVector<S, N>,
    /// Velocities q̇.
    pub v: SVector<S, N>,
}

impl<S: Scalar, const N: usize> Phase<S, N> {
    /// The state that has this phase at time `t`.
    #[inline]
    #[must_use]
    pub(crate) fn at(&self, t: S) -> State<S, N> {
        At { t, x: *self }
    }
}

impl<S: Scalar, const N: usize> From<State<S, N>> for Phase<S, N> {
    #[inline]
    fn from(state: State<S, N>) -> Self {
        state.x
    }
}

vector_pair!(Phase, v, {
    /// First to all coordinates, then to all velocities: as vectors of both, coordinates would wait for accelerations.
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
            }
        }
    }

    #[inline]
    fn fold<T>(&self, start: T, mut function: impl FnMut(T, S) -> T) -> T {
        let coordinates = self.q.iter().fold(start, |value, x| function(value, *x));
        self.v
            .iter()
            .fold(coordinates, |value, x| function(value, *x))
    }

    #[inline]
    fn allowed_error(&self, tolerance: &ErrorTolerance<S>) -> Self {
        Self {
            q: self.q.map(|q| tolerance.of_coordinate(q.abs())),
            v: self.v.map(|v| tolerance.of_velocity(v.abs())),
        }
    }

    fn rate(&self, sizes: &Self) -> Option<S> {
        Some(rate(self, sizes))
    }
});

/// The largest of |q̇ᵢ|/sᵢ and √(|q̈ᵢ|/sᵢ), where sᵢ is the size of a coordinate, as far as it is not zero.
fn rate<S: Scalar, const N: usize>(derivative: &Phase<S, N>, sizes: &Phase<S, N>) -> S {
    let largest = |slopes: &SVector<S, N>| {
        let pairs = slopes.iter().zip(sizes.q.iter());
        pairs.fold(S::zero(), |most, (slope, size)| {
            let sized = S::one() - is_zero(*size);
            most.max(slope.abs() / one_if_zero(*size) * sized)
        })
    };
    largest(&derivative.q).max(largest(&derivative.v).sqrt())
}

impl<S: Scalar, const N: usize> TypicalSizes<Phase<S, N>> for [f64; N] {
    fn into_state(self) -> Phase<S, N> {
        let sizes = SVector::from(self.map(S::from_f64));
        Phase { q: sizes, v: sizes }
    }
}
