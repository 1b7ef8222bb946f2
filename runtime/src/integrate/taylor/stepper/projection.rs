//! Projection of the ends of steps onto the manifold of the dynamics.

use super::TaylorStepper;
use crate::integrate::dynamics::Dynamics;
use crate::integrate::error::IntegrationError;
use crate::integrate::projected::{Projected, corrected};
use crate::integrate::projection::Projection;
use crate::integrate::taylor::step_size::reached;
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

impl<X, const HALF: usize> TaylorStepper<X, HALF> {
    /// Projects the end of an accepted step, where the other polynomial begins, onto the manifold, and changes the
    /// polynomial of the step to end there. The correction may be limited to the allowed error.
    pub(super) fn project_end<S: Scalar, D: Dynamics<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        projection: &Projection<S, X>,
        is_limited: bool,
    ) -> Result<(), IntegrationError>
    where
        X: VectorSpace<S>,
    {
        let [first, second] = &self.polynomials;
        let (present, next) = if self.exchanged {
            (second, first)
        } else {
            (first, second)
        };
        let tau: S = present.argument(next.time);
        let step = Projected {
            dynamics,
            t: S::from_f64(next.time),
            before: present.from.value(),
            length: S::from_f64((next.time - present.time).abs()),
            lane: None,
        };
        let (end, correction) = corrected(&next.from, projection);
        let tolerance = self.tolerance((next.time - present.time).abs());
        let sizes = reached(present.from.value(), &present.coefficients, tau.abs());
        let allowed = dynamics.allowed_error(&sizes, &tolerance);
        let found = (projection, end.value());
        let distance = step.check(found, &correction, &allowed, is_limited)?;
        self.statistics
            .note_projection(distance, projection.pivoted.largest());
        let [present, next] = [self.exchanged, !self.exchanged].map(usize::from);
        self.polynomials[next].from = end;
        self.polynomials[present]
            .coefficients
            .change_end(tau, &correction);
        Ok(())
    }
}
