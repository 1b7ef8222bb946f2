//! Steps of lanes that end at discontinuity surfaces, and motions that cannot leave them.

use super::TaylorLanes;
use super::arrivals::Arrivals;
use super::attempt::Proposals;
use super::verdicts::Verdict;
use crate::integrate::error::IntegrationError;
use crate::integrate::taylor::Series;
use crate::integrate::taylor::branch_crossings::Crossing;
use crate::integrate::taylor::coefficients::TaylorCoefficients;
use crate::integrate::taylor::discontinuity::{Passage, StepToSurface, surface_at};
use crate::integrate::taylor::interpolant::difference;
use crate::integrate::taylor::step_size::{limiting_component, too_small};
use crate::integrate::tolerance::Tolerance;
use crate::limits::taylor::{BEFORE, MAX_SHORT_PASSAGES, RESOLUTION, SHORT_PASSAGE};
use crate::linalg::LaneStates;
use crate::scalar::{Lanes, Scalar as _};

impl<X: LaneStates<L>, const L: usize, const HALF: usize> TaylorLanes<X, L, HALF> {
    /// Returns the fraction of the step of a lane that is to be tried next if it is known, and the component in which the
    /// polynomial differs from the motion, if there is one. `None` if the step is accepted.
    pub(super) fn rejection<D>(
        &mut self,
        dynamics: &D,
        (lane, verdict, proposals): (usize, Verdict, Proposals<L>),
        times: (f64, f64),
        arrivals: &mut Option<Arrivals<X, L>>,
    ) -> Option<(Option<f64>, Option<usize>)>
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let beyond = match verdict {
            Verdict::Agrees => return None,
            Verdict::Shorten(part) => return Some((Some(part), None)),
            Verdict::Crosses(crossing) => {
                self.pass(dynamics, (lane, crossing, proposals), times, arrivals)?
            }
            Verdict::Differs(component) => component,
        };
        Some((None, Some(beyond)))
    }

    /// Ends the step of a lane at a sign change of a switching function, as [`TaylorStepper`](crate::TaylorStepper)
    /// does. Returns a component in which the polynomial differs from the motion before it, if there is one.
    fn pass<D>(
        &mut self,
        dynamics: &D,
        (lane, crossing, proposals): (usize, Crossing, Proposals<L>),
        (end, target): (f64, f64),
        arrivals: &mut Option<Arrivals<X, L>>,
    ) -> Option<usize>
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let beyond = self.check_before(dynamics, (lane, crossing, &proposals), end);
        if beyond.is_some() {
            return beyond;
        }
        let (begin, unit) = (self.time, Lanes(self.unit));
        let at_lane =
            |t: f64| core::array::from_fn(|other| if other == lane { t } else { begin[other] });
        let junction = StepToSurface {
            dynamics,
            from: &self.state,
            coefficients: &self.coefficients,
            unit,
            time: &|t| Lanes(at_lane(t)),
            // The other lanes keep their times.
            argument: &|t| {
                let [high, low] = difference(Lanes(at_lane(t)), Lanes(begin));
                (high + low) / unit
            },
            lane,
            begin: begin[lane],
            end,
            target,
        };
        let mut behind = TaylorCoefficients::new(self.state.value().clone());
        let evaluations = &mut self.statistics[lane].evaluations;
        let (arrival, slides) = match junction.pass(crossing, &mut behind, evaluations) {
            Passage::Crosses(arrival) => (arrival, false),
            Passage::Slides(arrival) => (arrival, true),
            Passage::Unclear => return Some(0),
        };
        let arrivals = arrivals.get_or_insert_with(|| Arrivals {
            time: [None; L],
            state: self.state.clone(),
            function: [0; L],
            slides: [false; L],
        });
        arrivals.time[lane] = Some(arrival.time);
        arrivals.state.copy_lane(lane, &arrival.state);
        arrivals.function[lane] = crossing.function;
        arrivals.slides[lane] = slides;
        None
    }

    /// Ends the step of a lane at a discontinuity surface, and returns whether it does end there.
    pub(super) fn arrive(&mut self, lane: usize, arrivals: &Arrivals<X, L>) -> bool {
        let Some(time) = arrivals.time[lane] else {
            return false;
        };
        let length = (time - self.time[lane]).abs();
        self.length[lane] = self.length[lane].max(length);
        self.uncertain[lane].accept(time, length, Some(f64::INFINITY));
        let scale = time.abs().max(self.time_scale[lane]);
        if length <= SHORT_PASSAGE * f64::EPSILON * scale {
            self.short_passages[lane] += 1;
        } else {
            self.short_passages[lane] = 0;
        }
        let is_stuck = arrivals.slides[lane] || self.short_passages[lane] > MAX_SHORT_PASSAGES;
        self.sliding[lane] = is_stuck.then_some(arrivals.function[lane]);
        self.time_scale[lane] = self.time_scale[lane].max(length);
        self.time[lane] = time;
        true
    }

    /// Checks that the polynomial of a lane is the motion until shortly before a sign change of a switching function.
    /// Returns a component in which it is not.
    fn check_before<D>(
        &mut self,
        dynamics: &D,
        (lane, crossing, proposals): (usize, Crossing, &Proposals<L>),
        end: f64,
    ) -> Option<usize>
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let begin = self.time[lane];
        let h = (end - begin).abs();
        let resolution = RESOLUTION * f64::EPSILON * (begin.abs() + h) / h;
        let before = crossing.at - resolution.max(BEFORE * crossing.at);
        if before <= resolution {
            return None;
        }
        let mut step = Lanes([0.0; L]);
        step.0[lane] = end - begin;
        let only: [bool; L] = core::array::from_fn(|other| other == lane);
        let t = Lanes(self.time) + step * Lanes([before; L]);
        let reached = self.at(&t.0);
        let allowance = self.allowance(step.abs());
        if let Some(beyond) = self.check_at(dynamics, (t, &reached), &allowance, &only) {
            return beyond[lane];
        }
        let cut = t - Lanes(self.time);
        let inner = self.is_uncertain_within(cut, proposals, &only);
        self.check_within((dynamics, &()), (cut, &allowance), inner)[lane]
    }

    /// Stops the motion in a lane that cannot leave a discontinuity surface.
    pub(super) fn stop_sliding<D>(&mut self, dynamics: &D, lane: usize)
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        if let (Some(function), None) = (self.sliding[lane], self.errors[lane]) {
            self.slide(dynamics, lane, function);
        }
    }

    #[cold]
    fn slide<D>(&mut self, dynamics: &D, lane: usize, function: usize)
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let error = IntegrationError::SlidingMode {
            time: self.time[lane],
            function: dynamics.switching_function(function).name,
        };
        self.fail(lane, error);
    }

    /// Records the error for a step that is too small.
    #[cold]
    pub(super) fn too_small<D>(
        &mut self,
        dynamics: &D,
        lane: usize,
        step: f64,
        rejected: Option<usize>,
    ) where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let (t, time) = (Lanes(self.time), self.time[lane]);
        let reduced = self.state.reduced(dynamics);
        let motion = (&self.coefficients, Lanes(self.unit));
        if let Some(function) = surface_at(dynamics, (t, &reduced), motion, lane) {
            return self.slide(dynamics, lane, function);
        }
        let component = rejected.unwrap_or_else(|| {
            let weights = Tolerance::weights(&self.allowed(dynamics));
            limiting_component(&self.coefficients, &weights, |ratio| ratio.lane(lane))
        });
        let error = too_small(
            dynamics.vanishing_inertia_in_lane(lane, t, self.state.value()),
            (time, step),
            dynamics.component_name(component),
            self.method.tolerance::<Lanes<L>>(),
        );
        self.fail(lane, error);
    }
}
