//! The interface between an integration and its conditions and events.

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
    /// The events.
    pub(crate) events: MetConditions,
}

/// Conditions and events: whether they are met, and where they occur. They are numbered from 0.
pub trait Detection<S: Scalar, D: Dynamics<S> + ?Sized>: Sized {
    /// What is known about the events up to a time.
    type Memory: Remembers;

    /// The number of conditions and events.
    const COUNT: usize;

    /// Returns an error if an event is watched that the dynamics do not have.
    fn check(&self, dynamics: &D) -> Result<(), IntegrationError> {
        let _ = dynamics;
        Ok(())
    }

    /// Returns the conditions on the state that hold at the initial time or at the end of a step.
    fn holding(&mut self, t: f64, x: &D::State) -> MetConditions {
        let _ = (t, x);
        MetConditions::default()
    }

    /// Whether the integration stops at the event with this index.
    fn is_terminal(&self, event: usize) -> bool {
        let _ = event;
        false
    }

    /// Returns the index of an event in the declaration of the model, if it is declared there.
    fn declared(&self, event: usize) -> Option<usize> {
        let _ = event;
        None
    }

    /// Returns the function of an event as a number of the scalar; `None` if events have one time for several motions.
    fn function(&mut self, dynamics: &D, t: S, x: &D::State, event: usize) -> Option<S> {
        let _ = (dynamics, t, x, event);
        None
    }

    /// Returns what is known about the events at the initial time.
    fn begin(&mut self, dynamics: &D, t: f64, x: &D::State) -> Self::Memory;

    /// Returns the next events within the last step, after those that were found before.
    fn next<T: Advance<S, D>>(
        &mut self,
        memory: &mut Self::Memory,
        step: &mut LastStep<'_, S, D, T>,
    ) -> Option<Occurring> {
        let _ = (memory, step);
        None
    }

    /// Notes that the events found last occur at this time of the last step, together with others.
    fn occur_at<T: Advance<S, D>>(
        &mut self,
        memory: &mut Self::Memory,
        step: &mut LastStep<'_, S, D, T>,
        t: f64,
    ) {
        let _ = (memory, step, t);
    }

    /// Returns the events that a run reports at its end and that were not found before. Of the `pending` events, which
    /// were found after its end, these are the ones that rounding does not distinguish from the end.
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

    /// Restarts from a state that reactions to events have left, after steps of this length. Returns the events that
    /// recur in too short a time.
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

/// The conditions and events that a problem watches. This trait is sealed; it is a bound of functions that are generic
/// over problems.
pub trait Watched<S: Scalar, D: Dynamics<S> + ?Sized>: Detection<S, D> {}

impl<S: Scalar, D: Dynamics<S> + ?Sized, C: Detection<S, D>> Watched<S, D> for C {}

/// Watches nothing.
impl<S: Scalar, D: Dynamics<S> + ?Sized> Detection<S, D> for () {
    type Memory = ();

    const COUNT: usize = 0;

    fn begin(&mut self, _: &D, _: f64, _: &D::State) {}
}

/// Functions whose zeros are events, and the crossings that are watched.
pub trait EventFunctions<S: Scalar, D: Dynamics<S> + ?Sized>: Sized {
    /// The type of the values of the functions.
    type Values: Values;

    /// Returns the values at a time and a state.
    fn values(&mut self, dynamics: &D, t: f64, x: &D::State) -> Self::Values;

    /// Returns the function with this index as a number of the scalar; `None` if events have one time for several
    /// motions.
    fn function(&mut self, dynamics: &D, t: S, x: &D::State, event: usize) -> Option<S>;

    /// Returns an error if an event is watched that the dynamics do not have.
    fn check(&self, dynamics: &D) -> Result<(), IntegrationError> {
        let _ = dynamics;
        Ok(())
    }

    /// Returns the crossing that is watched.
    fn event(&self, index: usize) -> Event;

    /// Returns the number of parts of a step at whose ends the functions are evaluated, if it is set.
    fn parts(&self) -> Option<u32>;

    /// Returns the next events within the last step, after those that were found before. They are found by sampling,
    /// unless more is known about the functions.
    fn next<T: Advance<S, D>>(
        &mut self,
        memory: &mut Memory<Self::Values>,
        step: &mut LastStep<'_, S, D, T>,
    ) -> Option<Occurring> {
        sampling::next(self, memory, step)
    }
}

/// Implements the detection of events by their functions.
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
