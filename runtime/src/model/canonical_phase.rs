//! Coordinates and momenta, without the time.

use nalgebra::SVector;

use super::vector_pair::vector_pair;
use crate::linalg::{IntoVector, LaneStates, VectorSpace};
use crate::scalar::{Lanes, Scalar};

/// Coordinates q and momenta p of a system with `N` degrees of freedom: the state of
/// [Hamilton's equations](crate::CanonicalEquations).
///
/// As a derivative, `q` holds q̇ and `p` holds ṗ. Its components are the coordinates, then the momenta.
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

vector_pair!(CanonicalPhase, p, {});
