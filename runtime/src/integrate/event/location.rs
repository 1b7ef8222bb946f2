//! The location of a zero between two times.
//!
//! I. F. D. Oliveira & R. H. C. Takahashi, *An Enhancement of the Bisection Method Average Performance Preserving
//! Minmax Optimality*, ACM Trans. Math. Softw. **47** (2021) 5: interpolate, truncate, project. It takes at most one
//! evaluation more than bisection, and only a few for a smooth function.

use crate::limits::events::DIVISIONS;

/// An end of a bracket: a time, and the value of the function there.
pub(crate) type End = (f64, f64);

/// The sequence of trial times within a shrinking bracket.
pub(crate) struct Bracket {
    width: f64,
    divisions: usize,
}

impl Bracket {
    pub(crate) fn new(a: f64, b: f64) -> Self {
        Self {
            width: (b - a).abs(),
            divisions: 0,
        }
    }

    /// Returns a time between the ends, whose values have different signs if they are known; `None` if there is no
    /// number between the ends.
    pub(crate) fn divide(&mut self, (a, of_a): End, (b, of_b): End) -> Option<f64> {
        let middle = a + 0.5 * (b - a);
        let is_end = |t: f64| t.to_bits() == a.to_bits() || t.to_bits() == b.to_bits();
        if self.divisions >= DIVISIONS || is_end(middle) {
            return None;
        }
        let time = self.interpolate((a, of_a), (b, of_b), middle);
        self.divisions += 1;
        Some(if is_end(time) { middle } else { time })
    }

    fn interpolate(&self, (a, of_a): End, (b, of_b): End, middle: f64) -> f64 {
        let secant = (b * of_a - a * of_b) / (of_a - of_b);
        let crosses = of_a * of_b <= 0.0 && secant.is_finite();
        let width = (b - a).abs();
        let least = f64::EPSILON * a.abs().max(b.abs());
        if !crosses || width <= 2.0 * least {
            return middle;
        }
        let to_middle = middle - secant;
        // The constants of the paper: κ₁ = 0.2/(b − a), κ₂ = 2, n₀ = 1.
        let truncation = 0.2 * width * (width / self.width);
        let truncated = if truncation <= to_middle.abs() {
            secant + truncation.copysign(to_middle)
        } else {
            middle
        };
        // The bracket may be as wide as it would be one division later with bisection.
        let slack = i32::try_from(self.divisions).map_or(0.0, |n| libm::ldexp(self.width, -n));
        let radius = (slack - 0.5 * width).max(0.0);
        let projected = if (truncated - middle).abs() <= radius {
            truncated
        } else {
            middle - radius.copysign(to_middle)
        };
        // Stay off the ends.
        let inner = 0.5 * width - least;
        middle + (projected - middle).clamp(-inner, inner)
    }
}

#[cfg(test)]
mod tests {
    use super::Bracket;

    /// Returns the upper end of the last bracket of a zero in (0, 2), and the number of evaluations.
    fn zero(function: impl Fn(f64) -> f64) -> (f64, usize) {
        let mut ends = [0.0, 2.0].map(|t| (t, function(t)));
        let mut bracket = Bracket::new(0.0, 2.0);
        let mut evaluations = 0;
        while let Some(t) = bracket.divide(ends[0], ends[1]) {
            evaluations += 1;
            let value = function(t);
            let end = usize::from(value >= 0.0);
            ends[end] = (t, value);
        }
        (ends[1].0, evaluations)
    }

    #[test]
    fn zeros_are_located_to_the_last_bit() {
        for root in [1e-3_f64, 0.1, 0.5, 1.0, 1.9, core::f64::consts::SQRT_2] {
            for (function, most) in [
                ((|d| d) as fn(f64) -> f64, 12),
                (|d: f64| d.sinh() + 3.0 * d, 12),
                (|d: f64| d.powi(3), 66),
                (|d: f64| d.signum(), 66),
                (|d: f64| (50.0 * d).atan(), 16),
            ] {
                let (found, evaluations) = zero(|t| function(t - root));
                assert!(
                    found >= root && found <= root.next_up(),
                    "{found:e} {root:e}"
                );
                assert!(evaluations <= most, "{evaluations} > {most} for {root}");
            }
        }
    }
}
