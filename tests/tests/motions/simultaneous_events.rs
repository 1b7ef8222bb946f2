//! Declared events at one time, or so near that rounding cannot tell: none hides another one.

use lagrangian::DeclaredEvent;
use lagrangian::prelude::*;
use lagrangian_tests::assert_close;

/// A particle that moves freely, with events that have zeros at one place; of them, some are known to a few digits only.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    event(
        gate = x - place,
        pair = (x - place) * (x - place - 1e-4),
        touch = (x - place).powi(2),
        touch_later = (x - place - 1e-10).powi(2),
        cubic = (x - place).powi(3),
        wave = sin(7.0 * (x - place)) * (2.0 + x),
    ),
)]
struct Particle {
    place: f64,
}

const COUNT: usize = 6;

/// How well each is known: a double zero to half of the digits, a triple zero to a third.
const ERRORS: [f64; COUNT] = [1e-14, 1e-9, 1e-6, 1e-6, 1e-4, 1e-13];

/// The times of each of three events.
fn watched(events: [usize; 3], speed: f64, place: f64) -> [Vec<f64>; 3] {
    let motion = Problem::new(&Particle { place }, State::new(0.0, [0.0], [speed]))
        .on(events.map(DeclaredEvent::new))
        .record()
        .solve(1.0, Taylor::new())
        .unwrap();
    let mut times = [const { Vec::new() }; 3];
    for occurrence in motion.events() {
        times[occurrence.event].push(occurrence.t);
    }
    times
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn events_at_one_place_are_those_that_each_is_alone() {
    watch_together(|_, _| true);
}

/// Each ordered pair at each place, with a third event that differs from place to place.
#[test]
fn some_events_at_one_place_are_those_that_each_is_alone() {
    watch_together(|number, events| (number + events.iter().sum::<usize>()).is_multiple_of(COUNT));
}

/// Three events at once, of those that are chosen by the number of their place.
fn watch_together(is_chosen: fn(usize, [usize; 3]) -> bool) {
    let places = [[1.0, 0.3], [0.7, 0.21], [0.9, 0.7]];
    for (number, [speed, place]) in places.into_iter().enumerate() {
        let alone: [Vec<f64>; COUNT] =
            core::array::from_fn(|event| watched([event; 3], speed, place)[0].clone());
        let counts = [&alone[0], &alone[1], &alone[2], &alone[3], &alone[4]].map(Vec::len);
        assert_eq!(counts, [1, 2, 1, 1, 1]);
        for first in 0..COUNT {
            for second in 0..COUNT {
                for third in 0..COUNT {
                    let events = [first, second, third];
                    if !is_chosen(number, events) {
                        continue;
                    }
                    let found = watched(events, speed, place);
                    for (event, found) in events.into_iter().zip(found) {
                        let what = format!("{event} of {events:?} at {place}");
                        assert_eq!(found.len(), alone[event].len(), "{what}: {found:?}");
                        assert_close(&what, &found, &alone[event], ERRORS[event]);
                    }
                }
            }
        }
    }
}
