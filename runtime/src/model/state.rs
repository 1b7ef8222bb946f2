//! States of a mechanical system.

use nalgebra::SVector;

use crate::linalg::IntoVector;
use crate::scalar::Scalar;

/// Time, coordinates q and velocities q̇ of a system with `N` degrees of freedom.
///
/// ```
/// use lagrangian::State;
///
/// let state = State::new(0.0, [0.0, 0.5, 0.0], [0.3, 0.0, 20.0]);
/// assert_eq!(state.q[1], 0.5);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "S: serde::Serialize",
        deserialize = "S: serde::Deserialize<'de>"
    ))
)]
pub struct State<S: Scalar, const N: usize> {
    /// Time.
    pub t: S,
    /// Coordinates q.
    pub q: SVector<S, N>,
    /// Velocities q̇.
    pub v: SVector<S, N>,
}

impl<S: Scalar, const N: usize> State<S, N> {
    /// The state at time `t` with coordinates `q` and velocities `v`, from arrays or vectors.
    pub fn new(t: S, q: impl IntoVector<S, N>, v: impl IntoVector<S, N>) -> Self {
        Self {
            t,
            q: q.into_vector(),
            v: v.into_vector(),
        }
    }
}
