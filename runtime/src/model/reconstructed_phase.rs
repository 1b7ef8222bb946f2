//! Coordinates and velocities of a reduced model, and the ignorable coordinates.

use nalgebra::SVector;

use super::augmented_phase::further_components;
use super::phase::Phase;
use super::state::State;
use crate::integrate::{At, TypicalSizes};
use crate::linalg::{ErrorTolerance, IntoVector, LaneStates, VectorSpace};
use crate::scalar::{Lanes, Scalar};

/// Coordinates q and velocities q̇ of a reduced model with `N` degrees of freedom, and the `K` ignorable coordinates of the
/// full one: the state that an integrator steps under [`Reconstruction`](crate::Reconstruction).
///
/// At a time, it is made from a pair of a [`State`] of the reduced model and the ignorable coordinates:
///
/// ```
/// use lagrangian::{At, ReconstructedPhase, State};
///
/// let state = State::new(2.0, [0.5], [0.0]);
/// let start: At<f64, ReconstructedPhase<f64, 1, 2>> = (state, [0.0, 0.25]).into();
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
