//! The interface of all methods of integration.
//!
//! An [`Integrator`] is a method with its settings. It starts a [`Stepper`], which has a time and a state, and owns the
//! memory of the method between steps.

use super::dynamics::Dynamics;
use super::error::IntegrationError;
use super::stepper::Advance;
use crate::scalar::Scalar;

/// A method of integration with its settings.
///
/// [`Dop853`](crate::Dop853) and [`RungeKutta`](crate::RungeKutta) accept any [`Dynamics`], [`Taylor`](crate::Taylor)
/// accepts dynamics with a [`Series`](crate::Series).
pub trait Integrator<S: Scalar, D: Dynamics<S> + ?Sized> {
    /// The type that takes the steps.
    type Stepper: Advance<S, D>;

    /// Starts a stepper at time `t` and state `x`. Costs one evaluation of the derivative.
    ///
    /// # Errors
    ///
    /// If a setting is invalid, the time, the state or its derivative is not finite, or the state is off the
    /// [manifold](Dynamics::project) of the dynamics.
    fn start(&self, dynamics: &D, t: f64, x: D::State) -> Result<Self::Stepper, IntegrationError>;

    /// Returns the relative error of the accelerations at which, by default, an integration by this method ends near a
    /// singularity ([`Problem::singularity_tolerance`](crate::Problem::singularity_tolerance)).
    fn singularity_tolerance(&self) -> f64;
}
