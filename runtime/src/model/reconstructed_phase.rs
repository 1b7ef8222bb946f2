//! Coordinates and velocities of a reduced model, and the ignorable coordinates.

use nalgebra::SVector;

use super::augmented_phase::further_components;
use super::phase::Phase;
use super::state::State;
#[cfg(feature = "alloc")]
use crate::integrate::Trajectory;
use crate::integrate::{At, InitialValue, TypicalSizes};
use crate::linalg::{ErrorTolerance, IntoVector, LaneStates, VectorSpace};
use crate::scalar::{Lanes, Scalar};

/// Coordinates q and velocities q̇ of a reduced model with `N` degrees of freedom, and the `K` ignorable coordinates of the
/// full one: the state that an integrator steps under [`Reconstruction`](crate::Reconstruction).
///
/// The initial value is made from a [`State`] of the reduced model and the ignorable coordinates:
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian::ReconstructedPhase;
///
/// let state = State::new(2.0, [0.5], [0.0]);
/// let x = ReconstructedPhase { q: state.q, v: state.v, ignorable: SVector::from([0.0, 0.25]) };
/// let start = At { t: state.t, x };
/// assert_eq!(start.state(), state);
/// assert_eq!(start.ignorable[1], 0.25);
/// ```
///
/// Its components are the coordinates, the velocities, then the ignorable coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "S: serde::Serialize",
        deserialize = "S: serde::Deserialize<'de>"
    ))
)]
pub struct ReconstructedPhase<S: Scalar, const N: usize, const K: usize> {
    /// Coordinates q.
    pub q: SVector<S, N>,
    /// Velocities q̇.
    pub v: SVector<S, N>,
    /// The ignorable coordinates.
    pub ignorable: SVector<S, K>,
}

further_components!(ReconstructedPhase, ignorable);
