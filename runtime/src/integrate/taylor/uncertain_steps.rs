//! The steps within which a polynomial is compared with the equations.

use crate::limits::taylor::{INNER_CHECKS, LONG_STEP, MIN_AHEAD, MIN_STEP};

/// The steps of a motion in which the series may miss a change of the equations, such as a pulse, so that the residual is
/// computed at intermediate times, too.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct UncertainSteps {
    /// The length beyond which steps are long; 0 before the first step.
    long: f64,
    /// The last rejected step, while its end is ahead.
    rejected: Option<RejectedStep>,
}

/// A step that was rejected because the polynomial differs from the motion within it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
struct RejectedStep {
    end: f64,
    /// The signed length.
    length: f64,
}

impl RejectedStep {
    /// Returns the time between two intermediate times in it.
    fn interval(self) -> f64 {
        self.length.abs() / f64::from(INNER_CHECKS + 1)
    }

    /// Whether its end is ahead of a motion in its direction.
    fn is_ahead(self, time: f64) -> bool {
        let least_step = MIN_STEP * f64::EPSILON * time.abs();
        let ahead = (self.end - time) * self.length.signum();
        ahead > least_step.max(MIN_AHEAD * self.interval())
    }
}

impl UncertainSteps {
    /// Before the first step, which is long.
    pub(super) const NEW: Self = Self {
        long: 0.0,
        rejected: None,
    };

    /// Whether a step of this signed length is long, or may pass over the cause of a rejection.
    #[inline]
    pub(super) fn contain(self, time: f64, step: f64) -> bool {
        let may_pass_over = |rejected: RejectedStep| step.abs() > rejected.interval();
        step.abs() > self.long || self.ahead(time, step).is_some_and(may_pass_over)
    }

    /// Returns the length of a step of this signed length, shortened if it passes the end of a rejected one.
    #[inline]
    pub(super) fn limited(self, time: f64, step: f64) -> f64 {
        let ahead = self.ahead(time, step);
        let duration = |rejected: RejectedStep| (rejected.end - time).abs();
        ahead.map_or(step.abs(), |rejected| step.abs().min(duration(rejected)))
    }

    /// Returns the rejected step whose end is ahead of a step of this signed length.
    #[inline]
    fn ahead(self, time: f64, step: f64) -> Option<RejectedStep> {
        let rejected = self.rejected?;
        let is_ahead = rejected.length * step > 0.0 && rejected.is_ahead(time);
        is_ahead.then_some(rejected)
    }

    /// Records an accepted step of this length to the time `end`. If the step was cut short, `proposed` is the length that
    /// the tolerance allows, infinite if it is unknown: steps are then long beyond the limit so far, or beyond twice this
    /// length if that is less.
    #[inline]
    pub(super) fn accept(&mut self, end: f64, length: f64, proposed: Option<f64>) {
        let longest = proposed.map_or(0.0, |proposed| self.long.min(LONG_STEP * proposed));
        self.long = longest.max(LONG_STEP * length);
        self.rejected = self.rejected.filter(|rejected| rejected.is_ahead(end));
    }

    /// Records a step of this signed length that was rejected because the polynomial differs from the motion.
    pub(super) fn reject(&mut self, end: f64, length: f64) {
        self.rejected = Some(RejectedStep { end, length });
    }
}

#[cfg(test)]
mod tests {
    use super::UncertainSteps;

    #[test]
    fn long_steps_are_uncertain() {
        let mut steps = UncertainSteps::NEW;
        assert!(steps.contain(0.0, 1e-9));
        steps.accept(1.0, 1.0, None);
        assert!(!steps.contain(1.0, 1.9) && steps.contain(1.0, 2.1));
        assert!(!steps.contain(1.0, -1.9) && steps.contain(1.0, -2.1));
        // One that lands says nothing, unless the tolerance proposed a shorter step than before.
        steps.accept(1.1, 0.1, Some(f64::INFINITY));
        assert!(!steps.contain(1.1, 1.9));
        steps.accept(1.2, 0.1, Some(0.4));
        assert!(!steps.contain(1.2, 0.7) && steps.contain(1.2, 0.9));
        steps.accept(1.3, 0.1, None);
        assert!(steps.contain(1.3, 0.3));
    }

    #[test]
    fn steps_end_where_rejected_ones_did() {
        for sign in [1.0, -1.0] {
            let mut steps = UncertainSteps::NEW;
            steps.reject(3.4 * sign, 3.4 * sign);
            steps.accept(1.7 * sign, 1.7, None);
            let at = |steps: UncertainSteps, time: f64, step: f64| {
                let (time, step) = (time * sign, step * sign);
                (steps.limited(time, step), steps.contain(time, step))
            };
            assert!((at(steps, 1.7, 3.0).0 - 1.7).abs() < 1e-15);
            assert!((at(steps, 1.7, f64::INFINITY).0 - 1.7).abs() < 1e-15);
            assert!(at(steps, 1.7, 1.7).1);
            // Shorter than the time between two checks, 0.2.
            assert_eq!(at(steps, 1.7, 0.1), (0.1, false));
            // In the other direction.
            assert_eq!(at(steps, 1.7, -3.0), (3.0, false));
            // A shorter attempt on the way.
            steps.reject(3.3 * sign, 1.6 * sign);
            assert!((at(steps, 1.7, 3.0).0 - 1.6).abs() < 1e-15);
            steps.accept(3.3 * sign, 1.6, None);
            assert_eq!(at(steps, 3.3, 3.0), (3.0, false));
            // It is forgotten.
            assert_eq!(at(steps, 0.0, 3.0), (3.0, false));
        }
    }
}
