//! What an integration asks of conditions and events.

use super::memory::{Memory, Remembers};
use super::met_conditions::MetConditions;
use super::values::Values;
use super::{Event, LastStep, sampling};
use crate::integrate::at::At;
use crate::integrate::dynamics::Dynamics;
use crate::integrate::error::IntegrationError;
use crate::integrate::stepper::Advance;
use crate::scalar::Scalar;

/// Events that occur at one time.
#[derive(Clone, Copy, Debug)]
pub struct Occurring {
    /// The time.
    pub(crate) t: f64,
    /// Which events.
    pub(crate) events: MetConditions,
}

/// Conditions and events: whether they are met, and where they occur. They are numbered from 0.
pub trait Detection<S: Scalar, D: Dynamics<S> + ?Sized>: Sized {
    /// What is known of the events up to a time.
    type Memory: Remembers;

    /// How many conditions and events there are.
    const COUNT: usize;

    /// An error if an event is watched for that the dynamics do not have.
    fn check(&self, dynamics: &D) -> Result<(), IntegrationError> {
        let _ = dynamics;
        Ok(())
    }

    /// Which conditions on the state at the initial time or at the end of a step hold.
    fn holding(&mut self, t: f64, x: &D::State) -> MetConditions {
        let _ = (t, x);
        MetConditions::default()
    }

    /// Whether the integration stops at the event of an index.
    fn is_terminal(&self, event: usize) -> bool {
        let _ = event;
        false
    }

    /// The index of an event in the declaration of the model, if it is there.
    fn declared(&self, event: usize) -> Option<usize> {
        let _ = event;
        None
    }

    /// The function of an event as a number of the scalar; none where events have one time for several motions.
    fn function(&mut self, dynamics: &D, t: S, x: &D::State, event: usize) -> Option<S> {
        let _ = (dynamics, t, x, event);
        None
    }

    /// What is known of the events at the initial time.
    fn begin(&mut self, dynamics: &D, t: f64, x: &D::State) -> Self::Memory;

    /// The next events within the last step, after those that were found before.
    fn next<T: Advance<S, D>>(
        &mut self,
        memory: &mut Self::Memory,
        step: &mut LastStep<'_, S, D, T>,
    ) -> Option<Occurring> {
        let _ = (memory, step);
        None
    }

    /// The events found last occur at this time of the last step, together with others.
    fn occur_at<T: Advance<S, D>>(
        &mut self,
        memory: &mut Self::Memory,
        step: &mut LastStep<'_, S, D, T>,
        t: f64,
    ) {
        let _ = (memory, step, t);
    }

    /// The events that a run reports where it ends, and that were not found before; of those that were found behind its end, the
    /// ones that rounding does not tell from it.
    fn close<T: Advance<S, D>>(
        &mut self,
        memory: &mut Self::Memory,
        step: &mut LastStep<'_, S, D, T>,
        here: &At<f64, D::State>,
        pending: Option<Occurring>,
    ) -> MetConditions {
        let _ = (memory, step, here, pending);
        MetConditions::default()
    }

    /// Begins anew from a state that reactions to events have left, after steps of this length. The events that occur again
    /// and again in too short a time.
    fn restart(
        &mut self,
        memory: &mut Self::Memory,
        dynamics: &D,
        occurring: Occurring,
        x: &D::State,
        step: f64,
    ) -> MetConditions {
        let _ = (memory, dynamics, occurring, x, step);
        MetConditions::default()
    }
}

/// What a problem watches for: the conditions and events of its settings. The trait is sealed; it is a bound of functions that
/// are generic over problems.
pub trait Watched<S: Scalar, D: Dynamics<S> + ?Sized>: Detection<S, D> {}

impl<S: Scalar, D: Dynamics<S> + ?Sized, C: Detection<S, D>> Watched<S, D> for C {}

/// Nothing is watched.
impl<S: Scalar, D: Dynamics<S> + ?Sized> Detection<S, D> for () {
    type Memory = ();

    const COUNT: usize = 0;

    fn begin(&mut self, _: &D, _: f64, _: &D::State) {}
}

/// The functions of which the zeros are events, and what is watched for.
pub trait EventFunctions<S: Scalar, D: Dynamics<S> + ?Sized>: Sized {
    /// The values of the functions.
    type Values: Values;

    /// The values at a time and a state.
    fn values(&mut self, dynamics: &D, t: f64, x: &D::State) -> Self::Values;

    /// The function of an index as a number of the scalar; none where events have one time for several motions.
    fn function(&mut self, dynamics: &D, t: S, x: &D::State, event: usize) -> Option<S>;

    /// An error if an event is watched for that the dynamics do not have.
    fn check(&self, dynamics: &D) -> Result<(), IntegrationError> {
        let _ = dynamics;
        Ok(())
    }

    /// What is watched for.
    fn event(&self, index: usize) -> Event;

    /// The parts of a step at whose ends the functions are evaluated, if it is set.
    fn parts(&self) -> Option<u32>;

    /// The next events within the last step, after those that were found before: by sampling, unless more is known of the
    /// functions.
    fn next<T: Advance<S, D>>(
        &mut self,
        memory: &mut Memory<Self::Values>,
        step: &mut LastStep<'_, S, D, T>,
    ) -> Option<Occurring> {
        sampling::next(self, memory, step)
    }
}

/// The detection of events by their functions.
macro_rules! detection_by_functions {
    ($scalar:ident, $dynamics:ident) => {
        type Memory =
            $crate::integrate::event::Memory<<Self as EventFunctions<$scalar, $dynamics>>::Values>;

        const COUNT: usize =
            <<Self as EventFunctions<$scalar, $dynamics>>::Values as $crate::integrate::event::values::Values>::COUNT;

        fn check(
            &self,
            dynamics: &$dynamics,
        ) -> Result<(), $crate::integrate::error::IntegrationError> {
            EventFunctions::check(self, dynamics)
        }

        fn is_terminal(&self, event: usize) -> bool {
            EventFunctions::<$scalar, $dynamics>::event(self, event).is_terminal()
        }

        fn function(
            &mut self,
            dynamics: &$dynamics,
            t: $scalar,
            x: &$dynamics::State,
            event: usize,
        ) -> Option<$scalar> {
            EventFunctions::function(self, dynamics, t, x, event)
        }

        fn begin(&mut self, dynamics: &$dynamics, t: f64, x: &$dynamics::State) -> Self::Memory {
            $crate::integrate::event::Memory::at_start(self, dynamics, t, x)
        }

        fn next<T: $crate::integrate::stepper::Advance<$scalar, $dynamics>>(
            &mut self,
            memory: &mut Self::Memory,
            step: &mut $crate::integrate::event::LastStep<'_, $scalar, $dynamics, T>,
        ) -> Option<$crate::integrate::event::Occurring> {
            EventFunctions::next(self, memory, step)
        }

        fn occur_at<T: $crate::integrate::stepper::Advance<$scalar, $dynamics>>(
            &mut self,
            memory: &mut Self::Memory,
            step: &mut $crate::integrate::event::LastStep<'_, $scalar, $dynamics, T>,
            t: f64,
        ) {
            let there = step.at(t);
            memory.at_event = EventFunctions::values(self, step.dynamics(), t, &there.x);
        }

        fn close<T: $crate::integrate::stepper::Advance<$scalar, $dynamics>>(
            &mut self,
            memory: &mut Self::Memory,
            step: &mut $crate::integrate::event::LastStep<'_, $scalar, $dynamics, T>,
            here: &$crate::integrate::at::At<f64, $dynamics::State>,
            pending: Option<$crate::integrate::event::Occurring>,
        ) -> $crate::integrate::event::MetConditions {
            memory.close(self, step, here, pending)
        }

        fn restart(
            &mut self,
            memory: &mut Self::Memory,
            dynamics: &$dynamics,
            occurring: $crate::integrate::event::Occurring,
            x: &$dynamics::State,
            step: f64,
        ) -> $crate::integrate::event::MetConditions {
            $crate::integrate::event::sampling::restart(self, memory, dynamics, occurring, x, step)
        }
    };
}
pub(super) use detection_by_functions;
