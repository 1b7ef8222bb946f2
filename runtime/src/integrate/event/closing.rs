//! The events that a run reports at its end.

use super::junction::Junction;
use super::memory::{Memory, has_sign};
use super::met_conditions::MetConditions;
use super::sides::Sides;
use super::values::Values;
use super::{EventFunctions, LastStep, Occurring};
use crate::integrate::at::At;
use crate::integrate::dynamics::Dynamics;
use crate::integrate::stepper::Advance;
use crate::limits::events::BETWEEN;
use crate::scalar::Scalar;

/// The event functions at the end of a run.
struct Ending<V> {
    t: f64,
    junction: Junction<V>,
    /// The signs of the functions on both sides of the end, if one of them is needed.
    sides: Option<Sides<V>>,
}

impl<V: Values> Ending<V> {
    /// Returns the value at the end of a function that moves away from zero there; `None` if it approaches zero.
    fn departing(&self, event: usize) -> Option<f64> {
        let value = self.junction.value(event);
        let departs = |sides: &Sides<V>| sides.departs(event, value);
        self.sides.as_ref().is_some_and(departs).then_some(value)
    }

    /// Selects, from the events found within the last step beyond the end, those that rounding does not distinguish
    /// from the end.
    fn pending<S, D, G, T>(
        &self,
        source: &mut G,
        step: &mut LastStep<'_, S, D, T>,
        pending: Occurring,
    ) -> MetConditions
    where
        S: Scalar,
        D: Dynamics<S> + ?Sized,
        G: EventFunctions<S, D, Values = V>,
        T: Advance<S, D>,
    {
        let is_next = !step.comes_before(step.after(self.t), pending.t);
        let behind = is_next.then(|| {
            let there = step.at(pending.t);
            source.values(step.dynamics(), there.t, &there.x)
        });
        let mut events = MetConditions::default();
        for event in pending.events.indices() {
            let behind = behind.and_then(|behind| behind.as_slice().get(event).copied());
            let crosses = |sides: &Sides<V>| sides.before_crossing(event).is_some();
            let is_passed =
                self.sides.as_ref().is_some_and(crosses) || self.departing(event).is_some();
            let is_behind = behind.is_some_and(|behind| behind * self.junction.value(event) > 0.0);
            let is_at_zero = self.junction.zeros.contains(event);
            if is_passed && is_behind
                || is_at_zero && is_zero_between(source, step, event, [self.t, pending.t])
            {
                events.insert(event);
            }
        }
        events
    }
}

impl<V: Values> Memory<V> {
    /// Returns the events that a run reports at its end, `here`, in addition to those found before. Of the `pending`
    /// events, which were found within the last step beyond `here`, these are the ones that rounding does not
    /// distinguish from the end.
    pub(super) fn close<S, D, G, T>(
        &mut self,
        source: &mut G,
        step: &mut LastStep<'_, S, D, T>,
        here: &At<f64, D::State>,
        pending: Option<Occurring>,
    ) -> MetConditions
    where
        S: Scalar,
        D: Dynamics<S> + ?Sized,
        G: EventFunctions<S, D, Values = V>,
        T: Advance<S, D>,
    {
        let count = self.signs.as_slice().len();
        if count == 0 || self.is_leaving {
            return MetConditions::default();
        }
        let junction = Junction::at(source, step.dynamics(), here.t, &here.x);
        let asks = junction.zeros.or(self.touching).any() || pending.is_some();
        let sides = asks.then(|| {
            let (dynamics, length) = (step.dynamics(), step.end() - step.begin());
            let state = (here.t, &here.x);
            Sides::of(source, dynamics, state, length, &junction.noise)
        });
        let ending = Ending {
            t: here.t,
            junction,
            sides,
        };
        let is_known = !step.comes_before(step.after(here.t), self.until);
        let mut closing = MetConditions::default();
        if let Some(pending) = pending {
            closing = ending.pending(source, step, pending);
        }
        for event in (0..count).filter(|_| is_known) {
            if self.occurs_at(&ending, event, source, step)
                && !self.is_same_zero(event, source, step, here.t)
            {
                closing.insert(event);
            }
        }
        if here.t - self.until == 0.0 {
            for event in 0..count {
                self.see(event, ending.junction.value(event));
            }
            self.leave(&ending.junction, here.t);
            self.note_zeros(closing, here.t);
            // Functions that touch zero are handled now, or left to the next run.
            self.touching = MetConditions::default();
            if self.left.any() {
                self.leave_from(here.t);
            }
        }
        closing
    }

    /// Whether an event's function has crossed or reached zero at the end of a run.
    fn occurs_at<S, D, G, T>(
        &self,
        ending: &Ending<V>,
        event: usize,
        source: &G,
        step: &LastStep<'_, S, D, T>,
    ) -> bool
    where
        S: Scalar,
        D: Dynamics<S> + ?Sized,
        G: EventFunctions<S, D, Values = V>,
        T: Advance<S, D>,
    {
        let crossing = source.event(event).crossing();
        let is_zero = ending.junction.zeros.contains(event);
        let is_touching = self.touching.contains(event);
        let last = self.zero_at.as_slice().get(event).copied();
        let last = last.filter(|last| !last.is_nan());
        // If another list of events has stopped the run before the time until which this one is known, the known sign
        // may be the one after the end.
        let is_beyond = step.comes_before(ending.t, self.until);
        let known = self.sign_before(event);
        let mut before = if is_beyond { f64::NAN } else { known };
        if (is_zero || is_touching) && (is_beyond || has_sign(before)) {
            // The last sign may be due to rounding just before the end. The sign at a distance from the end counts
            // instead, unless the zero between them is known.
            let apart = ending.sides.as_ref().and_then(|sides| sides.before(event));
            let is_apart = |reach: f64| last.is_none_or(|last| (ending.t - last).abs() > reach);
            before = apart
                .filter(|(_, reach)| is_apart(*reach))
                .map_or(before, |(sign, _)| sign);
        }
        if is_zero {
            return crossing.between(before, 0.0);
        }
        let is_new = last.is_none_or(|last| step.comes_before(last, step.begin()));
        let departs = ending
            .departing(event)
            .is_some_and(|value| value * before > 0.0);
        let is_touched = is_new && is_touching && departs && crossing.between(before, 0.0);
        is_touched || crossing.between(before, ending.junction.value(event))
    }

    /// Whether an event's function has been zero ever since its last zero.
    fn is_same_zero<S, D, G, T>(
        &self,
        event: usize,
        source: &mut G,
        step: &mut LastStep<'_, S, D, T>,
        t: f64,
    ) -> bool
    where
        S: Scalar,
        D: Dynamics<S> + ?Sized,
        G: EventFunctions<S, D, Values = V>,
        T: Advance<S, D>,
    {
        let last = self.zero_at.as_slice().get(event).copied();
        let Some(last) = last.filter(|last| !last.is_nan()) else {
            return false;
        };
        is_zero_between(source, step, event, [last, t])
    }
}

/// Whether an event's function that is zero at two times is zero between them. Times that cannot be distinguished are
/// the same.
fn is_zero_between<S, D, G, T>(
    source: &mut G,
    step: &mut LastStep<'_, S, D, T>,
    event: usize,
    [from, to]: [f64; 2],
) -> bool
where
    S: Scalar,
    D: Dynamics<S> + ?Sized,
    G: EventFunctions<S, D>,
    T: Advance<S, D>,
{
    if !step.comes_before(step.after(from), to) {
        return true;
    }
    // Nothing is known about earlier steps, so the function has to be zero at the beginning of this one.
    let is_earlier = step.comes_before(from, step.begin());
    let from = if is_earlier { step.begin() } else { from };
    let mut is_zero = |part: f64| {
        let there = step.at(from + part * (to - from));
        let junction = Junction::at(source, step.dynamics(), there.t, &there.x);
        junction.zeros.contains(event)
    };
    if is_earlier && !is_zero(0.0) {
        return false;
    }
    // The middle is left out: a periodic function is zero there, between two of its zeros. Rounding may move one of the
    // values off zero.
    BETWEEN.into_iter().filter(|part| is_zero(*part)).count() > 1
}
