//! Steppers, and checks that times, states and derivatives are finite.

use super::compensated::Clock;
use super::dynamics::Dynamics;
use super::error::IntegrationError;
use super::step_polynomial::StepPolynomial;
use crate::linalg::{ErrorTolerance, VectorSpace};
use crate::scalar::Scalar;

/// An integration in progress, step by step.
///
/// A clone is a checkpoint: an integration continued from it is identical to the last bit. Steps are taken by
/// [`Advance::step`]. For example, a sampled controller with a zero-order hold, ten times a second:
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
    /// Whether [`interpolate`](Advance::interpolate) is dense output, which is cheap enough that sample times need not
    /// be ends of steps.
    const DENSE_OUTPUT: bool;

    /// Returns the time reached.
    fn time(&self) -> f64;

    /// Returns the state at that time.
    fn state(&self) -> &X;

    /// Returns the time at the beginning of the last step.
    fn previous_time(&self) -> f64;

    /// Returns the statistics so far.
    fn statistics(&self) -> Statistics;

    /// Returns the state at the beginning of the last step, if it is known.
    fn previous_state(&self) -> Option<&X> {
        None
    }

    /// Applies a visitor to the Taylor polynomial of the last step, if there is one; events are found by it.
    fn visit_polynomial<V: StepPolynomial<S, X>>(&self, visitor: V) -> Option<V::Output> {
        let _ = visitor;
        None
    }
}

/// A stepper for the dynamics that its method supports.
///
/// The dynamics are passed to each step, and must not change until [`restart`](Self::restart) is called.
pub trait Advance<S: Scalar, D: Dynamics<S> + ?Sized>: Stepper<S, D::State> {
    /// Takes one step towards the time `target`, and never beyond it; the last step lands on it exactly. At the target
    /// nothing is done.
    ///
    /// # Errors
    ///
    /// If no step gives a finite state and meets the tolerance, or its end cannot be [projected](Dynamics::project).
    /// The stepper then keeps its time and state.
    fn step(&mut self, dynamics: &D, target: f64) -> Result<(), IntegrationError>;

    /// Returns the state at a time within the last step, on a curve that ends at the end of the step. It is on the
    /// manifold of the dynamics within the tolerance of the method; a [`Run`](crate::problem::Run) and samples
    /// [project](Dynamics::project) it.
    fn interpolate(&mut self, dynamics: &D, t: f64) -> D::State;

    /// Discards everything computed from the dynamics, because they have changed, for example by a new value of a held
    /// input.
    fn restart(&mut self, dynamics: &D);

    /// Continues from another time and state, for example after an impact, at the time of an event within the last
    /// step. The statistics are continued, too.
    ///
    /// # Errors
    ///
    /// If the time, the state or its derivative is not finite, or the state is off the [manifold](Dynamics::project) of
    /// the dynamics. The stepper is then unchanged.
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
    /// The largest move of the end of a step by [`Dynamics::project`]: the largest component of a correction over its
    /// allowed error; for fixed steps, over the error that a tolerance of 1 would allow. 0 without a projection.
    #[cfg_attr(feature = "serde", serde(default))]
    pub projection: f64,
    /// Steps at whose ends the accelerations of a model with constraints are solved for with pivoting, by a dense numerical
    /// factorization, because a pivot without it would be too small; in several lanes at once, steps in which one of them is.
    #[cfg_attr(feature = "serde", serde(default))]
    pub pivoted: u64,
}

impl Statistics {
    /// Returns the number of accepted and rejected steps.
    #[must_use]
    pub fn attempts(&self) -> u64 {
        self.steps.saturating_add(self.rejected)
    }

    /// Returns the combined statistics of this part and another one.
    #[must_use]
    pub(crate) fn plus(self, other: Self) -> Self {
        Self {
            steps: self.steps + other.steps,
            rejected: self.rejected + other.rejected,
            evaluations: self.evaluations + other.evaluations,
            projection: self.projection.max(other.projection),
            pivoted: self.pivoted + other.pivoted,
        }
    }

    /// Notes the projection of the end of a step, which moved it by so much and is pivoted where this is positive.
    pub(crate) fn note_projection(&mut self, distance: f64, pivoted: f64) {
        self.projection = self.projection.max(distance);
        self.pivoted += u64::from(pivoted > 0.0);
    }
}

/// Returns the time from `clock` to `target`; `None` at the target.
pub(crate) fn remaining(clock: &Clock, target: f64) -> Result<Option<f64>, IntegrationError> {
    let remaining = clock.until(target);
    if remaining.is_finite() {
        Ok(Some(remaining).filter(|remaining| *remaining != 0.0))
    } else {
        Err(IntegrationError::NonFiniteTime { time: target })
    }
}

/// Returns the derivative, or an error unless the derivative, the time and the state are finite and the allowed errors
/// are valid.
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

/// Returns an error if the allowed error of a component is negative or not a number.
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

/// Evaluates the derivative out of line. It is called where it is one evaluation of many, so that its code is not
/// repeated there.
#[inline(never)]
pub(crate) fn derivative_apart<S: Scalar, D: Dynamics<S> + ?Sized>(
    dynamics: &D,
    t: S,
    x: &D::State,
) -> D::State {
    dynamics.derivative(t, x)
}

/// Returns an error unless the time and the state are finite.
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

/// Returns the value of a lane that is not finite.
fn non_finite_lane<S: Scalar>(value: S) -> f64 {
    let least = value.smallest();
    if least.is_finite() {
        value.largest()
    } else {
        least
    }
}
