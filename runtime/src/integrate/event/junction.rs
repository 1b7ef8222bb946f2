//! Where one run ends and another begins: to which of them an event belongs.
//!
//! A run that begins knows a time and a state, and nothing of the run before it. So both decide by what the event functions are
//! at the state that is handed over: a run that ends there reports the events whose functions have reached zero or changed
//! their signs, and one that begins there takes the signs that it finds. A function is zero there if rounding cannot tell it from
//! zero: a few roundings of the time and of the components of the state change it by as much as its value. What it
//! does next is then to leave zero, which is no event.
//!
//! In one direction a function that is distinguishable from zero is taken at its word. For an event in either direction, a
//! change of sign within the resolution of time, before or behind, is a zero there, too: an impact that stops a run lies behind
//! the zero by rounding, and the motion away from it passes the zero once more.

use super::memory::Memory;
use super::met_conditions::MetConditions;
use super::values::Values;
use super::{Crossing, EventFunctions, LastStep, Occurring};
use crate::integrate::at::At;
use crate::integrate::dynamics::Dynamics;
use crate::integrate::stepper::{Advance, derivative_apart};
use crate::limits::events::{MOVED_EPSILONS, TIME_RESOLUTION};
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

/// The event functions at a state that one run hands over to another.
pub(super) struct Junction<V> {
    pub(super) values: V,
    /// What rounding makes of them.
    pub(super) noise: V,
    /// Which of them are zero.
    pub(super) zeros: MetConditions,
}

impl<V: Values> Junction<V> {
    pub(super) fn at<S, D, G>(source: &mut G, dynamics: &D, t: f64, x: &D::State) -> Self
    where
        S: Scalar,
        D: Dynamics<S> + ?Sized,
        G: EventFunctions<S, D, Values = V>,
    {
        let values = source.values(dynamics, t, x);
        let noise = rounding(source, dynamics, (t, x), &values);
        let pairs = values.as_slice().iter().zip(noise.as_slice());
        let zeros = MetConditions::of(pairs.map(|(value, noise)| value.abs() <= *noise));
        let mut junction = Self {
            values,
            noise,
            zeros,
        };
        junction.find_zeros_within_resolution(source, dynamics, (t, x));
        junction
    }

    /// Adds the functions that change their signs within the resolution of time: for events in either direction that of a
    /// stepper, and on a scalar with more digits than the time has, for all of them, that of the scalar.
    fn find_zeros_within_resolution<S, D, G>(
        &mut self,
        source: &mut G,
        dynamics: &D,
        (t, x): (f64, &D::State),
    ) where
        S: Scalar,
        D: Dynamics<S> + ?Sized,
        G: EventFunctions<S, D, Values = V>,
    {
        let is_finer = S::machine_epsilon() < f64::EPSILON;
        let events = 0..self.values.as_slice().len();
        let either = |event: &usize| source.event(*event).crossing() == Crossing::Either;
        let asked = events.filter(|event| !self.zeros.contains(*event));
        let asked = asked.map(|event| (event, either(&event)));
        let asked = asked.filter(|(_, is_either)| *is_either || is_finer);
        let [either, directed] = asked.fold([MetConditions::default(); 2], |mut sets, asked| {
            sets[usize::from(!asked.1)].insert(asked.0);
            sets
        });
        if !either.or(directed).any() {
            return;
        }
        let reduced = dynamics.reduced(x, &x.zeroed());
        let rate = derivative_apart(dynamics, S::from_f64(t), &reduced);
        let size = |x: &D::State| x.fold(S::zero(), |sum, x| sum + x.abs()).largest();
        let time_scale = size(x) / size(&rate);
        let time_scale = if time_scale.is_finite() {
            time_scale
        } else {
            0.0
        };
        let of_scalar = MOVED_EPSILONS * S::machine_epsilon();
        let of_time = TIME_RESOLUTION * f64::EPSILON * t.abs();
        for (events, distance) in [
            (either, of_time + of_scalar * time_scale),
            (directed, of_scalar * (t.abs() + time_scale)),
        ] {
            if !events.any() || distance <= 0.0 {
                continue;
            }
            let [before, behind] = [-distance, distance].map(|distance| {
                let mut there = x.clone();
                there.add_scaled(S::from_f64(distance), &rate);
                source.values(dynamics, t + distance, &there)
            });
            let pairs = before.as_slice().iter().zip(behind.as_slice());
            let changes = MetConditions::of(pairs.map(|(before, behind)| before * behind <= 0.0));
            for event in events.indices().filter(|event| changes.contains(*event)) {
                self.zeros.insert(event);
            }
        }
    }

    fn value(&self, event: usize) -> f64 {
        let value = self.values.as_slice().get(event).copied();
        value.unwrap_or(f64::NAN)
    }

    /// What a value has to exceed to show that a function has left its zero.
    fn hysteresis(&self, event: usize) -> f64 {
        let noise = self.noise.as_slice().get(event).copied().unwrap_or(0.0);
        noise.max(self.value(event).abs())
    }
}

impl<V: Values> Memory<V> {
    /// The memory of a run that begins.
    pub(super) fn at_start<S, D, G>(source: &mut G, dynamics: &D, t: f64, x: &D::State) -> Self
    where
        S: Scalar,
        D: Dynamics<S> + ?Sized,
        G: EventFunctions<S, D, Values = V>,
    {
        let junction = Junction::at(source, dynamics, t, x);
        let mut memory = Self::new(t, junction.values);
        memory.leave(&junction, t);
        memory
    }

    /// Notes which functions are zero at a time: they have no signs until they leave it.
    fn leave(&mut self, junction: &Junction<V>, t: f64) {
        for event in junction.zeros.indices() {
            let least = junction.hysteresis(event);
            let [signs, hysteresis, zeros] =
                [&mut self.signs, &mut self.hysteresis, &mut self.zero_at].map(V::as_mut_slice);
            for (slice, value) in [(signs, 0.0), (hysteresis, least), (zeros, t)] {
                if let Some(place) = slice.get_mut(event) {
                    *place = value;
                }
            }
        }
        self.left = junction.zeros;
    }

    /// The events that a run reports where it ends, `here`, besides those that were found before. Of those that are `pending`,
    /// which were found within the last step behind `here`, the ones that rounding does not tell from it.
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
        let is_next = |t: f64| !step.comes_before(step.after(here.t), t);
        let is_known = is_next(self.until);
        let mut closing = MetConditions::default();
        if let Some(pending) = pending {
            let behind = is_next(pending.t).then(|| {
                let there = step.at(pending.t);
                source.values(step.dynamics(), there.t, &there.x)
            });
            for event in pending.events.indices() {
                let behind = behind.and_then(|behind| behind.as_slice().get(event).copied());
                let is_behind = behind.is_some_and(|behind| behind * junction.value(event) > 0.0);
                let is_at_zero = junction.zeros.contains(event);
                if is_behind
                    || is_at_zero && is_zero_between(source, step, event, [here.t, pending.t])
                {
                    closing.insert(event);
                }
            }
        }
        for event in (0..count).filter(|_| is_known) {
            let now = if junction.zeros.contains(event) {
                0.0
            } else {
                junction.value(event)
            };
            let (crossing, before) = (source.event(event).crossing(), self.sign_before(event));
            let last = self.zero_at.as_slice().get(event).copied();
            let is_new =
                last.is_none_or(|last| last.is_nan() || step.comes_before(last, step.begin()));
            let is_touched =
                is_new && self.departing.contains(event) && crossing.between(before, 0.0);
            if (is_touched || crossing.between(before, now))
                && !self.is_same_zero(event, source, step, here.t)
            {
                closing.insert(event);
            }
        }
        if here.t - self.until == 0.0 {
            for event in 0..count {
                self.see(event, junction.value(event));
            }
            self.leave(&junction, here.t);
            self.note_zeros(closing, here.t);
            // What is touched is known now, or is left to what follows.
            self.touching = MetConditions::default();
            if self.left.any() {
                self.leave_from(here.t);
            }
        }
        closing
    }

    /// Whether an event's function has been zero ever since it was last.
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

/// Whether an event's function that is zero at two times is zero between them.
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
    if !step.comes_before(from, to) {
        return true;
    }
    let middle = from + 0.5 * (to - from);
    let middle = if step.comes_before(middle, step.begin()) {
        step.begin()
    } else {
        middle
    };
    let there = step.at(middle);
    let junction = Junction::at(source, step.dynamics(), there.t, &there.x);
    junction.zeros.contains(event)
}

/// By how much the values change when the time and the state are moved by some rounding errors.
pub(super) fn rounding<S, D, G>(
    source: &mut G,
    dynamics: &D,
    (t, x): (f64, &D::State),
    values: &G::Values,
) -> G::Values
where
    S: Scalar,
    D: Dynamics<S> + ?Sized,
    G: EventFunctions<S, D>,
{
    let part = MOVED_EPSILONS * S::machine_epsilon();
    let epsilon = S::from_f64(part);
    let mut noise = G::Values::ZERO;
    for alternation in [1.0, -1.0] {
        let mut sign = S::one();
        let moved = x.map(|component| {
            sign *= S::from_f64(alternation);
            component + component * sign * epsilon
        });
        let time = t - alternation * t * MOVED_EPSILONS * f64::EPSILON.min(part);
        let there = source.values(dynamics, time, &moved);
        let pairs = there.as_slice().iter().zip(values.as_slice());
        for (noise, (there, here)) in noise.as_mut_slice().iter_mut().zip(pairs) {
            *noise = noise.max((there - here).abs());
        }
    }
    noise
}
