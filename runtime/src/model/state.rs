//! States of a mechanical system.

use super::phase::Phase;
use crate::integrate::At;
use crate::linalg::IntoVector;
use crate::scalar::Scalar;

/// Time, coordinates q and velocities q̇ of a system with `N` degrees of freedom.
///
/// ```
/// use lagrangian::State;
///
/// let state = State::new(0.0, [0.0, 0.5, 0.0], [0.3, 0.0, 20.0]);
/// assert_eq!(state.q[1], 0.5);
/// assert_eq!(state.v[2], 20.0);
/// ```
pub type State<S, const N: usize> = At<S, Phase<S, N>>;

impl<S: Scalar, const N: usize> State<S, N> {
    /// The state at time `t` with coordinates `q` and velocities `v`, from arrays or vectors.
    pub fn new(t: S, q: impl IntoVector<S, N>, v: impl IntoVector<S, N>) -> Self {
        Self {
            t,
            x: Phase::new(q, v),
        }
    }
}
