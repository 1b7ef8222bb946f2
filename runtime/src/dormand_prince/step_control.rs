//! How long a step may be: Hairer, Nørsett & Wanner, II.4 and II.10.

use super::coefficients::{FIFTH_ORDER_ERROR, THIRD_ORDER, WEIGHTS};
use super::{ALL_STAGES, STAGES};
use crate::{
    Dynamics, IntegrationError, Scalar, VectorSpace, compensated::Clock, runge_kutta::combination,
};

/// A new step is that which would just meet the tolerance, times this.
const SAFETY: f64 = 0.9;

/// A step is at most this much shorter than the one before.
const MOST_SHORTENING: f64 = 1.0 / 0.333;

/// A step is at most this much longer than the one before.
const MOST_LENGTHENING: f64 = 6.0;

/// The error of a step goes with the eighth power of its size.
const ORDER: f64 = 8.0;

/// The errors that are allowed in a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Tolerance {
    pub(crate) relative: f64,
    pub(crate) absolute: f64,
}

impl Tolerance {
    pub(crate) fn check(self) -> Result<(), IntegrationError> {
        let Self { relative, absolute } = self;
        let valid = |tolerance: f64| tolerance.is_finite() && tolerance >= 0.0;
        if valid(relative) && valid(absolute) && relative + absolute > 0.0 {
            Ok(())
        } else {
            Err(IntegrationError::InvalidTolerance { relative, absolute })
        }
    }

    /// The sum of the squares of the components, each in relation to the error allowed at the
    /// larger of two sizes; and the number of components. Of several lanes the largest counts.
    #[inline]
    fn squares<S: Scalar, X: VectorSpace<S>>(self, vector: &X, sizes: &[X; 2]) -> (f64, f64) {
        let [before, after] = sizes;
        let relative = S::from_f64(self.relative);
        let absolute = S::from_f64(self.absolute);
        let larger = before.components().zip(after.components());
        let scaled = vector.components().zip(larger).map(|(component, (a, b))| {
            let size = component.abs();
            // What is exactly 0 has no error, also where the tolerance for it is 0.
            if size.largest() == 0.0 {
                return 0.0;
            }
            (size / (absolute + relative * a.max(b))).largest()
        });
        scaled.fold((0.0, 0.0), |(sum, count), ratio| {
            (sum + ratio * ratio, count + 1.0)
        })
    }
}

/// What came of trying a step.
pub(super) struct Attempt {
    /// The estimated error in relation to the tolerance.
    pub(super) error: f64,
    /// Whether the new state is finite.
    pub(super) finite: Result<(), IntegrationError>,
}

/// The error of a step in relation to the tolerance: h e₅² / √(e₅² + 0.01 e₃²), (10.17) of II.10,
/// where e₅ and e₃ are the root mean squares of the estimates of orders 5 and 3.
#[inline]
pub(super) fn error<S: Scalar, X: VectorSpace<S>>(
    stages: &[X; ALL_STAGES],
    h: f64,
    sizes: &[X; 2],
    tolerance: Tolerance,
) -> f64 {
    let zero = sizes[0].zeroed();
    let fifth = combination(&FIFTH_ORDER_ERROR, stages, &zero);
    let mut third = combination(&WEIGHTS, stages, &zero);
    third.add_scaled(-S::one(), &combination(&THIRD_ORDER, stages, &zero));
    let (fifth, components) = tolerance.squares(&fifth, sizes);
    let (third, _) = tolerance.squares(&third, sizes);
    let denominator = fifth + 0.01 * third;
    if denominator == 0.0 {
        return 0.0;
    }
    h.abs() * fifth / Scalar::sqrt(components * denominator)
}

/// The size of the next step, a positive number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct StepControl {
    step: f64,
    /// Whether the last attempt was rejected: the next step is then not to be longer.
    rejected: bool,
}

impl StepControl {
    pub(super) fn new(step: f64) -> Self {
        Self {
            step,
            rejected: false,
        }
    }

    pub(super) fn step(&self) -> f64 {
        self.step
    }

    /// Decides on a step of size `h`, and what to try next.
    pub(super) fn accepts(&mut self, attempt: &Attempt, h: f64) -> bool {
        if attempt.finite.is_err() || !attempt.error.is_finite() {
            self.step = h / MOST_SHORTENING;
            self.rejected = true;
            return false;
        }
        let shortening = Scalar::powf(attempt.error, 1.0 / ORDER) / SAFETY;
        if attempt.error > 1.0 {
            self.step = h / shortening.min(MOST_SHORTENING);
            self.rejected = true;
            return false;
        }
        let step = h / shortening.clamp(1.0 / MOST_LENGTHENING, MOST_SHORTENING);
        // A step cut short to land on a time says nothing against the longer one planned before.
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

/// The size of the first step from `(clock, x)`, where the derivative is `slope`; at most
/// `longest`, whose sign is the direction. It costs one evaluation.
///
/// An explicit Euler step estimates the second derivative; the step is such that h⁸ times the
/// larger of the derivatives is 0.01: II.4, the algorithm at its end.
pub(super) fn initial_step<S: Scalar, D: Dynamics<S> + ?Sized>(
    dynamics: &D,
    clock: Clock,
    x: &D::State,
    slope: &D::State,
    longest: f64,
    tolerance: Tolerance,
) -> f64 {
    let size = dynamics.magnitude(x);
    let sizes = [size.clone(), size.clone()];
    let (first, _) = tolerance.squares(slope, &sizes);
    let (zeroth, _) = tolerance.squares(&size, &sizes);
    let guess = if first <= 1e-10 || zeroth <= 1e-10 {
        1e-6
    } else {
        0.01 * Scalar::sqrt(zeroth / first)
    };
    let guess = guess.min(longest.abs());

    let euler = guess.copysign(longest);
    let mut ahead = x.clone();
    ahead.add_scaled(S::from_f64(euler), slope);
    let mut change = dynamics.derivative(S::from_f64(clock.after(euler)), &ahead);
    change.add_scaled(-S::one(), slope);
    let second = Scalar::sqrt(tolerance.squares(&change, &sizes).0) / guess;

    let steepest = second.max(Scalar::sqrt(first));
    let step = if steepest <= 1e-15 {
        (guess * 1e-3).max(1e-6)
    } else {
        Scalar::powf(0.01 / steepest, 1.0 / ORDER)
    };
    step.min(100.0 * guess).min(longest.abs())
}

const _: () = assert!(FIFTH_ORDER_ERROR.len() == STAGES && THIRD_ORDER.len() == STAGES);
