//! Event functions that touch zero, or have two zeros next to each other, where one run ends and another begins.

use crate::directions::{Direction, EVERY, directed};
use crate::random_numbers::Random;
use crate::two_runs::{ENDS, X, in_two_runs, run};
use lagrangian::DeclaredEvent;
use lagrangian::prelude::*;

/// A stone that is thrown, on a spring sideways.
#[derive(Lagrangian, Clone, Copy, Debug)]
#[lagrangian(
    taylor,
    coordinates(x, y),
    kinetic = 0.5 * (dot(x).powi(2) + dot(y).powi(2)),
    potential = 0.5 * k * x.powi(2) + g * y,
    event(
        // Zeros of even order.
        square = x.powi(2),
        noon = (t - c).powi(2),
        // Two zeros, and the same from below.
        pair = (t - c).powi(2) - d,
        below = d - (t - c).powi(2),
        near = d - x.powi(2),
    ),
)]
struct Stone {
    k: f64,
    g: f64,
    c: f64,
    d: f64,
}

const TOUCHING: [DeclaredEvent<Stone>; 2] = [Stone::SQUARE, Stone::NOON];
const PAIRS: [DeclaredEvent<Stone>; 3] = [Stone::PAIR, Stone::BELOW, Stone::NEAR];

/// A number between powers of ten.
fn power(random: &mut Random, from: f64, to: f64) -> f64 {
    10.0_f64.powf(from + (to - from) * random.uniform())
}

/// A stone, where it begins, and the time until which it moves, forwards or backwards.
fn thrown(random: &mut Random, case: usize) -> (Stone, At<f64, X>, f64) {
    let model = Stone {
        k: 1.0 + 3.0 * random.uniform(),
        g: 0.5 + random.uniform(),
        c: 0.2 + random.uniform(),
        d: power(random, -13.0, -4.0),
    };
    let q = [0.4 + random.uniform(), 0.0];
    let v = [random.uniform() - 0.5, 0.3 + random.uniform()];
    let (from, end) = [(-0.3, 2.5), (2.5, -0.3)][case % 2];
    (model, State::new(from, q, v), end)
}

/// Splits of motions at zeros of these functions and near them, of which each zero is reported by one run.
fn each_zero_once(events: &[DeclaredEvent<Stone>], seed: u64, cases: &[usize]) {
    let mut random = Random(seed);
    for &case in cases {
        let (model, start, end) = thrown(&mut random, case);
        let method = [Taylor::new(), Taylor::new().max_step(0.1)][(case / 2) % 2];
        for direction in EVERY {
            for &event in events {
                let watching = |direction, start: &At<f64, X>| {
                    directed!(direction, Problem::new(&model, *start).on(event)).record()
                };
                let problem = |start: &At<f64, X>| watching(direction, start);
                let all = run(watching(Direction::Either, &start), method, end);
                let whole = run(problem(&start), method, end);
                for kind in ENDS {
                    let place = random.below(u16::try_from(all.len()).unwrap());
                    let time = all[usize::from(place)].1;
                    let ulp = time.abs().next_up() - time.abs();
                    let at = match random.below(3) {
                        0 => time,
                        1 => time + (f64::from(random.below(33)) - 16.0) * ulp,
                        _ => {
                            time + [1.0, -1.0][usize::from(random.below(2))]
                                * power(&mut random, -15.0, -4.0)
                        }
                    };
                    let parts = in_two_runs(problem, method, &start, (at, end), kind);
                    assert_eq!(
                        parts.len(),
                        whole.len(),
                        "{kind:?} at {at:e} = {time:e} {:+e}, {direction:?} {event:?} of {model:?} from {start:?}: {parts:?} {whole:?}",
                        at - time
                    );
                }
            }
        }
    }
}

/// Forwards by long steps, and backwards by short ones.
const SOME: &[usize] = &[0, 3];

#[test]
fn a_function_that_touches_zero_does_so_once() {
    each_zero_once(&TOUCHING, 5, SOME);
}

#[test]
fn both_zeros_of_a_close_pair_are_reported_once() {
    each_zero_once(&PAIRS, 7, SOME);
}

#[test]
#[ignore = "takes a minute; run with `--include-ignored`"]
fn touches_and_close_pairs_are_reported_once() {
    let all: Vec<usize> = (0..40).collect();
    each_zero_once(&TOUCHING, 5, &all[..4]);
    each_zero_once(&PAIRS, 7, &all[..3]);
    each_zero_once(&TOUCHING, 21, &all);
    each_zero_once(&PAIRS, 23, &all);
}

/// The terms of a polynomial cancel where the function does not: no event is before the zero of the function.
#[test]
fn no_event_comes_before_its_zero() {
    for i in 0..32 {
        let (c, d) = (0.3 + 0.043 * f64::from(i), 1e-11);
        let model = Stone {
            k: 1.0,
            g: 1.0,
            c,
            d,
        };
        let start = State::new(-0.3, [0.4, 0.0], [0.0, 1.0]);
        let pair = Problem::new(&model, start).on(Stone::PAIR).record();
        let times = run(pair, Taylor::new(), 2.5);
        assert_eq!(times.len(), 2);
        for (time, sign) in times.iter().zip([-1.0, 1.0]) {
            let error = time.1 - (c + sign * d.sqrt());
            assert!(error >= -4.0 * f64::EPSILON, "{error:e} at {c}");
        }
    }
}
