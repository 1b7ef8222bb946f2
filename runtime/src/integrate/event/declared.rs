//! Events that the dynamics declare.
//!
//! Where a step is a Taylor polynomial, the series of an event function is one, too, and no root of it is missed. By other
//! methods the functions are sampled.

use super::detection::Detection;
use super::memory::Memory;
use super::polynomial::{Polynomial, Root};
use super::{
    Crossing, Event, EventDynamics, LastStep, MetConditions, Occurring, SingleNumber, sampling,
};
use crate::integrate::sample::Sample;
use crate::integrate::step_polynomial::StepPolynomial;
use crate::integrate::stepper::Advance;
use crate::integrate::taylor::TaylorCoefficients;
use crate::limits::events::{LEAST_WINDOW, MOST_COEFFICIENTS, UNCERTAINTY};
use crate::scalar::{DoubleDouble, Scalar};

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

impl<S, D, const K: usize> Detection<S, D> for DeclaredEvents<K>
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

impl<const K: usize> DeclaredEvents<K> {
    /// The window that begins at a time, with the polynomials of the event functions; none if they have no series.
    ///
    /// A series does not see corners, as those of |x| and max(x, y): where the polynomials are not the functions in the
    /// middle and at the end of the window, it is shortened, down to a small part of the step.
    fn window<S, D, T>(
        &mut self,
        begin: f64,
        step: &mut LastStep<'_, S, D, T>,
    ) -> Option<(Window, [Polynomial; K])>
    where
        S: SingleNumber,
        D: EventDynamics<S> + ?Sized,
        T: Advance<S, D>,
    {
        let from = step.at(begin);
        let least = LEAST_WINDOW * (step.end() - step.begin()).abs();
        let mut end = step.end();
        loop {
            let search = Search {
                events: self,
                dynamics: step.dynamics(),
                from: &from,
                end,
            };
            let (polynomials, end_of_window) = step.polynomial(search)??;
            end = end_of_window;
            let mut agree = true;
            for part in [0.5, 1.0] {
                let sample = step.at(begin + (end - begin) * part);
                let values = self.values(step.dynamics(), sample.t, &sample.x);
                let mut pairs = values.iter().zip(&polynomials);
                agree &= pairs
                    // Where a function is not a number, or there is no such event, nothing is compared.
                    .all(|(value, polynomial)| value.is_nan() || polynomial.is_near(part, *value));
            }
            if agree || (end - begin).abs() <= least {
                return Some((Window { begin, end }, polynomials));
            }
            end = begin + 0.25 * (end - begin);
        }
    }

    /// The next events at roots of these polynomials of the fraction of the step.
    fn next_roots<S, D, T>(
        &mut self,
        memory: &mut Memory<[f64; K]>,
        step: &mut LastStep<'_, S, D, T>,
        window: Window,
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
            found[event] = self.first_of(event, polynomial, memory, from, near);
        }
        let times = found.iter().flatten().map(|root: &Root| root.at);
        let first = times.fold(f64::INFINITY, f64::min);
        if first > 1.0 {
            for (sign, polynomial) in memory.signs.iter_mut().zip(polynomials) {
                *sign = polynomial.last_sign(from, *sign);
            }
            memory.arrive(window.end);
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
        Some(Occurring {
            t: self.just_behind(memory, step, time, &found, events),
            events,
        })
    }

    /// The first root of an event's polynomial that is one of its event.
    fn first_of(
        &self,
        event: usize,
        polynomial: &Polynomial,
        memory: &Memory<[f64; K]>,
        from: f64,
        near: f64,
    ) -> Option<Root> {
        let crossing = self.event(event).crossing();
        let is_at_start = from <= 0.0 && memory.is_leaving;
        let deflated = is_at_start && memory.at_zero.contains(event);
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
        if from <= 0.0 && !memory.is_leaving {
            // The last step may have ended before a root that is now behind, to rounding.
            let before = memory.signs[event];
            let behind = polynomial.sign_behind(from, next);
            let returns = next.is_some_and(|root| root.at <= near && root.behind * before > 0.0);
            if returns {
                next = next.and_then(|root| polynomial.next_root(root.until, root.behind));
            } else if crossing.between(before, behind) && behind != 0.0 {
                return Some(Root {
                    at: 0.0,
                    before,
                    behind,
                    until: 0.0,
                });
            }
        }
        for _ in 0..MOST_COEFFICIENTS {
            let root = next?;
            // A zero at the initial time is no crossing, whatever rounding makes of it.
            let is_initial =
                is_at_start && !deflated && root.at <= near && crossing == Crossing::Either;
            let behind = if root.before * root.behind < 0.0 {
                root.behind
            } else {
                0.0
            };
            if crossing.between(root.before, behind) && !is_initial {
                return Some(root);
            }
            next = polynomial.next_root(root.until, root.behind);
        }
        None
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

/// A part of a step, over which the series of the event functions converge.
#[derive(Clone, Copy)]
struct Window {
    begin: f64,
    end: f64,
}

impl Window {
    /// The part of it up to a time.
    fn fraction(self, t: f64) -> f64 {
        (t - self.begin) / (self.end - self.begin)
    }

    /// The first number that is not before a part of it.
    fn time(self, fraction: f64) -> f64 {
        if fraction >= 1.0 {
            return self.end;
        }
        let time = self.begin + fraction * (self.end - self.begin);
        if self.fraction(time) >= fraction {
            time
        } else if self.end >= self.begin {
            time.next_up()
        } else {
            time.next_down()
        }
    }
}

/// Makes the polynomials of event functions in a window from the polynomial of a step.
struct Search<'a, D: ?Sized, X, const K: usize> {
    events: &'a DeclaredEvents<K>,
    dynamics: &'a D,
    /// Where the window begins.
    from: &'a Sample<X>,
    /// Where it ends at the latest.
    end: f64,
}

impl<S, D, const K: usize> StepPolynomial<S, D::State> for Search<'_, D, D::State, K>
where
    S: SingleNumber,
    D: EventDynamics<S> + ?Sized,
{
    /// The polynomials, and where the window ends.
    type Output = Option<([Polynomial; K], f64)>;

    /// The series of an event function may converge more slowly than that of the motion, for which the step was chosen.
    /// Then the window is shorter than the step: its last two terms are rounding errors there, or as small in relation to
    /// the others as those of the motion are in the step.
    fn visit<const HALF: usize>(
        self,
        t: f64,
        unit: f64,
        motion: &TaylorCoefficients<D::State, HALF>,
    ) -> Self::Output {
        let Sample { t: begin, x } = self.from;
        let offset = (begin - t) / unit;
        let shifted = (offset != 0.0).then(|| motion.shifted(S::from_f64(offset)));
        let motion = shifted.as_ref().unwrap_or(motion);
        let (time, unit_of_time) = (S::from_f64(*begin), S::from_f64(unit));
        let series = (self.dynamics).event_series(time, x, unit_of_time, motion)?;
        let epsilon = S::machine_epsilon();
        let step = (self.end - begin) / unit;
        let allowed = (UNCERTAINTY * epsilon).max(motion.last_terms(step));
        let mut part = 1.0;
        loop {
            let ratio = DoubleDouble::from(step) * DoubleDouble::from(part);
            let mut converge = true;
            let mut polynomials = [Polynomial::ZERO; K];
            for (polynomial, (index, _)) in polynomials.iter_mut().zip(self.events.events) {
                let values = core::iter::once(series.initial()).chain(series.higher());
                let mut power = DoubleDouble::from(1.0);
                let coefficients = values.map(|values| {
                    let value = values.as_ref().get(index).copied().unwrap_or(S::zero());
                    let coefficient = double_double(value) * power;
                    power *= ratio;
                    coefficient
                });
                *polynomial = Polynomial::new(coefficients, epsilon)?;
                converge &= polynomial.last_terms() <= allowed;
            }
            if converge || part <= LEAST_WINDOW {
                let end = if part < 1.0 {
                    begin + (self.end - begin) * part
                } else {
                    self.end
                };
                return Some((polynomials, end));
            }
            part *= 0.5;
        }
    }
}

/// A number with its digits beyond those of `f64`.
fn double_double<S: Scalar>(value: S) -> DoubleDouble {
    let high = value.smallest();
    let low = (value - S::from_f64(high)).smallest();
    DoubleDouble::new(high, if low.is_finite() { low } else { 0.0 })
}
