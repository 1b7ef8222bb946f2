//! Event functions of a state at a time.

use super::detection::detection_by_functions;
use super::{Crossing, Detection, Event, EventFunctions, EventValues, MetConditions};
use crate::integrate::at::At;
use crate::integrate::dynamics::Dynamics;
use crate::scalar::Scalar;

/// The condition that a function of the state at a time crosses zero.
#[derive(Clone, Copy, Debug)]
pub struct FunctionOfState<F> {
    pub(crate) function: F,
    pub(crate) event: Event,
    pub(crate) parts: Option<u32>,
}

impl<F> FunctionOfState<F> {
    /// The event that the function crosses zero in either direction.
    pub(crate) fn new(function: F) -> Self {
        Self {
            function,
            event: Event::new(Crossing::Either),
            parts: None,
        }
    }
}

impl<S, D, F, R> EventFunctions<S, D> for FunctionOfState<F>
where
    S: Scalar,
    D: Dynamics<S> + ?Sized,
    F: FnMut(&At<S, D::State>) -> R,
    R: EventValues<S>,
{
    type Values = R::Numbers;

    fn values(&mut self, _: &D, t: f64, x: &D::State) -> R::Numbers {
        let x = x.clone();
        (self.function)(&At {
            t: S::from_f64(t),
            x,
        })
        .numbers()
    }

    fn function(&mut self, _: &D, t: S, x: &D::State, event: usize) -> Option<S> {
        (self.function)(&At { t, x: x.clone() }).value(event)
    }

    fn event(&self, _: usize) -> Event {
        self.event
    }

    fn parts(&self) -> Option<u32> {
        self.parts
    }
}

impl<S, D, F, R> Detection<S, D> for FunctionOfState<F>
where
    S: Scalar,
    D: Dynamics<S> + ?Sized,
    F: FnMut(&At<S, D::State>) -> R,
    R: EventValues<S>,
{
    detection_by_functions!(S, D);
}

/// The condition that a predicate of the state at a time holds at the end of a step.
#[derive(Clone, Copy, Debug)]
pub struct PredicateOfState<F>(pub(crate) F);

impl<S, D, F> Detection<S, D> for PredicateOfState<F>
where
    S: Scalar,
    D: Dynamics<S> + ?Sized,
    F: FnMut(&At<S, D::State>) -> bool,
{
    type Memory = ();

    const COUNT: usize = 1;

    fn begin(&mut self, _: &D, _: f64, _: &D::State) {}

    fn holding(&mut self, t: f64, x: &D::State) -> MetConditions {
        let (t, x) = (S::from_f64(t), x.clone());
        MetConditions::of(core::iter::once((self.0)(&At { t, x })))
    }
}
