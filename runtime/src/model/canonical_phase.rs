//! Coordinates and momenta, without the time.

use nalgebra::SVector;

use crate::linalg::{IntoVector, LaneStates, VectorSpace};
use crate::scalar::{Lanes, Scalar};

/// Coordinates q and momenta p of a system with `N` degrees of freedom: the state of [Hamilton's
/// equations](crate::CanonicalEquations).
///
/// In a derivative, `q` holds q̇ and `p` holds ṗ. The components are the coordinates, then the momenta.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "S: serde::Serialize",
        deserialize = "S: serde::Deserialize<'de>"
    ))
)]
pub struct CanonicalPhase<S: Scalar, const N: usize> {
    /// Coordinates q.
    pub q: SVector<S, N>,
    /// Momenta p = ∂L/∂q̇.
    pub p: SVector<S, N>,
}

impl<S: Scalar, const N: usize> CanonicalPhase<S, N> {
    /// Creates a phase from coordinates and momenta, given as arrays or vectors.
    pub fn new(q: impl IntoVector<S, N>, p: impl IntoVector<S, N>) -> Self {
        Self {
            q: q.into_vector(),
            p: p.into_vector(),
        }
    }
}

impl<S: Scalar, const N: usize> VectorSpace<S> for CanonicalPhase<S, N> {
    #[inline]
    fn add_scaled(&mut self, factor: S, other: &Self) {
        self.q.add_scaled(factor, &other.q);
        self.p.add_scaled(factor, &other.p);
    }

    #[inline]
    fn map(&self, mut function: impl FnMut(S) -> S) -> Self {
        Self {
            q: self.q.map(&mut function),
            p: self.p.map(&mut function),
        }
    }

    #[inline]
    fn zip_map(&self, other: &Self, mut function: impl FnMut(S, S) -> S) -> Self {
        Self {
            q: VectorSpace::zip_map(&self.q, &other.q, &mut function),
            p: VectorSpace::zip_map(&self.p, &other.p, &mut function),
        }
    }

    #[inline]
    fn components(&self) -> impl Iterator<Item = S> + '_ {
        self.q.iter().chain(self.p.iter()).copied()
    }
}

impl<const L: usize, const N: usize> LaneStates<L> for CanonicalPhase<Lanes<L>, N> {
    type Lane = CanonicalPhase<f64, N>;

    #[inline]
    fn broadcast(state: &Self::Lane) -> Self {
        Self {
            q: LaneStates::broadcast(&state.q),
            p: LaneStates::broadcast(&state.p),
        }
    }

    #[inline]
    fn lane(&self, lane: usize) -> Self::Lane {
        CanonicalPhase {
            q: self.q.lane(lane),
            p: self.p.lane(lane),
        }
    }

    #[inline]
    fn set_lane(&mut self, lane: usize, state: &Self::Lane) {
        self.q.set_lane(lane, &state.q);
        self.p.set_lane(lane, &state.p);
    }
}
