//! Numerical derivatives by Richardson extrapolation of central differences.
//!
//! Central differences with shrinking steps are extrapolated to step 0, and the entry of the tableau with the smallest
//! estimated error is taken: C. J. F. Ridders, *Accurate computation of F′(x) and F′(x) F″(x)*, Adv. Eng. Softw. **4**
//! (1982) 75–76. In contrast to Ridders, all steps are taken, even after rounding errors appear, so that steep
//! functions are resolved. The ratio of the steps is irrational, so that no period is missed.

use crate::limits::derivative_checks::{
    COLUMNS, MIN_JUMP, ROUNDING_AMPLIFICATION, SHORTER_STEPS, STEP_RATIO, STEPS,
};

/// A numerical derivative and an estimate of its error.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NumericalDerivative {
    pub(crate) value: f64,
    pub(crate) error: f64,
}

/// A difference quotient.
#[derive(Clone, Copy)]
struct Quotient {
    step: f64,
    value: f64,
    /// The magnitude of the two values.
    size: f64,
    /// The rounding error of the quotient.
    rounding: f64,
}

impl NumericalDerivative {
    /// Returns the derivative of `value` at `x`, from values at most `reach` away; `None` if they are not finite.
    ///
    /// `epsilon` is the machine epsilon of the scalar on which `value` is evaluated.
    pub(crate) fn central(
        value: impl Fn(f64) -> f64,
        epsilon: f64,
        x: f64,
        reach: f64,
    ) -> Option<Self> {
        let quotient = |step: f64| {
            let (left, right) = (x - step, x + step);
            let (before, after) = (value(left), value(right));
            let slope = (after - before) / (right - left);
            let size = before.abs() + after.abs();
            Quotient {
                step,
                value: slope,
                size,
                rounding: epsilon * (size + (x * slope).abs()) / step,
            }
        };
        let mut step = reach;
        let mut quotients = [(); STEPS].map(|()| {
            let quotient = quotient(step);
            step *= STEP_RATIO;
            quotient
        });
        let jump = jump(&quotients, quotient);
        for quotient in &mut quotients {
            quotient.rounding = quotient.rounding.max(jump / quotient.step);
        }
        best(&quotients)
    }
}

/// Returns the entry of the tableau with the smallest estimated error.
fn best(quotients: &[Quotient; STEPS]) -> Option<NumericalDerivative> {
    let tableau = tableau(quotients);
    let mut best: Option<NumericalDerivative> = None;
    for row in 1..STEPS - SHORTER_STEPS {
        for column in 1..COLUMNS {
            let value = tableau[row][column];
            let neighbours = [tableau[row][column - 1], tableau[row - 1][column - 1]];
            let neighbours = neighbours.map(|neighbour| (value - neighbour).abs());
            // Differences from the results of shorter steps are due to noise of the values, which matters less for
            // longer steps.
            let step = quotients[row].step;
            let noise = (row + 1..STEPS).map(|shorter| {
                (tableau[shorter][column] - value).abs() * quotients[shorter].step / step
            });
            let noise = noise.filter(|noise| noise.is_finite()).fold(0.0, f64::max);
            let error = neighbours[0].max(neighbours[1])
                + noise
                + ROUNDING_AMPLIFICATION * quotients[row].rounding;
            if error.is_finite() && best.is_none_or(|best| error < best.error) {
                best = Some(NumericalDerivative { value, error });
            }
        }
    }
    best
}

/// Returns the Richardson tableau: the quotients, and columns in each of which one more power of the squared step is
/// eliminated.
fn tableau(quotients: &[Quotient; STEPS]) -> [[f64; COLUMNS]; STEPS] {
    let mut above = [f64::NAN; COLUMNS];
    quotients.map(|quotient| {
        let mut row = [quotient.value; COLUMNS];
        let mut weight = 1.0;
        for column in 1..COLUMNS {
            weight /= STEP_RATIO * STEP_RATIO;
            let left = row[column - 1];
            row[column] = left + (left - above[column - 1]) / (weight - 1.0);
        }
        above = row;
        row
    })
}

/// Returns the quantization of coarsely rounded values, which do not change at all at short steps: the height of the
/// first jump. A function with a plateau changes by less, and a function with real discontinuities by more.
fn jump(quotients: &[Quotient; STEPS], quotient: impl Fn(f64) -> Quotient) -> f64 {
    let changes = |quotient: &Quotient| quotient.value != 0.0;
    let Some(last) = quotients.iter().rposition(changes) else {
        return 0.0;
    };
    let Some(next) = quotients.get(last + 1) else {
        return 0.0;
    };
    let (mut inside, mut outside) = (next.step, quotients[last]);
    for _ in 0..STEPS {
        let middle = quotient(0.5 * (inside + outside.step));
        if changes(&middle) {
            outside = middle;
        } else {
            inside = middle.step;
        }
    }
    let jump = (2.0 * outside.value * outside.step).abs();
    let size = quotients.iter().map(|quotient| quotient.size);
    let size = size.filter(|size| size.is_finite()).fold(0.0, f64::max);
    if jump <= MIN_JUMP * size { jump } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::NumericalDerivative;

    fn measured(value: impl Fn(f64) -> f64, x: f64, reach: f64) -> NumericalDerivative {
        NumericalDerivative::central(value, f64::EPSILON, x, reach).unwrap()
    }

    #[test]
    fn slopes_are_within_their_errors() {
        type Case = (&'static str, fn(f64) -> f64, fn(f64) -> f64, f64, f64);
        let cases: [Case; 8] = [
            ("sin", libm::sin, libm::cos, 0.7, 0.3),
            ("exp", libm::exp, libm::exp, -30.0, 5.0),
            ("sqrt", libm::sqrt, |x| 0.5 / libm::sqrt(x), 1e-6, 0.9e-6),
            ("1/x", |x| 1.0 / x, |x| -1.0 / (x * x), 1e9, 1e8),
            (
                "steep",
                |x| libm::tanh(1e4 * x),
                |x| 1e4 / libm::pow(libm::cosh(1e4 * x), 2.0),
                1e-4,
                0.5,
            ),
            (
                "periodic",
                |x| libm::sin(core::f64::consts::TAU * x),
                |_| core::f64::consts::TAU,
                0.0,
                1.0,
            ),
            ("offset", |x| 1e6 + libm::sin(x), libm::cos, 0.7, 0.3),
            ("kinked", f64::abs, |_| 1.0, 1e-3, 0.5),
        ];
        for (name, value, derivative, x, reach) in cases {
            let NumericalDerivative { value, error } = measured(value, x, reach);
            let expected = derivative(x);
            assert!(
                (value - expected).abs() <= error,
                "{name}: {value} for {expected}, {error}"
            );
            assert!(
                error <= 1e-7 * expected.abs(),
                "{name}: {error} of {expected}"
            );
        }
    }

    #[test]
    fn noise_is_part_of_the_error() {
        // Rounded to nine decimals, like a table.
        let value = |x: f64| libm::round(libm::sin(x) * 1e9) / 1e9;
        for n in 0..200 {
            let x = 0.01 * f64::from(n);
            let NumericalDerivative { value, error } = measured(value, x, 0.2);
            assert!(
                (value - libm::cos(x)).abs() <= error,
                "at {x}: {value}, {error}"
            );
            assert!(error < 1e-5, "at {x}: {error}");
        }
    }

    #[test]
    fn noise_is_seen_at_short_steps_too() {
        // Noise as random as a hash, of a few parts in 10⁹.
        let hash = |x: f64| x.to_bits().wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let noise = |x: f64| if hash(x) >> 63 == 0 { 4e-9 } else { 0.0 };
        let value = |x: f64| libm::sin(x) + noise(x);
        for n in 0..200 {
            let x = 0.01 * f64::from(n);
            let NumericalDerivative { value, error } = measured(value, x, 0.2);
            assert!(
                (value - libm::cos(x)).abs() <= error,
                "at {x}: {value}, {error}"
            );
            assert!(error < 1e-5, "at {x}: {error}");
        }
    }

    #[test]
    fn plateaus_and_steps_are_flat() {
        let dead_zone = |x: f64| (x.abs() - 0.5).max(0.0) * x.signum();
        let gears = |x: f64| libm::floor(4.0 * x);
        for n in 0..100 {
            let x = 0.004_1 * f64::from(n) + 0.01;
            let NumericalDerivative { value, error } = measured(dead_zone, x, 0.7);
            assert!(
                value.abs() <= error && error < 1e-6,
                "at {x}: {value}, {error}"
            );
            let NumericalDerivative { value, error } = measured(gears, x, 0.7);
            assert!(
                value.abs() <= error && error < 1e-6,
                "at {x}: {value}, {error}"
            );
        }
    }

    #[test]
    fn there_is_no_slope_where_there_are_no_values() {
        assert!(NumericalDerivative::central(|_| f64::NAN, f64::EPSILON, 0.0, 1.0).is_none());
        // A value that is missing only at long steps does no harm.
        let NumericalDerivative { value, .. } =
            measured(|x| if x > 1.1 { f64::NAN } else { x * x }, 1.0, 0.5);
        assert!((value - 2.0).abs() < 1e-9);
    }
}
