//! Steps in which the zeros of event functions are few, simple and isolated from each other.

use super::DeclaredEvents;
use crate::integrate::event::isolation::{Isolated, Isolation};
use crate::integrate::event::junction::rounding;
use crate::integrate::event::memory::Memory;
use crate::integrate::event::polynomial::Root;
use crate::integrate::event::simple_zero::SimpleZero;
use crate::integrate::event::window::Window;
use crate::integrate::event::{
    EventDynamics, EventFunctions, LastStep, MetConditions, Occurring, SingleNumber,
};
use crate::integrate::stepper::Advance;
use crate::limits::events::SIMPLIFIED_NEWTON_STEPS;

/// The next event in a step or in a part of it, or `None` if there are no more there.
type Next = Option<Occurring>;

/// A zero of the function of an event, alone in a part of a step.
#[derive(Clone, Copy)]
struct ZeroInPart {
    event: usize,
    zero: SimpleZero,
    /// The time of the end of the part.
    end: f64,
}

impl<const K: usize> DeclaredEvents<K> {
    /// Returns the next event in the rest of a step, if the zeros of the event functions are isolated in the step, anew for each
    /// event; `None` if what is left of the step has to be searched.
    pub(super) fn isolated<S, D, T>(
        &mut self,
        memory: &mut Memory<[f64; K]>,
        step: &mut LastStep<'_, S, D, T>,
    ) -> Option<Next>
    where
        S: SingleNumber,
        D: EventDynamics<S> + ?Sized,
        T: Advance<S, D>,
    {
        let has_failed = memory.not_isolated - step.begin() == 0.0;
        if has_failed || !memory.is_plain_at(memory.window) {
            return None;
        }
        let functions = self.functions_in(step)?;
        let (end, dynamics, last) = (step.end(), step.dynamics(), functions.last);
        let isolated = step.polynomial(Isolation(functions)).flatten();
        let isolated = isolated.filter(|isolated| self.agrees_in_middle(step, isolated));
        let Some(isolated) = isolated else {
            memory.not_isolated = step.begin();
            return None;
        };
        let window = Window {
            begin: step.begin(),
            end,
            corner: None,
            last,
            is_known: true,
        };
        // Functions of a scalar with other digits are searched.
        let has_digits_of_f64 = S::machine_epsilon() - f64::EPSILON == 0.0;
        let mut noise = None;
        loop {
            let from = window.fraction(memory.window);
            let signs = isolated.map(|function| function.sign_at(from));
            if !memory.agrees_with(&signs) {
                return None;
            }
            let [Some((event, zero)), second] = first_zeros(&isolated, from) else {
                return memory.keep_signs(signs, end).then_some(None);
            };
            if !has_digits_of_f64 {
                return None;
            }
            let [_, to] = step.ends()?;
            let noise = *noise.get_or_insert_with(|| rounding(self, dynamics, (end, to), &last));
            // The zero of a function that is not certain at the end of the step may be a rounding error.
            let is_certain = last[event].abs() > 2.0 * noise[event];
            let zero = is_certain.then(|| zero.with_noise(noise[event]))?;
            let end_of_part = match second {
                None => end,
                Some((other, second)) => {
                    let next = second.with_noise(noise[other]).from();
                    let until = zero.until();
                    (until < next).then(|| window.time(0.5 * (until + next)))?
                }
            };
            let part = ZeroInPart {
                event,
                zero,
                end: end_of_part,
            };
            let found = self.with_zero(memory, step, part, (&isolated, signs), window)?;
            if found.is_some() || second.is_none() {
                return Some(found);
            }
        }
    }

    /// Whether the functions agree with their polynomials in the middle of a step.
    fn agrees_in_middle<S, D, T>(
        &mut self,
        step: &mut LastStep<'_, S, D, T>,
        functions: &[Isolated; K],
    ) -> bool
    where
        S: SingleNumber,
        D: EventDynamics<S> + ?Sized,
        T: Advance<S, D>,
    {
        let middle = step.at(step.begin() + 0.5 * (step.end() - step.begin()));
        let values = self.values(step.dynamics(), middle.t, &middle.x);
        let mut pairs = values.iter().zip(functions);
        pairs.all(|(value, function)| (value - function.in_middle).abs() <= function.allowed)
    }

    /// Returns the event at a zero that is alone in its part of a step, before which the functions have these signs:
    /// `Some(None)` if it crosses in a direction that is not watched, and `None` if the part has to be searched.
    fn with_zero<S, D, T>(
        &mut self,
        memory: &mut Memory<[f64; K]>,
        step: &mut LastStep<'_, S, D, T>,
        part: ZeroInPart,
        (functions, mut signs): (&[Isolated; K], [f64; K]),
        window: Window<K>,
    ) -> Option<Next>
    where
        S: SingleNumber,
        D: EventDynamics<S> + ?Sized,
        T: Advance<S, D>,
    {
        let ZeroInPart { event, zero, end } = part;
        let before = signs[event];
        let (t, values) = self.located(step, (event, before), zero, window)?;
        // What follows within the resolution of time occurs together with the event.
        if step.comes_before(end, step.after(t)) {
            return None;
        }
        let agrees = |other: usize| {
            if other == event {
                values[other].abs() <= functions[other].allowed
            } else {
                values[other] * signs[other] > 0.0
            }
        };
        if !(0..K).all(agrees) {
            return None;
        }
        signs[event] = -before;
        memory.pass_zero(signs, event, (t, end));
        if !self.event(event).crossing().between(before, -before) {
            return Some(None);
        }
        memory.at_event = values;
        memory.until = step.after(t);
        let events = MetConditions::of((0..K).map(|other| other == event));
        Some(Some(Occurring { t, events }))
    }

    /// Returns the first time at which the function of an event has reached its zero, to rounding, and the values of all
    /// functions there; `None` if they contradict the polynomial.
    fn located<S, D, T>(
        &mut self,
        step: &mut LastStep<'_, S, D, T>,
        (event, before): (usize, f64),
        zero: SimpleZero,
        window: Window<K>,
    ) -> Option<(f64, [f64; K])>
    where
        S: SingleNumber,
        D: EventDynamics<S> + ?Sized,
        T: Advance<S, D>,
    {
        let mut evaluated = |this: &mut Self, t: f64| {
            let there = step.at(t);
            (t, this.values(step.dynamics(), t, &there.x))
        };
        let (mut at, mut found) = (zero.at, evaluated(self, window.time(zero.at)));
        // The polynomial lacks further terms, and its coefficients are rounded.
        let mut is_located = false;
        for _ in 0..SIMPLIFIED_NEWTON_STEPS {
            at += before * found.1[event] / zero.slope;
            if at.is_nan() || (at - zero.at).abs() > zero.until() - zero.at {
                return None;
            }
            at = at.clamp(0.0, 1.0);
            let time = window.time(at);
            if time - found.0 != 0.0 {
                found = evaluated(self, time);
            }
            let steps = found.0 / (window.end - window.begin);
            is_located = zero.is_rounding_error(found.1[event], steps);
            if is_located {
                break;
            }
        }
        if !is_located {
            return None;
        }
        if before * found.1[event] > 0.0 {
            let root = Root {
                at,
                before,
                behind: -before,
                until: zero.until(),
            };
            let t = self.time_of(event, root, step, window)?;
            let there = step.at(t);
            found = (t, self.values(step.dynamics(), t, &there.x));
        }
        Some(found)
    }
}

/// Returns the first two zeros of event functions behind a fraction of a step, with their events.
fn first_zeros<const K: usize>(
    functions: &[Isolated; K],
    from: f64,
) -> [Option<(usize, SimpleZero)>; 2] {
    let mut first = [None::<(usize, SimpleZero)>; 2];
    for (event, function) in functions.iter().enumerate() {
        for zero in function.zeros_behind(from).take(2) {
            let is_before = |other: &Option<(usize, SimpleZero)>| {
                other.is_none_or(|(_, other)| zero.at < other.at)
            };
            if is_before(&first[0]) {
                first = [Some((event, zero)), first[0]];
            } else if is_before(&first[1]) {
                first[1] = Some((event, zero));
            }
        }
    }
    first
}
