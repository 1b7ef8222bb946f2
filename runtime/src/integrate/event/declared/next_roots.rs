//! The next events of a window, from the roots of the polynomials in it.

use super::DeclaredEvents;
use crate::integrate::event::detection::EventFunctions;
use crate::integrate::event::memory::Memory;
use crate::integrate::event::polynomial::{Polynomial, Root};
use crate::integrate::event::window::Window;
use crate::integrate::event::{
    Bracket, EventDynamics, LastStep, MetConditions, Occurring, SingleNumber,
};
use crate::integrate::stepper::Advance;

impl<const K: usize> DeclaredEvents<K> {
    /// The next events at roots of these polynomials of the fraction of the step.
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
        let mut found = [None; K];
        for (event, polynomial) in polynomials.iter().enumerate() {
            found[event] = self.first_of(event, polynomial, memory, (window, from, near));
        }
        let mut late = MetConditions::default();
        for _ in 0..=K {
            let times = found.iter().flatten().map(|root: &Root| root.at);
            let first = times.fold(f64::INFINITY, f64::min);
            if first > 1.0 {
                break;
            }
            let time = window.time(first);
            let events = occurring_at(&found, polynomials, window.fraction(step.after(time)));
            if let Some(t) = self.just_behind(memory, step, (time, window), &found, events) {
                note_occurring(memory, &found, events);
                let still = stay_at_zero(memory, polynomials, [from, near], window.fraction(t));
                memory.arrive(step.after(t));
                memory.left = still.without(events);
                memory.note_zeros(events, t);
                return Some(Occurring { t, events });
            }
            // The polynomial has its zero before the function has: that is in what follows.
            for event in events.indices() {
                let root = found.get_mut(event).and_then(Option::take);
                if let (Some(root), Some(sign)) = (root, memory.signs.get_mut(event)) {
                    *sign = root.before;
                    late.insert(event);
                }
            }
        }
        arrive_at_end(memory, &window, polynomials, [from, near], late);
        None
    }

    /// The time of events, moved by rounding errors until no function is before its zero any more. Those of the polynomial may be larger than
    /// those of the function, where terms of it cancel: then the zero is one of the function. None if that is behind the window.
    fn just_behind<S, D, T>(
        &mut self,
        memory: &mut Memory<[f64; K]>,
        step: &mut LastStep<'_, S, D, T>,
        (time, window): (f64, Window<K>),
        found: &[Option<Root>; K],
        events: MetConditions,
    ) -> Option<f64>
    where
        S: SingleNumber,
        D: EventDynamics<S> + ?Sized,
        T: Advance<S, D>,
    {
        let roots = || {
            events
                .indices()
                .filter_map(|event| Some((event, found[event]?)))
        };
        let certain = roots().fold(0.0_f64, |part, (_, root)| part.max(root.until));
        let near = step.after(time);
        let farthest = window.time(certain);
        let farthest = if step.comes_before(farthest, near) {
            near
        } else {
            farthest
        };
        let mut is_before = |t: f64, step: &mut LastStep<'_, S, D, T>| {
            let sample = step.at(t);
            let values = self.values(step.dynamics(), t, &sample.x);
            memory.at_event = values;
            roots().any(|(event, root)| {
                root.before * root.behind < 0.0 && values[event] * root.before > 0.0
            })
        };
        let mut distance = f64::EPSILON * time.abs().max(f64::MIN_POSITIVE);
        let (mut before, mut there) = (time, time);
        while is_before(there, step) {
            if there - farthest == 0.0 {
                let is_last = !step.comes_before(farthest, window.end);
                return (!is_last).then_some(near);
            }
            before = there;
            there = time + distance.copysign(farthest - time);
            if !step.comes_before(there, farthest) {
                there = farthest;
            }
            distance *= 4.0;
        }
        if step.comes_before(near, there) {
            let mut bracket = Bracket::new(before, there);
            while let Some(middle) = bracket.divide((before, f64::NAN), (there, f64::NAN)) {
                let end = if is_before(middle, step) {
                    &mut before
                } else {
                    &mut there
                };
                *end = middle;
            }
            is_before(there, step);
        }
        Some(there)
    }
}

/// The events that occur together up to a part of the window.
fn occurring_at<const K: usize>(
    found: &[Option<Root>; K],
    polynomials: &[Polynomial; K],
    together: f64,
) -> MetConditions {
    let occurs = |(root, polynomial): (&Option<Root>, &Polynomial)| {
        root.is_some_and(|root| {
            // Behind a time within its rounding errors, a zero without a change of sign is not seen any more.
            let touches = root.before * root.behind > 0.0;
            root.at <= together || touches && polynomial.is_uncertain(together)
        })
    };
    MetConditions::of(found.iter().zip(polynomials).map(occurs))
}

/// Notes which of the events that were found occur, and the signs before the others.
fn note_occurring<const K: usize>(
    memory: &mut Memory<[f64; K]>,
    found: &[Option<Root>; K],
    events: MetConditions,
) {
    for (event, root) in found.iter().enumerate() {
        let occurring = root.filter(|_| events.contains(event));
        memory.ahead[event] = match occurring {
            Some(_) => 0.0,
            None => root.map_or(0.0, |root| root.before),
        };
        if let Some(root) = occurring {
            (memory.signs[event], memory.resume[event]) = (root.behind, root.until);
        }
    }
}

/// The events whose functions have not left zero up to a part of the window.
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

/// Notes the signs at the end of a window, behind its last event; those of the events that are late are known.
fn arrive_at_end<const K: usize>(
    memory: &mut Memory<[f64; K]>,
    window: &Window<K>,
    polynomials: &[Polynomial; K],
    [from, near]: [f64; 2],
    late: MetConditions,
) {
    let still = stay_at_zero(memory, polynomials, [from, near], 1.0);
    for (event, polynomial) in polynomials.iter().enumerate() {
        if late.contains(event) || still.contains(event) {
            continue;
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
