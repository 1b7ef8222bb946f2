//! Steppers, and the check that times, states and derivatives are finite.

use super::compensated::Clock;
use super::dynamics::Dynamics;
use super::error::IntegrationError;
use super::step_polynomial::StepPolynomial;
use crate::linalg::{ErrorTolerance, VectorSpace};
use crate::scalar::Scalar;

/// An integration in progress, step by step.
///
/// A clone is a checkpoint: the integration continued from it is the same to the last bit.
/// The steps are taken by [`Advance::step`]. A sampled controller with a zero-order hold, ten times a second:
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
    /// Whether [`interpolate`](Advance::interpolate) is dense output, so cheap that sample times need not be ends of
    /// steps.
    const DENSE_OUTPUT: bool;

    /// The time reached.
    fn time(&self) -> f64;

    /// The state at that time.
    fn state(&self) -> &X;

    /// The time from which the last step was taken.
    fn previous_time(&self) -> f64;

    /// The cost so far.
    fn statistics(&self) -> Statistics;

    /// The state from which the last step was taken, where it is known.
    fn previous_state(&self) -> Option<&X> {
        None
    }

    /// What comes of the Taylor polynomial of the last step, where there is one: events are found by it.
    fn visit_polynomial<V: StepPolynomial<S, X>>(&self, visitor: V) -> Option<V::Output> {
        let _ = visitor;
        None
    }
}

/// A stepper of systems that have what its method needs.
///
/// The dynamics are passed to each step, and must be the same until [`restart`](Self::restart).
pub trait Advance<S: Scalar, D: Dynamics<S> + ?Sized>: Stepper<S, D::State> {
    /// Takes one step towards the time `target` and never beyond it; the last one lands on it
    /// exactly. At the target it does nothing.
    ///
    /// # Errors
    ///
    /// If no step gives a finite state and meets the tolerance, or its end cannot be [projected](Dynamics::project). The stepper keeps its time and state.
    fn step(&mut self, dynamics: &D, target: f64) -> Result<(), IntegrationError>;

    /// The state at a time within the last step, on a curve that ends at the end of the step. It is on the manifold of the dynamics as far
    /// as the tolerance of the method goes; a [`Run`](crate::problem::Run) and samples [project](Dynamics::project) it.
    fn interpolate(&mut self, dynamics: &D, t: f64) -> D::State;

    /// Discards what was computed from the dynamics, because they have changed: a new value of a held input, a load
    /// that was picked up.
    fn restart(&mut self, dynamics: &D);

    /// Goes on from another time and state: after an impact, from where an event is within the last step. The statistics
    /// go on, too.
    ///
    /// # Errors
    ///
    /// If the time, the state or its derivative is not finite, or the state is off the [manifold](Dynamics::project) of the dynamics. The
    /// stepper is as it was then.
    fn restart_at(&mut self, dynamics: &D, t: f64, x: D::State) -> Result<(), IntegrationError>;
}

/// The cost of an integration, and how far its steps were projected.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Statistics {
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps, whose estimated error exceeded the tolerance.
    pub rejected: u64,
    /// Evaluations of the derivative.
    pub evaluations: u64,
    /// How far [`Dynamics::project`] has moved the ends of steps: the largest component of a correction over the error that is
    /// allowed in it; of fixed steps, over the error that a tolerance of 1 would allow. 0 without a projection.
    #[cfg_attr(feature = "serde", serde(default))]
    pub projection: f64,
}

impl Statistics {
    /// Accepted and rejected steps.
    #[must_use]
    pub fn attempts(&self) -> u64 {
        self.steps.saturating_add(self.rejected)
    }

    /// The cost of this part and of another one.
    #[must_use]
    pub(crate) fn plus(self, other: Self) -> Self {
        Self {
            steps: self.steps + other.steps,
            rejected: self.rejected + other.rejected,
            evaluations: self.evaluations + other.evaluations,
            projection: self.projection.max(other.projection),
        }
    }
}

/// The time from `clock` to `target`; none at the target.
pub(crate) fn remaining(clock: &Clock, target: f64) -> Result<Option<f64>, IntegrationError> {
    let remaining = clock.until(target);
    if remaining.is_finite() {
        Ok(Some(remaining).filter(|remaining| *remaining != 0.0))
    } else {
        Err(IntegrationError::NonFiniteTime { time: target })
    }
}

/// The derivative; an error unless it, the time and the state are finite, and errors that are allowed are numbers.
pub(crate) fn checked_derivative<S: Scalar, D: Dynamics<S> + ?Sized>(
    dynamics: &D,
    t: f64,
    x: &D::State,
) -> Result<D::State, IntegrationError> {
    checked_state(dynamics, t, x)?;
    checked_sizes(dynamics, x)?;
    let reduced = dynamics.reduced(x, &x.zeroed());
    let derivative = derivative_apart(dynamics, S::from_f64(t), &reduced);
    match derivative.first_non_finite() {
        None => Ok(derivative),
        Some((index, value)) => Err(IntegrationError::NonFiniteDerivative {
            time: t,
            component: dynamics.component_name(index),
            value: non_finite_lane(value),
        }),
    }
}

/// An error if what is allowed in a component is negative or not a number.
#[inline(never)]
fn checked_sizes<S: Scalar, D: Dynamics<S> + ?Sized>(
    dynamics: &D,
    x: &D::State,
) -> Result<(), IntegrationError> {
    let one = ErrorTolerance {
        relative: 0.0,
        absolute: 1.0,
        rate: S::one(),
    };
    let allowed = dynamics.allowed_error(x, &one);
    let sizes = allowed.components().map(Scalar::smallest);
    match sizes
        .enumerate()
        .find(|(_, size)| size.is_nan() || *size < 0.0)
    {
        None => Ok(()),
        Some((index, size)) => Err(IntegrationError::InvalidSize {
            component: dynamics.component_name(index),
            size,
        }),
    }
}

/// The derivative, where it is one evaluation of many: its code is not repeated there.
#[inline(never)]
pub(crate) fn derivative_apart<S: Scalar, D: Dynamics<S> + ?Sized>(
    dynamics: &D,
    t: S,
    x: &D::State,
) -> D::State {
    dynamics.derivative(t, x)
}

/// An error unless the time and the state are finite.
#[inline]
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
        Some(found) => Err(non_finite_state(dynamics, t, found)),
    }
}

#[cold]
fn non_finite_state<S: Scalar, D: Dynamics<S> + ?Sized>(
    dynamics: &D,
    time: f64,
    (index, value): (usize, S),
) -> IntegrationError {
    IntegrationError::NonFiniteState {
        time,
        component: dynamics.component_name(index),
        value: non_finite_lane(value),
    }
}

/// The value of a lane that is not finite.
fn non_finite_lane<S: Scalar>(value: S) -> f64 {
    let least = value.smallest();
    if least.is_finite() {
        value.largest()
    } else {
        least
    }
}
