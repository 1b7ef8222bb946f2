//! Step size control: Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*, 2nd edition (1993), II.4
//! (control and first step) and II.10 (error estimate).

use super::coefficients::{FIFTH_ORDER_ERROR, THIRD_ORDER};
use super::{ALL_STAGES, STAGES};
use crate::integrate::compensated::Clock;
use crate::integrate::dynamics::Dynamics;
use crate::integrate::error::IntegrationError;
use crate::integrate::runge_kutta::combination;
use crate::integrate::stepper::derivative_apart;
use crate::integrate::tolerance::{Tolerance, ratios, squares_over_step};
use crate::limits::dormand_prince::{
    MAX_ERROR, MAX_GROWTH, MAX_PROBES, MAX_SHRINKAGE, MAX_STALLED_ATTEMPTS, MIN_ERROR, NEGLIGIBLE,
    PROBE, SAFETY, SHORTENED_PROBE, SMALL_STEP, THIRD_ORDER_WEIGHT, ZERO_DERIVATIVE,
};
use crate::linalg::{ErrorTolerance, VectorSpace, first_largest};
use crate::scalar::Scalar;

/// The bits of 1.
const ONE: u64 = 1.0_f64.to_bits();

/// 9/8 of the bits of 1, minus 0.055 of the distance to the bits of 2: the first guess below is then off by at most
/// 0.031.
const GUESS: u64 = ONE + ONE / 8 - 247_697_979_505_377;

/// Returns x^(−1/8) of a number between 1e-100 and 1e100 to one part in 7000; 8 is the order of the error.
///
/// The next step waits for it: three square roots and a division took 3 % of the time of a step of the symmetric top.
/// The bits of a number, read as an integer, are approximately its logarithm (J. F. Blinn, *Floating-point tricks*,
/// IEEE Computer Graphics and Applications **17** (1997) 80–84), which gives a guess y. The binomial series of
/// (1 − r)^(−1/8) in r = 1 − x y⁸ corrects it.
#[inline]
fn reciprocal_root(x: f64) -> f64 {
    let y = f64::from_bits(GUESS.wrapping_sub(x.to_bits() >> 3));
    let square = y * y;
    let fourth = square * square;
    let r = 1.0 - (x * fourth) * fourth;
    let series = Scalar::mul_add(r, 51.0 / 1024.0, 9.0 / 128.0);
    let series = Scalar::mul_add(r, series, 0.125);
    Scalar::mul_add(y * r, series, y)
}

/// The result of an attempted step.
pub(super) struct Attempt {
    /// The estimated error over the tolerance.
    pub(super) error: f64,
    /// Whether the new state is finite.
    pub(super) finite: Result<(), IntegrationError>,
}

/// Returns the error of a step over the tolerance from the estimates of orders 5 and 3: h e₅² / √(e₅² + 0.01 e₃²),
/// (10.17) of II.10, where e₅ and e₃ are the root mean squares of the two estimates.
#[inline]
pub(super) fn error<S: Scalar, X: VectorSpace<S>>(
    [fifth, third]: [&X; 2],
    h: f64,
    allowed: &[X; 2],
) -> f64 {
    let ([fifth, third], components) = squares_over_step([fifth, third], allowed);
    let denominator = fifth + THIRD_ORDER_WEIGHT * third;
    if denominator == 0.0 {
        return 0.0;
    }
    h.abs() * fifth / Scalar::sqrt(components * denominator)
}

/// The size of the next step, a positive number.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct StepControl {
    step: f64,
    /// Whether the last attempt was rejected: the next step must then not be longer than it.
    rejected: bool,
    /// The number of consecutive attempts with negligible steps.
    stalled: u32,
    /// The time scale of the motion: the one at its start, or the longest step so far. A time scale that followed the
    /// present step would allow ever larger errors of velocities where steps become short, as near a collision.
    time_scale: f64,
}

impl StepControl {
    pub(super) fn new(step: f64, time_scale: Option<f64>) -> Self {
        Self {
            step,
            rejected: false,
            stalled: 0,
            time_scale: time_scale.unwrap_or(0.0),
        }
    }

    /// Returns the time scale over a step `h`.
    pub(super) fn time_scale(&self, h: f64) -> f64 {
        self.time_scale.max(h.abs())
    }

    /// Whether steps have been negligible for so long that the integration makes no progress. This happens near t = 0,
    /// where even the shortest step advances the time.
    pub(super) fn stalls(&mut self, h: f64, remaining: f64) -> bool {
        let stalling = h.abs() < f64::EPSILON * remaining.abs();
        self.stalled = if stalling { self.stalled + 1 } else { 0 };
        self.stalled > MAX_STALLED_ATTEMPTS
    }

    pub(super) fn step(&self) -> f64 {
        self.step
    }

    /// Accepts or rejects a step of size `h`, and chooses the next step size.
    pub(super) fn accepts(&mut self, attempt: &Attempt, h: f64) -> bool {
        if attempt.finite.is_err() || !attempt.error.is_finite() {
            self.step = h / MAX_SHRINKAGE;
            self.rejected = true;
            return false;
        }
        // Beyond these errors the bounds of growth decide.
        let growth = SAFETY * reciprocal_root(attempt.error.clamp(MIN_ERROR, MAX_ERROR));
        if attempt.error > 1.0 {
            self.step = h * growth.max(1.0 / MAX_SHRINKAGE);
            self.rejected = true;
            return false;
        }
        self.time_scale = self.time_scale(h);
        let step = h * growth.clamp(1.0 / MAX_SHRINKAGE, MAX_GROWTH);
        // A step that was shortened to land on a time does not shorten the step that was planned before.
        let planned = if self.rejected { step.min(h) } else { step };
        self.step = if h < self.step {
            planned.max(self.step)
        } else {
            planned
        };
        self.rejected = false;
        true
    }
}

/// Returns the size of the first step from `(clock, x)`, where the derivative is `slope`. It is at most `longest`,
/// whose sign is the direction. This costs one evaluation.
///
/// An explicit Euler step estimates the second derivative; the step is such that h⁸ times the larger of the derivatives
/// is 0.01 (II.4, "Starting Step Size"). If the system provides a time scale, it is the unit of time, so that the step
/// does not depend on the unit of time of the equations. A component that is zero and has no absolute tolerance does
/// not count.
pub(super) fn initial_step<S: Scalar, D: Dynamics<S> + ?Sized>(
    dynamics: &D,
    (clock, x, slope): (Clock, &D::State, &D::State),
    longest: f64,
    time_scale: Option<f64>,
    tolerance: Tolerance,
) -> f64 {
    let unit = time_scale.unwrap_or(1.0);
    let sizes = Tolerance {
        relative: 1.0,
        absolute: 0.0,
    };
    let [size, allowed] = [sizes, tolerance]
        .map(|tolerance| dynamics.allowed_error(x, &tolerance.over(S::from_f64(unit))));
    let norm = |vector: &D::State| {
        let squares = ratios(vector, &allowed, 0.0).map(|ratio| ratio * ratio);
        Scalar::sqrt(squares.fold(0.0, |sum, square| sum + square))
    };
    let (zeroth, first) = (norm(&size), norm(slope) * unit);
    let probe = PROBE * zeroth / first;
    let scaled = first > NEGLIGIBLE && zeroth > NEGLIGIBLE && probe.is_normal();
    let probe = if scaled { probe } else { SMALL_STEP };
    let most = longest.abs() / unit;
    let probe = probe.min(most);

    let euler = (probe * unit).copysign(longest);
    let mut ahead = dynamics.reduced(x, &x.zeroed());
    ahead.add_scaled(S::from_f64(euler), slope);
    let mut change = derivative_apart(dynamics, S::from_f64(clock.after(euler)), &ahead);
    change.add_scaled(-S::one(), slope);
    let steepest = (norm(&change) * unit / probe).max(first);
    let step = if steepest <= ZERO_DERIVATIVE {
        (probe * SHORTENED_PROBE).max(SMALL_STEP)
    } else if steepest.is_finite() {
        Scalar::sqrt(Scalar::sqrt(Scalar::sqrt(PROBE / steepest)))
    } else {
        probe
    };
    (step.min(MAX_PROBES * probe) * unit).min(longest.abs())
}

/// Returns the error for a step size that is too small to advance the time at (t, x), or below `smallest` if this is
/// set. `stages` are the stages of the last attempt.
#[cold]
pub(super) fn too_small<S: Scalar, D: Dynamics<S> + ?Sized>(
    dynamics: &D,
    (time, x): (f64, &D::State),
    (step, smallest): (f64, Option<f64>),
    stages: &[D::State; ALL_STAGES],
    tolerance: ErrorTolerance<S>,
) -> IntegrationError {
    if let Some(singularity) = dynamics.vanishing_inertia(S::from_f64(time), x) {
        return IntegrationError::VanishingInertia {
            time,
            step,
            singularity,
        };
    }
    let allowed = dynamics.allowed_error(x, &tolerance);
    let error = combination(&FIFTH_ORDER_ERROR, stages, &x.zeroed());
    let (worst, _) = first_largest(ratios(&error, &allowed, f64::INFINITY));
    let component = dynamics.component_name(worst);
    if let Some(step) = smallest {
        return IntegrationError::SmallestStep {
            time,
            step,
            component,
        };
    }
    IntegrationError::StepTooSmall {
        time,
        step,
        component: Some(component),
        relative_only: tolerance.absolute == 0.0,
    }
}

const _: () = assert!(FIFTH_ORDER_ERROR.len() == STAGES && THIRD_ORDER.len() == STAGES);

#[cfg(test)]
mod tests {
    use super::reciprocal_root;

    #[test]
    fn reciprocal_roots_have_four_digits() {
        for i in 0..40_000_u32 {
            let x = libm::exp2(f64::from(i) * 0.002 - 40.0);
            let exact = libm::pow(x, -0.125);
            assert!((reciprocal_root(x) / exact - 1.0).abs() < 1.5e-4, "{x:e}");
        }
    }
}
