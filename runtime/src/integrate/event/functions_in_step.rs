//! The watched event functions in a step of the Taylor method.

use super::declared_event::DeclaredEvents;
use super::event_dynamics::{EventDynamics, SingleNumber};
use super::terms::Terms;
use crate::integrate::bernstein::as_number;
use crate::integrate::taylor::TaylorCoefficients;

/// The watched event functions in a step.
pub(super) struct FunctionsInStep<'a, D: ?Sized, X, const K: usize> {
    pub(super) events: &'a DeclaredEvents<K>,
    pub(super) dynamics: &'a D,
    /// The state at the beginning of the step.
    pub(super) from: &'a X,
    /// The time of the end of the step.
    pub(super) end: f64,
    /// The values at the end of the step.
    pub(super) last: [f64; K],
}

impl<X, D: ?Sized, const K: usize> FunctionsInStep<'_, D, X, K> {
    /// Returns what `examine` finds from the terms of each function, up to the order 2·`HALF`, and from its value at the end of
    /// the step. `None` if it finds nothing for one of them, or if one of the functions at whose zeros they have corners may
    /// have a zero: its enclosure has to keep the part `kept` of its first term away from zero.
    pub(super) fn examined<S, R, const HALF: usize, const OF_MOTION: usize>(
        &self,
        (t, unit): (f64, f64),
        motion: &TaylorCoefficients<X, OF_MOTION>,
        kept: f64,
        examine: impl Fn(&Terms<f64, HALF>, f64) -> Option<R>,
    ) -> Option<[R; K]>
    where
        S: SingleNumber,
        D: EventDynamics<S, State = X>,
        R: Copy + Default,
    {
        let [begin, unit_of_time] = [t, unit].map(S::from_f64);
        let series: TaylorCoefficients<_, HALF> =
            (self.dynamics).event_series(begin, self.from, unit_of_time, motion)?;
        let length = (self.end - t) / unit;
        let accuracy = (S::machine_epsilon(), as_number(1 + 2 * OF_MOTION));
        let terms = |index: usize| {
            series.initial().as_ref().get(index)?;
            let number =
                |values: &D::Values| values.as_ref().get(index).map(|value| value.smallest());
            let numbers = series.map(|values| number(values).unwrap_or(f64::NAN));
            Some(Terms::new(&numbers, length, accuracy))
        };
        let mut found = [R::default(); K];
        let watched = self.events.events.iter().zip(self.last);
        for (found, ((index, _), last)) in found.iter_mut().zip(watched) {
            *found = examine(&terms(*index)?, last)?;
            for branch in self.dynamics.branches(*index) {
                terms(*branch)?.sign(kept)?;
            }
        }
        Some(found)
    }
}
