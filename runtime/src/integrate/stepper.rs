//! A motion in progress, step by step, and what is checked before each.

use super::dynamics::Dynamics;
use super::error::IntegrationError;
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

/// A motion in progress.
///
/// A clone of it is a checkpoint: the motion continued from the clone is the same to the last bit.
/// It does not hold the dynamics; they are given to each step, and must be the same until
/// [`restart`](Self::restart).
///
/// A force that a controller sets ten times a second and holds in between:
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian::nalgebra::SVector;
///
/// /// A mass of 1 under a force: position and velocity.
/// struct Mass {
///     force: f64,
/// }
///
/// impl Dynamics for Mass {
///     type State = SVector<f64, 2>;
///
///     fn derivative(&self, _: f64, x: &Self::State) -> Self::State {
///         SVector::from([x[1], self.force])
///     }
/// }
///
/// let mut mass = Mass { force: 0.0 };
/// let mut stepper = Dop853::new().start(&mass, 0.0, SVector::from([1.0, 0.0]))?;
/// for period in 1..=100 {
///     let x = stepper.state();
///     mass.force = -x[0] - 2.0 * x[1];
///     stepper.restart(&mass);
///     let end = 0.1 * f64::from(period);
///     while stepper.time() < end {
///         stepper.step(&mass, end)?;
///     }
/// }
/// assert!(stepper.state()[0].abs() < 1e-2);
/// # Ok::<(), IntegrationError>(())
/// ```
pub trait Stepper<S: Scalar, X: VectorSpace<S>>: Clone {
    /// Whether [`interpolate`](Self::interpolate) is so cheap that sample times need not be ends of
    /// steps.
    const DENSE_OUTPUT: bool;

    /// The time reached.
    fn time(&self) -> f64;

    /// The state at that time.
    fn state(&self) -> &X;

    /// The time from which the last step was taken.
    fn previous_time(&self) -> f64;

    /// What has been done so far.
    fn statistics(&self) -> Statistics;

    /// Takes one step towards the time `target` and never beyond it; the last one lands on it
    /// exactly. At the target there is nothing to do.
    ///
    /// # Errors
    ///
    /// If no step can be taken that is finite and meets the tolerance. The stepper stays at its
    /// time and state.
    fn step<D: Dynamics<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        target: f64,
    ) -> Result<(), IntegrationError>;

    /// The state at a time within the last step.
    fn interpolate<D: Dynamics<S, State = X> + ?Sized>(&mut self, dynamics: &D, t: f64) -> X;

    /// Forgets what was remembered of the dynamics, which have changed: an input that is held for a
    /// while, a load that was picked up.
    fn restart<D: Dynamics<S, State = X> + ?Sized>(&mut self, dynamics: &D);
}

/// What an integration has cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Statistics {
    /// Steps taken.
    pub steps: u64,
    /// Steps tried and taken back, because the estimated error exceeded the tolerance.
    pub rejected: u64,
    /// Evaluations of the derivative.
    pub evaluations: u64,
}

/// An error unless the time, the state and its derivative are finite. Returns the derivative.
pub(crate) fn checked_derivative<S: Scalar, D: Dynamics<S> + ?Sized>(
    dynamics: &D,
    t: f64,
    x: &D::State,
) -> Result<D::State, IntegrationError> {
    checked_state(dynamics, t, x)?;
    let derivative = dynamics.derivative(S::from_f64(t), x);
    match derivative.first_non_finite() {
        None => Ok(derivative),
        Some((index, value)) => Err(IntegrationError::NonFiniteDerivative {
            time: t,
            component: dynamics.component_name(index),
            value: not_finite_of(value),
        }),
    }
}

/// An error unless the time and the state are finite.
pub(crate) fn checked_state<S: Scalar, D: Dynamics<S> + ?Sized>(
    dynamics: &D,
    t: f64,
    x: &D::State,
) -> Result<(), IntegrationError> {
    if !t.is_finite() {
        return Err(IntegrationError::NonFiniteTime { time: t });
    }
    match x.first_non_finite() {
        None => Ok(()),
        Some((index, value)) => Err(IntegrationError::NonFiniteState {
            time: t,
            component: dynamics.component_name(index),
            value: not_finite_of(value),
        }),
    }
}

/// Of several lanes, one that is not finite.
fn not_finite_of<S: Scalar>(value: S) -> f64 {
    let least = value.smallest();
    if least.is_finite() {
        value.largest()
    } else {
        least
    }
}
