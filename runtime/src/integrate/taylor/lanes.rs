//! The steps of the Taylor series method in lanes, each with its own step size.
//!
//! The arithmetic of states, series and checks is vectorized ([`Lanes`]). Quantities that control single lanes are in
//! arrays: times, units of time, and which lanes still move. Lanes do not depend on each other, except that every
//! series is computed as often as the lane that needs most requires.

mod arrivals;
mod checks;
mod events;
mod expansion;
mod last_step;
mod passage;
mod passing;
mod projection;

use arrivals::Arrivals;

use super::coefficients::{TaylorCoefficients, number};
use super::interpolant::difference;
use super::step_size::unit_near;
use super::{Series, Taylor};
use crate::integrate::compensated::Compensated;
use crate::integrate::error::IntegrationError;
use crate::integrate::stepper::Statistics;
use crate::integrate::tolerance::{Tolerance, largest_ratios, time_scale};
use crate::limits::taylor::{FIRST_UNIT, LANDING, MIN_STEP};
use crate::linalg::LaneStates;
use crate::scalar::Lanes;

/// The stepper of a [`Taylor`] method for `L` motions at once, each with its own time, step size and end.
///
/// An [`Ensemble`](crate::Ensemble) uses it, and assigns new motions to lanes that have finished. Here it is used
/// directly:
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian::{Lanes, TaylorLanes};
///
/// #[derive(Lagrangian)]
/// #[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), potential = 0.5 * k * x.powi(2))]
/// struct Oscillator<T: Scalar> { k: T }
///
/// let oscillators = Oscillator { k: Lanes([1.0, 4.0]) };
/// let dynamics = oscillators.dynamics();
/// let start = Phase::new([1.0], [0.0]);
/// let mut stepper = TaylorLanes::new(Taylor::new(), 0.0, &start);
/// let ends = [3.0, 5.0];
/// while (0..2).any(|lane| stepper.error(lane).is_none() && stepper.time(lane) < ends[lane]) {
///     stepper.step(&dynamics, &ends);
/// }
/// assert!((stepper.state(0).q[0] - 3.0_f64.cos()).abs() < 1e-14);
/// assert!((stepper.state(1).q[0] - 10.0_f64.cos()).abs() < 1e-14);
/// ```
#[derive(Clone, Debug)]
pub struct TaylorLanes<X, const L: usize, const HALF: usize> {
    method: Taylor<HALF>,
    time: [f64; L],
    state: Compensated<X>,
    /// Powers of two near the step sizes.
    unit: [f64; L],
    /// The polynomials of the last step, about the reduced states.
    coefficients: TaylorCoefficients<X, HALF>,
    /// The times and states at the beginning of the last step, and its units of time.
    previous: ([f64; L], Compensated<X>, [f64; L]),
    /// The lengths of the last steps, 0 before the first.
    length: [f64; L],
    /// The time scales of the motions: the ones at their starts, or the longest steps so far.
    time_scale: [f64; L],
    /// Whether a lane has been set since the last step.
    is_new: [bool; L],
    /// The switching function whose discontinuity surface the motion in a lane cannot leave, if there is one.
    sliding: [Option<usize>; L],
    /// The number of consecutive last steps of each lane that ended at discontinuity surfaces after no more than
    /// rounding errors of the time.
    short_passages: [u32; L],
    statistics: [Statistics; L],
    errors: [Option<IntegrationError>; L],
}

impl<X: LaneStates<L>, const L: usize, const HALF: usize> TaylorLanes<X, L, HALF> {
    const ORDER: usize = 2 * HALF;

    /// Creates a stepper with all lanes at time `t` and state `x`.
    #[must_use]
    pub fn new(method: Taylor<HALF>, t: f64, x: &X::Lane) -> Self {
        let state = Compensated::new(X::broadcast(x));
        Self {
            method,
            time: [t; L],
            unit: [1.0; L],
            coefficients: TaylorCoefficients::new(state.value().clone()),
            previous: ([t; L], state.clone(), [1.0; L]),
            state,
            length: [0.0; L],
            time_scale: [1.0 / FIRST_UNIT; L],
            is_new: [true; L],
            sliding: [None; L],
            short_passages: [0; L],
            statistics: [Statistics::default(); L],
            errors: [None; L],
        }
    }

    /// Sets the time and the state of a lane, in which a new motion then begins. Does nothing if there is no such lane.
    pub fn set_lane(&mut self, lane: usize, t: f64, x: &X::Lane) {
        if lane >= L {
            return;
        }
        self.time[lane] = t;
        self.unit[lane] = 1.0;
        self.state.set_lane(lane, x);
        self.previous.0[lane] = t;
        self.previous.1.set_lane(lane, x);
        self.length[lane] = 0.0;
        self.is_new[lane] = true;
        self.sliding[lane] = None;
        self.short_passages[lane] = 0;
        self.statistics[lane] = Statistics::default();
        self.errors[lane] = None;
    }

    /// Returns the time reached in a lane; NaN if there is no such lane.
    #[must_use]
    pub fn time(&self, lane: usize) -> f64 {
        self.time.get(lane).copied().unwrap_or(f64::NAN)
    }

    /// Returns the state at that time.
    #[must_use]
    pub fn state(&self, lane: usize) -> X::Lane {
        self.state.value().lane(lane)
    }

    /// Returns the times reached in all lanes.
    #[must_use]
    pub fn times(&self) -> Lanes<L> {
        Lanes(self.time)
    }

    /// Returns the states in all lanes.
    #[must_use]
    pub fn states(&self) -> &X {
        self.state.value()
    }

    /// Returns the time at the beginning of the last step of a lane; NaN if there is no such lane.
    #[must_use]
    pub fn previous_time(&self, lane: usize) -> f64 {
        self.previous.0.get(lane).copied().unwrap_or(f64::NAN)
    }

    /// Returns the states at the beginning of the last steps.
    pub(crate) fn previous_states(&self) -> &X {
        self.previous.1.value()
    }

    /// Returns the statistics of the motion in a lane so far.
    #[must_use]
    pub fn statistics(&self, lane: usize) -> Statistics {
        self.statistics.get(lane).copied().unwrap_or_default()
    }

    /// Returns the error that stopped the motion in a lane, if there is one. The lane keeps its state until it is
    /// [set](Self::set_lane).
    #[must_use]
    pub fn error(&self, lane: usize) -> Option<IntegrationError> {
        self.errors.get(lane).copied().flatten()
    }

    /// Ends the motion in a lane with an error.
    pub(super) fn fail(&mut self, lane: usize, error: IntegrationError) {
        if let Some(place) = self.errors.get_mut(lane) {
            *place = Some(error);
        }
    }

    /// Returns the states at times within the last step of each lane. They are on the manifold of the
    /// [dynamics](crate::Dynamics::project) within the tolerance.
    #[must_use]
    pub fn interpolate(&self, times: &[f64; L]) -> X {
        let (from, state, unit) = &self.previous;
        let [high, low] = difference(Lanes(*times), Lanes(*from));
        let tau = (high + low) / Lanes(*unit);
        state.plus(self.coefficients.change(tau)).into_value()
    }

    /// Takes one step in each lane towards its end, and never beyond it; the last step lands on it exactly. A lane at
    /// its end, or with an error, does nothing.
    ///
    /// The dynamics of a lane must not change until the lane is set.
    pub fn step<D>(&mut self, dynamics: &D, ends: &[f64; L])
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        self.begin(dynamics);
        let mut moving = self.moving(dynamics, ends);
        if !any(&moving) {
            return;
        }
        let longest = self.method.max_step.unwrap_or(f64::INFINITY);
        let Proposals { step, middle } = self.expand(dynamics, &mut moving);
        let mut proposed = step.map(|step| step.min(longest));
        let passed = self.singular_configurations(dynamics, &proposed, ends);
        for lane in lanes(&moving) {
            proposed[lane] = passed[lane].lengthened(proposed[lane]).min(longest);
        }
        let mut targets = self.time;
        let mut pending = moving;
        let mut component = [None; L];
        // The arrivals of lanes whose steps end at discontinuity surfaces.
        let mut arrivals = None;
        loop {
            for lane in lanes(&pending) {
                let target = self.target(lane, proposed[lane], ends[lane]);
                targets[lane] = target.unwrap_or_else(|| {
                    self.too_small(dynamics, lane, proposed[lane], component[lane]);
                    (moving[lane], pending[lane]) = (false, false);
                    self.time[lane]
                });
            }
            let reached = self.at(&targets);
            let verdicts = self.check(dynamics, &targets, (&reached, middle, &passed), &pending);
            for lane in lanes(&pending) {
                let judged = (lane, verdicts[lane], middle);
                let times = (targets[lane], ends[lane]);
                let rejection = self.rejection(dynamics, judged, times, &mut arrivals);
                let Some((part, beyond)) = rejection else {
                    pending[lane] = false;
                    continue;
                };
                component[lane] = beyond.or(component[lane]);
                self.statistics[lane].rejected += 1;
                let length = (targets[lane] - self.time[lane]).abs();
                proposed[lane] = match part {
                    Some(part) => part * length,
                    None => passed[lane].shortened(length),
                };
            }
            if !any(&pending) {
                let ends = (&targets, arrivals.as_ref(), &passed);
                let state = self.ends(dynamics, &mut moving, ends, reached.state);
                self.accept(&moving, (&targets, &proposed), state, arrivals.as_ref());
                return;
            }
        }
    }

    /// Returns the end of a proposed step of a lane on the way to `end`; `None` if the step is too small.
    fn target(&self, lane: usize, proposed: f64, end: f64) -> Option<f64> {
        let time = self.time[lane];
        let least = (MIN_STEP * f64::EPSILON * time.abs()).max(f64::MIN_POSITIVE);
        let remaining = end - time;
        if LANDING * proposed >= remaining.abs() {
            return Some(end);
        }
        (proposed > least).then(|| time + proposed.copysign(remaining))
    }

    /// Completes a step of the lanes that move.
    fn accept(
        &mut self,
        moving: &[bool; L],
        (targets, proposed): (&[f64; L], &[f64; L]),
        state: Compensated<X>,
        arrivals: Option<&Arrivals<X, L>>,
    ) {
        let previous = core::mem::replace(&mut self.state, state);
        self.previous = (self.time, previous, self.unit);
        for lane in lanes(moving) {
            self.statistics[lane].steps += 1;
            if arrivals.is_some_and(|arrivals| self.arrive(lane, arrivals)) {
                continue;
            }
            self.length[lane] = (targets[lane] - self.time[lane]).abs();
            self.time_scale[lane] = self.time_scale[lane].max(self.length[lane]);
            self.time[lane] = targets[lane];
            self.short_passages[lane] = 0;
            if proposed[lane].is_normal() {
                self.unit[lane] = unit_near(proposed[lane]);
            }
        }
    }

    /// Returns the lanes without an error that are not at their ends.
    fn moving<D>(&mut self, dynamics: &D, ends: &[f64; L]) -> [bool; L]
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        core::array::from_fn(|lane| {
            let remaining = ends[lane] - self.time[lane];
            if self.errors[lane].is_none() && !remaining.is_finite() {
                let time = ends[lane];
                self.fail(lane, IntegrationError::NonFiniteTime { time });
            }
            if remaining.abs() > 0.0 {
                self.stop_sliding(dynamics, lane);
            }
            self.errors[lane].is_none() && remaining.abs() > 0.0
        })
    }

    /// Checks new lanes, and chooses their first units of time.
    fn begin<D>(&mut self, dynamics: &D)
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        if !any(&self.is_new) {
            return;
        }
        let derivative = self.derivative(dynamics);
        let tolerance = self.method.tolerance::<Lanes<L>>();
        let state = self.state.value();
        let rates = tolerance.rates(dynamics, state, &derivative);
        let allowed = dynamics.allowed_error(state, &tolerance.over(Lanes([1.0; L])));
        let largest = tolerance.relative.max(tolerance.absolute);
        let ratios = largest_ratios(&derivative, &Tolerance::weights(&allowed));
        for lane in lanes(&core::mem::replace(&mut self.is_new, [false; L])) {
            self.statistics[lane].evaluations += 1;
            if let Some(error) = self.setting_error(dynamics, lane, &derivative) {
                self.fail(lane, error);
            }
            let time = match rates {
                Some(rates) => time_scale(rates.map(|rates| rates.0[lane])),
                None => 1.0 / (ratios.0[lane] * largest),
            };
            let usable = Some(time).filter(|time| time.is_normal());
            self.time_scale[lane] = usable.unwrap_or(1.0 / FIRST_UNIT);
            self.unit[lane] = unit_near(FIRST_UNIT * self.time_scale[lane]);
            self.check_start(dynamics, lane);
        }
    }

    fn derivative<D>(&self, dynamics: &D) -> X
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let value = self.state.value();
        dynamics.derivative(Lanes(self.time), &dynamics.reduced(value, &value.zeroed()))
    }

    /// Returns an error in the settings of the method, the time, the state or its derivative in a lane, if there is
    /// one.
    fn setting_error<D>(
        &self,
        dynamics: &D,
        lane: usize,
        derivative: &X,
    ) -> Option<IntegrationError>
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let time = self.time[lane];
        if let Err(error) = self.method.check() {
            return Some(error);
        }
        if !time.is_finite() {
            return Some(IntegrationError::NonFiniteTime { time });
        }
        if let Some((index, value)) = non_finite(self.state.value(), lane) {
            let component = dynamics.component_name(index);
            return Some(IntegrationError::NonFiniteState {
                time,
                component,
                value,
            });
        }
        non_finite(derivative, lane).map(|(index, value)| IntegrationError::NonFiniteDerivative {
            time,
            component: dynamics.component_name(index),
            value,
        })
    }

    /// Evaluates the polynomials at a time in each lane.
    fn at(&self, times: &[f64; L]) -> Reached<X, L> {
        let [high, low] = difference(Lanes(*times), Lanes(self.time));
        let tau = (high + low) / Lanes(self.unit);
        let (change, slope) = self.coefficients.change_and_derivative(tau);
        let state = self.state.plus(change);
        Reached { tau, state, slope }
    }
}

/// The values of the polynomials at a time in each lane.
struct Reached<X, const L: usize> {
    /// The arguments of the polynomials.
    tau: Lanes<L>,
    state: Compensated<X>,
    /// The derivatives of the polynomials with respect to their arguments.
    slope: X,
}

/// The next step in each lane, as proposed by the polynomials.
struct Proposals<const L: usize> {
    /// The length of the step; 0 if there is none.
    step: [f64; L],
    /// The larger of the two terms of about half the order, over their tolerances.
    middle: Lanes<L>,
}

/// Returns the lanes for which a mask is true.
fn lanes<const L: usize>(mask: &[bool; L]) -> impl Iterator<Item = usize> + use<L> {
    let mask = *mask;
    (0..L).filter(move |&lane| mask[lane])
}

fn any<const L: usize>(mask: &[bool; L]) -> bool {
    mask.contains(&true)
}

/// Returns the index and the value of the first component in a lane that is not finite.
fn non_finite<X: LaneStates<L>, const L: usize>(states: &X, lane: usize) -> Option<(usize, f64)> {
    let components = states.components().map(|component| component.lane(lane));
    components
        .enumerate()
        .find(|(_, component)| !component.is_finite())
}
