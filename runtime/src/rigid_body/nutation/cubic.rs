//! The two roots of a cubic between which a motion oscillates.

use crate::limits::rigid_bodies::{MAX_BISECTIONS, POLISHING_STEPS};

/// Returns the roots of a cubic on both sides of 0. The cubic is nonnegative at 0 and nonpositive at `bounds`, which
/// enclose the roots.
pub(super) fn roots_around_zero(coefficients: [f64; 4], bounds: [f64; 2]) -> [f64; 2] {
    let [constant, slope, bend, leading] = coefficients;
    let cubic = |x: f64| constant + x * (slope + x * (bend + x * leading));
    let deflated = |x: f64| slope + x * (bend + x * leading);
    if constant > 0.0 {
        bounds.map(|bound| bisect(cubic, bound))
    } else if slope > 0.0 {
        [0.0, bisect(deflated, bounds[1])]
    } else if slope < 0.0 {
        [bisect(|x| -deflated(x), bounds[0]), 0.0]
    } else {
        [0.0, 0.0]
    }
}

/// Returns the root of a cubic near `x` by Newton's method, to the last digit even if it is small.
pub(super) fn polished_root(coefficients: [f64; 4], mut x: f64) -> f64 {
    let [constant, slope, bend, leading] = coefficients;
    for _ in 0..POLISHING_STEPS {
        let value = constant + x * (slope + x * (bend + x * leading));
        x -= value / (slope + x * (2.0 * bend + 3.0 * x * leading));
    }
    x
}

/// Returns the sign change of a function that is positive at 0 but not at `outside`, to the last digit.
fn bisect(function: impl Fn(f64) -> f64, mut outside: f64) -> f64 {
    let mut inside = 0.0;
    for _ in 0..MAX_BISECTIONS {
        let middle = 0.5 * (inside + outside);
        if middle - inside == 0.0 || outside - middle == 0.0 {
            break;
        }
        if function(middle) > 0.0 {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    inside
}

#[cfg(test)]
mod tests {
    use super::{polished_root, roots_around_zero};

    #[track_caller]
    fn close(value: f64, expected: f64, tolerance: f64) {
        let error = (value - expected).abs();
        assert!(
            error <= tolerance,
            "{value} in place of {expected}: {error:e}"
        );
    }

    #[test]
    fn roots_on_both_sides() {
        // (x + 1/4) (1/2 − x) (2 − x)
        let [below, above] = roots_around_zero([0.25, 0.375, -2.25, 1.0], [-1.0, 1.0]);
        close(below, -0.25, 1e-16);
        close(above, 0.5, 1e-16);
    }

    #[test]
    fn a_root_at_zero_is_exact() {
        // x (1/2 − x) (2 − x), and its mirror image
        let [below, above] = roots_around_zero([0.0, 1.0, -2.5, 1.0], [-1.0, 1.0]);
        close(below, 0.0, 0.0);
        close(above, 0.5, 1e-16);
        let [below, above] = roots_around_zero([0.0, -1.0, -2.5, -1.0], [-1.0, 1.0]);
        close(below, -0.5, 1e-16);
        close(above, 0.0, 0.0);
    }

    #[test]
    fn a_double_root_at_zero_is_exact() {
        let [below, above] = roots_around_zero([0.0, 0.0, -1.0, 1.0], [-1.0, 0.5]);
        close(below, 0.0, 0.0);
        close(above, 0.0, 0.0);
    }

    #[test]
    fn a_small_root_has_all_its_digits() {
        // (x − 10⁻²⁰) (x − 1)² by its leading digits; relative to 1, the root is below the rounding errors.
        let root = polished_root([-1e-20, 1.0, -2.0, 1.0], 1e-16);
        close(root / 1e-20, 1.0, 1e-15);
    }

    /// Bisection ends at a root at the smallest number, and for a function that is never positive.
    #[test]
    fn bisection_ends() {
        let [_, above] = roots_around_zero([0.0, f64::MIN_POSITIVE, -1.0, 0.0], [-1.0, 1.0]);
        close(above / f64::MIN_POSITIVE, 1.0, 1e-15);
        let found = roots_around_zero([1.0, f64::NAN, 0.0, 0.0], [-1.0, 1.0]);
        assert!(found.iter().all(|x| x.is_finite()));
    }
}
