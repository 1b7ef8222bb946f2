//! The steps of the Taylor series method in lanes, each with its own step size.
//!
//! The arithmetic of states, series and checks is vectorized ([`Lanes`]). Quantities that control single lanes are in
//! arrays: times, units of time, and which lanes still move. Lanes do not depend on each other, except that every
//! series is computed as often as the lane that needs most requires.

mod arrivals;
mod attempt;
mod checks;
mod correction;
mod events;
mod expansion;
mod last_step;
mod passage;
mod passing;
mod projection;
mod rejection;
mod start;
mod verdicts;
mod within;

use attempt::{Attempt, Expansion, Proposals};
pub(crate) use within::{SingleMotions, StepOfLane};

use super::coefficients::{TaylorCoefficients, number};
use super::interpolant::difference;
use super::series_memory::SeriesMemory;
use super::step_size::near_normal;
use super::uncertain_steps::UncertainSteps;
use super::{Series, Taylor};
use crate::integrate::binary_logarithm::is_normal;
use crate::integrate::compensated::Compensated;
use crate::integrate::error::IntegrationError;
use crate::integrate::stepper::Statistics;
use crate::limits::taylor::{FIRST_UNIT, LANDING, MIN_STEP};
use crate::linalg::LaneStates;
use crate::scalar::{Lanes, Scalar};

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
    /// The steps that are checked within.
    uncertain: [UncertainSteps; L],
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
        let x = X::broadcast(x);
        let coefficients = TaylorCoefficients::new(x.clone());
        Self::with_coefficients(method, t, Compensated::new(x), coefficients)
    }

    /// Creates a stepper with all lanes at time `t`.
    #[inline]
    fn with_coefficients(
        method: Taylor<HALF>,
        t: f64,
        state: Compensated<X>,
        coefficients: TaylorCoefficients<X, HALF>,
    ) -> Self {
        Self {
            method,
            time: [t; L],
            unit: [1.0; L],
            coefficients,
            previous: ([t; L], state.clone(), [1.0; L]),
            state,
            length: [0.0; L],
            uncertain: [UncertainSteps::NEW; L],
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
        self.uncertain[lane] = UncertainSteps::NEW;
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
        self.step_of((dynamics, &()), ends, None);
    }

    /// Takes this step, with the series in this memory if it is given. Where few lanes are checked within their steps, each is
    /// checked by the equations of its motion in all lanes.
    pub(crate) fn step_of<D, M>(
        &mut self,
        (dynamics, motions): (&D, &M),
        ends: &[f64; L],
        memory: Option<&mut SeriesMemory>,
    ) where
        D: Series<Lanes<L>, State = X> + ?Sized,
        M: SingleMotions<X, L>,
    {
        self.begin(dynamics);
        let mut moving = self.moving(dynamics, ends);
        if !any(&moving) {
            return;
        }
        let from = self.state.reduced(dynamics);
        let proposals = self.expand((dynamics, memory), &from, &mut moving);
        let longest = self.method.max_step.unwrap_or(f64::INFINITY);
        let mut lengths = core::array::from_fn(|lane| {
            let step = proposals.step[lane].min(longest);
            let signed = step.copysign(ends[lane] - self.time[lane]);
            self.uncertain[lane].limited(self.time[lane], signed)
        });
        let passed = self.singular_configurations(dynamics, (&moving, ends), &mut lengths);
        let mut expansion = Expansion {
            from,
            proposals,
            passed,
        };
        let mut attempt = Attempt::new(moving, lengths, self.time);
        let mut reached = self.aim(dynamics, &mut attempt, ends);
        while let Some(verdicts) =
            self.check((dynamics, motions), &mut attempt, (&expansion, &reached))
        {
            self.judge(dynamics, &mut attempt, (&mut expansion, &verdicts), ends);
            if !any(&attempt.pending) {
                break;
            }
            reached = self.aim(dynamics, &mut attempt, ends);
        }
        self.correct(&mut attempt, &mut reached);
        let passed = expansion.passed.as_ref();
        self.finish(dynamics, &mut attempt, passed, &mut reached.state);
        self.accept((&attempt, &expansion.proposals), reached.state);
    }

    /// Determines the times at which the steps of the pending lanes end, and returns the values of the polynomials
    /// there. Lanes whose steps are too small stop.
    fn aim<D>(
        &mut self,
        dynamics: &D,
        attempt: &mut Attempt<X, L>,
        ends: &[f64; L],
    ) -> Reached<X, L>
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let Attempt {
            pending, lengths, ..
        } = &*attempt;
        let time = &self.time;
        let lands: [bool; L] =
            core::array::from_fn(|lane| LANDING * lengths[lane] >= (ends[lane] - time[lane]).abs());
        let targets = core::array::from_fn(|lane| {
            let step = lengths[lane].copysign(ends[lane] - time[lane]);
            let target = if lands[lane] {
                ends[lane]
            } else {
                time[lane] + step
            };
            if pending[lane] {
                target
            } else {
                attempt.targets[lane]
            }
        });
        let is_too_small: [bool; L] = core::array::from_fn(|lane| {
            let least = (MIN_STEP * f64::EPSILON * time[lane].abs()).max(f64::MIN_POSITIVE);
            let is_large = lengths[lane] > least;
            pending[lane] && !lands[lane] && !is_large
        });
        (attempt.targets, attempt.lands) = (targets, lands);
        if any(&is_too_small) {
            self.stop_short(dynamics, attempt, &is_too_small);
        }
        self.at(&attempt.targets)
    }

    /// Completes a step of the lanes that move.
    #[inline]
    fn accept(
        &mut self,
        (attempt, proposals): (&Attempt<X, L>, &Proposals<L>),
        state: Compensated<X>,
    ) {
        (self.previous.0, self.previous.2) = (self.time, self.unit);
        self.previous.1 = core::mem::replace(&mut self.state, state);
        let mut moving = attempt.moving;
        for (statistics, moving) in self.statistics.iter_mut().zip(moving) {
            statistics.steps += u64::from(moving);
        }
        if let Some(arrivals) = &attempt.arrivals {
            for lane in lanes(&attempt.moving) {
                moving[lane] = !self.arrive(lane, arrivals);
            }
        }
        let Attempt {
            targets, lengths, ..
        } = attempt;
        let update = |old: &[f64; L], new: [f64; L]| {
            core::array::from_fn(|lane| if moving[lane] { new[lane] } else { old[lane] })
        };
        let length = (Lanes(*targets) - Lanes(self.time)).abs();
        let time_scale = Scalar::max(Lanes(self.time_scale), length);
        self.length = update(&self.length, length.0);
        for lane in lanes(&moving) {
            let proposed = attempt.lands[lane].then_some(proposals.step[lane]);
            self.uncertain[lane].accept(targets[lane], length.0[lane], proposed);
        }
        self.time_scale = update(&self.time_scale, time_scale.0);
        self.time = update(&self.time, *targets);
        let near = lengths.map(near_normal);
        let unit = |lane: usize| {
            if is_normal(lengths[lane]) {
                near[lane]
            } else {
                self.unit[lane]
            }
        };
        self.unit = update(&self.unit, core::array::from_fn(unit));
        for (count, moving) in self.short_passages.iter_mut().zip(moving) {
            *count = if moving { 0 } else { *count };
        }
    }

    /// Returns the lanes without an error that are not at their ends.
    fn moving<D>(&mut self, dynamics: &D, ends: &[f64; L]) -> [bool; L]
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let remaining = Lanes(*ends) - Lanes(self.time);
        let can_move =
            |all, lane: usize| all & self.errors[lane].is_none() & self.sliding[lane].is_none();
        if remaining.is_finite() && (0..L).fold(true, can_move) {
            return remaining.0.map(|remaining| remaining.abs() > 0.0);
        }
        self.stop_some(dynamics, ends);
        core::array::from_fn(|lane| self.errors[lane].is_none() && remaining.0[lane].abs() > 0.0)
    }

    /// Evaluates the polynomials at a time in each lane.
    fn at(&self, times: &[f64; L]) -> Reached<X, L> {
        let [high, low] = difference(Lanes(*times), Lanes(self.time));
        let tau = (high + low) / Lanes(self.unit);
        let [change, slope] = self.coefficients.change_and_derivative_in_lanes(tau);
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

/// Returns the lanes for which a mask is true.
fn lanes<const L: usize>(mask: &[bool; L]) -> impl Iterator<Item = usize> + use<L> {
    let mask = *mask;
    (0..L).filter(move |&lane| mask[lane])
}

fn any<const L: usize>(mask: &[bool; L]) -> bool {
    mask.iter().fold(false, |any, lane| any | lane)
}

/// Returns the lanes for which two masks are true; the first one hardly ever is.
#[inline]
fn both<const L: usize>(rare: &[bool; L], asked: &[bool; L]) -> [bool; L] {
    if any(rare) {
        core::array::from_fn(|lane| rare[lane] && asked[lane])
    } else {
        [false; L]
    }
}

/// Returns the index and the value of the first component in a lane that is not finite.
fn non_finite<X: LaneStates<L>, const L: usize>(states: &X, lane: usize) -> Option<(usize, f64)> {
    let components = states.components().map(|component| component.lane(lane));
    components
        .enumerate()
        .find(|(_, component)| !component.is_finite())
}
