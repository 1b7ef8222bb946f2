//! The steps within which a polynomial is compared with the motion.

use crate::limits::taylor::{INNER_CHECKS, LONG_STEP, MIN_AHEAD, MIN_STEP};

/// The steps of a motion in which the series may miss changes, such as a pulse, so that the polynomial is compared with the
/// motion within them, too.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct UncertainSteps {
    /// The length beyond which steps are long; 0 before the first step.
    long: f64,
    /// The last step that differed from the motion.
    differed: Option<Differed>,
}

/// A step that differed from the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
struct Differed {
    /// The end of the step. What it has met is before it.
    end: f64,
    /// The interval between the times at which the step was compared.
    interval: f64,
}

impl UncertainSteps {
    /// Before the first step, which is long.
    pub(super) const NEW: Self = Self {
        long: 0.0,
        differed: None,
    };

    /// Whether a step of this signed length is long, or may pass over what another has met.
    #[inline]
    pub(super) fn contain(self, time: f64, step: f64) -> bool {
        let may_miss = |differed: Differed| step.abs() > differed.interval;
        step.abs() > self.long || self.ahead(time, step).is_some_and(may_miss)
    }

    /// Returns the length of a step of this signed length that does not pass the end of one that differed.
    #[inline]
    pub(super) fn limited(self, time: f64, step: f64) -> f64 {
        let ahead = self.ahead(time, step);
        ahead.map_or(step.abs(), |differed| {
            step.abs().min((differed.end - time).abs())
        })
    }

    /// Returns the step that differed, if its end is ahead of a step of this signed length.
    #[inline]
    fn ahead(self, time: f64, step: f64) -> Option<Differed> {
        // There is none, as a rule.
        let differed = self.differed?;
        let ahead = (differed.end - time) * step.signum();
        let least_step = MIN_STEP * f64::EPSILON * time.abs();
        let is_ahead = ahead > least_step.max(MIN_AHEAD * differed.interval);
        is_ahead.then_some(differed)
    }

    /// Notes the length of an accepted step. One whose end was given says little about the next one.
    #[inline]
    pub(super) fn accept(&mut self, length: f64, is_cut: bool) {
        let least = if is_cut { self.long } else { 0.0 };
        self.long = least.max(LONG_STEP * length);
    }

    /// Notes a step of this length that differed from the motion.
    pub(super) fn reject(&mut self, end: f64, length: f64) {
        let interval = length / f64::from(INNER_CHECKS + 1);
        self.differed = Some(Differed { end, interval });
    }
}

#[cfg(test)]
mod tests {
    use super::UncertainSteps;

    #[test]
    fn long_steps_are_uncertain() {
        let mut steps = UncertainSteps::NEW;
        assert!(steps.contain(0.0, 1e-9));
        steps.accept(1.0, false);
        assert!(!steps.contain(1.0, 1.9) && steps.contain(1.0, 2.1));
        assert!(!steps.contain(1.0, -1.9) && steps.contain(1.0, -2.1));
        // One that lands says nothing.
        steps.accept(0.1, true);
        assert!(!steps.contain(1.1, 1.9));
        steps.accept(0.1, false);
        assert!(steps.contain(1.2, 1.9));
    }

    #[test]
    fn steps_end_where_one_has_differed() {
        for sign in [1.0, -1.0] {
            let mut steps = UncertainSteps::NEW;
            steps.reject(3.4 * sign, 3.4);
            steps.accept(1.7, false);
            let at = |time: f64, step: f64| {
                let (time, step) = (time * sign, step * sign);
                (steps.limited(time, step), steps.contain(time, step))
            };
            assert!((at(1.7, 3.0).0 - 1.7).abs() < 1e-15);
            assert!((at(1.7, f64::INFINITY).0 - 1.7).abs() < 1e-15);
            assert!(at(1.7, 1.7).1);
            // Shorter than the interval of 0.2.
            assert_eq!(at(1.7, 0.1), (0.1, false));
            assert_eq!(at(3.4, 3.0), (3.0, false));
            // Away from it.
            assert_eq!(at(1.7, -3.0), (3.0, false));
        }
    }
}
