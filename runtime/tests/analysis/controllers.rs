//! Dynamic feedback, against motions in closed form.

use crate::common::assert_close;
use lagrangian::ComponentName;
use lagrangian::prelude::*;
use nalgebra::Matrix4;

/// A mass on a spring: m ẍ = force − k x.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = 0.5 * k * x.powi(2),
    force(x = force),
)]
struct Spring {
    m: f64,
    k: f64,
    #[lagrangian(input)]
    force: f64,
}

const SPRING: Spring = Spring {
    m: 2.0,
    k: 8.0,
    force: 0.0,
};

const FREE: Spring = Spring { k: 0.0, ..SPRING };

fn rest() -> State<f64, 1> {
    State::new(0.0, [0.0], [0.0])
}

fn precise() -> Dop853 {
    Dop853::new()
        .relative_tolerance(1e-12)
        .absolute_tolerance(1e-12)
}

const PROPORTIONAL: f64 = 6.0;
const INTEGRAL: f64 = 5.0;
const DERIVATIVE: f64 = 3.0;
const WANTED: f64 = 0.7;

/// The input and the derivative of the integral of the error.
#[allow(clippy::trivially_copy_pass_by_ref)] // Laws take their states by reference, however many.
fn pid(state: &State<f64, 1>, integral: &SVector<f64, 1>) -> (f64, f64) {
    let error = WANTED - state.q[Spring::X];
    let force = PROPORTIONAL * error + INTEGRAL * integral[0] - DERIVATIVE * state.v[Spring::X];
    (force, error)
}

/// (x, ẋ, z) under the PID controller, by the matrix exponential for (x, ẋ, z, 1).
fn under_pid(t: f64) -> [f64; 3] {
    let Spring { m, k, .. } = SPRING;
    #[rustfmt::skip]
    let matrix = Matrix4::new(
        0.0, 1.0, 0.0, 0.0,
        -(k + PROPORTIONAL) / m, -DERIVATIVE / m, INTEGRAL / m, PROPORTIONAL * WANTED / m,
        -1.0, 0.0, 0.0, WANTED,
        0.0, 0.0, 0.0, 0.0,
    );
    let state = (matrix * t).exp().column(3).into_owned();
    [state[0], state[1], state[2]]
}

#[test]
fn a_pid_controller_moves_the_spring_as_the_matrix_exponential() -> Result<(), IntegrationError> {
    let problem = Problem::new(&SPRING, rest()).feedback_with_states([0.0], pid);
    let controlled = problem.dynamics().clone();
    let times = [0.1, 0.75, 1.3, 4.0, 20.0];
    let motion = problem.save(times).solve(20.0, precise())?;
    assert!(
        motion.statistics.steps > times.len() as u64,
        "some times are within a step"
    );
    for sample in motion.samples() {
        let [x, v, z] = under_pid(sample.t);
        let state = sample.state();
        assert_close(state.q[0], x, 1e-10);
        assert_close(state.v[0], v, 1e-10);
        assert_close(sample.z[0], z, 1e-10);
        assert_eq!(state, State::new(sample.t, sample.q, sample.v));
        let force = controlled.inputs(sample)[Spring::FORCE];
        let exact = PROPORTIONAL * (WANTED - x) + INTEGRAL * z - DERIVATIVE * v;
        assert_close(force, exact, 1e-9);
    }
    // The integral balances the spring.
    assert_close(motion.q[0], WANTED, 1e-3);
    Ok(())
}

#[test]
fn fixed_steps_integrate_the_states_of_the_controller() -> Result<(), IntegrationError> {
    let [coarse, fine] = [0.02, 0.01].map(|step| -> Result<f64, IntegrationError> {
        let controlled = Problem::new(&SPRING, rest()).feedback_with_states([0.0], pid);
        let end = controlled.solve(2.0, RungeKutta::classical(step))?;
        Ok(end.z[0] - under_pid(2.0)[2])
    });
    // Order 4: half the step has a sixteenth of the error.
    let ratio = coarse? / fine?;
    assert!((ratio - 16.0).abs() < 1.0, "{ratio}");
    Ok(())
}

#[test]
fn an_actuator_follows_its_command_with_a_lag() -> Result<(), IntegrationError> {
    // z = c (1 − e^(−t/τ)) pushes a free mass.
    const LAG: f64 = 0.3;
    const COMMAND: f64 = 4.0;
    let law = |_: &State<f64, 1>, z: &SVector<f64, 1>| (*z, (SVector::from([COMMAND]) - z) / LAG);
    for end in [0.4, 2.0, -0.5] {
        let found = Problem::new(&FREE, rest())
            .feedback_with_states([0.0], law)
            .solve(end, precise())?;
        let risen = 1.0 - (-end / LAG).exp();
        let position = end * end / 2.0 - LAG * end + LAG * LAG * risen;
        assert_close(found.z[0], COMMAND * risen, 1e-10);
        assert_close(found.v[0], COMMAND / FREE.m * (end - LAG * risen), 1e-10);
        assert_close(found.q[0], COMMAND / FREE.m * position, 1e-10);
    }
    Ok(())
}

#[test]
fn errors_of_the_controllers_states_control_the_steps() -> Result<(), IntegrationError> {
    // A controller that oscillates at 50 rad/s and exerts no force.
    let times = [0.33, 1.0, 3.0];
    let motion = Problem::new(&FREE, rest())
        .feedback_with_states([1.0, 0.0], |_, z| (0.0, [z[1], -2500.0 * z[0]]))
        .save(times)
        .solve(3.0, precise())?;
    for sample in motion {
        let [cosine, sine] = [(50.0 * sample.t).cos(), (50.0 * sample.t).sin()];
        assert_close(sample.z[0], cosine, 1e-8);
        assert_close(sample.z[1], -50.0 * sine, 1e-6);
        assert_eq!(sample.motion(), Phase::new([0.0], [0.0]));
    }
    Ok(())
}

#[test]
fn a_controllers_states_are_named_in_errors() {
    let error = |second: f64| {
        Problem::new(&SPRING, rest())
            .feedback_with_states([0.0, second], |_, z| (0.0, [z[0], z[1].ln()]))
            .solve(1.0, precise())
            .unwrap_err()
            .error()
    };
    assert_eq!(
        error(f64::NAN).to_string(),
        "state 1 of the controller is NaN at t = 0"
    );
    let interrupted = error(-1.0);
    let IntegrationError::NonFiniteDerivative { component, .. } = interrupted else {
        panic!("{interrupted}");
    };
    assert_eq!(component, ComponentName::Controller(1));
}

#[test]
fn a_stop_condition_can_depend_on_the_controllers_states() -> Result<(), IntegrationError> {
    // A clock.
    let end = Problem::new(&SPRING, rest())
        .feedback_with_states([0.0], |_, _| (1.0, 1.0))
        .when(|x| x.z[0] - 0.75)
        .stop()
        .solve(10.0, precise())?;
    assert_eq!(end.reason, StopReason::Condition);
    assert_close(end.t, 0.75, 1e-12);
    Ok(())
}

#[test]
fn a_controller_on_another_scalar() -> Result<(), IntegrationError> {
    let law = |state: &State<f32, 1>, z: &SVector<f32, 1>| {
        let error = 0.7 - state.q[0];
        (6.0 * error + 5.0 * z[0] - 3.0 * state.v[0], error)
    };
    let start = State::new(0.0_f32, [0.0], [0.0]);
    let end = Problem::new(&SPRING, start)
        .feedback_with_states([0.0], law)
        .solve(2.0, RungeKutta::classical(0.01))?;
    let [x, _, z] = under_pid(2.0);
    assert_close(f64::from(end.q[0]), x, 1e-6);
    assert_close(f64::from(end.z[0]), z, 1e-6);
    Ok(())
}
