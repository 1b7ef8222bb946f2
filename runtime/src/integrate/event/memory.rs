//! What is known about event functions between evaluations.

use super::LastStep;
use super::met_conditions::MetConditions;
use super::values::Values;
use crate::integrate::checkpoint::EventSigns;
use crate::integrate::dynamics::Dynamics;
use crate::integrate::stepper::Advance;
use crate::limits::events::{
    DEPARTURE_GROWTH, OCCURRENCES, SHORT_PART, SHORT_TIME, TIME_RESOLUTION,
};
use crate::scalar::Scalar;

/// What is known about event functions up to a time.
#[derive(Clone, Copy, Debug)]
pub struct Memory<V> {
    /// The time up to which events were searched.
    pub(super) until: f64,
    /// The last values that had a sign; 0 if there was none yet, or if a function has reached zero.
    pub(super) signs: V,
    /// The time at which the method started or restarted.
    start: f64,
    /// Whether nothing was evaluated since the start.
    pub(super) is_leaving: bool,
    /// The distance from the start to the next evaluation, while a function stays at zero after the start.
    departure: f64,
    /// The value that an event's function has to exceed to count after a reaction to the event: the cooldown.
    pub(super) hysteresis: V,
    /// The events whose functions have not exceeded this value between two zeros.
    pub(super) within_rounding: MetConditions,
    /// The values of the functions at the last events.
    pub(super) at_event: V,
    /// For polynomials: the beginning of the present part of the step; its end if no event is left in it.
    pub(super) window: f64,
    /// The beginning of the step from which the first terms of the functions do not exclude events; NaN if none is known.
    pub(super) not_excluded: f64,
    /// The beginning of the step in which the zeros of the functions are not isolated; NaN if none is known.
    pub(super) not_isolated: f64,
    /// For polynomials: the part of the step after which the sign that follows the last root is certain.
    pub(super) resume: V,
    /// For polynomials, after an event: the signs of the other functions before their next roots, which may be next to
    /// the event because of rounding; 0 if there is none.
    pub(super) ahead: V,
    /// For polynomials: the events whose functions are zero to rounding at the end of the last window. If they do not
    /// cross zero, they have touched it.
    pub(super) touching: MetConditions,
    /// The direction of time in the steps that were searched.
    forwards: Option<bool>,
    /// The events whose reaction made the method restart: their functions are zero there.
    pub(super) at_zero: MetConditions,
    /// The events whose functions are zero at the beginning of this run, or at the end of the last one.
    pub(super) left: MetConditions,
    /// The time of the last zero of each function: at an event, or where a run began or ended. NaN if there was none.
    pub(super) zero_at: V,
    /// The time of the last reaction to each event.
    reactions: V,
    /// The number of consecutive occurrences of each event within a short time.
    in_a_row: V,
}

/// Whether a number is positive or negative, that is, neither zero nor NaN.
pub(super) fn has_sign(value: f64) -> bool {
    !value.is_nan() && value != 0.0
}

impl<V: Values> Memory<V> {
    /// Creates the memory at the initial time, at which the functions have these values.
    pub(super) fn new(start: f64, values: V) -> Self {
        let mut never = V::ZERO;
        never.as_mut_slice().fill(f64::NAN);
        Self {
            until: start,
            signs: values,
            start,
            is_leaving: true,
            departure: 0.0,
            hysteresis: V::ZERO,
            within_rounding: MetConditions::default(),
            at_event: V::ZERO,
            window: start,
            not_excluded: f64::NAN,
            not_isolated: f64::NAN,
            resume: V::ZERO,
            ahead: V::ZERO,
            at_zero: MetConditions::default(),
            touching: MetConditions::default(),
            forwards: None,
            left: MetConditions::default(),
            zero_at: never,
            reactions: never,
            in_a_row: V::ZERO,
        }
    }

    /// Restarts at `start`, where the functions have these signs.
    pub(super) fn begin_anew(&mut self, start: f64, signs: V, hysteresis: V) {
        // Zeros after the start were found before another list of events caused a reaction: the motion does not reach
        // them.
        for zero_at in self.zero_at.as_mut_slice() {
            let is_behind =
                |forwards| (forwards && *zero_at > start) || (!forwards && *zero_at < start);
            if self.forwards.is_some_and(is_behind) {
                *zero_at = f64::NAN;
            }
        }
        *self = Self {
            hysteresis,
            reactions: self.reactions,
            in_a_row: self.in_a_row,
            at_event: self.at_event,
            zero_at: self.zero_at,
            ..Self::new(start, signs)
        };
    }

    /// Returns the part that a checkpoint stores.
    fn signs_of_checkpoint(&self) -> EventSigns {
        let [positive, negative] = EventSigns::bits(self.signs.as_slice());
        EventSigns {
            positive,
            negative,
            forwards: self.forwards,
            touching: self.touching,
        }
    }

    /// Returns this memory of the functions at the time of a checkpoint, with the signs that it has stored.
    fn with_signs(mut self, stored: EventSigns) -> Self {
        for (event, value) in self.signs.as_mut_slice().iter_mut().enumerate() {
            let sign = stored.sign(event);
            if *value * sign <= 0.0 || value.is_nan() {
                *value = sign;
            }
        }
        self.forwards = stored.forwards;
        self.is_leaving = stored.forwards.is_none() || self.left.any();
        self.touching = stored.touching;
        self
    }

    /// Whether the memory is valid for an integration from `t` towards `end`, that is, one in the same direction.
    fn serves(&self, t: f64, end: f64) -> bool {
        let forwards = end >= t;
        t - self.until == 0.0 && self.forwards.is_none_or(|before| before == forwards)
    }

    /// Returns the sign of an event's function before its next zero: between two events of one step, the sign of its
    /// polynomial.
    pub(super) fn sign_before(&self, event: usize) -> f64 {
        let [ahead, sign] = [&self.ahead, &self.signs].map(|signs| signs.as_slice().get(event));
        let known = ahead.filter(|ahead| has_sign(**ahead)).or(sign);
        known.copied().unwrap_or(f64::NAN)
    }

    /// Records that events occur at a time.
    pub(super) fn note_zeros(&mut self, events: MetConditions, t: f64) {
        for event in events.indices() {
            if let Some(last) = self.zero_at.as_mut_slice().get_mut(event) {
                *last = t;
            }
        }
    }

    /// Lets functions leave zero from a time on, as from an initial time.
    pub(super) fn leave_from(&mut self, t: f64) {
        (self.start, self.is_leaving, self.departure) = (t, true, 0.0);
    }

    /// Whether a value of an event function is significant: during the cooldown it may be a rounding error.
    pub(super) fn counts(&self, event: usize, value: f64) -> bool {
        let least = self.hysteresis.as_slice().get(event);
        least.is_none_or(|least| *least == 0.0 || value.abs() > *least)
    }

    /// Takes the sign of a value, if it has one that is significant.
    pub(super) fn see(&mut self, event: usize, value: f64) {
        if !has_sign(value) || !self.counts(event, value) {
            return;
        }
        if let Some(sign) = self.signs.as_mut_slice().get_mut(event) {
            *sign = value;
        }
        if let Some(least) = self.hysteresis.as_mut_slice().get_mut(event) {
            *least = 0.0;
        }
    }

    /// Records a reaction to an event, in steps of about this length. Returns whether there were too many in a row,
    /// each within a short time, or two if the function does not leave zero (`is_left` is false). The time is longer if
    /// the function has not left its rounding errors in between.
    pub(super) fn is_accumulating(
        &mut self,
        event: usize,
        t: f64,
        step: f64,
        is_left: bool,
    ) -> bool {
        let short = SHORT_TIME * TIME_RESOLUTION * f64::EPSILON * (t.abs() + step.abs());
        let pair = (self.reactions.as_mut_slice().get_mut(event))
            .zip(self.in_a_row.as_mut_slice().get_mut(event));
        let Some((last, in_a_row)) = pair else {
            return false;
        };
        let is_within = self.within_rounding.contains(event);
        let short = if is_within {
            short.max(SHORT_PART * step.abs())
        } else {
            short
        };
        if (t - *last).abs() <= short {
            *in_a_row += 1.0;
        } else {
            *in_a_row = 0.0;
        }
        *last = t;
        *in_a_row >= OCCURRENCES || (*in_a_row > 0.0 && !is_left)
    }

    /// Returns the next time at which the functions are to be evaluated; `None` at the end of the step. The regular
    /// times are the ends of `parts` of the step.
    ///
    /// There may be a zero at the initial time, such as the one at which the integration stopped before, and rounding
    /// may put the initial value on either side of it. The first time therefore is distinguishable from the initial
    /// time (K. L. Hiebert & L. F. Shampine, *Implicitly Defined Output Points for Solutions of ODEs*, SAND80-0180,
    /// 1980; the choice of the time follows SUNDIALS: A. C. Hindmarsh et al., ACM Trans. Math. Softw. **31** (2005)
    /// 363–396). A difference of nearly equal numbers, such as a height above a floor that is not at 0, is rounded to
    /// zero for a while, but a flight that ends within the first step must not be missed. While a function is zero,
    /// each time is therefore four times as far away.
    pub(super) fn next_time<S: Scalar, D: Dynamics<S> + ?Sized, T: Advance<S, D>>(
        &mut self,
        step: &LastStep<'_, S, D, T>,
        parts: u32,
    ) -> Option<f64> {
        let (begin, end) = (step.begin(), step.end());
        if !step.comes_before(self.until, end) {
            return None;
        }
        if self.is_leaving {
            let after = step.after(self.start);
            if after - end != 0.0 {
                return Some(after);
            }
            self.is_leaving = false;
        }
        let time = |part: f64| begin + (end - begin) * (part / f64::from(parts));
        let passed = f64::from(parts) * ((self.until - begin) / (end - begin));
        let passed = libm::floor(passed).max(0.0);
        let mut next = end;
        // Because of rounding, the part that was passed last may be on either side.
        for part in [passed + 2.0, passed + 1.0, passed] {
            if part > 0.0 && part < f64::from(parts) && step.comes_before(self.until, time(part)) {
                next = time(part);
            }
        }
        let time = self.start + self.departure.copysign(end - begin);
        if self.departure > 0.0
            && step.comes_before(self.until, time)
            && step.comes_before(time, next)
        {
            next = time;
        }
        Some(next)
    }

    /// Records that all events up to a time are known.
    pub(super) fn arrive(&mut self, time: f64) {
        self.go_to(time);
        self.is_leaving = false;
        self.departure = 0.0;
        self.at_zero = MetConditions::default();
        self.left = MetConditions::default();
        self.touching = MetConditions::default();
    }

    /// Whether the search has come to this time, at which a part of a step begins, with nothing particular about it: no function is
    /// zero there.
    pub(super) fn is_plain_at(&self, begin: f64) -> bool {
        let is_special = self.touching.or(self.left).or(self.at_zero).any();
        !is_special && self.until - begin == 0.0 && self.window - begin == 0.0
    }

    /// Whether functions with these signs at the beginning of a part of a step have not changed them where it begins.
    pub(super) fn agrees_with(&self, signs: &V) -> bool {
        let mut pairs = signs.as_slice().iter().zip(self.signs.as_slice());
        pairs.all(|(sign, before)| sign * before >= 0.0)
    }

    /// Records that the functions have these signs up to the end of a step. Returns false, and records nothing, if one of
    /// them had another sign before the step.
    pub(super) fn keep_signs(&mut self, signs: V, end: f64) -> bool {
        let agrees = self.agrees_with(&signs);
        if agrees {
            (self.signs, self.window) = (signs, end);
            self.arrive(end);
        }
        agrees
    }

    /// Records that the function of an event has the only zero of a part of a step at `t`, and the signs behind it, up to the end of
    /// the part.
    pub(super) fn pass_zero(&mut self, signs: V, event: usize, (t, end): (f64, f64)) {
        (self.signs, self.window) = (signs, end);
        self.arrive(end);
        let mut events = MetConditions::default();
        events.insert(event);
        self.note_zeros(events, t);
    }

    /// Records that no event has occurred up to a time at which the functions have these values.
    pub(super) fn pass(&mut self, time: f64, values: &V) {
        for (i, value) in values.as_slice().iter().enumerate() {
            self.see(i, *value);
        }
        let is_signed = self.signs.as_slice().iter().all(|sign| has_sign(*sign));
        let is_departing = self.is_leaving || self.departure > 0.0;
        self.departure = if is_departing && !is_signed {
            DEPARTURE_GROWTH * (time - self.start).abs()
        } else {
            0.0
        };
        self.is_leaving = false;
        self.left = MetConditions::default();
        self.go_to(time);
    }

    fn go_to(&mut self, time: f64) {
        if time - self.until != 0.0 {
            self.forwards = Some(time > self.until);
        }
        self.until = time;
    }
}

/// What is known about events between the calls of an integration.
pub trait Remembers: Sized {
    /// Returns the part that a checkpoint stores.
    fn event_signs(&self) -> EventSigns;

    /// Returns this memory of the functions at the time of a checkpoint, with the signs that it has stored.
    #[must_use]
    fn recalled(self, stored: EventSigns) -> Self;

    /// Whether the memory is valid for an integration from `t` towards `end`, that is, one in the same direction.
    fn goes_on(&self, t: f64, end: f64) -> bool;
}

impl<V: Values> Remembers for Memory<V> {
    fn event_signs(&self) -> EventSigns {
        self.signs_of_checkpoint()
    }

    fn recalled(self, stored: EventSigns) -> Self {
        self.with_signs(stored)
    }

    fn goes_on(&self, t: f64, end: f64) -> bool {
        self.serves(t, end)
    }
}

/// Without events nothing is remembered.
impl Remembers for () {
    fn event_signs(&self) -> EventSigns {
        EventSigns::default()
    }

    fn recalled(self, _: EventSigns) {}

    fn goes_on(&self, _: f64, _: f64) -> bool {
        true
    }
}
