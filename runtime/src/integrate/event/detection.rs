//! What a driver asks of conditions and events.

use super::LastStep;
use super::met_conditions::MetConditions;
use crate::integrate::dynamics::Dynamics;
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

/// How conditions are evaluated, and events are found.
pub trait Detection<S: Scalar, D: Dynamics<S> + ?Sized> {
    /// What is known of the event functions from before.
    type Memory;

    /// The memory at the initial time.
    fn begin(&mut self, dynamics: &D, t: f64, x: &D::State) -> Self::Memory;

    /// Whether a condition on the state at the initial time or at the end of a step holds.
    fn holds(&mut self, t: f64, x: &D::State) -> bool {
        let _ = (t, x);
        false
    }

    /// The next events within the last step, after those that were found before.
    fn next<T: Advance<S, D>>(
        &mut self,
        memory: &mut Self::Memory,
        step: &mut LastStep<'_, S, D, T>,
    ) -> Option<Occurring>;

    /// Whether an event stops the integration.
    fn is_terminal(&self, event: usize) -> bool;

    /// Goes on after a reaction to `occurring` has changed the state to `x`. `step` is the length of the last step, a
    /// measure of time. Events are returned that occur again and again in too short a time.
    fn restart(
        &mut self,
        memory: &mut Self::Memory,
        dynamics: &D,
        occurring: Occurring,
        x: &D::State,
        step: f64,
    ) -> MetConditions;
}
