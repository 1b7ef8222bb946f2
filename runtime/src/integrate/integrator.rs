//! The interface of all methods of integration.
//!
//! An [`Integrator`] is a method with its settings. It starts a [`Stepper`], which is at a time and
//! a state, and owns what the method remembers between steps.

use super::dynamics::Dynamics;
use super::error::IntegrationError;
use super::stepper::Advance;
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
    /// If a setting is invalid, the time, the state or its derivative is not finite, or the state is off the
    /// [manifold](Dynamics::project) of the dynamics.
    fn start(&self, dynamics: &D, t: f64, x: D::State) -> Result<Self::Stepper, IntegrationError>;

    /// The relative error of the accelerations at which an integration by this method ends near a singularity by default
    /// ([`Problem::singularity_tolerance`](crate::Problem::singularity_tolerance)).
    fn singularity_tolerance(&self) -> f64;
}
