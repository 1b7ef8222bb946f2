//! Steps of DOP853 that pass singular configurations of constraints.

use super::STAGES;
use super::coefficients::{MATRIX, NODES};
use super::step_control::{Attempt, StepControl};
use super::stepper::Dop853Stepper;
use crate::integrate::compensated::Compensated;
use crate::integrate::dynamics::Dynamics;
use crate::integrate::passing::{Clearance, shorter_lengths};
use crate::integrate::runge_kutta::stage_state;
use crate::limits::dormand_prince::PASSING_TOLERANCE;
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

impl<X> Dop853Stepper<X> {
    /// Attempts a step `h`, or a shorter one that keeps away from singular configurations.
    #[cold]
    pub(super) fn attempt_passing<S: Scalar, D: Dynamics<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        h: f64,
        control: &StepControl,
    ) -> (f64, Compensated<X>, Attempt, Clearance)
    where
        X: VectorSpace<S>,
    {
        let mut best = (h, Clearance::NONE);
        let least = self.limited(0.0);
        let others = shorter_lengths(h).skip(1);
        let others = others.take_while(|h| h.abs() >= least);
        for h in core::iter::once(h).chain(others) {
            let (state, attempt, clearance) = self.attempt_with_clearance(dynamics, h, control);
            if clearance.is_sufficient() {
                return (h, state, attempt, clearance);
            }
            if clearance.is_larger_than(best.1) {
                best = (h, clearance);
            }
        }
        let h = best.0;
        let (state, attempt, clearance) = self.attempt_with_clearance(dynamics, h, control);
        (h, state, attempt, clearance)
    }

    /// Attempts a step `h`. Close to a singular configuration its error, which is rounding then, may be larger than the tolerance.
    fn attempt_with_clearance<S: Scalar, D: Dynamics<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        h: f64,
        control: &StepControl,
    ) -> (Compensated<X>, Attempt, Clearance)
    where
        X: VectorSpace<S>,
    {
        let (state, mut attempt) = self.attempt(dynamics, h, control.time_scale(h));
        let clearance = self.clearance(dynamics, h);
        if clearance.is_small() {
            let tolerance = self.method.tolerance;
            let largest = tolerance.relative.max(tolerance.absolute);
            attempt.error *= (largest / PASSING_TOLERANCE).min(1.0);
        }
        (state, attempt, clearance)
    }

    /// Returns how far the attempted step `h` keeps from singular configurations.
    fn clearance<S: Scalar, D: Dynamics<S, State = X> + ?Sized>(
        &self,
        dynamics: &D,
        h: f64,
    ) -> Clearance
    where
        X: VectorSpace<S>,
    {
        let from = self.state.reduced(dynamics);
        (1..=STAGES).fold(Clearance::UNLIMITED, |clearance, i| {
            let at = stage_state(&from, h, MATRIX[i], &self.stages);
            clearance.with(dynamics, self.clock.after(NODES[i] * h), &at)
        })
    }
}
