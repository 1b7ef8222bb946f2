//! Stop conditions: predicates, and events.

use super::dynamics::Dynamics;
use super::event::{Detection, Event, LastStep, Memory, Occurring};
use super::stepper::Advance;
use crate::scalar::Scalar;

/// A condition on which a [`Driver`](crate::Driver) stops, or events that it watches for; made by
/// [`Driver::stop_when`](crate::Driver::stop_when), [`Driver::stop_at_zero`](crate::Driver::stop_at_zero),
/// [`Driver::stop_at_crossing`](crate::Driver::stop_at_crossing) and [`Driver::events`](crate::Driver::events), and by
/// nothing else: the trait is sealed.
pub trait StopCondition<S: Scalar, D: Dynamics<S> + ?Sized>: Detection<S, D> {}

impl<S: Scalar, D: Dynamics<S> + ?Sized, C: Detection<S, D>> StopCondition<S, D> for C {}

/// No stop condition.
#[derive(Clone, Copy, Debug, Default)]
pub struct Unconditional;

/// The condition that a function of time and state is true at the end of a step.
#[derive(Clone, Copy, Debug)]
pub struct Predicate<F>(pub(crate) F);

/// What conditions without events have of them: none.
macro_rules! no_events {
    ($dynamics:ident) => {
        type Values = [f64; 0];

        fn values(&mut self, _: &$dynamics, _: f64, _: &$dynamics::State) -> [f64; 0] {
            []
        }

        fn event(&self, _: usize) -> Event {
            Event::either()
        }

        fn next<T: Advance<S, $dynamics>>(
            &mut self,
            _: &mut Memory<[f64; 0]>,
            _: &mut LastStep<'_, S, $dynamics, T>,
        ) -> Option<Occurring> {
            None
        }
    };
}

impl<S: Scalar, D: Dynamics<S> + ?Sized> Detection<S, D> for Unconditional {
    no_events!(D);
}

impl<S: Scalar, D: Dynamics<S> + ?Sized, F: FnMut(f64, &D::State) -> bool> Detection<S, D>
    for Predicate<F>
{
    no_events!(D);

    fn holds(&mut self, t: f64, x: &D::State) -> bool {
        (self.0)(t, x)
    }
}
