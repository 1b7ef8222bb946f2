//! A state at a time, for any dynamics.

use core::ops::{Deref, DerefMut};

use crate::scalar::Scalar;

/// A state `x` at a time `t`: an initial value, a sample, a final state.
///
/// It dereferences to `x`: with a [`State`](crate::State) of a mechanical system it thus has the fields `t`, `q` and
/// `v`. For other dynamics it is made from a pair:
///
/// ```
/// use lagrangian::nalgebra::SVector;
/// use lagrangian::{At, State};
///
/// let pendulum = State::new(0.0, [0.5], [0.0]);
/// assert_eq!(pendulum.q[0], 0.5);
/// let decay = At::from((0.0, SVector::from([1.0])));
/// assert_eq!(decay[0], 1.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct At<S, X> {
    /// Time.
    pub t: S,
    /// The state at that time.
    pub x: X,
}

impl<S, X> Deref for At<S, X> {
    type Target = X;

    #[inline]
    fn deref(&self) -> &X {
        &self.x
    }
}

impl<S, X> DerefMut for At<S, X> {
    #[inline]
    fn deref_mut(&mut self) -> &mut X {
        &mut self.x
    }
}

impl<X> At<f64, X> {
    /// Converts the time to the scalar type of the state.
    #[inline]
    pub(crate) fn on_scalar<S: Scalar>(self) -> At<S, X> {
        At {
            t: S::from_f64(self.t),
            x: self.x,
        }
    }
}

impl<S: Scalar, X> At<S, X> {
    /// Converts the time to a single number: NaN where its lanes differ.
    pub(crate) fn at_one_time(self) -> At<f64, X> {
        let (least, most) = (self.t.smallest(), self.t.largest());
        let t = if least < most { f64::NAN } else { least };
        At { t, x: self.x }
    }
}

impl<S, X> From<(S, X)> for At<S, X> {
    fn from((t, x): (S, X)) -> Self {
        Self { t, x }
    }
}

impl<S: Clone, X: Clone> From<&At<S, X>> for At<S, X> {
    fn from(state: &Self) -> Self {
        state.clone()
    }
}
