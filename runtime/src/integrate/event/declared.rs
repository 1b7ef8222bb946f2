//! Events that the dynamics declare.
//!
//! If a step is a Taylor polynomial, the series of an event function is a polynomial, too, and none of its roots is
//! missed. For other methods the functions are sampled.

mod first_root;
mod isolated;
mod next_roots;
#[cfg(test)]
mod tests;

use super::declared_event::DeclaredEvents;
use super::event_functions::{EventFunctions, detection_by_functions};
use super::exclusion::Exclusion;
use super::functions_in_step::FunctionsInStep;
use super::junction::rounding;
use super::memory::Memory;
use super::polynomial::Polynomial;
use super::window::{Search, Window};
use super::{
    Detection, Event, EventDynamics, LastStep, MetConditions, Occurring, OneSigned, SingleNumber,
    sampling,
};
use crate::integrate::error::IntegrationError;
use crate::integrate::stepper::Advance;
use crate::limits::events::MIN_WINDOW;

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
            if !step.comes_before(memory.window, step.end()) {
                // No event is left in the step.
                memory.arrive(step.end());
                return None;
            }
            if step.comes_before(memory.until, memory.window) {
                // No event is left up to the window.
                memory.arrive(memory.window);
            }
            if self.excludes_events(memory, step) {
                return None;
            }
            if let Some(known) = self.isolated(memory, step) {
                return known;
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

    fn declared(&self, event: usize) -> Option<usize> {
        self.events.get(event).map(|(index, _)| *index)
    }

    fn watched_functions(&self, dynamics: &D) -> MetConditions {
        let mut watched = MetConditions::default();
        for (index, _) in self.events {
            watched.insert(index);
            for branch in dynamics.branches(index) {
                watched.insert(*branch);
            }
        }
        watched
    }

    #[inline]
    fn passes_over(
        &mut self,
        memory: &mut Memory<[f64; K]>,
        dynamics: &D,
        [begin, end]: [f64; 2],
        one_signed: OneSigned,
    ) -> bool {
        let mut signs = [0.0; K];
        for (sign, (index, _)) in signs.iter_mut().zip(&self.events) {
            let Some(of_event) = one_signed.sign(*index) else {
                if one_signed.may_have_zero(*index) {
                    memory.not_excluded = begin;
                }
                return false;
            };
            let mut branches = dynamics.branches(*index).iter();
            if branches.any(|branch| one_signed.sign(*branch).is_none()) {
                return false;
            }
            *sign = of_event;
        }
        memory.is_plain_at(begin) && memory.keep_signs(signs, end)
    }
}

impl<const K: usize> DeclaredEvents<K> {
    /// Whether the first terms exclude all events from a step that has not been searched yet. If so, the whole step is done.
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
        let begin = step.begin();
        if !memory.is_plain_at(begin) || memory.not_excluded - begin == 0.0 {
            return false;
        }
        let functions = self.functions_in(step);
        let signs = functions.and_then(|functions| step.polynomial(Exclusion(functions))?);
        signs.is_some_and(|signs| memory.keep_signs(signs, step.end()))
    }

    /// Returns the functions in a step; `None` if its ends are not known, since there is no polynomial then.
    fn functions_in<'a, S, D, T>(
        &'a mut self,
        step: &'a LastStep<'_, S, D, T>,
    ) -> Option<FunctionsInStep<'a, D, D::State, K>>
    where
        S: SingleNumber,
        D: EventDynamics<S> + ?Sized,
        T: Advance<S, D>,
    {
        let [from, to] = step.ends()?;
        let (end, dynamics) = (step.end(), step.dynamics());
        let last = self.values(dynamics, end, to);
        Some(FunctionsInStep {
            events: self,
            dynamics,
            from,
            end,
            last,
        })
    }

    /// Returns the window that begins at a time, with the polynomials of the event functions; `None` if they have no
    /// series.
    ///
    /// A series does not represent corners, such as those of |x| and max(x, y). If the dynamics tell at which zeros
    /// corners are, the window ends just after the first one. Corners of external functions are not known: if the
    /// polynomials disagree with the functions in the middle or at the end of the window, it is shortened, down to a
    /// small part of the step.
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
        // Without the ends there is no polynomial, and no reason to interpolate.
        step.ends()?;
        // A window that is shorter than the resolution of time might not advance it.
        let least = MIN_WINDOW * (step.end() - step.begin()).abs();
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
                // It is not yet certain which branch follows.
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
                    // A function that is not a number, or an event that does not exist, is not compared.
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
}
