//! Discretization, poles, controllability and regulators, against reference values (`data/linear_control.json`), against
//! closed forms and against the motion of the model itself.

use lagrangian::DoubleDouble;
use lagrangian::analysis::{Controllability, RegulatorError, StateSpace};
use lagrangian::prelude::*;
use lagrangian_tests::{Figures, assert_close, linear_control, list, relative_error};
use nalgebra::{Complex, Matrix1, Matrix4};
use serde_json::Value;

type TwoInputs = StateSpace<f64, 4, 2, 4>;

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

fn matrix<const R: usize, const C: usize>(value: &Value) -> SMatrix<f64, R, C> {
    SMatrix::from_fn(|i, j| number(&value[i][j]))
}

fn error<const R: usize, const C: usize>(found: &SMatrix<f64, R, C>, expected: &Value) -> f64 {
    let expected = matrix::<R, C>(expected);
    relative_error(found.as_slice(), expected.as_slice(), 1e-300)
}

fn error_of_poles(found: &[Complex<f64>], expected: &Value) -> f64 {
    let expected = list(expected)
        .iter()
        .map(|pole| Complex::new(number(&pole[0]), number(&pole[1])));
    let distances = expected.map(|pole| {
        let nearest = found
            .iter()
            .map(|x| (x - pole).norm() / pole.norm().max(1.0));
        nearest.fold(f64::INFINITY, f64::min)
    });
    distances.fold(0.0, f64::max)
}

#[test]
fn python_control() {
    let mut figures = Figures::new();
    for (index, case) in list(&linear_control()).iter().enumerate() {
        let at = format!("case {index}");
        let plant: TwoInputs = StateSpace::new(matrix(&case["a"]), matrix(&case["b"]));
        let (q, r) = (matrix(&case["q"]), matrix(&case["r"]));
        let mut record = |name, error, tolerance| figures.record(name, &at, error, tolerance);
        record(
            "poles",
            error_of_poles(&plant.poles().unwrap(), &case["open_poles"]),
            1e-10,
        );
        let regulator = plant.regulator(&q, &r).unwrap();
        record("gain", error(&regulator.gain, &case["gain"]), 1e-10);
        record("cost", error(&regulator.cost, &case["cost"]), 1e-10);
        record(
            "closed poles",
            error_of_poles(&regulator.poles, &case["poles"]),
            1e-10,
        );
        record("residual", regulator.residual, 1e-13);
        let period = number(&case["period"]);
        let held = plant.discretized(period);
        record("held A", error(&held.a, &case["held_a"]), 1e-14);
        record("held B", error(&held.b, &case["held_b"]), 1e-13);
        let regulator = held.regulator(&(q * period), &(r * period)).unwrap();
        record(
            "held gain",
            error(&regulator.gain, &case["held_gain"]),
            1e-10,
        );
        record(
            "held cost",
            error(&regulator.cost, &case["held_cost"]),
            1e-10,
        );
        record("held residual", regulator.residual, 1e-13);
        let rank = plant.controllability().rank;
        assert_eq!(
            rank,
            usize::try_from(case["rank"].as_u64().unwrap()).unwrap()
        );
    }
    figures.finish();
}

/// exp of (0, 1; −ω², −2 ζ ω) and its integral in closed form, for short and for long periods; in double-doubles to 30 digits.
#[test]
fn zero_order_hold_of_an_oscillator() {
    for (omega, period) in [
        (2.0, 1e-3),
        (2.0, 0.5),
        (50.0, 1.0),
        (1.0, 0.0),
        (3.0, -0.7),
    ] {
        let a = Matrix2::new(0.0, 1.0, -omega * omega, 0.0);
        let held = StateSpace::new(a, Vector2::new(0.0, 1.0)).discretized(period);
        let (sine, cosine) = f64::sin_cos(omega * period);
        let tolerance = 1e-14 * (1.0 + omega * f64::abs(period));
        let expected = [cosine, -omega * sine, sine / omega, cosine];
        let error = relative_error(held.a.as_slice(), &expected, 1e-300);
        assert!(error < tolerance, "ω = {omega}, h = {period}: {error:e}");
        let half = (0.5 * omega * period).sin();
        let expected = [2.0 * half * half / (omega * omega), sine / omega];
        let error = relative_error(held.b.as_slice(), &expected, 1e-300);
        assert!(error < tolerance, "ω = {omega}, h = {period}: {error:e}");
    }
    let number = DoubleDouble::from_f64;
    let [zero, one] = [0.0, 1.0].map(number);
    let mut fine = StateSpace::new(
        Matrix2::new(zero, one, number(-9.0), zero),
        Vector2::new(zero, one),
    );
    fine.derivative = Vector2::new(one, zero);
    let held = fine.discretized(number(0.7));
    let angle = number(3.0) * number(0.7);
    let errors = [
        held.a[(0, 0)] - angle.cos(),
        held.b[0] - (one - angle.cos()) / number(9.0),
        held.increment[0] - angle.sin() / number(3.0),
    ];
    for error in errors {
        assert!(error.to_f64().abs() < 1e-29, "{error:?}");
    }
}

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, theta),
    define(px = x + l * sin(theta), py = l * cos(theta)),
    kinetic = 0.5 * cart * dot(x).powi(2) + 0.5 * pole * (dot(px).powi(2) + dot(py).powi(2)),
    potential = pole * g * py,
    force(x = push),
)]
struct CartPole {
    cart: f64,
    pole: f64,
    l: f64,
    g: f64,
    #[lagrangian(input)]
    push: f64,
}

const MODEL: CartPole = CartPole {
    cart: 1.0,
    pole: 0.2,
    l: 0.5,
    g: 9.81,
    push: 0.0,
};

/// A short step of the linear model from anywhere is one of the model itself, to second order; f₀ is the derivative there.
#[test]
fn linearization_where_no_equilibrium_is() {
    let state = State::new(0.0, [0.2, 0.7], [-0.3, 0.9]);
    let plant = StateSpace::<f64, 4, 1, 4>::of(&MODEL.with_inputs([2.0]), &state);
    assert!(!plant.is_at_equilibrium(1e-3));
    let pushed = MODEL.with_inputs([2.0]);
    let mut errors = [0.0; 2];
    for (error, period) in errors.iter_mut().zip([2e-3, 1e-3]) {
        let end = Problem::new(&pushed, state).solve(period, Dop853::new());
        let change = plant.discretized(period).increment;
        let moved: Vec<f64> = change
            .iter()
            .zip(plant.output.iter())
            .map(|(x, y)| x + y)
            .collect();
        let expected: Vec<f64> = end.unwrap().x.components().collect();
        *error = relative_error(&moved, &expected, 1e-300);
    }
    // The error is of the third order in the period.
    assert!(
        errors[0] < 1e-7 && (errors[0] / errors[1] - 8.0).abs() < 0.3,
        "{errors:?}"
    );
}

/// The cost of a motion from near the upright pole is xᵀ P x.
#[test]
fn cost_of_a_motion() {
    let upright = State::new(0.0, [0.0, 0.0], [0.0, 0.0]);
    let plant = StateSpace::<f64, 4, 1, 4>::of(&MODEL, &upright);
    let weight = Matrix4::from_diagonal(&[10.0, 1.0, 1.0, 1.0].into());
    let regulator = plant.regulator(&weight, &Matrix1::new(0.1)).unwrap();
    let gain = regulator.gain;
    let deviation =
        |state: &State<f64, 2>| SVector::from([state.q[0], state.q[1], state.v[0], state.v[1]]);
    let small = State::new(0.0, [1e-5, 2e-5], [-1e-5, 1e-5]);
    let x = deviation(&small);
    let expected = x.dot(&(regulator.cost * x));
    let end = Problem::new(&MODEL, small)
        .feedback_with_states([0.0], |state, _| {
            let x = deviation(state);
            let u = -(gain * x)[0];
            (u, x.dot(&(weight * x)) + 0.1 * u * u)
        })
        .solve(20.0, Dop853::new().absolute_tolerance(1e-22))
        .unwrap();
    assert!((end.z[0] / expected - 1.0).abs() < 1e-7);

    // Samples every 10 ms, with a hold, balance the model itself from 30 degrees.
    let period = 0.01;
    let held = plant.discretized(period);
    let regulator = held
        .regulator(&(weight * period), &Matrix1::new(0.1 * period))
        .unwrap();
    assert!(regulator.poles.radius() < 1.0);
    let mut state = State::new(0.0, [0.0, 0.5], [0.0, 0.0]);
    for _ in 0..800 {
        let u = -(regulator.gain * deviation(&state))[0];
        let pushed = MODEL.with_inputs([u]);
        let motion = Problem::new(&pushed, state).solve(state.t + period, Dop853::new());
        state = motion.unwrap().last;
    }
    assert_close("at rest", deviation(&state).as_slice(), &[0.0; 4], 1e-4);
}

/// What no input reaches is named.
#[test]
fn modes_that_are_not_controlled() {
    // A pushed cart, and an inverted pendulum beside it.
    let a = Matrix4::new(
        0.0, 0.0, 1.0, 0.0, //
        0.0, 0.0, 0.0, 1.0, //
        0.0, 0.0, 0.0, 0.0, //
        0.0, 9.0, 0.0, 0.0,
    );
    let b = SVector::from([0.0, 0.0, 1.0, 0.0]);
    let apart = StateSpace::new(a, b);
    assert_eq!(apart.controllability().rank, 2);
    let unit = Matrix4::identity();
    let RegulatorError::NotStabilizable { mode } =
        apart.regulator(&unit, &Matrix1::new(1.0)).unwrap_err()
    else {
        panic!("it is not stabilizable");
    };
    assert!((mode.eigenvalue - 3.0).norm() < 1e-14);
    // θ̇ + 3 θ.
    assert_eq!(mode.component, 1);
    let message = apart
        .regulator(&unit, &Matrix1::new(1.0))
        .unwrap_err()
        .to_string();
    assert!(
        message.starts_with("no input reaches the mode with the eigenvalue 3"),
        "{message}"
    );
    // In another basis, and in discrete time.
    let turn = nalgebra::Rotation3::from_euler_angles(0.3, -0.5, 1.1);
    let mut basis = Matrix4::identity();
    basis.fixed_view_mut::<3, 3>(1, 1).copy_from(turn.matrix());
    let turned = StateSpace::new(basis.transpose() * a * basis, basis.transpose() * b);
    let uncontrollable = Controllability::of(&turned.a, &turned.b);
    assert_eq!(uncontrollable.rank, 2);
    let values = uncontrollable.uncontrollable().unwrap();
    assert_close(
        "modes",
        &[values[0].re.abs(), values[1].re.abs()],
        &[3.0, 3.0],
        1e-13,
    );
    let error = turned
        .discretized(0.1)
        .regulator(&unit, &Matrix1::new(1.0))
        .unwrap_err();
    let RegulatorError::NotStabilizable { mode } = error else {
        panic!("{error}");
    };
    assert!((mode.eigenvalue - 0.3_f64.exp()).norm() < 1e-13);

    // Two pendulums alike, moved by one cart, keep their difference; of different lengths, they do not.
    let twins = |other: f64| {
        let a = Matrix4::new(
            0.0, 0.0, 1.0, 0.0, //
            0.0, 0.0, 0.0, 1.0, //
            4.0, 0.0, 0.0, 0.0, //
            0.0, other, 0.0, 0.0,
        );
        StateSpace::new(a, SVector::from([0.0, 0.0, 1.0, 1.0]))
            .controllability()
            .rank
    };
    assert_eq!(twins(4.0), 2);
    assert_eq!(twins(4.0 + 1e-6), 4);
    // Position shows all, velocity does not show where the cart is.
    let chain = StateSpace::new(Matrix2::new(0.0, 1.0, 0.0, 0.0), Vector2::new(0.0, 1.0));
    let seen = |c: [f64; 2]| {
        chain
            .with_outputs::<1>(c.into(), SMatrix::zeros(), SVector::zeros())
            .observability()
            .rank
    };
    assert_eq!(seen([1.0, 0.0]), 2);
    assert_eq!(seen([0.0, 1.0]), 1);
}

#[test]
fn weights_that_are_none() {
    let chain = StateSpace::new(Matrix2::new(0.0, 1.0, 0.0, 0.0), Vector2::new(0.0, 1.0));
    let text = |q: [f64; 4], r: f64| {
        let found = chain.regulator(&Matrix2::from_row_slice(&q), &Matrix1::new(r));
        found.unwrap_err().to_string()
    };
    let unit = [1.0, 0.0, 0.0, 1.0];
    assert_eq!(
        text(unit, 0.0),
        "the eigenvalues of the weight R of inputs have to be positive, and one is 0"
    );
    assert_eq!(
        text([1.0, 0.0, 0.0, -0.5], 1.0),
        "the eigenvalues of the weight Q of states must not be negative, and one is -0.5"
    );
    assert_eq!(
        text([1.0, 0.5, 0.25, 1.0], 1.0),
        "the weight Q of states is not symmetric: its entries (1, 0) and (0, 1) differ by -0.25"
    );
    assert!(text([0.0, 0.0, 0.0, 1.0], 1.0).starts_with("the mode with the eigenvalue 0"));
    assert!(text([f64::NAN, 0.0, 0.0, 1.0], 1.0).contains("not"));
    let broken = StateSpace::new(
        Matrix2::new(0.0, f64::INFINITY, 0.0, 0.0),
        Vector2::new(0.0, 1.0),
    );
    let error = broken.regulator(&Matrix2::identity(), &Matrix1::new(1.0));
    assert_eq!(error.unwrap_err(), RegulatorError::NotFinite);
    assert!(broken.poles().is_none());
}
