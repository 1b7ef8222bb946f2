//! States of a mechanical system.

use nalgebra::SVector;

use super::phase::Phase;
use crate::integrate::At;
use crate::linalg::IntoVector;
use crate::scalar::Scalar;

/// Time, coordinates q and velocities q̇ of a system with `N` degrees of freedom, and additional states ([`Phase`]).
///
/// ```
/// use lagrangian::State;
/// use lagrangian::nalgebra::SVector;
///
/// let state = State::new(0.0, [0.0, 0.5, 0.0], [0.3, 0.0, 20.0]);
/// assert_eq!(state.q[1], 0.5);
/// assert_eq!(state.v[2], 20.0);
///
/// // With two states of a controller.
/// let controlled: State<f64, 3, SVector<f64, 2>> = (state, [0.0, 0.25]).into();
/// assert_eq!(controlled.state(), state);
/// assert_eq!(controlled.z[1], 0.25);
/// ```
pub type State<S, const N: usize, Z = ()> = At<S, Phase<S, N, Z>>;

impl<S: Scalar, const N: usize> State<S, N> {
    /// Creates the state at time `t` with coordinates `q` and velocities `v`, given as arrays or vectors.
    pub fn new(t: S, q: impl IntoVector<S, N>, v: impl IntoVector<S, N>) -> Self {
        Self {
            t,
            x: Phase::new(q, v),
        }
    }
}

impl<S: Scalar, const N: usize, Z> State<S, N, Z> {
    /// Returns the state of the mechanical system alone.
    #[inline]
    #[must_use]
    pub fn state(&self) -> State<S, N> {
        self.x.at_time(self.t)
    }
}

/// Combines the state of the mechanical system with additional states.
impl<S, C, const N: usize, const K: usize> From<(State<S, N>, C)> for State<S, N, SVector<S, K>>
where
    S: Scalar,
    C: IntoVector<S, K>,
{
    fn from((state, z): (State<S, N>, C)) -> Self {
        Self {
            t: state.t,
            x: state.x.with(z.into_vector()),
        }
    }
}
