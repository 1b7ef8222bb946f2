//! Steps that end at discontinuity surfaces, and motions that cannot leave them.

use super::TaylorStepper;
use crate::integrate::error::IntegrationError;
use crate::integrate::taylor::Series;
use crate::integrate::taylor::branch_crossings::Crossing;
use crate::integrate::taylor::discontinuity::{Passage, StepToSurface, surface_at};
use crate::integrate::taylor::step_size::{Proposal, too_small};
use crate::limits::taylor::{BEFORE, MAX_SHORT_PASSAGES, RESOLUTION, SHORT_PASSAGE};
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

impl<X, const HALF: usize> TaylorStepper<X, HALF> {
    /// Ends a step at a sign change of a switching function, with the state after it. Returns a component in which the
    /// polynomial differs from the motion before it, if there is one.
    ///
    /// # Errors
    ///
    /// If the state after it cannot be projected onto the manifold of the dynamics.
    pub(super) fn pass<S: Scalar, D: Series<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        (crossing, proposal): (Crossing, Proposal),
        (end, target): (f64, f64),
    ) -> Result<Option<usize>, IntegrationError>
    where
        X: VectorSpace<S>,
    {
        if let Err(component) = self.check_before(dynamics, (crossing, proposal), end) {
            return Ok(Some(component));
        }
        let [first, second] = &mut self.polynomials;
        let (present, next) = if self.exchanged {
            (second, first)
        } else {
            (first, second)
        };
        let junction = StepToSurface {
            dynamics,
            from: &present.from,
            coefficients: &present.coefficients,
            unit: S::from_f64(present.unit),
            time: &S::from_f64,
            argument: &|t| present.argument(t),
            lane: 0,
            begin: present.time,
            end,
            target,
        };
        let evaluations = &mut self.statistics.evaluations;
        let passage = junction.pass(crossing, &mut next.coefficients, evaluations);
        let (arrival, slides) = match passage {
            Passage::Crosses(arrival) => (arrival, false),
            Passage::Slides(arrival) => (arrival, true),
            Passage::Unclear => return Ok(Some(0)),
        };
        let length = (arrival.time - present.time).abs();
        (next.time, next.from) = (arrival.time, arrival.state);
        let unit = present.unit;
        let t = S::from_f64(arrival.time);
        if let Some(projection) = dynamics.project(t, next.from.value()) {
            self.project_end(dynamics, &projection, true)?;
        }
        self.unit = unit;
        self.proposal = None;
        self.length = self.length.max(length);
        self.uncertain
            .accept(arrival.time, length, Some(f64::INFINITY));
        let scale = arrival.time.abs().max(self.time_scale);
        if length <= SHORT_PASSAGE * S::machine_epsilon() * scale {
            self.short_passages += 1;
        } else {
            self.short_passages = 0;
        }
        let is_stuck = slides || self.short_passages > MAX_SHORT_PASSAGES;
        self.sliding = is_stuck.then_some(crossing.function);
        self.accept(length);
        Ok(None)
    }

    /// Checks that the polynomial is the motion until shortly before a sign change of a switching function.
    fn check_before<S: Scalar, D: Series<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        (crossing, proposal): (Crossing, Proposal),
        end: f64,
    ) -> Result<(), usize>
    where
        X: VectorSpace<S>,
    {
        let begin = self.polynomial().time;
        let h = (end - begin).abs();
        let resolution = RESOLUTION * S::machine_epsilon() * (begin.abs() + h) / h;
        let before = crossing.at - resolution.max(BEFORE * crossing.at);
        if before <= resolution {
            return Ok(());
        }
        let allowance = self.allowance(h);
        self.check_at(dynamics, (end, before), &allowance)?;
        let cut = begin + (end - begin) * before;
        let tau: S = self.polynomial().argument(cut);
        if self.is_uncertain_within(proposal, cut, tau) {
            self.check_within(dynamics, cut, &allowance)?;
        }
        Ok(())
    }

    /// Returns the error for a motion that cannot leave a discontinuity surface.
    #[cold]
    pub(super) fn sliding_error<S: Scalar, D: Series<S, State = X> + ?Sized>(
        &self,
        dynamics: &D,
        function: usize,
    ) -> IntegrationError
    where
        X: VectorSpace<S>,
    {
        IntegrationError::SlidingMode {
            time: self.polynomial().time,
            function: dynamics.switching_function(function).name,
        }
    }

    /// Returns the error for a step that is too small; `rejected` is the component for which a longer one was rejected,
    /// if there is one.
    #[cold]
    pub(super) fn too_small<S: Scalar, D: Series<S, State = X> + ?Sized>(
        &self,
        dynamics: &D,
        step: f64,
        rejected: Option<usize>,
    ) -> IntegrationError
    where
        X: VectorSpace<S>,
    {
        let polynomial = self.polynomial();
        let (time, here) = (polynomial.time, polynomial.from.value());
        let reduced = polynomial.from.reduced(dynamics);
        let t = S::from_f64(time);
        let motion = (&polynomial.coefficients, S::from_f64(polynomial.unit));
        if let Some(function) = surface_at(dynamics, (t, &reduced), motion, 0) {
            return self.sliding_error(dynamics, function);
        }
        let component = rejected.unwrap_or_else(|| self.limiting_component(dynamics));
        too_small(
            dynamics.vanishing_inertia(t, here),
            (time, step),
            dynamics.component_name(component),
            self.method.tolerance::<S>(),
        )
    }
}
