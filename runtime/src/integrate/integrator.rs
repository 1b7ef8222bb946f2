//! The interface of all methods of integration.
//!
//! An [`Integrator`] is a method with its settings. It starts a [`Stepper`], which is at a time and
//! a state, and owns what the method remembers between steps. A [`Driver`] takes steps until there is a reason to
//! stop.

use super::driver::Driver;
use super::dynamics::Dynamics;
use super::error::IntegrationError;
use super::observer::Unobserved;
use super::outcome::Outcome;
use super::sample::{InitialValue, Sample};
use super::stepper::Stepper;
use super::stop_condition::Unconditional;
#[cfg(feature = "alloc")]
use super::trajectory::{PartialTrajectory, Trajectory};
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

/// A method of integration and its settings: [`Dop853`](crate::Dop853),
/// [`RungeKutta`](crate::RungeKutta).
pub trait Integrator {
    /// What takes the steps.
    type Stepper<S: Scalar, X: VectorSpace<S>>: Stepper<S, X>;

    /// A stepper at time `t` and state `x`. Costs one evaluation of the derivative.
    ///
    /// # Errors
    ///
    /// If a setting is invalid, or the time, the state or its derivative is not finite.
    fn start<S: Scalar, D: Dynamics<S> + ?Sized>(
        &self,
        dynamics: &D,
        t: f64,
        x: D::State,
    ) -> Result<Self::Stepper<S, D::State>, IntegrationError>;

    /// The relative error of the accelerations at which a [`Driver`] of this method ends near a singularity
    /// by default ([`Driver::singularity_tolerance`]).
    fn singularity_tolerance(&self) -> f64;

    /// A driver of this method, to which limits, stop conditions and an observer can be added.
    fn driver(&self) -> Driver<Self, Unconditional, Unobserved>
    where
        Self: Clone,
    {
        Driver::new(self.clone())
    }

    /// Integrates from `initial` to the time `end`, which may lie before it, and returns the final state.
    ///
    /// # Errors
    ///
    /// Any of [`IntegrationError`].
    fn integrate_to<S: Scalar, D: Dynamics<S> + ?Sized>(
        &self,
        dynamics: &D,
        initial: impl InitialValue<D::State>,
        end: f64,
    ) -> Result<Sample<D::State>, IntegrationError>
    where
        Self: Clone,
    {
        let outcome: Outcome<D::State> = self.driver().run_until(dynamics, initial, end)?;
        Ok(outcome.last)
    }

    /// The motion from `initial` at each of `times`, which advance in one direction.
    ///
    /// # Errors
    ///
    /// Any of [`IntegrationError`], with the samples up to then.
    #[cfg(feature = "alloc")]
    fn sample<S: Scalar, D: Dynamics<S> + ?Sized>(
        &self,
        dynamics: &D,
        initial: impl InitialValue<D::State>,
        times: &[f64],
    ) -> Result<Trajectory<D::State>, PartialTrajectory<D::State>>
    where
        Self: Clone,
    {
        self.driver().sample(dynamics, initial, times)
    }
}
