//! Inputs that are functions of time, and inputs that are held, under the Taylor series method.

use crate::common::assert_close;
use lagrangian::prelude::*;
use lagrangian::signals::{Constant, Polynomial, Signal, Sinusoid, Sum};
use lagrangian::{DoubleDouble, Lanes};
use nalgebra::SVector;

/// A pendulum whose support is pushed, and whose spring and weight are inputs, too.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x, theta),
    define(p = [x + l * sin(theta), -l * cos(theta)]),
    kinetic = 0.5 * (m * dot(p).norm_squared() + 2.0 * dot(x).powi(2)),
    potential = m * gravity * p.y + 0.5 * stiffness * x.powi(2),
    force(x = push * cos(theta) * exp(-push.powi(2)), theta = push / (2.0 + sin(gravity))),
)]
struct Crane {
    m: f64,
    l: f64,
    #[lagrangian(input)]
    push: f64,
    #[lagrangian(input)]
    stiffness: f64,
    #[lagrangian(input)]
    gravity: f64,
}

/// The same with the inputs written as expressions of time.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x, theta),
    define(
        push = 0.7 * sin(1.5 * t + 0.25) + 0.2 * sin(4.0 * t),
        stiffness = 3.0 + 0.1 * t - 0.02 * t.powi(2),
        gravity = 9.81,
        p = [x + l * sin(theta), -l * cos(theta)],
    ),
    kinetic = 0.5 * (m * dot(p).norm_squared() + 2.0 * dot(x).powi(2)),
    potential = m * gravity * p.y + 0.5 * stiffness * x.powi(2),
    force(x = push * cos(theta) * exp(-push.powi(2)), theta = push / (2.0 + sin(gravity))),
)]
struct Written {
    m: f64,
    l: f64,
}

const CRANE: Crane = Crane {
    m: 1.3,
    l: 0.8,
    push: 0.1,
    stiffness: 3.0,
    gravity: 9.81,
};

type Signals = (Sum<[Sinusoid; 2]>, Polynomial<3>, Constant);

fn signals() -> Signals {
    let sine = |amplitude, angular_frequency, phase| Sinusoid {
        amplitude,
        angular_frequency,
        phase,
    };
    (
        Sum([sine(0.7, 1.5, 0.25), sine(0.2, 4.0, 0.0)]),
        Polynomial([3.0, 0.1, -0.02]),
        Constant(9.81),
    )
}

fn start<S: Scalar>(t: f64) -> State<S, 2> {
    let [t, x, theta, v, w] = [t, 0.2, 1.0, 0.0, -0.5].map(S::from_f64);
    State::new(t, SVector::from([x, theta]), SVector::from([v, w]))
}

#[test]
fn signals_are_expressions_of_time() {
    let written = Written { m: 1.3, l: 0.8 };
    for t in [0.0, -3.0] {
        let driven = Problem::new(&CRANE, start(t)).driven_by(signals());
        let driven = driven.solve(10.0, Taylor::new()).unwrap();
        let written = Problem::new(&written, start(t)).solve(10.0, Taylor::new());
        let written = written.unwrap();
        for i in 0..2 {
            assert_close(driven.q[i], written.q[i], 1e-12);
            assert_close(driven.v[i], written.v[i], 1e-12);
        }
    }
}

fn explicit() -> Dop853 {
    Dop853::new()
        .relative_tolerance(1e-13)
        .absolute_tolerance(1e-13)
}

#[test]
fn all_methods_integrate_driven_models() {
    let driven = || Problem::new(&CRANE, start(0.0)).driven_by(signals());
    let series = driven().solve(10.0, Taylor::new()).unwrap();
    let explicit = driven().solve(10.0, explicit()).unwrap();
    assert_close(series.q[0], explicit.q[0], 1e-10);
    assert_close(series.q[1], explicit.q[1], 1e-10);
}

#[test]
fn signals_are_on_all_scalars() {
    let alone = Problem::new(&CRANE, start(0.0)).driven_by(signals());
    let alone = alone.solve(3.0, Taylor::new()).unwrap();
    let precise = Problem::new(&CRANE, start::<DoubleDouble>(0.0)).driven_by(signals());
    let precise = precise.solve(3.0, Taylor::order_40()).unwrap();
    let lanes = Problem::new(&CRANE, start::<Lanes<4>>(0.0)).driven_by(signals());
    let lanes = lanes.solve(3.0, Taylor::new()).unwrap();
    for i in 0..2 {
        assert_close(alone.q[i], precise.q[i].to_f64(), 1e-13);
        assert_close(alone.q[i], lanes.q[i].lane(2), 1e-13);
    }
}

/// Held for the whole motion, by the fields and by `with_inputs`, and held from sample to sample.
#[test]
fn inputs_that_are_held() {
    let free = Problem::new(&CRANE, start(0.0));
    let by_field = free.clone().solve(5.0, Taylor::new()).unwrap().last;
    let expected = free.clone().solve(5.0, explicit()).unwrap();
    assert_close(by_field.q[1], expected.q[1], 1e-10);

    let held = CRANE.with_inputs([0.1, 3.0, 9.81]);
    let found = Problem::new(&held, start(0.0)).solve(5.0, Taylor::new());
    assert_eq!(found.unwrap().last, by_field);
    let held = free.driven_by([0.1, 3.0, 9.81].map(Constant));
    let found = held.solve(5.0, Taylor::new()).unwrap();
    assert_eq!(found.last, by_field);

    // A sampled controller, ten times a second.
    let law = |state: &State<f64, 2>| [-2.0 * state.q[0] - state.v[0], 3.0, 9.81];
    let (mut series, mut steps) = (start(0.0), start(0.0));
    for period in 1..=30 {
        let end = 0.1 * f64::from(period);
        let under = CRANE.with_inputs(law(&series));
        let next = Problem::new(&under, series).solve(end, Taylor::new());
        series = next.unwrap().last;
        let under = CRANE.with_inputs(law(&steps));
        let next = Problem::new(&under, steps).solve(end, explicit());
        steps = next.unwrap().last;
    }
    assert_close(series.q[0], steps.q[0], 1e-10);
    assert_close(series.q[1], steps.q[1], 1e-10);
}

/// Each series, summed, is the signal at another time.
#[test]
fn series_of_signals() {
    fn check<G: Signal<DoubleDouble>>(signal: &G, expected: impl Fn(DoubleDouble) -> DoubleDouble) {
        let [zero, t, unit] = [0.0, 1.25, 0.125].map(DoubleDouble::from_f64);
        let mut series = [zero; 40];
        signal.add_series::<20>(t, unit, &mut series);
        for tau in [0.0, 0.5, -1.0] {
            let tau = DoubleDouble::from_f64(tau);
            let sum = series.iter().rev().fold(zero, |sum, c| sum * tau + *c);
            let time = t + tau * unit;
            assert!((sum - expected(time)).abs().to_f64() < 1e-29);
            assert!((signal.value(time) - expected(time)).abs().to_f64() < 1e-29);
        }
    }
    let number = DoubleDouble::from_f64;
    check(&Constant(0.75), |_| number(0.75));
    check(&Polynomial([1.0, -2.0, 0.5, 0.25]), |t| {
        number(1.0) - t * number(2.0) + t * t * number(0.5) + t * t * t * number(0.25)
    });
    check(&Polynomial([]), |_| number(0.0));
    let sine = Sinusoid {
        amplitude: 1.5,
        angular_frequency: -3.0,
        phase: 0.5,
    };
    check(&sine, |t| {
        number(1.5) * (number(0.5) - t * number(3.0)).sin()
    });
    check(&Sum((sine, Constant(2.0))), |t| {
        number(1.5) * (number(0.5) - t * number(3.0)).sin() + number(2.0)
    });
}
