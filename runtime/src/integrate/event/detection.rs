//! The interface between an integration and its conditions and events.

use super::LastStep;
use super::memory::Remembers;
use super::met_conditions::MetConditions;
use super::one_signed::OneSigned;
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

    /// Returns the event functions of the dynamics that are watched, and those at whose zeros they have corners, by their
    /// indices below 64.
    fn watched_functions(&self, dynamics: &D) -> MetConditions {
        let _ = dynamics;
        MetConditions::default()
    }

    /// Notes that a step between these times was taken, in which these functions have one sign. Returns false if the step has to
    /// be examined, by [`next`](Self::next) and [`holding`](Self::holding); lists that have passed over it then find nothing.
    fn passes_over(
        &mut self,
        memory: &mut Self::Memory,
        dynamics: &D,
        step: [f64; 2],
        one_signed: OneSigned,
    ) -> bool {
        let _ = (memory, dynamics, step, one_signed);
        false
    }

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

    #[inline]
    fn passes_over(&mut self, (): &mut (), _: &D, _: [f64; 2], _: OneSigned) -> bool {
        true
    }
}
