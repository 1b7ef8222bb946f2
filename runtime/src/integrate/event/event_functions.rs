//! Functions whose zeros are events.

use super::memory::Memory;
use super::values::Values;
use super::{Event, LastStep, Occurring};
use crate::integrate::dynamics::Dynamics;
use crate::integrate::error::IntegrationError;
use crate::integrate::stepper::Advance;
use crate::scalar::Scalar;

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

    /// Returns the next events within the last step, after those that were found before.
    fn next<T: Advance<S, D>>(
        &mut self,
        memory: &mut Memory<Self::Values>,
        step: &mut LastStep<'_, S, D, T>,
    ) -> Option<Occurring>;
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
