//! Coordinates and momenta, without the time.

use nalgebra::SVector;

use crate::linalg::{IntoVector, LaneStates, VectorSpace, lanes_by_fields, operations_by_fields};
use crate::scalar::{Lanes, Scalar};

/// Coordinates q and momenta p of a system with `N` degrees of freedom: the state of [Hamilton's
/// equations](crate::CanonicalEquations).
///
/// In a derivative, `q` holds q̇ and `p` holds ṗ. The components are the coordinates, then the momenta.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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
    operations_by_fields! { q, p }

    #[inline]
    fn components(&self) -> impl Iterator<Item = S> + '_ {
        self.q.iter().chain(self.p.iter()).copied()
    }
}

lanes_by_fields! {
    [const N: usize] CanonicalPhase<Lanes<L>, N> => CanonicalPhase<f64, N> { q, p }
}
