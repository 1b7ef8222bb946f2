//! Projection of the ends of steps of motions in lanes onto the manifold of the dynamics.

use super::TaylorLanes;
use super::attempt::Attempt;
use crate::integrate::compensated::Compensated;
use crate::integrate::projected::{Projected, corrected};
use crate::integrate::projection::Projection;
use crate::integrate::taylor::Series;
use crate::integrate::taylor::interpolant::difference;
use crate::integrate::taylor::singular_configuration::SingularConfiguration;
use crate::integrate::taylor::step_size::reached;
use crate::linalg::LaneStates;
use crate::scalar::{Lanes, Scalar};

impl<X: LaneStates<L>, const L: usize, const HALF: usize> TaylorLanes<X, L, HALF> {
    /// Completes the states at the ends of the steps: lanes that do not move keep theirs, and the others are projected
    /// onto the manifold of the dynamics if they have one.
    pub(super) fn finish<D>(
        &mut self,
        dynamics: &D,
        attempt: &mut Attempt<X, L>,
        passed: Option<&[SingularConfiguration; L]>,
        state: &mut Compensated<X>,
    ) where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let Attempt {
            moving,
            targets,
            arrivals,
            ..
        } = attempt;
        for lane in (0..L).filter(|&lane| !moving[lane]) {
            state.copy_lane(lane, &self.state);
        }
        let mut times = core::array::from_fn(|lane| {
            if moving[lane] {
                targets[lane]
            } else {
                self.time[lane]
            }
        });
        if let Some(arrivals) = arrivals {
            arrivals.copy_to(state);
            times = core::array::from_fn(|lane| arrivals.time(lane).unwrap_or(times[lane]));
        }
        if let Some(projection) = dynamics.project(Lanes(times), state.value()) {
            let ends = (Lanes(times), &*state, passed);
            *state = self.project(dynamics, moving, ends, &projection);
        }
    }

    /// Projects the ends of the steps of the moving lanes onto the manifold, and changes their polynomials to end
    /// there. A lane in which the projection fails stops moving.
    fn project<D>(
        &mut self,
        dynamics: &D,
        moving: &mut [bool; L],
        (t, state, passed): (
            Lanes<L>,
            &Compensated<X>,
            Option<&[SingularConfiguration; L]>,
        ),
        projection: &Projection<Lanes<L>, X>,
    ) -> Compensated<X>
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let [high, low] = difference(t, Lanes(self.time));
        let tau = (high + low) / Lanes(self.unit);
        let before = self.state.value();
        let mut step = Projected {
            dynamics,
            t,
            before,
            length: (t - Lanes(self.time)).abs(),
            lane: None,
        };
        let (mut end, correction) = corrected(state, projection);
        let sizes = reached(before, &self.coefficients, tau.abs());
        let tolerance = self.tolerance((t - Lanes(self.time)).abs());
        let allowed = dynamics.allowed_error(&sizes, &tolerance);
        let checked: [_; L] = core::array::from_fn(|lane| {
            step.lane = Some(lane);
            let found = (projection, end.value());
            let is_limited = passed.is_none_or(|passed| passed[lane].limits_corrections());
            moving[lane].then(|| step.check(found, &correction, &allowed, is_limited))
        });
        for (lane, checked) in checked.into_iter().enumerate() {
            match checked {
                None => end.copy_lane(lane, &self.state),
                Some(Ok(distance)) => {
                    let pivoted = projection.pivoted.in_lane(lane);
                    self.statistics[lane].note_projection(distance, pivoted);
                    let change = correction.lane(lane);
                    self.coefficients.change_end_in(lane, tau.0[lane], &change);
                }
                Some(Err(error)) => {
                    end.copy_lane(lane, &self.state);
                    moving[lane] = false;
                    self.fail(lane, error);
                }
            }
        }
        end
    }

    /// Stops the motion in a lane that begins off the manifold.
    pub(super) fn check_start<D>(&mut self, dynamics: &D, lane: usize)
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let t = Lanes(self.time);
        let before = self.state.value();
        let Some(projection) = dynamics.project(t, before) else {
            return;
        };
        let start = Projected {
            dynamics,
            t,
            before,
            length: Lanes([0.0; L]),
            lane: Some(lane),
        };
        let (end, correction) = corrected(&self.state, &projection);
        let tolerance = self.tolerance(Lanes(self.time_scale));
        let allowed = dynamics.allowed_error(before, &tolerance);
        let found = (&projection, end.value());
        if let Err(error) = start.check(found, &correction, &allowed, true)
            && self.errors[lane].is_none()
        {
            let error = start.named(before, error);
            self.fail(lane, error);
        }
    }
}
