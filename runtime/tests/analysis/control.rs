//! Static feedback, which is evaluated at every stage of every step.

use core::cell::Cell;

use crate::common::assert_close;
use lagrangian::prelude::*;
use nalgebra::SVector;

/// A mass on a spring under a force: m ẍ = u − k x.
#[derive(Clone, Debug, Lagrangian)]
#[lagrangian(
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = 0.5 * k * x.powi(2),
    force(x = force)
)]
struct Spring {
    m: f64,
    k: f64,
    #[lagrangian(input)]
    force: f64,
}

/// The same spring with the force sin(3 t) in the model.
struct Forced(Spring);

impl Dynamics for Forced {
    type State = Phase<f64, 1>;

    fn derivative(&self, t: f64, x: &Phase<f64, 1>) -> Phase<f64, 1> {
        let inputs = SVector::from([(3.0 * t).sin()]);
        Phase::new(
            x.v,
            self.0.with_inputs(inputs).accelerations(&At::from((t, *x))),
        )
    }
}

const SPRING: Spring = Spring {
    m: 2.0,
    k: 8.0,
    force: 0.0,
};

fn initial() -> State<f64, 1> {
    State::new(0.0, [1.0], [0.0])
}

#[test]
fn open_loop_control_equals_a_force_in_the_model() {
    let law = |state: &State<f64, 1>| SVector::from([(3.0 * state.t).sin()]);
    let controlled = || Problem::new(&SPRING, initial()).feedback(law);
    let forced = || Problem::new(Forced(SPRING), initial());
    let fixed = RungeKutta::classical(0.05);
    let [a, b] = [controlled().solve(2.0, fixed), forced().solve(2.0, fixed)];
    assert_eq!(
        a.unwrap().last,
        b.unwrap().last,
        "the law is evaluated at the same times to the last bit"
    );
    let times = [0.3, 1.1, 2.0];
    let a = controlled().save(times).solve(2.0, Dop853::new()).unwrap();
    let b = forced().save(times).solve(2.0, Dop853::new()).unwrap();
    // The error scales are the same, and so are the steps.
    assert_eq!(a.samples(), b.samples());
}

#[test]
fn the_law_is_evaluated_at_every_stage_of_every_step() {
    let calls = Cell::new(0_u64);
    let law = |_: &State<f64, 1>| {
        calls.set(calls.get() + 1);
        SVector::from([0.0])
    };
    let controlled = || Problem::new(&SPRING, initial()).feedback(law);
    let end = controlled().solve(1.0, RungeKutta::classical(0.1)).unwrap();
    let statistics = end.statistics;
    assert_eq!(statistics.steps, 10);
    // Four stages a step, and one evaluation at the start.
    assert_eq!((calls.get(), statistics.evaluations), (41, 41));
    calls.set(0);
    let statistics = controlled().solve(1.0, Dop853::new()).unwrap().statistics;
    assert_eq!(calls.get(), statistics.evaluations);
    // Twelve evaluations an accepted step, eleven a rejected one, two at the start.
    let Statistics {
        steps, rejected, ..
    } = statistics;
    assert_eq!(calls.get(), 12 * steps + 11 * rejected + 2);
}

/// A PD controller makes a damped oscillator, whose motion is known in closed form.
#[test]
fn state_feedback_closes_the_loop() {
    // m ẍ = −k x − d ẋ with d = 2 m δ, ω² = k/m − δ²: x = e^(−δt)(cos ωt + (δ/ω) sin ωt).
    let delta = 0.5;
    let end = Problem::new(&SPRING, initial())
        .feedback(|state| -2.0 * SPRING.m * delta * state.v[0])
        .solve(1.7, Dop853::new())
        .unwrap();
    let omega = (SPRING.k / SPRING.m - delta * delta).sqrt();
    let (s, c) = (omega * end.t).sin_cos();
    let exact = (-delta * end.t).exp() * (c + delta / omega * s);
    assert_close(end.q[0], exact, 1e-9);
}

#[test]
fn a_law_returns_a_number_an_array_or_a_vector() {
    let problem = || Problem::new(&SPRING, initial());
    let number = |state: &State<f64, 1>| (3.0 * state.t).sin();
    let fixed = RungeKutta::classical(0.05);
    let expected = Problem::new(Forced(SPRING), initial()).solve(1.0, fixed);
    let ends = [
        expected,
        problem().feedback(number).solve(1.0, fixed),
        problem()
            .feedback(|state| [number(state)])
            .solve(1.0, fixed),
        problem()
            .feedback(|state| SVector::from([number(state)]))
            .solve(1.0, fixed),
    ];
    let [expected, ends @ ..] = ends.map(|end| end.unwrap().last);
    assert_eq!(ends, [expected; 3]);
    let state = State::new(0.5, [1.0], [0.0]);
    let controlled = problem().feedback(number);
    assert_eq!(
        controlled.dynamics().inputs(&state),
        SVector::from([1.5_f64.sin()])
    );
}

#[test]
fn constant_inputs_equal_those_of_the_fields() {
    let held = SPRING.with_inputs([8.0]);
    let end = Problem::new(&held, initial())
        .solve(1.0, Dop853::new())
        .unwrap();
    assert_close(end.q[0], 1.0, 1e-12);
}
