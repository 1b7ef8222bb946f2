//! Ensembles: lanes with steps of their own, against single motions and closed forms.

use crate::common::{assert_close, in_lanes};
use lagrangian::prelude::*;
use lagrangian::{Lanes, TaylorLanes};
use nalgebra::SVector;

#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(theta),
    kinetic = 0.5 * (l * dot(theta)).powi(2),
    potential = -g * l * cos(theta),
)]
struct Pendulum<T: Scalar> {
    l: T,
    g: f64,
}

/// Without parameters, so that it is one model on all scalars.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(alpha, beta),
    define(
        p = [sin(alpha), -cos(alpha)],
        r = p + [sin(beta), -cos(beta)],
    ),
    kinetic = 0.5 * (dot(p).norm_squared() + dot(r).norm_squared()),
    potential = 9.81 * (p.y + r.y),
)]
struct DoublePendulum;

#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), force(x = -rate.powi(2) * x + push * sin(2.0 * t)))]
struct Driven {
    rate: f64,
    push: f64,
}

/// A force with a corner at x = 0.
#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), potential = abs(x))]
struct Valley;

/// Thirty motions of different lengths, forwards and backwards, from different times.
fn motions() -> Vec<(State<f64, 2>, f64)> {
    some_motions(30)
}

fn some_motions(count: u8) -> Vec<(State<f64, 2>, f64)> {
    let numbers = (0..count).map(|i| 0.37 * f64::from(i));
    let motion = |s: f64| {
        let start = State::new(s, [2.0 * s.sin(), 1.5 * (3.0 * s).cos()], [s.cos(), 0.2]);
        (start, s + 4.0 * (1.7 * s).sin())
    };
    numbers.map(motion).collect()
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn a_motion_has_the_bits_that_it_has_alone() {
    together_and_alone(&motions());
    the_order_does_not_matter(&motions());
    lanes_and_single_motions(&motions());
}

/// More than there are lanes, in both directions of time.
#[test]
fn some_motions_have_the_bits_that_they_have_alone() {
    together_and_alone(&some_motions(12));
}

fn together_and_alone(motions: &[(State<f64, 2>, f64)]) {
    let method = Taylor::new();
    let together = in_lanes::<8, _, _>(method, &DoublePendulum.dynamics(), motions.iter().copied());
    assert_eq!(together.len(), motions.len());
    for (found, &(start, end)) in together.iter().zip(motions) {
        let found = found.as_ref().unwrap();
        let alone = in_lanes::<2, _, _>(method, &DoublePendulum.dynamics(), [(start, end)]);
        assert_eq!(found, alone[0].as_ref().unwrap());
        assert_eq!(found.reason, StopReason::Completed);
        assert_eq!(found.last.t.to_bits(), end.to_bits());
    }
}

#[test]
fn the_order_of_the_motions_does_not_matter() {
    the_order_does_not_matter(&some_motions(12));
}

fn the_order_does_not_matter(motions: &[(State<f64, 2>, f64)]) {
    let motions = motions.iter().copied();
    let dynamics = DoublePendulum.dynamics();
    let forwards = in_lanes::<4, _, _>(Taylor::order_16(), &dynamics, motions.clone());
    let mut backwards = in_lanes::<4, _, _>(Taylor::order_16(), &dynamics, motions.rev());
    backwards.reverse();
    assert_eq!(forwards, backwards);
}

#[test]
fn lanes_take_the_steps_of_single_motions() {
    lanes_and_single_motions(&some_motions(12));
}

fn lanes_and_single_motions(motions: &[(State<f64, 2>, f64)]) {
    let method = Taylor::new();
    let together = in_lanes::<8, _, _>(method, &DoublePendulum.dynamics(), motions.iter().copied());
    for (found, &(start, end)) in together.iter().zip(motions) {
        let found = found.as_ref().unwrap();
        let alone = Problem::new(&DoublePendulum, start)
            .solve(end, method)
            .unwrap();
        for i in 0..2 {
            assert_close(found.last.x.q[i], alone.q[i], 1e-11);
            assert_close(found.last.x.v[i], alone.v[i], 1e-11);
        }
        let steps = [found.statistics.steps, alone.statistics.steps];
        assert!(steps[0].abs_diff(steps[1]) <= 1, "{steps:?}");
    }
}

/// x = a cos ωt + b sin ωt + sin 2t/(ω² − 4) from x = 1, ẋ = 0: the lanes have different times, too.
#[test]
fn parameters_initial_times_and_ends_are_those_of_the_motion() {
    let number = |i: usize| 0.1 * f64::from(u8::try_from(i).unwrap());
    let members = (0..50).map(number).map(|s| {
        let driven = Driven {
            rate: 2.5 + s,
            push: 1.0 + s,
        };
        Problem::new(driven, State::new(-s, [1.0], [0.0]))
    });
    let ends = Ensemble::new(members).solve(|i: usize| 10.0 - number(i), Taylor::new());
    for (i, end) in ends.into_iter().enumerate() {
        let (s, end) = (number(i), end.unwrap().last);
        let (rate, push) = (2.5 + s, 1.0 + s);
        let share = push / (rate * rate - 4.0);
        let forced = |t: f64| [share * (2.0 * t).sin(), 2.0 * share * (2.0 * t).cos()];
        let from = forced(-s);
        let free = [1.0 - from[0], -from[1] / rate];
        let (sine, cosine) = (rate * 10.0).sin_cos();
        let expected = free[0] * cosine + free[1] * sine + forced(10.0 - s)[0];
        assert!((end.x.q[0] - expected).abs() < 2e-13 * (1.0 + share), "{i}");
    }
}

#[test]
fn corners_shorten_the_steps_of_their_lane_alone() {
    let motions = [1.0, 2.0, 3.0, 4.0].map(|x: f64| {
        let quarter = (2.0 * x).sqrt();
        (State::new(0.0, [x], [0.0]), 2.0 * quarter)
    });
    let found = in_lanes::<4, _, _>(Taylor::new(), &Valley.dynamics(), motions);
    for (x, result) in [1.0, 2.0, 3.0, 4.0].into_iter().zip(found) {
        let outcome = result.unwrap();
        assert!((outcome.last.x.q[0] + x).abs() < 1e-9);
        // The corner ends a step, and rejects none.
        assert!(outcome.statistics.steps >= 2 && outcome.statistics.rejected == 0);
        let start = State::new(0.0, [x], [0.0]);
        let end = 2.0 * (2.0 * x).sqrt();
        let alone = in_lanes::<1, _, _>(Taylor::new(), &Valley.dynamics(), [(start, end)]);
        assert_eq!(&outcome, alone[0].as_ref().unwrap());
    }
}

#[test]
fn limits_and_settings_are_errors_of_each_motion() {
    let motions = || motions().into_iter().take(5);
    let dynamics = DoublePendulum.dynamics();
    let problems = || motions().map(|(start, _)| Problem::new(&dynamics, start));
    let ends: Vec<f64> = motions().map(|(_, end)| end).collect();
    let ends = |index: usize| ends[index];
    let limited = Ensemble::new(problems().map(|problem| problem.max_steps(2)));
    let limited = limited.lanes::<2>().solve(ends, Taylor::new());
    for (result, (start, end)) in limited.into_iter().zip(motions()) {
        let outcome = result.unwrap();
        let last = outcome.last.t;
        assert!(outcome.statistics.steps + outcome.statistics.rejected <= 2);
        match outcome.reason {
            StopReason::Completed => assert_eq!(last.to_bits(), end.to_bits()),
            reason => {
                assert_eq!(reason, StopReason::StepLimit);
                assert!((last - start.t).abs() < (end - start.t).abs());
            }
        }
    }
    for tolerance in [0.0, f64::NAN, -1.0] {
        let invalid = problems().map(|problem| problem.singularity_tolerance(tolerance));
        let results = Ensemble::new(invalid).solve(ends, Taylor::new());
        assert_eq!(results.len(), 5);
        assert!(results.into_iter().all(|result| matches!(
            result.unwrap_err().error(),
            IntegrationError::InvalidSingularityTolerance { .. }
        )));
        let method = Taylor::new().relative_tolerance(tolerance);
        let results = in_lanes::<2, _, _>(method, &dynamics, motions());
        assert_eq!(results.len(), 5);
        assert!(
            results
                .iter()
                .all(|result| matches!(result, Err(IntegrationError::InvalidTolerance { .. })))
        );
    }
    for end in [f64::NAN, f64::INFINITY] {
        let to_end = motions().map(|(start, _)| (start, end));
        let results = in_lanes::<2, _, _>(Taylor::new(), &dynamics, to_end);
        assert!(
            results
                .iter()
                .all(|result| matches!(result, Err(IntegrationError::NonFiniteTime { .. })))
        );
    }
    let nothing = in_lanes::<2, _, _>(Taylor::new(), &dynamics, []);
    assert!(nothing.is_empty());
    let resting = motions().map(|(start, _)| (start, start.t));
    let still = in_lanes::<2, _, _>(Taylor::new(), &dynamics, resting);
    for (result, (start, _)) in still.into_iter().zip(motions()) {
        assert_eq!(result.unwrap().last, start);
    }
}

#[test]
fn dense_output_of_each_lane_is_within_its_step() {
    let lengths = [0.5, 1.0, 2.0, 4.0];
    let pendulums = Pendulum {
        l: Lanes(lengths),
        g: 1.0,
    };
    let dynamics = pendulums.dynamics();
    let small = 1e-6;
    let start = Phase::new([small], [0.0]);
    let mut stepper = TaylorLanes::new(Taylor::new(), 0.0, &start);
    for _ in 0..5 {
        stepper.step(&dynamics, &[100.0; 4]);
        let middle = core::array::from_fn(|lane| {
            0.3 * stepper.previous_time(lane) + 0.7 * stepper.time(lane)
        });
        let states = stepper.interpolate(&middle);
        for lane in 0..4 {
            // A swing so small has the period of the linear equation, up to its square.
            let expected = small * (middle[lane] / lengths[lane].sqrt()).cos();
            assert!((states.q[0].lane(lane) - expected).abs() < 1e-16);
        }
    }
    let times: [f64; 4] = core::array::from_fn(|lane| stepper.time(lane));
    assert!(times[3] > 1.5 * times[0], "{times:?}");
}

/// Dynamics by hand, whose state is a vector.
#[test]
fn systems_that_are_no_models_have_ensembles() {
    use crate::common::Oscillator;

    let starts = (0..9).map(|i| (At::from((0.0, SVector::from([f64::from(i), 0.0]))), 2.0));
    let found = in_lanes::<4, _, _>(Taylor::new(), &Oscillator, starts);
    for (i, result) in (0..9).zip(found) {
        assert_close(
            result.unwrap().last.x[0],
            f64::from(i) * 2.0_f64.cos(),
            1e-14,
        );
    }
}
