//! Jumps beside jumps and corners: at once, one within another, in lanes, and resumed.

use crate::common::in_lanes;
use lagrangian::prelude::*;

/// Two waves whose jumps coincide at each second one, a relay beside them, and a corner.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x, y),
    kinetic = 0.5 * (dot(x).powi(2) + dot(y).powi(2)),
    potential = 0.5 * x.powi(2) + 0.5 * y.powi(2) + 2.0 * max(x - y - 0.4, 0.0).powi(2),
    force(x = signum(sin(t)) - 0.5 * signum(sin(2.0 * t)) + 0.3 * signum(x - 0.2), y = 0.2 * signum(sin(t) + 0.5 * signum(x))),
)]
struct Several;

/// Jumps that coincide, that depend on jumps, and corners beside them: the same as by small steps of another method between.
#[test]
fn jumps_together_with_corners() {
    let start = State::new(0.1, [0.5, 0.1], [0.2, -0.3]);
    let found = Problem::new(&Several, start)
        .solve(30.0, Taylor::new())
        .unwrap();
    let precise = Dop853::new()
        .relative_tolerance(1e-14)
        .absolute_tolerance(1e-14);
    let expected = Problem::new(&Several, start).solve(30.0, precise).unwrap();
    assert!(
        (found.q - expected.q).norm() < 1e-9,
        "{} {}",
        found.q,
        expected.q
    );
    let back = Problem::new(&Several, found.last)
        .solve(0.1, Taylor::new())
        .unwrap();
    assert!((back.q - start.q).norm() < 1e-9, "{}", back.q);
}

/// A jump in a coupling of six coordinates, between which relays act.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x[6]),
    kinetic = (0..6).map(|i| 0.5 * dot(x[i]).powi(2)).sum(),
    potential = (0..6).map(|i| 0.5 * x[i].powi(2)).sum() + (0..5).map(|i| 0.1 * abs(x[i + 1] - x[i])).sum(),
)]
struct Chain6;

#[test]
fn six_coordinates_conserve_energy() {
    let start = State::new(
        0.0,
        [0.3, -0.2, 0.9, 0.1, -0.5, 0.4],
        [0.1, 0.5, -0.3, 0.2, 0.7, -0.9],
    );
    let end = Problem::new(&Chain6, start)
        .solve(50.0, Taylor::new())
        .unwrap();
    let drift = Chain6.energy(&end) - Chain6.energy(&start);
    assert!(drift.abs() < 1e-12, "{drift:e}");
}

/// In lanes, each with jumps of its own, to the last bit as alone.
#[test]
fn jumps_in_lanes() {
    let starts = (0..11).map(|i| {
        let i = f64::from(i);
        (
            State::new(0.1 * i, [0.5 - 0.03 * i, 0.1], [0.2, -0.3 + 0.05 * i]),
            12.0 - i,
        )
    });
    let ends = in_lanes::<4, _, _>(Taylor::new(), &Several.dynamics(), starts.clone());
    for (end, (start, t)) in ends.into_iter().zip(starts) {
        let alone = Problem::new(&Several, start)
            .solve(t, Taylor::new())
            .unwrap();
        assert_eq!(end.unwrap().last, alone.last);
    }
}

/// Stored and resumed anywhere, to the last bit.
#[test]
fn checkpoints_between_jumps() {
    let problem = Problem::new(&Several, State::new(0.1, [0.5, 0.1], [0.2, -0.3]));
    let mut whole = problem.clone().start(Taylor::new()).unwrap();
    whole.advance(25.0).unwrap();
    let problem = problem.max_steps(1);
    let mut parts = problem.clone().start(Taylor::new()).unwrap();
    while parts.advance(25.0).unwrap().reason == StopReason::StepLimit {
        let checkpoint = parts.checkpoint();
        parts = problem.clone().resume(checkpoint, Taylor::new()).unwrap();
    }
    assert_eq!(parts.state(), whole.state());
}

/// Switching functions on which others depend: without an end of the step where x changes its sign, the series of the outer one
/// would be that of the branch before.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    potential = 8.0 * max(abs(x) - 1.0, 0.0).powi(2),
    force(x = 0.25 * signum(sin(3.0 * t) + 0.5 * signum(x))),
)]
struct Nested;

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn nested_jumps_are_those_of_their_branches() {
    follow_nested_jumps(1);
}

#[test]
fn some_nested_jumps_are_those_of_their_branches() {
    follow_nested_jumps(9);
}

/// Compares motions from one start of so many with those by small steps of another method.
fn follow_nested_jumps(stride: usize) {
    // Longer steps pass over short times between jumps.
    let precise = Dop853::new()
        .relative_tolerance(1e-13)
        .absolute_tolerance(1e-13)
        .max_step(0.01);
    for i in (0..24).step_by(stride) {
        let i = f64::from(i);
        let start = State::new(0.3 * i, [0.9 - 0.07 * i], [0.5 + 0.1 * i]);
        let end = start.t + 5.0 + 0.37 * i;
        let found = Problem::new(&Nested, start)
            .solve(end, Taylor::new())
            .unwrap();
        let expected = Problem::new(&Nested, start).solve(end, precise).unwrap();
        assert!(
            (found.q - expected.q).norm() < 1e-8,
            "{i}: {} {}",
            found.q,
            expected.q
        );
    }
}

/// Forces that are continuous at a surface, but have no series on one side of it: those of Hertz and of Torricelli.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    potential = 0.5 * x.powi(2) + 40.0 * max(-x, 0.0).powf(2.5),
    force(x = -0.3 * sqrt(max(x - 0.5, 0.0))),
)]
struct Hertz;

#[test]
fn singular_series_behind_a_corner() {
    let precise = Dop853::new()
        .relative_tolerance(1e-14)
        .absolute_tolerance(1e-14);
    let start = State::new(0.0, [1.0], [0.0]);
    let found = Problem::new(&Hertz, start)
        .max_steps(1000)
        .solve(12.0, Taylor::new())
        .unwrap();
    assert_eq!(
        found.reason,
        StopReason::Completed,
        "{:?}",
        found.statistics
    );
    let expected = Problem::new(&Hertz, start).solve(12.0, precise).unwrap();
    assert!((found.q - expected.q).norm() < 1e-9);
}
