//! The interface of all methods of integration.
//!
//! An [`Integrator`] is a method with its settings. It starts a [`Stepper`], which is at a time and
//! a state, and owns what the method remembers between steps. A [`Driver`] takes steps until there is a reason to
//! stop.

use super::at::{At, InitialValue};
use super::driver::Driver;
use super::dynamics::Dynamics;
use super::error::IntegrationError;
use super::outcome::{Outcome, StopReason};
use super::stepper::Advance;
#[cfg(feature = "alloc")]
use super::trajectory::{PartialTrajectory, Trajectory};
use crate::limits::MAX_STEPS;
use crate::scalar::Scalar;

/// A method of integration with its settings, for systems that have what it needs: [`Dop853`](crate::Dop853) and
/// [`RungeKutta`](crate::RungeKutta) for any [`Dynamics`], [`Taylor`](crate::Taylor) for those with a
/// [`Series`](crate::Series).
pub trait Integrator<S: Scalar, D: Dynamics<S> + ?Sized> {
    /// What takes the steps.
    type Stepper: Advance<S, D>;

    /// A stepper at time `t` and state `x`. Costs one evaluation of the derivative.
    ///
    /// # Errors
    ///
    /// If a setting is invalid, or the time, the state or its derivative is not finite.
    fn start(&self, dynamics: &D, t: f64, x: D::State) -> Result<Self::Stepper, IntegrationError>;

    /// The relative error of the accelerations at which a [`Driver`] of this method ends near a singularity
    /// by default ([`Driver::singularity_tolerance`]).
    fn singularity_tolerance(&self) -> f64;

    /// Integrates from `initial` to the time `end`, which may lie before it, and returns the final state.
    ///
    /// # Errors
    ///
    /// Any of [`IntegrationError`].
    fn integrate_to(
        &self,
        dynamics: &D,
        initial: impl InitialValue<D::State>,
        end: f64,
    ) -> Result<At<f64, D::State>, IntegrationError>
    where
        Self: Clone,
    {
        let outcome: Outcome<D::State> =
            Driver::new(self.clone()).run_until(dynamics, initial, end)?;
        completed(&outcome).map(|()| outcome.last)
    }

    /// The motion from `initial` at each of `times`, which advance in one direction.
    ///
    /// # Errors
    ///
    /// Any of [`IntegrationError`], with the samples up to then.
    #[cfg(feature = "alloc")]
    fn sample(
        &self,
        dynamics: &D,
        initial: impl InitialValue<D::State>,
        times: &[f64],
    ) -> Result<Trajectory<D::State, S>, PartialTrajectory<D::State, S>>
    where
        Self: Clone,
    {
        let trajectory = Driver::new(self.clone()).sample(dynamics, initial, times)?;
        match completed(&trajectory.outcome) {
            Ok(()) => Ok(trajectory),
            Err(error) => Err(PartialTrajectory::new(error, trajectory)),
        }
    }
}

/// An error if the limit of steps has stopped an integration without a driver that could go on.
fn completed<X>(outcome: &Outcome<X>) -> Result<(), IntegrationError> {
    if outcome.reason == StopReason::StepLimit {
        Err(IntegrationError::TooManySteps {
            time: outcome.last.t,
            limit: MAX_STEPS,
        })
    } else {
        Ok(())
    }
}

/// A method of integration, whatever it integrates.
pub trait IntegrationMethod: Clone {
    /// A driver of this method, to which limits, stop conditions and an observer can be added.
    fn driver(&self) -> Driver<Self> {
        Driver::new(self.clone())
    }
}
