//! A state at a time, for any dynamics.

/// A state `x` at a time `t`: an initial value, a sample, a final state.
///
/// Times are `f64` whatever the scalars of the state are. For a mechanical system it is made from a
/// [`State`](crate::State), and viewed as one by [`state`](Self::state); for other dynamics it is made from a pair:
///
/// ```
/// use lagrangian::{Sample, State};
/// use lagrangian::nalgebra::SVector;
///
/// let pendulum = Sample::from(State::new(0.0, [0.5], [0.0]));
/// assert_eq!(pendulum.state().q[0], 0.5);
/// let decay = Sample::from((0.0, SVector::from([1.0])));
/// assert_eq!(decay.x[0], 1.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Sample<X> {
    /// Time.
    pub t: f64,
    /// The state at that time.
    pub x: X,
}

/// The initial value of an integration: a [`Sample`], a pair of a time and a state, or the [`State`](crate::State) of a
/// mechanical system with as many coordinates as it has.
#[diagnostic::on_unimplemented(
    message = "an integration of `{X}` does not begin at `{Self}`",
    label = "this is no state of the system",
    note = "a mechanical system with `N` coordinates begins at a `State<S, N>`, of `N` coordinates and as many \
            velocities, and under `with_controller` at a pair with the states of the controller, `(state, [0.0])`; \
            under a control law `S` is `f64`, unless the struct has a type parameter or its declaration `scalar = f32`; \
            other dynamics begin at a pair `(t, x)`"
)]
pub trait InitialValue<X> {
    /// The time and the state.
    fn into_sample(self) -> Sample<X>;
}

impl<X> InitialValue<X> for Sample<X> {
    fn into_sample(self) -> Self {
        self
    }
}

impl<X: Clone> InitialValue<X> for &Sample<X> {
    fn into_sample(self) -> Sample<X> {
        self.clone()
    }
}

impl<X> InitialValue<X> for (f64, X) {
    fn into_sample(self) -> Sample<X> {
        self.into()
    }
}

impl<X> From<(f64, X)> for Sample<X> {
    fn from((t, x): (f64, X)) -> Self {
        Self { t, x }
    }
}

impl<X: Clone> From<&Sample<X>> for Sample<X> {
    fn from(sample: &Sample<X>) -> Self {
        sample.clone()
    }
}
