//! Steps in which event functions have several zeros.

use core::f64::consts::{FRAC_PI_2, TAU};

use lagrangian::DoubleDouble;
use lagrangian::prelude::*;

use crate::random_numbers::Random;

/// x = cos(t − φ), with functions of one, two and three times its frequency, and a second one next to the first.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    potential = 0.5 * x.powi(2),
    event(
        level = x - c,
        near = x - c - d,
        double = x * dot(x),
        triple = x * (4.0 * x.powi(2) - 3.0),
    ),
)]
struct Oscillator {
    c: f64,
    d: f64,
}

/// The times t = first + k distance between two times, in ascending order.
fn spaced(first: f64, distance: f64, [from, to]: [f64; 2]) -> Vec<f64> {
    let mut k = ((from - first) / distance).ceil();
    let mut times = Vec::new();
    while first + k * distance < to {
        times.push(first + k * distance);
        k += 1.0;
    }
    times
}

/// In steps with several zeros of one function or of several functions, each is found where the closed form has it, in both
/// directions of time.
#[test]
fn each_zero_of_a_step_is_found() {
    fn check<const HALF: usize>(method: Taylor<HALF>, forwards: bool, random: &mut Random) {
        let phase = TAU * random.uniform();
        let c = 0.99 * (2.0 * random.uniform() - 1.0);
        let oscillator = Oscillator { c, d: 0.0 };
        let end = if forwards { 40.0 } else { -40.0 };
        let start = State::new(0.0, [f64::cos(phase)], [f64::sin(phase)]);
        let motion = Problem::new(&oscillator, start)
            .on([Oscillator::LEVEL, Oscillator::DOUBLE])
            .record()
            .on(Oscillator::TRIPLE)
            .rising()
            .record()
            .solve(end, method)
            .unwrap();
        let span = [f64::min(0.0, end), f64::max(0.0, end)];
        let turn = f64::acos(c);
        let mut level = spaced(phase - turn, TAU, span);
        level.extend(spaced(phase + turn, TAU, span));
        let double = spaced(phase, FRAC_PI_2, span);
        // cos 3(t − φ) rises where sin 3(t − φ) = −1; backwards in time it rises at the other zeros.
        let rising = if forwards { -FRAC_PI_2 } else { FRAC_PI_2 };
        let triple = spaced(phase + rising / 3.0, TAU / 3.0, span);
        for (event, mut expected) in [level, double, triple].into_iter().enumerate() {
            expected.sort_by(f64::total_cmp);
            if !forwards {
                expected.reverse();
            }
            let events = motion.events().iter().filter(|found| found.event == event);
            let found: Vec<f64> = events.map(|found| found.t).collect();
            assert_eq!(found.len(), expected.len(), "{event} {phase} {c}");
            for (found, expected) in found.iter().zip(&expected) {
                let difference = (found - expected).abs();
                assert!(
                    difference < 1e-12,
                    "{event} {phase} {c}: {found} {expected}"
                );
            }
        }
        let steps = motion.statistics.steps;
        assert!(steps * 3 < motion.events().len() as u64, "{steps} steps");
    }
    let mut random = Random(5);
    for index in 0..16 {
        check(Taylor::new(), index % 2 == 0, &mut random);
        check(Taylor::<20>::of_half_order(), index % 2 == 1, &mut random);
    }
}

/// After a stop at one of the zeros of a step the run goes on to the next one; a reaction at a zero changes what follows.
#[test]
fn a_run_goes_on_behind_the_first_zero_of_a_step() {
    let mut random = Random(6);
    for _ in 0..8 {
        let phase = TAU * random.uniform();
        let oscillator = Oscillator { c: 0.5, d: 0.0 };
        let start = State::new(0.0, [f64::cos(phase)], [f64::sin(phase)]);
        let problem =
            || Problem::new(&oscillator, start).on([Oscillator::LEVEL, Oscillator::DOUBLE]);
        let whole = problem().record().solve(20.0, Taylor::new()).unwrap();
        let whole: Vec<f64> = whole.events().iter().map(|event| event.t).collect();
        let mut run = problem().stop().start(Taylor::new()).unwrap();
        let mut times = Vec::new();
        loop {
            let part = run.advance(20.0).unwrap();
            if part.reason == StopReason::Completed {
                break;
            }
            times.push(part.t);
        }
        assert_eq!(times.len(), whole.len(), "{phase}");
        for (t, expected) in times.iter().zip(&whole) {
            assert!((t - expected).abs() < 1e-12, "{phase}: {t} {expected}");
        }
        // A kick at the first zero sends the motion back.
        let mut kicks = 0;
        let kicked = problem()
            .then(|x| {
                kicks += 1;
                if kicks == 1 {
                    x.v[0] = -x.v[0];
                }
            })
            .solve(20.0, Taylor::new())
            .unwrap();
        let first = whole[0];
        let back = |t: f64| f64::cos(2.0 * first - t - phase);
        assert!((kicked.q[0] - back(20.0)).abs() < 1e-12, "{phase}");
    }
}

/// A driven pendulum, with functions that oscillate several times as fast as it.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(theta),
    kinetic = 0.5 * dot(theta).powi(2),
    potential = -g * cos(theta) - 0.5 * theta * cos(2.0 * t),
    event(
        wave = sin(k * theta + shift) - level,
        beat = cos(k * dot(theta)) - 0.3 * theta - level,
        product = sin(theta) * sin(0.5 * k * theta - t) - 0.4 * level,
    ),
)]
struct Driven<T: Scalar> {
    g: T,
    k: T,
    shift: T,
    level: T,
}

/// Returns the number of steps of a motion with these parameters and initial values, computed in this scalar, and the indices and
/// times of its events.
macro_rules! events {
    ($scalar:ty, $parameters:expr, $initial:expr) => {{
        let [g, k, shift, level] = $parameters.map(<$scalar>::from_f64);
        let ([theta, rate], end): ([f64; 2], f64) = $initial;
        let driven = Driven { g, k, shift, level };
        let [theta, rate] = [theta, rate].map(<$scalar>::from_f64);
        let motion = Problem::new(
            &driven,
            State::new(<$scalar>::from_f64(0.0), [theta], [rate]),
        )
        .on([Driven::<$scalar>::WAVE, Driven::<$scalar>::BEAT])
        .record()
        .on(Driven::<$scalar>::PRODUCT)
        .falling()
        .record()
        .solve(end, Taylor::new())
        .unwrap();
        let steps = motion.statistics.steps;
        let events = motion.events().iter();
        let events: Vec<(usize, f64)> = events
            .map(|found| (found.event, Scalar::smallest(found.t)))
            .collect();
        (steps, events)
    }};
}

/// Compares events with the events of the motion in double-doubles, where each step with a zero is searched for roots.
fn compare_with_search(motions: u32) {
    let mut random = Random(9);
    let mut between = |low: f64, high: f64| low + (high - low) * random.uniform();
    let [mut several, mut all] = [0_u64; 2];
    for index in 0..motions {
        let parameters = [
            between(0.5, 4.0),
            between(1.0, 9.0),
            between(0.0, TAU),
            between(-1.0, 1.0),
        ];
        let end = if index % 2 == 0 { 6.0 } else { -6.0 };
        let initial = ([between(-2.0, 2.0), between(-2.0, 2.0)], end);
        let (steps, found) = events!(f64, parameters, initial);
        let (_, expected) = events!(DoubleDouble, parameters, initial);
        assert_eq!(
            found.len(),
            expected.len(),
            "{index} {parameters:?} {initial:?}"
        );
        for ((event, t), (expected, at)) in found.iter().zip(&expected) {
            assert_eq!(event, expected, "{index} {parameters:?} {initial:?}");
            assert!((t - at).abs() < 1e-9, "{index}: {t} {at}");
        }
        several += (found.len() as u64).saturating_sub(steps);
        all += found.len() as u64;
    }
    assert!(several * 4 > all, "{several} of {all}");
}

#[test]
fn events_agree_with_a_search_in_double_doubles() {
    compare_with_search(4);
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn events_of_many_motions_agree_with_a_search_in_double_doubles() {
    compare_with_search(1000);
}

/// Events that occur together have the later of their times, at which both have occurred: the next run finds neither of them again.
#[test]
fn neighbouring_events_that_stop_a_run_occur_once() {
    let mut random = Random(7);
    for index in 0..200 {
        let phase = TAU * random.uniform();
        let oscillator = Oscillator {
            c: 0.9 * (2.0 * random.uniform() - 1.0),
            d: 10.0_f64.powf(-14.0 + 2.5 * random.uniform()),
        };
        let start = State::new(0.0, [f64::cos(phase)], [f64::sin(phase)]);
        let problem = || Problem::new(&oscillator, start).on([Oscillator::LEVEL, Oscillator::NEAR]);
        let mut run = problem().stop().start(Taylor::new()).unwrap();
        let mut counts = [0; 2];
        loop {
            let part = run.advance(20.0).unwrap();
            if part.reason == StopReason::Completed {
                break;
            }
            for event in part.met.indices() {
                counts[event] += 1;
            }
        }
        let turn = f64::acos(oscillator.c);
        let zeros = spaced(phase - turn, TAU, [0.0, 20.0]).len()
            + spaced(phase + turn, TAU, [0.0, 20.0]).len();
        assert_eq!(
            counts, [zeros; 2],
            "{index} {phase} {} {}",
            oscillator.c, oscillator.d
        );
    }
}
