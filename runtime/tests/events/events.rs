//! Events, under every method.

use core::f64::consts::PI;
use core::ops::ControlFlow;
use std::cell::RefCell;

use crate::common::{Oscillator, assert_close, equation};
use crate::event_models::{PENDULUM, period, times, under_each_method};
use lagrangian::prelude::*;
use nalgebra::SVector;

type Vector<const N: usize> = SVector<f64, N>;

/// Zeros and turning points, in both directions of time: every quarter of the period.
#[test]
fn a_pendulum_passes_its_lowest_point_twice_in_a_period() {
    let quarter = 0.25 * period(&PENDULUM, 2.0);
    under_each_method!(|method, error| {
        for end in [20.5 * quarter, -20.5 * quarter] {
            let start = State::new(0.0, [2.0], [0.0]);
            let motion = Problem::new(&PENDULUM, start)
                .when(|x| x.q[0])
                .rising()
                .record()
                .when(|x| x.q[0])
                .falling()
                .record()
                .when(|x| x.v[0])
                .record()
                .solve(end, method)
                .unwrap();
            assert_eq!(motion.reason, StopReason::Completed);
            for (event, first, apart) in [(0, 3.0, 4.0), (1, 1.0, 4.0), (2, 2.0, 2.0)] {
                let found = times(motion.events(), event);
                assert_eq!(found.len(), if event == 2 { 10 } else { 5 });
                for (n, time) in (0..).map(f64::from).zip(found) {
                    let expected = (first + n * apart) * quarter;
                    assert_close(time, expected.copysign(end), error * 40.0);
                }
            }
            let in_order = |a: &Occurrence<_>, b: &Occurrence<_>| a.t.abs() <= b.t.abs();
            assert!(motion.events().is_sorted_by(in_order));
        }
    });
}

/// Walls that are reached at the same time, in the order in which they are declared.
#[test]
fn simultaneous_events_come_in_their_order() {
    let free = equation::<2, _>(|_, _| SVector::from([-1.0, -1.0]));
    let start = At::from((0.0, SVector::from([2.0, 2.0])));
    let seen = RefCell::new(Vec::new());
    let react = |event| {
        let seen = &seen;
        move |x: &mut At<f64, Vector<2>>| {
            seen.borrow_mut().push((event, x.t));
            x[0] -= 1.0;
        }
    };
    let motion = Problem::new(&free, start)
        .when(|x| x[1])
        .falling()
        .then(react(0))
        .when(|x| x[0] + 0.5)
        .falling()
        .then(react(1))
        .when(|x| x[0])
        .falling()
        .then(react(2))
        .solve(5.0, Dop853::new())
        .unwrap();
    let seen = seen.take();
    let order: Vec<usize> = seen.iter().map(|(event, _)| *event).collect();
    assert_eq!(order, [0, 2]);
    assert_eq!(seen[0].1.to_bits(), seen[1].1.to_bits());
    assert_close(seen[0].1, 2.0, 1e-14);
    // Two reactions have acted on one state.
    assert_close(motion[0], 2.0 - 5.0 - 2.0, 1e-13);
}

/// A terminal event ends the integration, others do not; an observer sees both, and may stop it.
#[test]
fn events_are_observed_and_some_are_terminal() {
    let start = At::from((0.0, SVector::from([1.0, 0.0])));
    let problem = Problem::new(&Oscillator, start)
        .when(|x| x[0])
        .record()
        .when(|x| 7.0 - x.t)
        .falling()
        .stop();
    let mut seen = Vec::new();
    let motion = problem
        .clone()
        .each_step(|progress| seen.push((progress.t, progress.kind)))
        .save([2.0, 6.9, 7.1])
        .solve(7.1, Dop853::new())
        .unwrap();
    assert_eq!(motion.reason, StopReason::Condition);
    assert!(motion.met.contains(1) && !motion.met.contains(0));
    assert_eq!(
        [0, 1].map(|event| times(motion.events(), event).len()),
        [2, 1]
    );
    assert_close(motion.t, 7.0, 1e-14);
    assert!(seen.is_sorted_by(|a, b| a.0 <= b.0), "{seen:?}");
    let events = seen.iter().filter_map(|(t, kind)| match kind {
        ObservationKind::Event(event) => Some((*event, *t)),
        _ => None,
    });
    let events: Vec<(usize, f64)> = events.collect();
    let expected = [(0, 0.5 * PI), (0, 1.5 * PI), (1, 7.0)];
    assert_eq!(events.len(), 3);
    for (found, expected) in events.into_iter().zip(expected) {
        assert_eq!(found.0, expected.0);
        assert_close(found.1, expected.1, 1e-8);
    }
    let stopping = problem.each_step(|progress| match progress.kind {
        ObservationKind::Event(0) => ControlFlow::Break(()),
        _ => ControlFlow::Continue(()),
    });
    let motion = stopping.solve(9.0, Dop853::new()).unwrap();
    assert_eq!(motion.reason, StopReason::Observer);
    assert_close(motion.t, 0.5 * PI, 1e-8);
}

/// A relay with hysteresis: a mass goes to and fro between two thresholds at unit velocity.
#[test]
fn a_relay_switches_the_dynamics() {
    struct Relay {
        push: f64,
    }
    impl Dynamics for Relay {
        type State = Vector<1>;

        fn derivative(&self, _: f64, _: &Vector<1>) -> Vector<1> {
            SVector::from([self.push])
        }
    }
    let start = At::from((0.0, SVector::from([0.0])));
    let motion = Problem::new(Relay { push: 1.0 }, start)
        .when(|x| x[0] - 0.1)
        .rising()
        .then_with(|_, relay| relay.push = -1.0)
        .when(|x| x[0] + 0.1)
        .falling()
        .then_with(|_, relay| relay.push = 1.0)
        .solve(10.0, Dop853::new())
        .unwrap();
    assert_eq!(motion.events().len(), 50);
    for (n, occurrence) in motion.events().iter().enumerate() {
        assert_eq!(occurrence.event, n % 2);
        assert_close(
            occurrence.t,
            0.1 + 0.2 * f64::from(u8::try_from(n).unwrap()),
            1e-13,
        );
    }
}

/// Two zeros between neighbouring times are missed, and found with more of them.
#[test]
fn the_density_of_samples_can_be_set() {
    let start = At::from((0.0, SVector::from([1.0, 0.0])));
    let found = |parts: u32| {
        let dip = Problem::new(&Oscillator, start).when(|x| (x.t - 0.301) * (x.t - 0.299));
        let problem = dip.samples(parts).record();
        let motion = problem.solve(1.0, RungeKutta::classical(0.5)).unwrap();
        motion.events().len()
    };
    assert_eq!(found(0), 0);
    assert_eq!(found(300), 2);
}

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(height),
    kinetic = 0.5 * dot(height).powi(2),
    potential = g * height,
    event(floor = height)
)]
struct Thrown {
    g: f64,
}

/// What is declared has no polynomial under these methods: it is sampled as a closure is, and interpolates nothing besides.
#[test]
fn a_declared_event_evaluates_no_more_than_a_closure() {
    let start = State::new(0.0, [5.0], [10.0]);
    let thrown = Thrown { g: 9.81 };
    let problem = || Problem::new(&thrown, start);
    let lands = |x: &State<f64, 1>| x.q[0];
    let method = RungeKutta::classical(1e-3);
    let declared = problem().on(Thrown::FLOOR).record().solve(1.0, method);
    let closure = problem().when(lands).record().solve(1.0, method);
    let evaluations = [declared, closure].map(|end| end.unwrap().statistics.evaluations);
    assert_eq!(evaluations[0], evaluations[1]);
    assert!(evaluations[1] < 4010, "{evaluations:?}");

    let method = Dop853::new();
    let declared = problem().on(Thrown::FLOOR).samples(1).record();
    let closure = problem().when(lands).samples(1).record();
    let evaluations = [
        declared.solve(1.0, method).unwrap().statistics.evaluations,
        closure.solve(1.0, method).unwrap().statistics.evaluations,
    ];
    assert_eq!(evaluations[0], evaluations[1]);
}
