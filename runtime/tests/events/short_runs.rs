//! Runs of some roundings of the time, one after the other, of which the last ends at an event or next to it.
#![allow(clippy::unreadable_literal)] // Numbers of generated motions.

use crate::directions::{Direction, EVERY, directed};
use lagrangian::EquationsOfMotion;
use lagrangian::prelude::*;

/// An oscillator beside a clock.
#[derive(Lagrangian, Clone, Copy, Debug)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    potential = 0.5 * k * x.powi(2),
    event(cube = t.powi(3) - 5, early = t - 0.37, both = (t - 1) * (t - 2.5), pair = (t - 1).powi(2) - 1e-10, wave = sin(1.7 * t)),
)]
struct Oscillator {
    k: f64,
}

/// The times of an event in runs that end at these times.
fn seen<I>(
    method: I,
    start: State<f64, 1>,
    times: &[f64],
    direction: Direction,
    declared: bool,
) -> Vec<f64>
where
    I: Copy + for<'a> Integrator<f64, EquationsOfMotion<&'a Oscillator, f64, 1>>,
{
    let model = Oscillator { k: 1.0 };
    let (mut last, mut seen) = (start, Vec::new());
    for &time in times {
        let problem = Problem::new(&model, last);
        let motion = if declared {
            let cube = directed!(direction, problem.on(Oscillator::CUBE));
            cube.record().solve(time, method)
        } else {
            let cube = directed!(direction, problem.when(|x| [x.t.powi(3) - 5.0]));
            cube.record().solve(time, method)
        };
        let motion = motion.unwrap();
        seen.extend(motion.events().iter().map(|event| event.t));
        last = motion.last;
    }
    seen
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn runs_of_some_roundings_report_an_event_once() {
    report_an_event_once(2, 3);
}

#[test]
fn some_runs_of_some_roundings_report_an_event_once() {
    report_an_event_once(6, 5);
}

/// Runs that begin at one rounding of so many, and end at one of so many.
fn report_an_event_once(begins: usize, ends: usize) {
    let zero = 5.0_f64.cbrt();
    let near = |ulps: i64| f64::from_bits(zero.to_bits().wrapping_add_signed(ulps));
    let start = State::new(0.2, [0.3], [0.4]);
    for direction in EVERY {
        let count = usize::from(direction != Direction::Falling);
        for from in (-13..=11).step_by(begins) {
            for to in (from + 1..=13).step_by(ends) {
                let times = [near(from), near(to), 2.5];
                for declared in [true, false] {
                    let found = [
                        seen(Taylor::new(), start, &times, direction, declared),
                        seen(Dop853::new(), start, &times, direction, declared),
                        seen(
                            RungeKutta::classical(0.2),
                            start,
                            &times,
                            direction,
                            declared,
                        ),
                    ];
                    for times in found {
                        assert_eq!(
                            times.len(),
                            count,
                            "{direction:?} from {from} to {to}: {times:?}"
                        );
                    }
                }
            }
        }
    }
}

/// sin 2x is zero at both ends of a half period of x = π/2 · cos t, and in the middle.
#[test]
fn a_periodic_function_is_not_zero_between_its_zeros() {
    let quarter = core::f64::consts::FRAC_PI_2;
    let model = Oscillator { k: 1.0 };
    let start = State::new(0.0, [quarter - 1e-9], [0.5]);
    let run = |start: State<f64, 1>, end| {
        let wave = Problem::new(&model, start).when(|x| [(2.0 * x.q[0]).sin()]);
        wave.record().solve(end, Taylor::new()).unwrap()
    };
    let whole = run(start, 4.0);
    assert!(whole.events().len() >= 3);
    for event in whole.events() {
        for ulps in 0..9 {
            let end = f64::from_bits(event.t.to_bits() + ulps - 4);
            let first = run(start, end);
            let second = run(first.last, 4.0);
            let count = first.events().len() + second.events().len();
            assert_eq!(count, whole.events().len(), "{end:e}");
        }
    }
}

/// The sign before a rising zero is not the one before the falling zero on the way to it.
#[test]
fn an_event_is_not_reported_where_another_one_occurs() {
    let model = Oscillator { k: 1.0 };
    let motion = Problem::new(&model, State::new(-0.1, [0.2], [0.0]))
        .on(Oscillator::EARLY)
        .record()
        .on(Oscillator::BOTH)
        .rising()
        .record()
        .solve(3.2, Taylor::new())
        .unwrap();
    let found: Vec<usize> = motion.events().iter().map(|event| event.event).collect();
    assert_eq!(found, [0, 1]);
    assert!((motion.events()[1].t - 2.5).abs() < 1e-12);
}

/// Both zeros of a pair, each watched for in its direction.
#[test]
fn the_directions_of_a_pair_are_told_apart() {
    let model = Oscillator { k: 1.0 };
    let motion = Problem::new(&model, State::new(-0.1, [0.2], [0.0]))
        .on(Oscillator::PAIR)
        .rising()
        .record()
        .on(Oscillator::PAIR)
        .falling()
        .record()
        .solve(3.2, Taylor::new())
        .unwrap();
    let found = motion.events().iter().map(|event| (event.event, event.t));
    let found: Vec<(usize, f64)> = found.collect();
    assert_eq!(found.len(), 2);
    for ((event, time), expected) in found.iter().zip([(1, 1.0 - 1e-5), (0, 1.0 + 1e-5)]) {
        assert!(
            *event == expected.0 && (time - expected.1).abs() < 1e-9,
            "{found:?}"
        );
    }
}

/// Reactions to one direction, watched for beside the other one.
#[test]
fn a_reaction_leaves_no_event_in_the_other_direction() {
    let zero = 5.0_f64.cbrt();
    let near = |ulps: i64| f64::from_bits(zero.to_bits().wrapping_add_signed(ulps));
    for from in -13..=0 {
        for to in 1..=13 {
            let model = Oscillator { k: 1.0 };
            let mut last = State::new(0.2_f64, [0.3], [0.4]);
            let [mut seen, mut opposite] = [0; 2];
            for time in [near(from), near(to), 2.5] {
                // The method begins anew at each event.
                let problem = Problem::new(&model, last)
                    .when(|x| x.t.powi(3) - 5.0)
                    .falling()
                    .then_with(|_, _| opposite += 1)
                    .when(|x| x.t.powi(3) - 5.0)
                    .rising()
                    .then_with(|_, _| seen += 1);
                last = problem.solve(time, Dop853::new()).unwrap().last;
            }
            assert_eq!([opposite, seen], [0, 1], "from {from} to {to}");
        }
    }
}

/// Both directions of one function, in runs that stop at each event.
#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn where_a_run_stops_its_event_is_not_one_of_the_other_direction() {
    stop_around_a_zero(Taylor::new(), 1);
    stop_around_a_zero(Dop853::new(), 1);
    stop_around_a_zero(RungeKutta::classical(0.2), 1);
}

#[test]
fn where_some_runs_stop_their_event_is_not_one_of_the_other_direction() {
    stop_around_a_zero(Taylor::new(), 4);
    stop_around_a_zero(Dop853::new(), 4);
    stop_around_a_zero(RungeKutta::classical(0.2), 4);
}

/// Runs that end at one rounding of so many.
fn stop_around_a_zero<I>(method: I, stride: usize)
where
    I: Copy + for<'a> Integrator<f64, EquationsOfMotion<&'a Oscillator, f64, 1>>,
{
    let zero = 5.0_f64.cbrt();
    let near = |ulps: i64| f64::from_bits(zero.to_bits().wrapping_add_signed(ulps));
    let model = Oscillator { k: 1.0 };
    for from in -13..=0 {
        for to in (1..=13).step_by(stride) {
            let (mut last, mut seen) = (State::new(0.2, [0.3], [0.4]), Vec::new());
            for time in [near(from), near(to), 2.5] {
                while last.t < time {
                    let motion = Problem::new(&model, last)
                        .on(Oscillator::CUBE)
                        .falling()
                        .stop()
                        .on(Oscillator::CUBE)
                        .rising()
                        .stop()
                        .solve(time, method)
                        .unwrap();
                    seen.extend(motion.met.indices());
                    last = motion.last;
                }
            }
            assert_eq!(seen, [1], "from {from} to {to}");
        }
    }
}

/// A run in progress that is advanced by some roundings, to a zero.
#[test]
fn an_advance_of_some_roundings_to_a_zero_has_its_event() {
    let model = Oscillator { k: 1.0 };
    let start = State::new(0.2, [0.3], [0.4]);
    let method = Dop853::new().max_step(0.5);
    for direction in [Direction::Falling, Direction::Either] {
        let wave = Problem::new(&model, start).when(|x| [(3.0 * x.t).cos() - 0.12751145782990958]);
        let problem = directed!(direction, wave).record();
        let whole = problem.clone().solve(7.0, method).unwrap();
        for time in whole.events().iter().map(|event| event.t) {
            for from in [-33, -10, -5, -1, 0] {
                for to in (from + 1..=3).step_by(4) {
                    let near =
                        |ulps: i64| f64::from_bits(f64::to_bits(time).wrapping_add_signed(ulps));
                    let mut running = problem.clone().start(method).unwrap();
                    let parts = [near(from), near(to), 7.0];
                    let parts = parts.map(|end| running.advance(end).unwrap().events().len());
                    let seen: usize = parts.iter().sum();
                    assert_eq!(seen, whole.events().len(), "{time} from {from} to {to}");
                }
            }
        }
    }
}

/// At the time 0, where rounding is exact.
#[test]
fn a_zero_at_the_time_zero_is_an_event_in_one_direction() {
    let model = Oscillator { k: 1.0 };
    for begin in (0..100).map(|k| 0.1 + 0.0137 * f64::from(k)) {
        let (mut last, mut seen) = (State::new(begin, [0.3], [0.4]), Vec::new());
        while last.t > -1.0 {
            let motion = Problem::new(&model, last)
                .on(Oscillator::WAVE)
                .falling()
                .stop()
                .on(Oscillator::WAVE)
                .rising()
                .stop()
                .solve(-1.0, Taylor::new())
                .unwrap();
            seen.extend(motion.met.indices());
            last = motion.last;
        }
        assert_eq!(seen, [0], "from {begin}");
    }
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn a_resumed_run_does_not_repeat_the_event_at_its_beginning() {
    no_event_is_repeated(1);
}

#[test]
fn some_resumed_runs_do_not_repeat_the_event_at_their_beginning() {
    no_event_is_repeated(4);
}

/// A function whose own rounding exceeds what it changes by in a short run, which ends at one rounding of so many.
fn no_event_is_repeated(stride: usize) {
    let model = Pendulum {};
    let start = State::new(0.0, [-1.0474877091787331], [0.8359583815790192]);
    let problem = Problem::new(&model, start)
        .on(Pendulum::GROWTH)
        .rising()
        .record()
        .on(Pendulum::GROWTH)
        .falling()
        .record();
    let whole = problem.clone().solve(4.0, Taylor::new()).unwrap();
    let times: Vec<f64> = whole.events().iter().map(|event| event.t).collect();
    assert!(times.len() > 1);
    for time in times {
        for from in -9..=1 {
            for to in (from + 1..=9).step_by(stride) {
                let near = |ulps: i64| f64::from_bits(time.to_bits().wrapping_add_signed(ulps));
                let mut seen = 0;
                let mut checkpoint = None;
                for end in [near(from), near(to), 4.0] {
                    let problem = problem.clone();
                    let mut running = match checkpoint.take() {
                        Some(checkpoint) => problem.resume(checkpoint, Taylor::new()).unwrap(),
                        None => problem.start(Taylor::new()).unwrap(),
                    };
                    seen += running.advance(end).unwrap().events().len();
                    checkpoint = Some(running.checkpoint());
                }
                assert_eq!(seen, whole.events().len(), "{time} from {from} to {to}");
            }
        }
    }
}

/// A pendulum.
#[derive(Lagrangian, Clone, Copy, Debug)]
#[lagrangian(
    taylor,
    coordinates(theta),
    kinetic = 0.5 * dot(theta).powi(2),
    potential = -1.5 * cos(theta),
    event(growth = exp(theta) - 1.2),
)]
struct Pendulum {}

/// No step is so short that the time does not change.
#[test]
fn a_short_run_is_one_step() {
    let model = Oscillator { k: 1.0 };
    for (t, ulps) in [(0.3_f64, 1), (0.3, 7), (1e3, 3), (-1e-5, 9)] {
        let end = f64::from_bits(t.to_bits() + ulps);
        let start = State::new(t, [0.3], [0.4]);
        let motion = Problem::new(&model, start).solve(end, Dop853::new());
        assert_eq!(motion.unwrap().statistics.steps, 1, "{ulps} from {t}");
    }
}
