//! Dynamics with their own event functions.

use crate::integrate::dynamics::Dynamics;
use crate::integrate::taylor::TaylorCoefficients;
use crate::integrate::typical_sizes::WithSizes;
use crate::scalar::{DoubleDouble, Dual, Scalar};

/// Dynamics with event functions, such as the [equations of motion](crate::EquationsOfMotion) of a model that declares
/// [events](crate::quantities::Events), under any [law](crate::laws),
/// or [with sizes](crate::SetTypicalSizes::with_sizes).
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no declared events",
    note = "a model has some with the clause `event(name = expression)` in its declaration; of other systems, give \
            functions to `Problem::when`"
)]
pub trait EventDynamics<S: Scalar>: Dynamics<S> {
    /// The type whose constants name the events: the model, or `Self` for dynamics that are written by hand.
    type Model;

    /// An array with one value for each event, followed by the values of the functions at whose zeros event functions
    /// have corners or jumps ([`branches`](Self::branches)).
    type Values: AsRef<[S]> + Copy;

    /// Returns the names of the events.
    fn names(&self) -> &'static [&'static str];

    /// Returns the indices of those values at whose zeros the function of an event has a corner or a jump, such as the
    /// value of u for |u|, or u − v for max(u, v). Its series ends there, and another one begins. There are none by
    /// default.
    fn branches(&self, event: usize) -> &'static [usize] {
        let _ = event;
        &[]
    }

    /// Returns the values of the event functions.
    fn event_functions(&self, t: S, x: &Self::State) -> Self::Values;

    /// Returns the Taylor coefficients of the event functions along a motion through (t, x), up to an order that the
    /// coefficients of the motion have, in the same unit of time. The motion's coefficient of order 0 is not read. `None` if
    /// they are not known.
    fn event_series<const HALF: usize, const OF_MOTION: usize>(
        &self,
        t: S,
        x: &Self::State,
        unit: S,
        motion: &TaylorCoefficients<Self::State, OF_MOTION>,
    ) -> Option<TaylorCoefficients<Self::Values, HALF>> {
        let _ = (t, x, unit, motion);
        None
    }
}

impl<S: Scalar, D: EventDynamics<S> + ?Sized> EventDynamics<S> for &D {
    type Model = D::Model;
    type Values = D::Values;

    fn names(&self) -> &'static [&'static str] {
        (**self).names()
    }

    fn branches(&self, event: usize) -> &'static [usize] {
        (**self).branches(event)
    }

    #[inline]
    fn event_functions(&self, t: S, x: &D::State) -> D::Values {
        (**self).event_functions(t, x)
    }

    #[inline]
    fn event_series<const HALF: usize, const OF_MOTION: usize>(
        &self,
        t: S,
        x: &D::State,
        unit: S,
        motion: &TaylorCoefficients<D::State, OF_MOTION>,
    ) -> Option<TaylorCoefficients<D::Values, HALF>> {
        (**self).event_series(t, x, unit, motion)
    }
}

/// The sizes of coordinates do not affect events.
impl<S: Scalar, D: EventDynamics<S>> EventDynamics<S> for WithSizes<D, D::State> {
    type Model = D::Model;
    type Values = D::Values;

    fn names(&self) -> &'static [&'static str] {
        self.dynamics.names()
    }

    fn branches(&self, event: usize) -> &'static [usize] {
        self.dynamics.branches(event)
    }

    #[inline]
    fn event_functions(&self, t: S, x: &D::State) -> D::Values {
        self.dynamics.event_functions(t, x)
    }

    #[inline]
    fn event_series<const HALF: usize, const OF_MOTION: usize>(
        &self,
        t: S,
        x: &D::State,
        unit: S,
        motion: &TaylorCoefficients<D::State, OF_MOTION>,
    ) -> Option<TaylorCoefficients<D::Values, HALF>> {
        self.dynamics.event_series(t, x, unit, motion)
    }
}

/// A scalar that is a single number, with or without derivatives, so that each event has one time.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a single number",
    note = "the size of a solid is given by its lengths, as in `Solid::cuboid(x, y, z)`",
    note = "declared events are watched for in one motion: integrate lanes one by one, or give functions of all lanes to \
            `Problem::when`"
)]
pub trait SingleNumber: Scalar {}

impl SingleNumber for f64 {}

impl SingleNumber for f32 {}

impl SingleNumber for DoubleDouble {}

impl<S: SingleNumber, const N: usize> SingleNumber for Dual<S, N> {}
