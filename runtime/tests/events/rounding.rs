//! Event functions that are zero up to rounding, and small ones that are not.

use crate::directions::{Direction, EVERY, directed};
use lagrangian::prelude::*;

/// An oscillator that goes round the unit circle.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x, y),
    kinetic = 0.5 * (dot(x).powi(2) + dot(y).powi(2)),
    potential = 0.5 * (x.powi(2) + y.powi(2)),
    event(
        radius = sqrt(x.powi(2) + y.powi(2)) - 1,
        total_energy = 0.5 * (x.powi(2) + y.powi(2) + dot(x).powi(2) + dot(y).powi(2)) - 1,
        momentum = 1e6 * (x * dot(y) - y * dot(x) - 1),
        tiny = 1e-20 * (x - 0.5),
        near = x.powi(2) + y.powi(2) - 1 + 1e-12 * x,
    ),
)]
struct Circle;

fn functions(x: &State<f64, 2>) -> [f64; 5] {
    let ([a, b], [da, db]) = ([x.q[0], x.q[1]], [x.v[0], x.v[1]]);
    [
        a.hypot(b) - 1.0,
        0.5 * (a * a + b * b + da * da + db * db) - 1.0,
        1e6 * (a * db - b * da - 1.0),
        1e-20 * (a - 0.5),
        a * a + b * b - 1.0 + 1e-12 * a,
    ]
}

/// How often each event occurs in so many turns, declared and as a closure, and the number of steps.
fn occurrences(direction: Direction, turns: f64) -> ([[usize; 5]; 2], usize) {
    let start = State::new(0.0, [1.0, 0.0], [0.0, 1.0]);
    let end = turns * core::f64::consts::TAU;
    let mut counts = [[0; 5]; 2];
    let mut steps = 0;
    let events = [
        Circle::RADIUS,
        Circle::TOTAL_ENERGY,
        Circle::MOMENTUM,
        Circle::TINY,
        Circle::NEAR,
    ];
    for event in events {
        let circle = Problem::new(&Circle, start);
        let declared = directed!(direction, circle.clone().on(event)).record();
        let motion = declared.solve(end, Taylor::new()).unwrap();
        counts[0][event.index()] = motion.events().len();
        let given = directed!(direction, circle.when(|x| functions(x)[event.index()])).record();
        let motion = given.solve(end, Taylor::new()).unwrap();
        counts[1][event.index()] = motion.events().len();
        steps = usize::try_from(motion.statistics.steps).unwrap();
    }
    (counts, steps)
}

#[test]
#[ignore = "a long integration; run with `--include-ignored`"]
fn rounding_makes_few_events_of_a_constant() {
    few_events_of_a_constant(50.0);
}

#[test]
fn rounding_makes_few_events_of_a_constant_in_five_turns() {
    for turns in [5.0, -5.0] {
        few_events_of_a_constant(turns);
    }
}

fn few_events_of_a_constant(turns: f64) {
    for direction in EVERY {
        let (counts, steps) = occurrences(direction, turns);
        for of_kind in counts {
            for count in &of_kind[..3] {
                assert!(
                    *count <= 1 + steps / 2,
                    "{direction:?} {turns}: {counts:?} {steps}"
                );
            }
        }
    }
}

/// A function of any size has its zeros, also where terms cancel to a small rest that is larger than their rounding errors.
#[test]
fn small_functions_have_their_events() {
    for turns in [5.3, -5.3] {
        let (counts, _) = occurrences(Direction::Either, turns);
        // x = ½ twice in a turn, and once more at a sixth of it.
        assert_eq!([counts[0][3], counts[1][3]], [11, 11]);
        // x = 0 twice in a turn, and once more at a quarter of it.
        assert_eq!([counts[0][4], counts[1][4]], [11, 11]);
    }
}
