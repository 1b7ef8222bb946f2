//! External functions: the same motion as with their formulas, and derivatives that are checked.

mod slider;
mod tables;
mod several_arguments;
mod taylor;

use lagrangian::DerivativeError;
use lagrangian::prelude::*;
use lagrangian_tests::assert_close;

const TOLERANCE: f64 = 1e-13;

/// Time, position and velocity.
const STATES: [[f64; 3]; 4] = [
    [0.0, 0.3, 0.7],
    [1.0, -0.4, -0.2],
    [2.0, 1.1, 2.5],
    [0.5, 0.0, 0.0],
];

/// All that a model computes of its motion, one after the other.
fn computed<const N: usize>(
    model: &impl Lagrangian<N, Model: lagrangian::quantities::StateJacobian<N>>,
    state: &State<f64, N>,
    accelerations: &SVector<f64, N>,
) -> Vec<f64> {
    let linearization = model.linearize(state);
    let mut values = vec![model.lagrangian(state), model.energy(state)];
    values.extend(&model.momenta(state));
    values.extend(&model.mass_matrix(state));
    values.extend(&model.forcing(state));
    values.extend(&model.generalized_forces(state));
    values.extend(&model.accelerations(state));
    values.extend(&model.dynamics().accelerations(state));
    values.extend(&model.inverse_dynamics(state, accelerations));
    values.extend(&linearization.position);
    values.extend(&linearization.velocity);
    values.extend(&linearization.time);
    values
}

/// A spring on a scalar of its own, whose derivative by the stiffness has the wrong sign.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    function(
        push(x, k) = -k * x.sinh(),
        derivative(x) = -k * cosh(x),
        derivative(k) = sinh(x),
    ),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = push(x, stiffness)),
)]
struct Spring<T: Scalar> {
    m: T,
    #[lagrangian(input)]
    stiffness: T,
}

#[test]
fn a_wrong_derivative_is_found_out() {
    let spring = Spring {
        m: 2.0,
        stiffness: 3.0,
    };
    let state = State::new(0.0, [0.5], [0.0]);
    let expected = -1.5 * 0.5_f64.sinh();
    assert_close(
        "push",
        &[spring.accelerations(&state)[0]],
        &[expected],
        TOLERANCE,
    );
    let held = spring.check_derivatives("push", [-1.0..=1.0, 3.0..=3.0]);
    assert_eq!(held, Ok(()));
    let Err(DerivativeError::Wrong {
        function,
        argument,
        point,
        declared,
        measured,
        ..
    }) = spring.check_derivatives("push", [-1.0..=1.0, 1.0..=5.0])
    else {
        panic!("the sign is right");
    };
    assert_eq!((function, argument), ("push", "k"));
    assert!(
        (declared + measured).abs() < 1e-8,
        "{declared} at {point}, not {measured}"
    );
}

/// The characteristic of a motor, in single precision.
fn torque(speed: f32, voltage: f32) -> f32 {
    voltage / (1.0 + speed * speed)
}

/// A motor on one scalar alone, with inputs and outputs on it.
#[derive(Lagrangian)]
#[lagrangian(
    scalar = f32,
    coordinates(angle),
    function(
        torque(speed, voltage) = torque(speed, voltage),
        derivative(speed) = -2.0 * speed * torque(speed, voltage) / (1.0 + speed.powi(2)),
        derivative(voltage) = 1.0 / (1.0 + speed.powi(2)),
    ),
    kinetic = 0.5 * inertia * dot(angle).powi(2),
    force(angle = torque(dot(angle), volts) - drag * signum(angle) * sin(angle)),
    output(power = dot(angle) * torque(dot(angle), volts), turned = [cos(angle), sin(angle)]),
)]
struct Motor {
    inertia: f32,
    drag: f64,
    #[lagrangian(input)]
    volts: f32,
}

#[test]
fn a_model_may_be_on_one_scalar_alone() {
    let motor = Motor {
        inertia: 2.0,
        drag: 0.5,
        volts: 12.0,
    };
    let state = State::new(0.0, [0.5], [2.0]);
    let close = |found: f32, expected: f32| assert!((found - expected).abs() < 1e-6, "{found}");
    let expected = 0.5 * (12.0 / 5.0 - 0.5 * 0.5_f32.sin());
    close(motor.accelerations(&state)[0], expected);
    close(
        motor.linearize(&state).velocity[0],
        -0.5 * 4.0 * 12.0 / 25.0,
    );
    close(
        motor.with_inputs(motor.inputs()).input_jacobian(&state)[0],
        0.1,
    );
    let MotorOutputs { power, turned } = motor.outputs(&state);
    close(power, 4.8);
    close(turned[0], 0.5_f32.cos());
    let checked = motor.check_derivatives("torque", [-3.0..=3.0, 0.0..=24.0]);
    assert_eq!(checked, Ok(()));
}
