//! The next events of a window, from the roots of the polynomials in it.

use super::DeclaredEvents;
use crate::integrate::event::EventFunctions;
use crate::integrate::event::memory::Memory;
use crate::integrate::event::polynomial::{Polynomial, Root};
use crate::integrate::event::window::Window;
use crate::integrate::event::{
    Bracket, EventDynamics, LastStep, MetConditions, Occurring, SingleNumber,
};
use crate::integrate::stepper::Advance;
use crate::limits::events::MAX_COEFFICIENTS;

impl<const K: usize> DeclaredEvents<K> {
    /// Returns the next events at roots of these polynomials in the fraction of the step.
    pub(super) fn next_roots<S, D, T>(
        &mut self,
        memory: &mut Memory<[f64; K]>,
        step: &mut LastStep<'_, S, D, T>,
        window: Window<K>,
        polynomials: &[Polynomial; K],
    ) -> Option<Occurring>
    where
        S: SingleNumber,
        D: EventDynamics<S> + ?Sized,
        T: Advance<S, D>,
    {
        let from = window.fraction(memory.until);
        let near = window.fraction(step.after(window.begin));
        let (mut found, mut first_of_all) = ([None; K], [None; K]);
        for (event, polynomial) in polynomials.iter().enumerate() {
            [found[event], first_of_all[event]] =
                self.first_of(event, polynomial, memory, (window, from, near));
        }
        let (times, late) = self.times_of(memory, step, window, &found);
        let forwards = window.end >= window.begin;
        let in_order = |a: &f64, b: &f64| {
            if forwards {
                a.total_cmp(b)
            } else {
                b.total_cmp(a)
            }
        };
        let Some(first) = times.into_iter().flatten().min_by(in_order) else {
            arrive_at_end(
                memory,
                &window,
                (polynomials, &first_of_all),
                [from, near],
                late,
            );
            return None;
        };
        let behind = step.after(first);
        let is_here = |time: &f64| !step.comes_before(behind, *time);
        let occurs = |event: usize| {
            let touches = |root: &Root| {
                // After a time within its rounding errors, a zero without a change of sign is no longer seen.
                root.before * root.behind > 0.0
                    && polynomials[event].is_uncertain(window.fraction(behind))
            };
            times[event].as_ref().is_some_and(is_here) || found[event].as_ref().is_some_and(touches)
        };
        let events = MetConditions::of((0..K).map(occurs));
        // All of them have occurred at the latest of their times, so that a run which begins there finds none of them again.
        let together = times.into_iter().flatten().filter(is_here);
        let t = together.max_by(in_order).unwrap_or(first);
        let behind = step.after(t);
        note_occurring(memory, &found, events);
        let others = (polynomials, &first_of_all, &found);
        note_others(
            memory,
            &window,
            others,
            events,
            (t, window.fraction(behind)),
        );
        let still = stay_at_zero(memory, polynomials, [from, near], window.fraction(t));
        memory.arrive(behind);
        memory.left = still.without(events);
        memory.note_zeros(events, t);
        let sample = step.at(t);
        memory.at_event = self.values(step.dynamics(), t, &sample.x);
        Some(Occurring { t, events })
    }

    /// Returns the times of the events at these roots, as long as they may be the first. Also returns the events whose
    /// functions have not reached zero in the window; they occur later.
    fn times_of<S, D, T>(
        &mut self,
        memory: &mut Memory<[f64; K]>,
        step: &mut LastStep<'_, S, D, T>,
        window: Window<K>,
        found: &[Option<Root>; K],
    ) -> ([Option<f64>; K], MetConditions)
    where
        S: SingleNumber,
        D: EventDynamics<S> + ?Sized,
        T: Advance<S, D>,
    {
        let (mut times, mut late) = ([None; K], MetConditions::default());
        let mut first = f64::INFINITY;
        let mut order: [usize; K] = core::array::from_fn(|event| event);
        let at = |event: &usize| found[*event].map_or(f64::INFINITY, |root| root.at);
        order.sort_unstable_by(|a, b| at(a).total_cmp(&at(b)));
        for event in order {
            let Some(root) = found[event].filter(|root| root.at <= first.min(1.0)) else {
                break;
            };
            if let Some(t) = self.time_of(event, root, step, window) {
                times[event] = Some(t);
                first = first.min(window.fraction(step.after(t)));
            } else {
                memory.signs[event] = root.before;
                late.insert(event);
            }
        }
        (times, late)
    }

    /// Returns the time of an event at a root, moved by rounding errors until its function has reached zero. Where
    /// terms of the polynomial cancel, it has larger rounding errors than the function, whose zero then
    /// counts. `None` if that is after the window.
    pub(super) fn time_of<S, D, T>(
        &mut self,
        event: usize,
        root: Root,
        step: &mut LastStep<'_, S, D, T>,
        window: Window<K>,
    ) -> Option<f64>
    where
        S: SingleNumber,
        D: EventDynamics<S> + ?Sized,
        T: Advance<S, D>,
    {
        let time = window.time(root.at);
        if root.before * root.behind >= 0.0 {
            return Some(time);
        }
        let near = step.after(time);
        let farthest = window.time(root.until);
        let farthest = if step.comes_before(farthest, near) {
            near
        } else {
            farthest
        };
        let mut is_before = |t: f64| {
            let there = step.at(t);
            self.values(step.dynamics(), t, &there.x)[event] * root.before > 0.0
        };
        let mut distance = f64::EPSILON * time.abs().max(f64::MIN_POSITIVE);
        let (mut before, mut there) = (time, time);
        while is_before(there) {
            if there - farthest == 0.0 {
                let is_last = farthest - window.end == 0.0;
                return (!is_last).then_some(near);
            }
            before = there;
            there = time + distance.copysign(farthest - time);
            if (there - time).abs() >= (farthest - time).abs() {
                there = farthest;
            }
            distance *= 4.0;
        }
        if (near - time).abs() < (there - time).abs() {
            let mut bracket = Bracket::new(before, there);
            while let Some(middle) = bracket.divide((before, f64::NAN), (there, f64::NAN)) {
                let end = if is_before(middle) {
                    &mut before
                } else {
                    &mut there
                };
                *end = middle;
            }
        }
        Some(there)
    }
}

/// Records which of the events that were found occur.
fn note_occurring<const K: usize>(
    memory: &mut Memory<[f64; K]>,
    found: &[Option<Root>; K],
    events: MetConditions,
) {
    for event in events.indices() {
        if let Some(root) = found[event] {
            (memory.signs[event], memory.resume[event]) = (root.behind, root.until);
        }
        memory.ahead[event] = 0.0;
    }
}

/// Records, for the functions of the other events, the signs until their next roots after a part of the window, and the
/// times of the roots that are passed. These need not be events, but a root at which an event was found does not count
/// as passed.
fn note_others<const K: usize>(
    memory: &mut Memory<[f64; K]>,
    window: &Window<K>,
    (polynomials, first_of_all, found): (&[Polynomial; K], &[Option<Root>; K], &[Option<Root>; K]),
    events: MetConditions,
    (t, behind): (f64, f64),
) {
    let here = window.fraction(t);
    for event in (0..K).filter(|event| !events.contains(*event)) {
        let end = found[event].map_or(f64::INFINITY, |root| root.at);
        let is_passed = |root: &Root| root.at <= behind && root.at < end && window.trusts(root);
        let roots = roots_from(&polynomials[event], first_of_all[event], is_passed);
        let [last, next] = roots;
        if let Some(root) = last {
            (memory.signs[event], memory.resume[event]) = (root.behind, root.until);
            // A function that had no certain sign until now, or whose root cannot be distinguished from here, is zero
            // here.
            memory.zero_at[event] = if root.until > here - (behind - here) {
                t
            } else {
                window.time(root.at)
            };
        }
        memory.ahead[event] = next.map_or(0.0, |root| root.before);
    }
}

/// Returns the last passed root, starting from `first`, and the root after it.
fn roots_from(
    polynomial: &Polynomial,
    first: Option<Root>,
    is_passed: impl Fn(&Root) -> bool,
) -> [Option<Root>; 2] {
    let (mut last, mut next) = (None, first);
    for _ in 0..MAX_COEFFICIENTS {
        let Some(root) = next.filter(&is_passed) else {
            break;
        };
        last = Some(root);
        next = polynomial.next_root(root.until, root.behind);
    }
    [last, next]
}

/// Returns the events whose functions have not left zero up to a part of the window.
fn stay_at_zero<const K: usize>(
    memory: &Memory<[f64; K]>,
    polynomials: &[Polynomial; K],
    [from, near]: [f64; 2],
    part: f64,
) -> MetConditions {
    let stays = |(event, polynomial): (usize, &Polynomial)| {
        let is_left = memory.left.contains(event);
        let leaves = || polynomial.leaves(from.max(near), memory.hysteresis[event]);
        is_left && leaves().is_none_or(|(at, _)| at > part)
    };
    MetConditions::of(polynomials.iter().enumerate().map(stays))
}

/// Records the signs at the end of a window, after its last event; the signs of late events are already known.
fn arrive_at_end<const K: usize>(
    memory: &mut Memory<[f64; K]>,
    window: &Window<K>,
    (polynomials, first_of_all): (&[Polynomial; K], &[Option<Root>; K]),
    [from, near]: [f64; 2],
    late: MetConditions,
) {
    let still = stay_at_zero(memory, polynomials, [from, near], 1.0);
    for (event, polynomial) in polynomials.iter().enumerate() {
        if late.contains(event) || still.contains(event) {
            continue;
        }
        let is_passed = |root: &Root| root.at <= 1.0 && window.trusts(root);
        let [last, _] = roots_from(polynomial, first_of_all[event], is_passed);
        if let Some(root) = last {
            memory.zero_at[event] = window.time(root.at);
        }
        let known = (from, memory.resume[event]);
        memory.signs[event] = window.last_sign(polynomial, known, memory.signs[event]);
    }
    let touches =
        |(polynomial, resume): (&Polynomial, f64)| resume < 1.0 && polynomial.is_uncertain(1.0);
    let touching = MetConditions::of(polynomials.iter().zip(memory.resume).map(touches));
    memory.arrive(window.end);
    (memory.touching, memory.left) = (touching.without(still), still);
    (memory.resume, memory.ahead) = ([0.0; K], [0.0; K]);
    memory.window = window.end;
}
