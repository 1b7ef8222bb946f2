//! The Taylor series method: closed forms, corners, scalars, limits of its validity.

use crate::common::{Oscillator, assert_close};
use lagrangian::prelude::*;
use lagrangian::{DoubleDouble, Lanes};
use nalgebra::SVector;

#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(theta),
    kinetic = 0.5 * dot(theta).powi(2),
    potential = -rate.powi(2) * cos(theta),
)]
struct Pendulum<T: Scalar> {
    rate: T,
}

/// A stone in the air, with the time as a coordinate of the force.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x, y),
    kinetic = 0.5 * (dot(x).powi(2) + dot(y).powi(2)),
    potential = g * y,
    force(x = 6.0 * t),
)]
struct Stone {
    g: f64,
}

/// A mass between two constant forces, which meet in a corner of the potential.
#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), potential = abs(x))]
struct Valley;

#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), force(x = 2.0 * x.powi(3)))]
struct BlowUp;

#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), force(x = -ln(x)))]
struct Logarithm;

/// A force that is a function of time alone.
#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), force(x = sin(rate * t)))]
struct Driven<T: Scalar> {
    rate: T,
}

/// A push of √π/10 at t = 2.5.
#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), force(x = exp(-((t - 2.5) / 0.1).powi(2))))]
struct Pulse;

/// A push with corners: 1 in all, between t = 4 and t = 6.
#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), force(x = max(0.0, 1.0 - abs(t - 5.0))))]
struct Hat;

/// A spring whose end is far from the origin.
#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), potential = 0.5 * (x - end).powi(2))]
struct FarSpring {
    end: f64,
}

/// A stone with drag by the square of its speed, and a wall that pushes it by Hertz's law.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x, y),
    kinetic = 0.5 * (dot(x).powi(2) + dot(y).powi(2)),
    potential = g * y,
    force(
        x = -dot(x) * sqrt(dot(x).powi(2) + dot(y).powi(2)) + max(0.0, -x).powf(1.5),
        y = -dot(y) * sqrt(dot(x).powi(2) + dot(y).powi(2)),
    ),
)]
struct Drag {
    g: f64,
}

/// The lesser of two forces, of which one is steep.
#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), force(x = min(-x, 1e10 * (1.0 - x))))]
struct Steep;

#[test]
fn polynomial_motions_are_exact_in_one_step() {
    let start = State::new(0.5, [1.0, 2.0], [3.0, -1.0]);
    let stone = Stone { g: 8.0 };
    let state = Problem::new(&stone, start).solve(4.5, Taylor::new());
    let state = state.unwrap();
    assert_eq!(state.statistics.steps, 1);
    // ẍ = 6 t: x = 1 + (3 − 3 t₀²)(t − t₀) + t³ − t₀³.
    assert_close(
        state.q[0],
        1.0 + 2.25 * 4.0 + 4.5_f64.powi(3) - 0.125,
        1e-13,
    );
    assert_close(state.q[1], 2.0 - 4.0 - 64.0, 1e-13);
    assert_close(state.v[1], -1.0 - 32.0, 1e-13);
}

/// With a relative tolerance the unit of time means nothing: neither the steps nor the error depend on it.
#[test]
fn units_of_time_do_not_matter() {
    let mut all = Vec::new();
    for exponent in [-200, -40, 0, 40, 200] {
        let rate = 2.0_f64.powi(exponent);
        let pendulum = Pendulum { rate };
        let start = State::new(0.0, [2.5], [0.0]);
        let method = Taylor::new().relative_tolerance(f64::EPSILON);
        let end = Problem::new(&pendulum, start)
            .solve(50.0 / rate, method)
            .unwrap();
        all.push((end.statistics, end.q[0], end.v[0] / rate));
    }
    for (statistics, q, v) in &all {
        assert!(
            statistics.steps.abs_diff(all[2].0.steps) <= 2,
            "{statistics:?}"
        );
        assert_close(*q, all[2].1, 1e-12);
        assert_close(*v, all[2].2, 1e-12);
    }
}

#[test]
fn motions_are_reversible() {
    let pendulum = Pendulum { rate: 3.0 };
    let start = State::new(0.0, [3.0], [0.1]);
    let there = Problem::new(&pendulum, start)
        .solve(30.0, Taylor::new())
        .unwrap();
    let back = Problem::new(&pendulum, there.last)
        .solve(0.0, Taylor::new())
        .unwrap();
    assert_close(back.q[0], 3.0, 1e-11);
    assert_close(back.v[0], 0.1, 1e-11);
}

#[test]
fn dense_output_has_the_accuracy_of_the_steps() {
    let times: Vec<f64> = (0..=1000).map(|i| 0.02 * f64::from(i)).collect();
    let start = At::from((0.0, SVector::from([1.0, 0.0])));
    let motion = Problem::new(&Oscillator, start)
        .save(&times)
        .solve(times[1000], Taylor::new())
        .unwrap();
    assert!(motion.statistics.steps < 30);
    for sample in motion {
        assert_close(sample[0], sample.t.cos(), 1e-14);
        assert_close(sample[1], -sample.t.sin(), 1e-14);
    }
}

/// In a corner the polynomial of one side goes on as if there were no other.
#[test]
fn corners_shorten_the_step() {
    // From x = 1 at rest, a quarter of the period is √2, and the motion is made of parabolas.
    let quarter = 2.0_f64.sqrt();
    let start = State::new(0.0, [1.0], [0.0]);
    let times: Vec<f64> = (1..=8).map(|i| f64::from(i) * quarter).collect();
    let motion = Problem::new(&Valley, start)
        .max_steps(10_000)
        .save(&times)
        .solve(times[7], Taylor::new())
        .unwrap();
    for (i, sample) in (1..).zip(motion.samples()) {
        let expected = [0.0, -1.0, 0.0, 1.0][(i - 1) % 4];
        assert_close(sample.q[0], expected, 1e-9);
    }
    // Each of four corners ends a step.
    assert!(motion.statistics.steps > 4);
}

#[test]
fn double_doubles_have_all_digits() {
    let end = DoubleDouble::from_f64(8.0);
    let [zero, one] = [0.0, 1.0].map(DoubleDouble::from_f64);
    let initial = At::from((zero, SVector::from([one, zero])));
    let found = Problem::new(&Oscillator, initial)
        .solve(8.0, Taylor::order_40())
        .unwrap();
    let error = (found[0] - end.cos()).abs() + (found[1] + end.sin()).abs();
    assert!(error.to_f64() < 1e-29, "{error:?}");
}

#[test]
fn lanes_are_the_motions_of_each_lane() {
    let rates = [1.0, 2.0, 3.0, 4.5];
    let lanes = Pendulum { rate: Lanes(rates) };
    let start = State::new(
        Lanes([0.0; 4]),
        SVector::from([Lanes([2.0; 4])]),
        SVector::from([Lanes([0.0; 4])]),
    );
    let method = Taylor::new();
    let together = Problem::new(&lanes, start).solve(10.0, method).unwrap();
    for (lane, rate) in rates.into_iter().enumerate() {
        let start = State::new(0.0, [2.0], [0.0]);
        let alone = Problem::new(&Pendulum { rate }, start)
            .solve(10.0, method)
            .unwrap();
        assert_close(together.q[0].0[lane], alone.q[0], 1e-12);
    }
}

#[test]
fn single_precision_is_enough_for_itself() {
    let pendulum = Pendulum { rate: 1.0_f32 };
    let start: State<f32, 1> = State::new(0.0, SVector::from([1.0]), SVector::from([0.0]));
    let end = Problem::new(&pendulum, start)
        .solve(5.0, Taylor::order_12())
        .unwrap();
    let precise = Pendulum { rate: 1.0_f64 };
    let start = State::new(0.0, [1.0], [0.0]);
    let expected = Problem::new(&precise, start)
        .solve(5.0, Taylor::new())
        .unwrap();
    assert_close(f64::from(end.q[0]), expected.q[0], 2e-6);
}

#[test]
fn a_pole_of_the_solution_is_an_error_with_its_time() {
    // ẍ = 2 x³ with ẋ = x², whose solution is 1/(1 − t).
    let start = State::new(0.0, [1.0], [1.0]);
    let error = Problem::new(&BlowUp, start)
        .solve(2.0, Taylor::new())
        .unwrap_err()
        .error();
    assert!(
        error.to_string().contains("t = 0.99") || error.to_string().contains("t = 1"),
        "{error}"
    );
}

#[test]
fn where_there_is_no_series_the_error_names_the_component() {
    let start = State::new(0.25, [-1.0], [0.0]);
    let error = Problem::new(&Logarithm, start)
        .solve(1.0, Taylor::new())
        .unwrap_err()
        .error();
    assert!(
        matches!(error, IntegrationError::NonFiniteDerivative { .. }),
        "{error}"
    );
}

/// Where the motion is so small that its coefficients overflow in the first unit of time.
#[test]
fn tiny_motions_have_series() {
    let rate = 9.81_f64.sqrt();
    for size in [1e-16, 2e-16, 1e-100, 1e-300] {
        for start in [
            State::new(0.0, [size], [0.0]),
            State::new(0.0, [0.0], [size]),
        ] {
            let end = Problem::new(&Pendulum { rate }, start)
                .max_steps(1000)
                .solve(10.0, Taylor::new())
                .unwrap();
            let (s, c) = (rate * 10.0).sin_cos();
            let expected = start.q[0] * c + start.v[0] * s / rate;
            assert_close(end.q[0], expected, 1e-14);
        }
    }
}

/// The rounding of the time is no corner.
#[test]
fn late_times_and_many_digits_do_not_shorten_steps() {
    let rate = 100.0;
    let start = State::new(1e4, [0.0], [0.0]);
    let end = Problem::new(&Driven { rate }, start)
        .max_steps(300)
        .solve(1e4 + 5.0, Taylor::new())
        .unwrap();
    let (from, to) = (rate * 1e4, rate * (1e4 + 5.0));
    let expected = (from.cos() - to.cos()) / rate;
    // 100 t has the rounding errors of a number near 10⁶.
    assert_close(end.v[0], expected, 1e-10);

    let one = DoubleDouble::from_f64(1.0);
    let [t, q, v] = [0.0, 0.0, -1.0].map(DoubleDouble::from_f64);
    let start = State::new(t, SVector::from([q]), SVector::from([v]));
    let end = Problem::new(&Driven { rate: one }, start)
        .max_steps(300)
        .solve(9.7, Taylor::order_40())
        .unwrap();
    // x = −sin t.
    let error = end.q[0] + DoubleDouble::from_f64(9.7).sin();
    assert!(error.abs().to_f64() < 1e-29, "{error:?}");
}

#[test]
fn the_condition_of_a_force_is_no_corner() {
    let spring = FarSpring { end: 1e6 };
    let start = State::new(0.0, [1e6 + 1.0], [0.0]);
    let end = Problem::new(&spring, start)
        .max_steps(60)
        .solve(100.0, Taylor::new())
        .unwrap();
    assert_close(end.q[0] - 1e6, 100.0_f64.cos(), 1e-8);
}

#[test]
fn forces_that_act_within_a_long_step_are_noticed() {
    let start = State::new(0.0, [0.0], [0.0]);
    let end = Problem::new(&Pulse, start).solve(5.0, Taylor::new());
    assert_close(end.unwrap().v[0], 0.1 * core::f64::consts::PI.sqrt(), 1e-12);
    let end = Problem::new(&Hat, start).solve(10.0, Taylor::new());
    assert_close(end.unwrap().v[0], 1.0, 1e-9);
}

#[test]
fn roots_of_zero_have_series() {
    let drag = Drag { g: 9.81 };
    let start = State::new(0.0, [1.0, 0.0], [0.0, 0.0]);
    let end = Problem::new(&drag, start)
        .solve(2.0, Taylor::new())
        .unwrap();
    // v = −√g tanh(√g t).
    let rate = 9.81_f64.sqrt();
    assert_close(end.v[1], -rate * (2.0 * rate).tanh(), 1e-12);
    assert_close(end.q[1], -(2.0 * rate).cosh().ln(), 1e-12);
}

#[test]
fn the_branch_that_is_not_taken_costs_no_digits() {
    let start = State::new(0.0, [0.3], [0.0]);
    let end = Problem::new(&Steep, start)
        .max_steps(20)
        .solve(10.0, Taylor::new())
        .unwrap();
    assert_close(end.q[0], 0.3 * 10.0_f64.cos(), 1e-14);
}

#[test]
fn invalid_settings_are_errors() {
    let start = At::from((0.0, SVector::from([1.0, 0.0])));
    let run = |method: Taylor| {
        Problem::new(&Oscillator, start)
            .solve(1.0, method)
            .unwrap_err()
            .error()
    };
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = run(Taylor::new().relative_tolerance(tolerance));
        assert!(
            matches!(error, IntegrationError::InvalidTolerance { .. }),
            "{error}"
        );
    }
    for step in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = run(Taylor::new().max_step(step));
        assert!(
            matches!(error, IntegrationError::InvalidStep { .. }),
            "{error}"
        );
    }
}
