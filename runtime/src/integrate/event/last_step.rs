//! The step that was just taken, in which events are located.

use core::marker::PhantomData;

use crate::integrate::at::At;
use crate::integrate::dynamics::Dynamics;
use crate::integrate::error::IntegrationError;
use crate::integrate::projected::nearest;
use crate::integrate::step_polynomial::StepPolynomial;
use crate::integrate::stepper::Advance;
use crate::limits::events::TIME_RESOLUTION;
use crate::scalar::Scalar;

/// The last step of a stepper.
#[derive(Debug)]
pub struct LastStep<'a, S, D: ?Sized, T> {
    dynamics: &'a D,
    stepper: &'a mut T,
    scalar: PhantomData<S>,
}

impl<'a, S: Scalar, D: Dynamics<S> + ?Sized, T: Advance<S, D>> LastStep<'a, S, D, T> {
    pub(crate) fn new(dynamics: &'a D, stepper: &'a mut T) -> Self {
        Self {
            dynamics,
            stepper,
            scalar: PhantomData,
        }
    }

    pub(crate) fn dynamics(&self) -> &'a D {
        self.dynamics
    }

    pub(crate) fn begin(&self) -> f64 {
        self.stepper.previous_time()
    }

    pub(crate) fn end(&self) -> f64 {
        self.stepper.time()
    }

    /// Whether `a` comes before `b` in the direction of the integration.
    pub(crate) fn comes_before(&self, a: f64, b: f64) -> bool {
        if self.end() >= self.begin() {
            a < b
        } else {
            a > b
        }
    }

    /// Applies a visitor to the Taylor polynomial of the step, if it is one.
    pub(crate) fn polynomial<V: StepPolynomial<S, D::State>>(
        &self,
        visitor: V,
    ) -> Option<V::Output> {
        self.stepper.visit_polynomial(visitor)
    }

    /// Returns the states at the beginning and the end of the step, if they are known.
    pub(crate) fn ends(&self) -> Option<[&D::State; 2]> {
        Some([self.stepper.previous_state()?, self.stepper.state()])
    }

    /// Returns the sample at a time within the step, projected onto the manifold of the dynamics if they have one.
    /// Event functions thus are evaluated along one continuous curve through the ends of the steps. If the projection
    /// fails, the sample is not projected.
    pub(crate) fn at(&mut self, t: f64) -> At<f64, D::State> {
        if t - self.stepper.time() == 0.0 {
            let x = self.stepper.state().clone();
            return At { t, x };
        }
        let x = self.stepper.interpolate(self.dynamics, t);
        let x = nearest(self.dynamics, t, &x).ok().flatten().unwrap_or(x);
        At { t, x }
    }

    /// Returns the sample at a time within the step for a user, who must not see an unprojected one.
    ///
    /// # Errors
    ///
    /// If the projection fails.
    pub(crate) fn checked_at(&mut self, t: f64) -> Result<At<f64, D::State>, IntegrationError> {
        let x = if t - self.stepper.time() == 0.0 {
            self.stepper.state().clone()
        } else {
            let x = self.stepper.interpolate(self.dynamics, t);
            nearest(self.dynamics, t, &x)?.unwrap_or(x)
        };
        Ok(At { t, x })
    }

    /// Returns the shortest duration that is safely distinguishable at `t`.
    pub(crate) fn resolution(&self, t: f64) -> f64 {
        let step = self.end() - self.begin();
        TIME_RESOLUTION * f64::EPSILON * (t.abs() + step.abs())
    }

    /// Returns the first time after `t` within the step that is safely distinguishable from it; at most the end of the
    /// step.
    pub(crate) fn after(&self, t: f64) -> f64 {
        let end = self.end();
        let resolution = self.resolution(t);
        if resolution < (end - t).abs() {
            t + resolution.copysign(end - self.begin())
        } else {
            end
        }
    }
}
