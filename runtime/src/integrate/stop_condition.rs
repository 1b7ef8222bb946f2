//! Stop conditions: predicates, and events.

use super::dynamics::Dynamics;
use super::event::{Detection, LastStep, MetConditions, Occurring};
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
        type Memory = ();

        fn begin(&mut self, _: &$dynamics, _: f64, _: &$dynamics::State) {}

        fn next<T: Advance<S, $dynamics>>(
            &mut self,
            (): &mut (),
            _: &mut LastStep<'_, S, $dynamics, T>,
        ) -> Option<Occurring> {
            None
        }

        fn is_terminal(&self, _: usize) -> bool {
            false
        }

        fn restart(
            &mut self,
            (): &mut (),
            _: &$dynamics,
            _: Occurring,
            _: &$dynamics::State,
            _: f64,
        ) -> MetConditions {
            MetConditions::default()
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
