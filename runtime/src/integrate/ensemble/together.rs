//! Members of an ensemble in the lanes of a Taylor method.

#![allow(clippy::type_complexity)] // The type of a problem contains its settings.

use core::iter::{Enumerate, Fuse};

use super::EnsembleIntegrator;
use crate::integrate::event::{MetConditions, OneSigned, OneSignedInLanes, Watched};
use crate::integrate::in_lanes::InLanes;
use crate::integrate::loop_state::{Steps, Taken};
use crate::integrate::observer::Observer;
use crate::integrate::problem::{Found, Keep, Member, Problem};
use crate::integrate::reactions::Reactions;
use crate::integrate::stepper::{Statistics, Stepper as _};
use crate::integrate::taylor::{
    Series, SeriesMemory, SingleMotions, StepOfLane, Taylor, TaylorLanes, TaylorStepper,
};
use crate::linalg::LaneStates;
use crate::scalar::Lanes;

impl<D, const L: usize, const HALF: usize> EnsembleIntegrator<f64, D, L> for Taylor<HALF>
where
    D: InLanes<L>,
{
    fn solve_each<K, C, R, O, Kept>(
        &self,
        members: impl Iterator<Item = (Problem<f64, D, K, C, R, O>, f64)>,
        report: impl FnMut(usize, Found<f64, D::State, Kept>),
    ) where
        C: Watched<f64, D>,
        R: Reactions<f64, D>,
        O: Observer<D::State>,
        K: Keep<f64, D, Self::Stepper, Kept = Kept>,
    {
        let mut together = Together {
            method: *self,
            waiting: members.enumerate().fuse(),
            members: [const { None }; L],
            steppers: None,
            report,
        };
        while together.fill() {
            while !together.step() {}
        }
    }
}

/// The members that are integrated together, and those that are waiting.
struct Together<D, I, F, K, C, R, O, const L: usize, const HALF: usize>
where
    D: InLanes<L>,
    C: Watched<f64, D>,
    K: Keep<f64, D, TaylorStepper<D::State, HALF>>,
{
    method: Taylor<HALF>,
    waiting: Fuse<Enumerate<I>>,
    members: [Option<InLane<D, K, C, R, O, HALF>>; L],
    /// `None` before the first member.
    steppers: Option<Steppers<D, L, HALF>>,
    report: F,
}

/// The steppers of all lanes, the parameters for their equations, and the memory for their series.
type Steppers<D, const L: usize, const HALF: usize> = (
    TaylorLanes<<D as InLanes<L>>::States, L, HALF>,
    <D as InLanes<L>>::Parameters,
    SeriesMemory,
);

/// A member in a lane.
struct InLane<D, K, C, R, O, const HALF: usize>
where
    D: Series<f64>,
    C: Watched<f64, D>,
    K: Keep<f64, D, TaylorStepper<D::State, HALF>>,
{
    /// Its position among the members.
    index: usize,
    member: Member<f64, D, Taylor<HALF>, K, C, R, O>,
    /// The time towards which its steps are taken.
    target: f64,
    /// The statistics of the member before the lane was set.
    before: Statistics,
}

impl<D, K, C, R, O, const HALF: usize> InLane<D, K, C, R, O, HALF>
where
    D: Series<f64>,
    C: Watched<f64, D>,
    R: Reactions<f64, D>,
    O: Observer<D::State>,
    K: Keep<f64, D, TaylorStepper<D::State, HALF>>,
{
    /// Sets a lane to the time, the state and the parameters of the member.
    fn set<const L: usize>(
        &mut self,
        lane: usize,
        (lanes, parameters, _): &mut Steppers<D, L, HALF>,
    ) where
        D: InLanes<L>,
    {
        let stepper = self.member.stepper();
        lanes.set_lane(lane, stepper.time(), stepper.state());
        self.member.dynamics().set_lane(parameters, lane);
        // The lane evaluates the derivative at this state again, but the motion needs it only once.
        self.before = stepper.statistics();
        self.before.evaluations = self.before.evaluations.saturating_sub(1);
    }

    /// Whether the last step of a lane ended before the target, with nothing in it that the member has to see.
    #[inline]
    fn passes_over<const L: usize>(
        &mut self,
        lane: usize,
        lanes: &TaylorLanes<D::States, L, HALF>,
        one_signed: OneSigned,
    ) -> bool
    where
        D: InLanes<L>,
    {
        let attempts = || self.before.plus(lanes.statistics(lane)).attempts();
        let step = [lanes.previous_time(lane), lanes.time(lane)];
        lanes.error(lane).is_none() && self.member.passes_over(step, attempts, one_signed)
    }

    /// Lets the member process the last step of a lane. Returns whether the member has not ended.
    fn follow<const L: usize>(
        &mut self,
        lane: usize,
        lanes: &TaylorLanes<D::States, L, HALF>,
        is_regular: bool,
    ) -> bool
    where
        D: InLanes<L>,
    {
        let member = &mut self.member;
        let failure = lanes.error(lane);
        let is_within = failure.is_none() && (!is_regular || member.looks_within(lanes.time(lane)));
        let stepper = member.stepper_mut();
        stepper.follow((lanes, lane), self.before, is_within);
        let taken = match failure {
            Some(error) => {
                stepper.forget_last_step();
                Taken::Failed(error)
            }
            None if is_regular => Taken::Regular,
            None => Taken::Unchecked,
        };
        member.catch_up();
        let target = member.stepped(taken);
        self.target = target.unwrap_or(self.target);
        target.is_some()
    }
}

impl<D, I, F, K, C, R, O, const L: usize, const HALF: usize> Together<D, I, F, K, C, R, O, L, HALF>
where
    D: InLanes<L>,
    I: Iterator<Item = (Problem<f64, D, K, C, R, O>, f64)>,
    F: FnMut(usize, Found<f64, D::State, K::Kept>),
    C: Watched<f64, D>,
    R: Reactions<f64, D>,
    O: Observer<D::State>,
    K: Keep<f64, D, TaylorStepper<D::State, HALF>>,
{
    /// Assigns a member to each free lane, as long as there are any. Returns false when all have ended.
    fn fill(&mut self) -> bool {
        for lane in 0..L {
            if self.members[lane].is_some() {
                continue;
            }
            self.begin_next(lane);
            let Some(begun) = &mut self.members[lane] else {
                break;
            };
            let steppers = self.steppers.get_or_insert_with(|| {
                let (dynamics, stepper) = (begun.member.dynamics(), begun.member.stepper());
                let lanes = TaylorLanes::new(self.method, stepper.time(), stepper.state());
                (lanes, dynamics.parameters(), SeriesMemory::default())
            });
            begun.set(lane, steppers);
        }
        self.park();
        self.members.iter().any(Option::is_some)
    }

    /// Puts the next member that takes a step into a free lane. Members that end before their first step are reported. A member
    /// contains its stepper and is large: it is put into its lane before it begins, so that it is not moved afterwards.
    #[inline]
    fn begin_next(&mut self, lane: usize) {
        let place = &mut self.members[lane];
        for (index, (problem, end)) in self.waiting.by_ref() {
            let found = match problem.into_member(end, self.method) {
                Ok(member) => {
                    let begun = place.insert(InLane {
                        index,
                        member,
                        // Until it begins.
                        target: end,
                        before: Statistics::default(),
                    });
                    if let Some(target) = begun.member.go_on(Steps::Shared) {
                        begun.target = target;
                        return;
                    }
                    let Some(ended) = place.take() else { return };
                    ended.member.finish()
                }
                Err(found) => found,
            };
            (self.report)(index, found);
        }
    }

    /// Moves free lanes to the state of a busy one, so that they are at no singularity; they stay there.
    fn park(&mut self) {
        let Some((lanes, parameters, _)) = &mut self.steppers else {
            return;
        };
        let busy = self.members.iter().enumerate().find_map(|(lane, place)| {
            let place = place.as_ref()?;
            Some((lane, place.member.dynamics()))
        });
        let Some((busy, dynamics)) = busy else { return };
        for lane in (0..L).filter(|&lane| self.members[lane].is_none()) {
            lanes.set_lane(lane, lanes.time(busy), &lanes.state(busy));
            dynamics.set_lane(parameters, lane);
        }
    }

    /// Takes steps in all lanes until a member has to process one, and lets the members do so. Returns whether a lane
    /// has become free.
    fn step(&mut self) -> bool {
        let Some(steppers) = &mut self.steppers else {
            return true;
        };
        let (is_regular, passed) = steps(&mut self.members, steppers);
        let mut is_free = false;
        for (lane, place) in self.members.iter_mut().enumerate() {
            let Some(begun) = place else { continue };
            if passed[lane] {
                continue;
            }
            if !begun.follow(lane, &steppers.0, is_regular) {
                if let Some(InLane { index, member, .. }) = place.take() {
                    (self.report)(index, member.finish());
                }
                is_free = true;
            } else if begun.member.stepper().is_new() {
                begun.set(lane, steppers);
            }
        }
        is_free
    }
}

impl<D, K, C, R, O, const L: usize, const HALF: usize> SingleMotions<D::States, L>
    for [Option<InLane<D, K, C, R, O, HALF>>; L]
where
    D: InLanes<L>,
    C: Watched<f64, D>,
    R: Reactions<f64, D>,
    O: Observer<D::State>,
    K: Keep<f64, D, TaylorStepper<D::State, HALF>>,
{
    fn check<const ORDER_HALF: usize>(
        &self,
        step: StepOfLane<'_, D::States, L, ORDER_HALF>,
    ) -> Option<Result<(), usize>> {
        let dynamics = self.get(step.lane())?.as_ref()?.member.dynamics();
        let parameters = dynamics.parameters();
        Some(step.check(&dynamics.together(&parameters)))
    }
}

/// Takes steps in all lanes until a member has to process one. Returns whether it is certain that the last step has
/// neither led to a singularity nor passed one, and the lanes whose members pass over it.
fn steps<D, K, C, R, O, const L: usize, const HALF: usize>(
    members: &mut [Option<InLane<D, K, C, R, O, HALF>>; L],
    (lanes, parameters, memory): &mut Steppers<D, L, HALF>,
) -> (bool, [bool; L])
where
    D: InLanes<L>,
    C: Watched<f64, D>,
    R: Reactions<f64, D>,
    O: Observer<D::State>,
    K: Keep<f64, D, TaylorStepper<D::State, HALF>>,
{
    // Lanes without a member stay where they are.
    let mut targets = lanes.times().0;
    let (mut min_pivot, mut watched) = (0.0_f64, MetConditions::default());
    for (lane, begun) in busy(members) {
        targets[lane] = begun.target;
        min_pivot = min_pivot.max(begun.member.min_pivot());
        watched = watched.or(begun.member.deciding_functions());
    }
    loop {
        let Some(any) = members.iter().flatten().next() else {
            return (true, [true; L]);
        };
        let one_signed = {
            let equations = any.member.dynamics().together(parameters);
            lanes.step_of((&equations, &*members), &targets, Some(memory));
            if !is_regular(&equations, lanes, min_pivot) {
                return (false, [false; L]);
            }
            if watched.any() {
                lanes.one_signed(&equations, watched)
            } else {
                OneSignedInLanes::UNKNOWN
            }
        };
        let mut passed = [true; L];
        for (lane, begun) in busy(members) {
            passed[lane] = begun.passes_over(lane, lanes, one_signed.of_lane(lane));
        }
        if passed.contains(&false) {
            return (true, passed);
        }
    }
}

/// Returns the members in lanes.
fn busy<T>(members: &mut [Option<T>]) -> impl Iterator<Item = (usize, &mut T)> {
    let lanes = members.iter_mut().enumerate();
    lanes.filter_map(|(lane, begun)| Some((lane, begun.as_mut()?)))
}

/// Whether it is certain that the last steps have neither led to a singularity nor passed one.
fn is_regular<D, const L: usize, const HALF: usize>(
    equations: &D,
    lanes: &TaylorLanes<D::State, L, HALF>,
    min_pivot: f64,
) -> bool
where
    D: Series<Lanes<L>, State: LaneStates<L>>,
{
    if min_pivot <= 0.0 {
        return true;
    }
    let (times, states) = (lanes.times(), lanes.states());
    let before = lanes.previous_states();
    let found = equations.singularity_in_motion(times, states, min_pivot);
    let pole = equations.singularity_between(before, (times, states));
    found.is_none() && pole.is_none()
}
