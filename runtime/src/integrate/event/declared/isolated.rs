//! Steps in which at most one event function has a zero, a simple one.

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

/// What is known of the events in a step: the next one, or `None` if there are no more.
type Known = Option<Occurring>;

impl<const K: usize> DeclaredEvents<K> {
    /// Returns what is known of the events in a step that has not been searched yet, if it has at most one zero of an event
    /// function; `None` if the step has to be searched.
    pub(super) fn isolated<S, D, T>(
        &mut self,
        memory: &mut Memory<[f64; K]>,
        step: &mut LastStep<'_, S, D, T>,
    ) -> Option<Known>
    where
        S: SingleNumber,
        D: EventDynamics<S> + ?Sized,
        T: Advance<S, D>,
    {
        if !memory.is_plain_at(step.begin()) {
            return None;
        }
        let functions = self.functions_in(step)?;
        let (end, dynamics, last) = (step.end(), step.dynamics(), functions.last);
        let found = step.polynomial(Isolation(functions))??;
        let signs = found.map(|function| function.sign);
        if !memory.agrees_with(&signs) || !self.agrees_in_middle(step, &found) {
            return None;
        }
        let mut zeros = (0..K).filter_map(|event| Some((event, found[event].zero?)));
        match (zeros.next(), zeros.next()) {
            (None, _) => memory.keep_signs(signs, end).then_some(None),
            // The zero of a function that is not certain at the end of the step may be a rounding error. Functions of a scalar
            // with other digits are searched.
            (Some((event, zero)), None) if S::machine_epsilon() - f64::EPSILON == 0.0 => {
                let [_, to] = step.ends()?;
                let noise = rounding(self, dynamics, (end, to), &last)[event];
                let is_certain = last[event].abs() > 2.0 * noise;
                let zero = is_certain.then(|| zero.with_noise(noise))?;
                self.with_zero(memory, step, (event, zero), (&found, last))
            }
            _ => None,
        }
    }

    /// Whether the functions agree with their polynomials in the middle of a step.
    fn agrees_in_middle<S, D, T>(
        &mut self,
        step: &mut LastStep<'_, S, D, T>,
        isolated: &[Isolated; K],
    ) -> bool
    where
        S: SingleNumber,
        D: EventDynamics<S> + ?Sized,
        T: Advance<S, D>,
    {
        let middle = step.at(step.begin() + 0.5 * (step.end() - step.begin()));
        let values = self.values(step.dynamics(), middle.t, &middle.x);
        let mut pairs = values.iter().zip(isolated);
        pairs.all(|(value, function)| (value - function.in_middle).abs() <= function.allowed)
    }

    /// Returns what is known of a step with one zero, of the function of this event.
    fn with_zero<S, D, T>(
        &mut self,
        memory: &mut Memory<[f64; K]>,
        step: &mut LastStep<'_, S, D, T>,
        (event, zero): (usize, SimpleZero),
        (isolated, last): (&[Isolated; K], [f64; K]),
    ) -> Option<Known>
    where
        S: SingleNumber,
        D: EventDynamics<S> + ?Sized,
        T: Advance<S, D>,
    {
        let before = isolated[event].sign;
        let (t, values) = self.located(step, (event, before), zero, last)?;
        let agrees = |other: usize| {
            let (value, function) = (values[other], &isolated[other]);
            if other == event {
                value.abs() <= function.allowed
            } else {
                value * function.sign > 0.0
            }
        };
        if !(0..K).all(agrees) {
            return None;
        }
        let mut signs = isolated.map(|function| function.sign);
        signs[event] = -before;
        memory.pass_zero(signs, event, (t, step.end()));
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
        last: [f64; K],
    ) -> Option<(f64, [f64; K])>
    where
        S: SingleNumber,
        D: EventDynamics<S> + ?Sized,
        T: Advance<S, D>,
    {
        let window = Window {
            begin: step.begin(),
            end: step.end(),
            corner: None,
            last,
            is_known: true,
        };
        let mut evaluated = |this: &mut Self, t: f64| {
            let there = step.at(t);
            (t, this.values(step.dynamics(), t, &there.x))
        };
        let (mut at, mut found) = (zero.at, evaluated(self, window.time(zero.at)));
        // The polynomial lacks further terms, and its coefficients are rounded.
        let mut is_located = false;
        for _ in 0..SIMPLIFIED_NEWTON_STEPS {
            at += before * found.1[event] / zero.slope;
            if at.is_nan() || (at - zero.at).abs() > zero.until - zero.at {
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
                until: zero.until,
            };
            let t = self.time_of(event, root, step, window)?;
            let there = step.at(t);
            found = (t, self.values(step.dynamics(), t, &there.x));
        }
        Some(found)
    }
}
