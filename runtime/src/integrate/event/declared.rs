//! Events that the dynamics declare.
//!
//! Where a step is a Taylor polynomial, the series of an event function is one, too, and no root of it is missed. By other
//! methods the functions are sampled.

use core::ops::ControlFlow;

use super::detection::{Detection, EventFunctions, detection_by_functions};
use super::exclusion::Exclusion;
use super::junction::rounding;
use super::memory::Memory;
use super::polynomial::{Polynomial, Root};
use super::window::{Search, Window};
use super::{Event, EventDynamics, LastStep, MetConditions, Occurring, SingleNumber, sampling};
use crate::integrate::error::IntegrationError;
use crate::integrate::stepper::Advance;
use crate::limits::events::{LEAST_WINDOW, MOST_COEFFICIENTS};

/// Some of the events that the dynamics declare, by their indices, and what is watched for; made by
/// [`Driver::declared_events`](crate::Driver::declared_events).
#[derive(Clone, Copy, Debug)]
pub struct DeclaredEvents<const K: usize> {
    pub(crate) events: [(usize, Event); K],
    /// The parts of a step at whose ends the functions are evaluated, if it is set.
    pub(crate) parts: Option<u32>,
}

impl<const K: usize> DeclaredEvents<K> {
    fn event(&self, index: usize) -> Event {
        let event = self.events.get(index);
        event.map_or(Event::either(), |(_, event)| *event)
    }
}

impl<S, D, const K: usize> EventFunctions<S, D> for DeclaredEvents<K>
where
    S: SingleNumber,
    D: EventDynamics<S> + ?Sized,
{
    type Values = [f64; K];

    fn values(&mut self, dynamics: &D, t: f64, x: &D::State) -> [f64; K] {
        let values = dynamics.event_functions(S::from_f64(t), x);
        let value = |index: usize| values.as_ref().get(index).map(|value| value.smallest());
        self.events
            .map(|(index, _)| value(index).unwrap_or(f64::NAN))
    }

    fn function(&mut self, dynamics: &D, t: S, x: &D::State, event: usize) -> Option<S> {
        let (index, _) = self.events.get(event)?;
        dynamics.event_functions(t, x).as_ref().get(*index).copied()
    }

    fn check(&self, dynamics: &D) -> Result<(), IntegrationError> {
        let events = dynamics.names();
        let mut watched = self.events.iter().map(|(index, _)| *index);
        match watched.find(|index| *index >= events.len()) {
            Some(index) => Err(IntegrationError::NoSuchEvent { index, events }),
            None => Ok(()),
        }
    }

    fn event(&self, index: usize) -> Event {
        Self::event(self, index)
    }

    fn parts(&self) -> Option<u32> {
        self.parts
    }

    fn next<T: Advance<S, D>>(
        &mut self,
        memory: &mut Memory<[f64; K]>,
        step: &mut LastStep<'_, S, D, T>,
    ) -> Option<Occurring> {
        while step.comes_before(memory.until, step.end()) {
            if step.comes_before(memory.window, step.begin()) {
                memory.window = step.begin();
                (memory.resume, memory.ahead) = ([0.0; K], [0.0; K]);
            }
            if self.excludes_events(memory, step) {
                return None;
            }
            let Some((window, polynomials)) = self.window(memory.window, step) else {
                return sampling::next(self, memory, step);
            };
            let found = self.next_roots(memory, step, window, &polynomials);
            if found.is_some() {
                return found;
            }
        }
        None
    }
}

impl<S, D, const K: usize> Detection<S, D> for DeclaredEvents<K>
where
    S: SingleNumber,
    D: EventDynamics<S> + ?Sized,
{
    detection_by_functions!(S, D);
}

impl<const K: usize> DeclaredEvents<K> {
    /// Whether none of the events can occur in a step, of which nothing was looked at yet. Then that is all of it.
    fn excludes_events<S, D, T>(
        &mut self,
        memory: &mut Memory<[f64; K]>,
        step: &mut LastStep<'_, S, D, T>,
    ) -> bool
    where
        S: SingleNumber,
        D: EventDynamics<S> + ?Sized,
        T: Advance<S, D>,
    {
        let (begin, end) = (step.begin(), step.end());
        let is_special = memory.touching.or(memory.left).or(memory.at_zero).any();
        if is_special || memory.until - begin != 0.0 || memory.window - begin != 0.0 {
            return false;
        }
        let Some(signs) = self
            .excluded(step, false)
            .or_else(|| self.excluded(step, true))
        else {
            return false;
        };
        // A sign that differs from that before the step changes where it begins.
        let mut pairs = signs.iter().zip(&memory.signs);
        if pairs.any(|(sign, before)| sign * before < 0.0 || before.is_nan()) {
            return false;
        }
        memory.signs = signs;
        memory.window = end;
        memory.arrive(end);
        true
    }

    /// The signs of the functions in a step without zeros, by a few terms of their series or by all.
    fn excluded<S, D, T>(
        &mut self,
        step: &mut LastStep<'_, S, D, T>,
        by_all_terms: bool,
    ) -> Option<[f64; K]>
    where
        S: SingleNumber,
        D: EventDynamics<S> + ?Sized,
        T: Advance<S, D>,
    {
        let (begin, end, dynamics) = (step.begin(), step.end(), step.dynamics());
        // Without them there is no polynomial either, and no reason to interpolate.
        step.ends()?;
        let middle = by_all_terms.then(|| {
            let middle = step.at(begin + 0.5 * (end - begin));
            self.values(dynamics, middle.t, &middle.x)
        });
        let [from, to] = step.ends()?;
        let last = self.values(dynamics, end, to);
        let exclusion = Exclusion {
            events: self,
            dynamics,
            from,
            end,
            last,
            middle,
        };
        step.polynomial(exclusion).flatten()
    }

    /// The window that begins at a time, with the polynomials of the event functions; none if they have no series.
    ///
    /// A series does not see corners, as those of |x| and max(x, y). Where dynamics tell at which zeros there are some, the
    /// window ends behind the first one. Of external functions nothing is told: where the polynomials are not the functions
    /// in the middle and at the end of the window, it is shortened, down to a small part of the step.
    fn window<S, D, T>(
        &mut self,
        begin: f64,
        step: &mut LastStep<'_, S, D, T>,
    ) -> Option<(Window<K>, [Polynomial; K])>
    where
        S: SingleNumber,
        D: EventDynamics<S> + ?Sized,
        T: Advance<S, D>,
    {
        // A window that is shorter than the resolution of time might not advance it.
        let least = LEAST_WINDOW * (step.end() - step.begin()).abs();
        let least = least.max(step.resolution(begin));
        let (mut begin, mut end) = (begin, step.end());
        let mut shift = step.resolution(begin).copysign(end - begin);
        let mut from = step.at(begin);
        loop {
            let resolution = step.resolution(begin);
            let search = Search {
                events: self,
                dynamics: step.dynamics(),
                from: &from,
                end,
                least,
                resolution,
            };
            let expansion = step.polynomial(search)??;
            if expansion.is_at_corner && step.comes_before(begin + shift, end) {
                // Which branch follows is not certain yet.
                begin += shift;
                shift *= 4.0;
                from = step.at(begin);
                continue;
            }
            end = expansion.end;
            let mut polynomials = expansion.polynomials;
            let mut last = [0.0; K];
            let mut agree = true;
            for part in [0.0, 0.5, 1.0] {
                let sample = step.at(begin + (end - begin) * part);
                last = self.values(step.dynamics(), sample.t, &sample.x);
                let noise = rounding(self, step.dynamics(), (sample.t, &sample.x), &last);
                for (polynomial, noise) in polynomials.iter_mut().zip(noise) {
                    polynomial.shift_by(noise);
                }
                let mut pairs = last.iter().zip(&polynomials);
                agree &= pairs
                    // Where a function is not a number, or there is no such event, nothing is compared.
                    .all(|(value, polynomial)| value.is_nan() || polynomial.is_near(part, *value));
            }
            if agree || (end - begin).abs() <= least {
                let window = Window {
                    begin,
                    end,
                    corner: expansion.corner,
                    last,
                    is_known: agree,
                };
                return Some((window, polynomials));
            }
            end = begin + 0.25 * (end - begin);
        }
    }

    /// The next events at roots of these polynomials of the fraction of the step.
    fn next_roots<S, D, T>(
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
        let times = found.iter().flatten().map(|root: &Root| root.at);
        let first = times.fold(f64::INFINITY, f64::min);
        if first > 1.0 {
            for (event, polynomial) in polynomials.iter().enumerate() {
                let known = (from, memory.resume[event]);
                memory.signs[event] = window.last_sign(polynomial, known, memory.signs[event]);
            }
            let touches = |(polynomial, resume): (&Polynomial, f64)| {
                resume < 1.0 && polynomial.is_uncertain(1.0)
            };
            let touching = polynomials.iter().zip(memory.resume).map(touches);
            let touching = MetConditions::of(touching);
            let departs =
                |(polynomial, sign): (&Polynomial, f64)| polynomial.slope(1.0) * sign > 0.0;
            let departing = MetConditions::of(polynomials.iter().zip(memory.signs).map(departs));
            memory.arrive(window.end);
            (memory.touching, memory.departing) = (touching, departing.and(touching));
            (memory.resume, memory.ahead) = ([0.0; K], [0.0; K]);
            memory.window = window.end;
            return None;
        }
        let time = window.time(first);
        let together = window.fraction(step.after(time));
        let occurs = |(root, polynomial): (&Option<Root>, &Polynomial)| {
            root.is_some_and(|root| {
                // Behind a time within its rounding errors, a zero without a change of sign is not seen any more.
                let touches = root.before * root.behind > 0.0;
                root.at <= together || touches && polynomial.is_uncertain(together)
            })
        };
        let events = MetConditions::of(found.iter().zip(polynomials).map(occurs));
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
        memory.arrive(step.after(time));
        let t = self.just_behind(memory, step, time, &found, events);
        memory.note_zeros(events, t);
        Some(Occurring { t, events })
    }

    /// The first root of an event's polynomial that is one of its event.
    fn first_of(
        &self,
        event: usize,
        polynomial: &Polynomial,
        memory: &Memory<[f64; K]>,
        (window, from, near): (Window<K>, f64, f64),
    ) -> Option<Root> {
        let crossing = self.event(event).crossing();
        let is_left = from <= 0.0 && memory.left.contains(event);
        let deflated = is_left || from <= 0.0 && memory.at_zero.contains(event);
        let polynomial = if deflated {
            polynomial.over_argument()
        } else {
            *polynomial
        };
        let sign = if memory.resume[event] > from {
            memory.signs[event]
        } else if from > 0.0 {
            memory.ahead[event]
        } else {
            0.0
        };
        let mut next = polynomial.next_root(from.max(memory.resume[event]), sign);
        if from <= 0.0 && !deflated {
            next = match self.at_last_end(event, &polynomial, memory, (from, near, next)) {
                ControlFlow::Continue(next) => next,
                ControlFlow::Break(root) => return Some(root),
            };
        }
        for _ in 0..MOST_COEFFICIENTS {
            let root = window.behind(event, next?);
            // The zero that is left is no crossing, whatever rounding makes of it.
            let is_initial = is_left && root.at <= near;
            let behind = if root.before * root.behind < 0.0 {
                root.behind
            } else {
                0.0
            };
            let is_one = window.is_known || behind != 0.0;
            if is_one && crossing.between(root.before, behind) && !is_initial {
                return Some(root);
            }
            next = polynomial.next_root(root.until, root.behind);
        }
        None
    }

    /// An event at the beginning of a step: the last step may have ended before a root that is now behind, to rounding, or at a
    /// zero, whether or not the sign changes there. Otherwise the next root that is not the last one again.
    fn at_last_end(
        &self,
        event: usize,
        polynomial: &Polynomial,
        memory: &Memory<[f64; K]>,
        (from, near, next): (f64, f64, Option<Root>),
    ) -> ControlFlow<Root, Option<Root>> {
        let crossing = self.event(event).crossing();
        let before = memory.signs[event];
        let behind = polynomial.sign_behind(from, next);
        let touches = memory.touching.contains(event)
            && before * behind > 0.0
            && crossing.between(before, 0.0);
        let returns = next.filter(|root| {
            root.at <= near && root.behind * before > 0.0 && root.before * root.behind < 0.0
        });
        let crosses = crossing.between(before, behind) && behind != 0.0;
        match returns {
            Some(root) if !touches => {
                ControlFlow::Continue(polynomial.next_root(root.until, root.behind))
            }
            _ if touches || crosses => ControlFlow::Break(Root {
                at: 0.0,
                before,
                behind,
                until: 0.0,
            }),
            _ => ControlFlow::Continue(next),
        }
    }

    /// The time of an event, moved by rounding errors until its function is not before the zero any more.
    fn just_behind<S, D, T>(
        &mut self,
        memory: &mut Memory<[f64; K]>,
        step: &mut LastStep<'_, S, D, T>,
        time: f64,
        found: &[Option<Root>; K],
        events: MetConditions,
    ) -> f64
    where
        S: SingleNumber,
        D: EventDynamics<S> + ?Sized,
        T: Advance<S, D>,
    {
        let last = step.after(time);
        let mut distance = f64::EPSILON * time.abs().max(f64::MIN_POSITIVE);
        let mut there = time;
        while step.comes_before(there, last) {
            let sample = step.at(there);
            let values = self.values(step.dynamics(), there, &sample.x);
            let is_before = |event: usize| {
                let root = found.get(event).copied().flatten();
                root.is_some_and(|root| {
                    root.before * root.behind < 0.0 && values[event] * root.before > 0.0
                })
            };
            if !events.indices().any(is_before) {
                memory.at_event = values;
                return there;
            }
            there = time + distance.copysign(last - time);
            distance *= 4.0;
        }
        let sample = step.at(last);
        memory.at_event = self.values(step.dynamics(), last, &sample.x);
        last
    }
}
