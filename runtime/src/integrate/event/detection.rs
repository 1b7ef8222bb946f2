//! What a driver asks of conditions and events.

use super::memory::Memory;
use super::met_conditions::MetConditions;
use super::values::Values;
use super::{Event, LastStep, sampling};
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

/// How conditions are evaluated, and events are found: the functions of which the zeros are events, and what is watched
/// for.
pub trait Detection<S: Scalar, D: Dynamics<S> + ?Sized>: Sized {
    /// The values of the event functions.
    type Values: Values;

    /// The values at a time and a state.
    fn values(&mut self, dynamics: &D, t: f64, x: &D::State) -> Self::Values;

    /// The event function of an index as a number of the scalar; none where events have one time for several motions.
    fn function(&mut self, dynamics: &D, t: S, x: &D::State, event: usize) -> Option<S> {
        let _ = (dynamics, t, x, event);
        None
    }

    /// An error if an event is watched for that the dynamics do not have.
    fn check(&self, dynamics: &D) -> Result<(), IntegrationError> {
        let _ = dynamics;
        Ok(())
    }

    /// What is watched for.
    fn event(&self, index: usize) -> Event;

    /// The parts of a step at whose ends the functions are evaluated, if it is set.
    fn parts(&self) -> Option<u32> {
        None
    }

    /// Whether a condition on the state at the initial time or at the end of a step holds.
    fn holds(&mut self, t: f64, x: &D::State) -> bool {
        let _ = (t, x);
        false
    }

    /// What is known of the event functions at the initial time.
    fn begin(&mut self, dynamics: &D, t: f64, x: &D::State) -> Memory<Self::Values> {
        Memory::new(t, self.values(dynamics, t, x))
    }

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
