//! Detection of events by sampling: if the signs of an event function at two neighbouring times differ, it has crossed
//! zero between them.

use super::junction::rounding;
use super::location::Bracket;
use super::memory::Memory;
use super::met_conditions::MetConditions;
use super::values::Values;
use super::{Crossing, EventFunctions, LastStep, Occurring};
use crate::integrate::dynamics::Dynamics;
use crate::integrate::stepper::{Advance, derivative_apart};
use crate::limits::events::{COOLDOWN, EXTRAPOLATIONS, PARTS};
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

/// Returns the next events within the last step.
pub(super) fn next<
    S: Scalar,
    D: Dynamics<S> + ?Sized,
    G: EventFunctions<S, D>,
    T: Advance<S, D>,
>(
    source: &mut G,
    memory: &mut Memory<G::Values>,
    step: &mut LastStep<'_, S, D, T>,
) -> Option<Occurring> {
    let usual = if T::DENSE_OUTPUT { PARTS } else { 1 };
    let parts = source.parts().unwrap_or(usual).max(1);
    while let Some(time) = memory.next_time(step, parts) {
        let sample = step.at(time);
        let mut values = source.values(step.dynamics(), time, &sample.x);
        let changed = sign_changes(memory, &values);
        if changed.any() {
            let crossed = crossings(source, memory, &values);
            let noise = rounding(source, step.dynamics(), (time, &sample.x), &values);
            if crossed
                .indices()
                .any(|event| has_crossed(event, &values, &noise))
            {
                return Some(locate(source, memory, step, (time, values)));
            }
            // These values are too near to zero for a certain sign: the next samples decide.
            for event in changed.indices() {
                let is_certain = has_crossed(event, &values, &noise);
                if let (false, Some(value)) = (is_certain, values.as_mut_slice().get_mut(event)) {
                    *value = 0.0;
                }
            }
        }
        memory.pass(time, &values);
    }
    None
}

/// Whether a changed sign is certain, or the value is exactly zero: a function that reaches zero may stay there.
fn has_crossed<V: Values>(event: usize, values: &V, noise: &V) -> bool {
    let [value, noise] = [values, noise].map(|values| values.as_slice().get(event).copied());
    let pair = value.zip(noise);
    pair.is_some_and(|(value, noise)| value == 0.0 || value.abs() > noise || noise.is_nan())
}

/// Returns the functions whose signs have changed, whether or not in the direction of their events.
fn sign_changes<V: Values>(memory: &Memory<V>, values: &V) -> MetConditions {
    let pairs = memory.signs.as_slice().iter().zip(values.as_slice());
    MetConditions::of(pairs.map(|(before, after)| Crossing::Either.between(*before, *after)))
}

/// Returns the events whose functions have crossed zero when they have these values.
fn crossings<S: Scalar, D: Dynamics<S> + ?Sized, G: EventFunctions<S, D>>(
    source: &G,
    memory: &Memory<G::Values>,
    values: &G::Values,
) -> MetConditions {
    let pairs = memory.signs.as_slice().iter().zip(values.as_slice());
    let crossed = pairs.enumerate().map(|(i, (before, after))| {
        let crosses = source.event(i).crossing().between(*before, *after);
        crosses && memory.counts(i, *after)
    });
    MetConditions::of(crossed)
}

/// Locates the first events before a time at which some have occurred. The result is the time just after the zero;
/// events within the resolution of time occur together.
fn locate<S: Scalar, D: Dynamics<S> + ?Sized, G: EventFunctions<S, D>, T: Advance<S, D>>(
    source: &mut G,
    memory: &mut Memory<G::Values>,
    step: &mut LastStep<'_, S, D, T>,
    (mut time, mut values): (f64, G::Values),
) -> Occurring {
    let mut events = crossings(source, memory, &values);
    let (mut before, mut signs) = (memory.until, memory.signs);
    let mut bracket = Bracket::new(before, time);
    loop {
        let first = events.indices().next().unwrap_or(0);
        let of = |values: &G::Values| values.as_slice().get(first).copied().unwrap_or(f64::NAN);
        let Some(middle) = bracket.divide((before, of(&signs)), (time, of(&values))) else {
            break;
        };
        let sample = step.at(middle);
        let found = source.values(step.dynamics(), middle, &sample.x);
        let crossed = crossings(source, memory, &found);
        if crossed.any() {
            (time, values, events) = (middle, found, crossed);
        } else {
            (before, signs) = (middle, found);
            for (i, value) in found.as_slice().iter().enumerate() {
                memory.see(i, *value);
            }
        }
    }
    let sample = step.at(step.after(time));
    let after = source.values(step.dynamics(), sample.t, &sample.x);
    let later = crossings(source, memory, &after).without(events);
    if later.any() {
        events = events.or(later);
        (time, values) = together(
            source,
            memory,
            step,
            later,
            [(time, values), (sample.t, after)],
        );
    }
    memory.at_event = values;
    let noise = rounding(source, step.dynamics(), (sample.t, &sample.x), &after);
    // A zero that is crossed here in a direction that is not watched is not an event of the following part, either.
    memory.note_zeros(events.or(sign_changes(memory, &after)), time);
    let hysteresis = memory.hysteresis.as_slice().iter();
    memory.within_rounding = MetConditions::of(hysteresis.map(|least| *least > 0.0));
    memory.pass(sample.t, &after);
    let noise = noise.as_slice().iter();
    let signs = memory.signs.as_mut_slice().iter_mut().zip(noise);
    let signs = signs.zip(after.as_slice()).enumerate();
    for (_, ((sign, noise), value)) in signs.filter(|(i, _)| events.contains(*i)) {
        // A function that has reached zero has no sign until it leaves zero.
        if value.is_nan() || value.abs() <= *noise {
            *sign = 0.0;
        }
    }
    Occurring { t: time, events }
}

/// Returns the first time in an interval at which all of these events have occurred, none of which has at its
/// beginning. An integration that continues from there thus finds none of them before its zero.
fn together<S: Scalar, D: Dynamics<S> + ?Sized, G: EventFunctions<S, D>, T: Advance<S, D>>(
    source: &mut G,
    memory: &Memory<G::Values>,
    step: &mut LastStep<'_, S, D, T>,
    events: MetConditions,
    [(mut before, _), (mut time, mut values)]: [(f64, G::Values); 2],
) -> (f64, G::Values) {
    let mut bracket = Bracket::new(before, time);
    while let Some(middle) = bracket.divide((before, f64::NAN), (time, f64::NAN)) {
        let sample = step.at(middle);
        let found = source.values(step.dynamics(), middle, &sample.x);
        if events.without(crossings(source, memory, &found)).any() {
            before = middle;
        } else {
            (time, values) = (middle, found);
        }
    }
    (time, values)
}

/// Restarts after a reaction. The sign of an event function is then the sign of its rate, taken along the derivative of
/// the changed state. When the function leaves zero, its values count as soon as they exceed their rounding errors:
/// this is the cooldown. If it has returned to zero by then, the event occurs again. (F. Biscani & D. Izzo, *Revisiting
/// high-order Taylor methods for astrodynamics and celestial mechanics*, Mon. Not. R. Astron. Soc. **504** (2021) 2614,
/// use a time as cooldown, the error of the event function over its rate. A threshold of the value does not depend on
/// how the rate changes.)
pub(super) fn restart<S: Scalar, D: Dynamics<S> + ?Sized, G: EventFunctions<S, D>>(
    source: &mut G,
    memory: &mut Memory<G::Values>,
    dynamics: &D,
    Occurring { t, events }: Occurring,
    x: &D::State,
    step: f64,
) -> MetConditions {
    let mut signs = source.values(dynamics, t, x);
    let noise = rounding(source, dynamics, (t, x), &signs);
    let rate = derivative_apart(dynamics, S::from_f64(t), &dynamics.reduced(x, &x.zeroed()));
    let mut along = |distance: f64| {
        let mut there = x.clone();
        there.add_scaled(S::from_f64(distance), &rate);
        source.values(dynamics, t + distance, &there)
    };
    let mut hysteresis = G::Values::ZERO;
    let mut accumulating = MetConditions::default();
    let mut at_zero = MetConditions::default();
    // Other functions that are zero to rounding have crossed zero in a direction that is not watched, or are leaving
    // it.
    let triples = signs.as_mut_slice().iter_mut().zip(noise.as_slice());
    let triples = triples.zip(hysteresis.as_mut_slice());
    for (_, ((sign, noise), least)) in triples.enumerate().filter(|(i, _)| !events.contains(*i)) {
        if sign.abs() <= *noise {
            (*sign, *least) = (0.0, *noise);
        }
    }
    for event in events.indices() {
        let at = |values: &G::Values| values.as_slice().get(event).copied().unwrap_or(0.0);
        // A reaction may have moved the zero.
        if at(&signs).abs() > COOLDOWN * (at(&memory.at_event).abs() + at(&noise)) {
            continue;
        }
        at_zero.insert(event);
        let rounding = COOLDOWN * at(&noise);
        let changes = EXTRAPOLATIONS.map(|part| part * step);
        let mut changes = changes
            .into_iter()
            .map(|distance| at(&along(distance)) - at(&along(-distance)));
        let change = changes.find(|change| change.abs() > rounding);
        let least = at(&signs).abs() + rounding;
        if let Some(sign) = signs.as_mut_slice().get_mut(event) {
            *sign = change.unwrap_or(0.0);
        }
        if let Some(hysteresis) = hysteresis.as_mut_slice().get_mut(event) {
            *hysteresis = least;
        }
        if memory.is_accumulating(event, t, step, change.is_some()) {
            accumulating.insert(event);
        }
    }
    memory.begin_anew(t, signs, hysteresis);
    memory.at_zero = at_zero;
    accumulating
}
