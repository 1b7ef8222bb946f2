//! Dynamics with event functions of their own.

use crate::integrate::dynamics::Dynamics;
use crate::integrate::taylor::TaylorCoefficients;
use crate::scalar::{DoubleDouble, Scalar};

/// Dynamics with event functions, such as the [equations of motion](crate::EquationsOfMotion) of a model that declares
/// [events](crate::Events).
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no declared events",
    note = "a model has some with the clause `event(name = expression)` in its declaration; under a control law, \
            driven by signals or with sizes, give functions to `Driver::events`"
)]
pub trait EventDynamics<S: Scalar>: Dynamics<S> {
    /// One value for each event: an array.
    type Values: AsRef<[S]> + Copy;

    /// The names of the events.
    fn names(&self) -> &'static [&'static str];

    /// The values of the event functions.
    fn event_functions(&self, t: S, x: &Self::State) -> Self::Values;

    /// The Taylor coefficients of the event functions along a motion through (t, x), given those of the motion in the same
    /// unit of time; its coefficient of order 0 is not read. `None` where they are not known.
    fn event_series<const HALF: usize>(
        &self,
        t: S,
        x: &Self::State,
        unit: S,
        motion: &TaylorCoefficients<Self::State, HALF>,
    ) -> Option<TaylorCoefficients<Self::Values, HALF>> {
        let _ = (t, x, unit, motion);
        None
    }
}

/// A scalar that is one number, with or without derivatives: events happen at one time.
#[diagnostic::on_unimplemented(
    message = "declared events are watched for in one motion, and `{Self}` is several",
    note = "integrate the lanes one by one, or give functions of all lanes to `Driver::events`"
)]
pub trait SingleNumber: Scalar {}

impl SingleNumber for f64 {}

impl SingleNumber for f32 {}

impl SingleNumber for DoubleDouble {}
