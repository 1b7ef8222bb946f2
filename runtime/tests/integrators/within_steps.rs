//! Times within steps, at which polynomials are compared with the equations where a step may have missed a change.

use crate::common::assert_close;
use crate::members::{alone_and_together, number};
use lagrangian::prelude::*;

/// An oscillator of period 2π that is pushed for a short time, of which neither the series at the beginning of a step nor the
/// derivative at its end knows.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    potential = 0.5 * x.powi(2),
    force(x = exp(-((t - time) / width).powi(2))),
)]
struct Pushed {
    time: f64,
    width: f64,
}

/// Where a step was rejected because of a pulse, no later step passes over it. Most members begin in a lane while others are
/// under way.
#[test]
fn pulses_are_not_passed_over() {
    let members: Vec<_> = (0..30)
        .map(|index| Pushed {
            time: 0.7 + 1.5 * number(index),
            width: 0.02 + 0.05 * number(index + 1),
        })
        .collect();
    let start = |index| State::new(0.0, [number(index + 2)], [0.5]);
    let member = |index: usize| {
        let problem = Problem::new(&members[index], start(index));
        (problem, 5.0 + 5.0 * number(index + 3))
    };
    let together = alone_and_together(members.len(), member, Taylor::new());
    for (index, found) in together.into_iter().enumerate() {
        let found = found.unwrap();
        let (problem, end) = member(index);
        let in_short_steps = problem.solve(end, Taylor::new().max_step(0.02)).unwrap();
        let error = (found.q[0] - in_short_steps.q[0]).abs();
        assert!(error < 1e-12, "{index}: {error}");
        assert!(found.statistics.rejected > 0, "{index}");
    }
}

/// A force that jumps where the position changes its sign.
#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), force(x = -signum(x)))]
struct Relay;

/// Backwards in time, too, a step to a discontinuity surface is accepted at once.
#[test]
fn steps_to_surfaces_are_not_rejected() {
    let ends = [-10.0, 10.0, -7.0, 7.0, -3.0];
    let member = |index: usize| {
        let start = State::new(0.0, [1.0 + 0.1 * number(index)], [0.0]);
        (Problem::new(&Relay, start), ends[index])
    };
    for found in alone_and_together(ends.len(), member, Taylor::new()) {
        let statistics = found.unwrap().statistics;
        assert!(statistics.rejected <= statistics.steps, "{statistics:?}");
    }
}

/// An oscillator under a force that is nearly a square wave.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    potential = 0.5 * x.powi(2),
    force(x = tanh(steepness * sin(3.0 * t))),
)]
struct Switched {
    steepness: f64,
}

/// While steps grow after a change of the force, they do not pass over two others.
#[test]
fn changes_of_sign_are_not_passed_over() {
    for steepness in [10.0, 100.0, 1000.0] {
        let model = Switched { steepness };
        let problem = || Problem::new(&model, State::new(0.0, [1.0], [0.0]));
        let in_short_steps = problem()
            .solve(10.0, Taylor::new().max_step(0.003))
            .unwrap();
        let found = problem().solve(10.0, Taylor::new()).unwrap();
        assert_close(found.q[0], in_short_steps.q[0], 1e-13);
        let method = Taylor::order_16()
            .relative_tolerance(1e-9)
            .absolute_tolerance(1e-9);
        let member = |_| (problem(), 10.0);
        for found in alone_and_together(5, member, method) {
            assert_close(found.unwrap().q[0], in_short_steps.q[0], 2e-8);
        }
    }
}

#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(theta), kinetic = 0.5 * dot(theta).powi(2), potential = -cos(theta))]
struct Pendulum;

/// Advances a pendulum to these times; returns the steps and the evaluations of the equations.
fn advanced(times: impl IntoIterator<Item = f64>) -> (u64, u64) {
    let start = State::new(0.0, [1.0], [0.0]);
    let mut run = Problem::new(&Pendulum, start).start(Taylor::new()).unwrap();
    for time in times {
        run.advance(time).unwrap();
    }
    let statistics = run.statistics();
    (statistics.steps, statistics.evaluations)
}

/// In a loop of short steps the equations are evaluated once at the start, at sixteen times within the first step, and at the
/// beginning and the end of each.
#[test]
fn steps_that_land_are_evaluated_twice() {
    let (steps, evaluations) = advanced((1..=500).map(|i| 0.01 * f64::from(i)));
    assert_eq!((steps, evaluations), (500, 2 * 500 + 17));
}

/// A step is not long because the one before it landed.
#[test]
fn a_step_after_one_that_lands_is_not_long() {
    let (steps, evaluations) = advanced((1..=20).flat_map(|i| [f64::from(i), f64::from(i) + 1e-3]));
    assert!(steps > 40, "{steps}");
    assert!(evaluations < 2 * steps + 17, "{steps} {evaluations}");
}
