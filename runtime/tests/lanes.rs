//! Several motions at once, in two lanes.

mod common;

use common::{Pendulum, assert_close};
use lagrangian::Lanes;
use lagrangian::prelude::*;

const PENDULUM: Pendulum = Pendulum {
    m: 1.0,
    g: 9.81,
    l: 1.0,
};

/// Two pendulums of different amplitudes, stepped together.
fn both() -> State<Lanes<2>, 1> {
    State::new(Lanes([0.0; 2]), [Lanes([0.5, 2.5])], [Lanes([0.0, 1.0])])
}

#[test]
fn lanes_move_as_they_would_alone() {
    let method = Dop853::new()
        .relative_tolerance(1e-12)
        .absolute_tolerance(1e-12);
    let times = [0.5, 1.0, 2.0];
    let together = method.sample(&PENDULUM.dynamics(), both(), &times).unwrap();
    for (lane, (q, v)) in [(0.5, 0.0), (2.5, 1.0)].into_iter().enumerate() {
        let initial = State::new(0.0, [q], [v]);
        let alone = method
            .sample(&PENDULUM.dynamics(), initial, &times)
            .unwrap();
        for (together, alone) in together.states().zip(alone.states()) {
            assert_close(together.q[0].0[lane], alone.q[0], 1e-10);
            assert_close(together.v[0].0[lane], alone.v[0], 1e-10);
        }
    }
}

/// Where the steps are the same, so are the bits.
#[test]
fn lanes_that_take_the_same_steps_have_the_same_bits() {
    let method = RungeKutta::classical(0.01);
    let together = method.integrate_to(&PENDULUM.dynamics(), both(), 2.0);
    let together = together.unwrap().x;
    for (lane, (q, v)) in [(0.5, 0.0), (2.5, 1.0)].into_iter().enumerate() {
        let initial = State::new(0.0_f64, [q], [v]);
        let alone = method.integrate_to(&PENDULUM.dynamics(), initial, 2.0);
        let alone = alone.unwrap().x;
        assert_eq!(together.q[0].lane(lane).to_bits(), alone.q[0].to_bits());
        assert_eq!(together.v[0].lane(lane).to_bits(), alone.v[0].to_bits());
    }
}

/// The error that counts is that of the worst lane.
#[test]
fn the_step_is_that_of_the_fastest_lane() {
    let method = Dop853::new()
        .relative_tolerance(1e-10)
        .absolute_tolerance(1e-10);
    let steps = |initial: State<Lanes<2>, 1>| {
        let driver = method.driver();
        driver
            .integrate_to(&PENDULUM.dynamics(), initial, 10.0)
            .unwrap()
            .statistics
            .steps
    };
    let slow = State::new(Lanes([0.0; 2]), [Lanes([0.5; 2])], [Lanes([0.0; 2])]);
    assert!(steps(both()) > steps(slow));
}

#[test]
fn a_lane_that_is_not_finite_is_an_error_and_lanes_have_one_time() {
    let method = Dop853::new();
    let mut initial = both();
    initial.q[0] = Lanes([0.5, f64::NAN]);
    let error = method
        .integrate_to(&PENDULUM.dynamics(), initial, 1.0)
        .unwrap_err();
    assert_eq!(error.to_string(), "the coordinate theta is NaN at t = 0");
    let mut initial = both();
    initial.t = Lanes([0.0, 1.0]);
    let error = method
        .integrate_to(&PENDULUM.dynamics(), initial, 1.0)
        .unwrap_err();
    assert!(
        matches!(error, IntegrationError::NonFiniteTime { .. }),
        "{error}"
    );
}
