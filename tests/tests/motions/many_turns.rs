//! Angles that grow: an integration loses no digits with the turns that they count.

use std::cell::Cell;
use std::f64::consts::TAU;

use lagrangian::prelude::*;
use lagrangian::{DoubleDouble, ErrorTolerance, Lanes, Series, TaylorCoefficients};

/// A heavy top with three different moments of inertia, of which ψ matters.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(phi, theta, psi),
    define(
        w1 = dot(phi) * sin(theta) * sin(psi) + dot(theta) * cos(psi),
        w2 = dot(phi) * sin(theta) * cos(psi) - dot(theta) * sin(psi),
        w3 = dot(phi) * cos(theta) + dot(psi),
    ),
    kinetic = 0.5 * (i1 * w1.powi(2) + i2 * w2.powi(2) + i3 * w3.powi(2)),
    potential = weight * cos(theta),
)]
struct Top {
    i1: f64,
    i2: f64,
    i3: f64,
    weight: f64,
}

const TOP: Top = Top {
    i1: 1.2,
    i2: 1.0,
    i3: 0.5,
    weight: 5.1,
};

/// A rotor of which half the angle matters, on any scalar.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    kinetic = 0.5 * dot(theta).powi(2),
    potential = k * cos(theta / 2),
)]
struct Rotor {
    k: f64,
}

/// A motor with a torque that follows a law.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    kinetic = 0.5 * dot(theta).powi(2),
    potential = 0.1 * cos(theta),
    force(theta = torque),
)]
struct Motor {
    #[lagrangian(input)]
    torque: f64,
}

/// The same system without the reduction of its angles.
struct Unreduced<D>(D);

impl<S: Scalar, D: Dynamics<S>> Dynamics<S> for Unreduced<D> {
    type State = D::State;

    fn derivative(&self, t: S, x: &Self::State) -> Self::State {
        self.0.derivative(t, x)
    }

    fn allowed_error(&self, x: &Self::State, tolerance: &ErrorTolerance<S>) -> Self::State {
        self.0.allowed_error(x, tolerance)
    }
}

impl<S: Scalar, D: Series<S>> Series<S> for Unreduced<D> {
    fn series<const HALF: usize>(
        &self,
        t: S,
        x: &Self::State,
        unit: S,
        coefficients: &mut TaylorCoefficients<Self::State, HALF>,
    ) {
        self.0.series(t, x, unit, coefficients);
    }
}

const TURNS: f64 = 160_000.0;

/// ψ(0) = 0.2 after so many turns, rounded.
fn start<S: Scalar>(turns: f64) -> State<S, 3> {
    let psi = 0.2 + turns * TAU;
    let number = S::from_f64;
    State::new(
        S::zero(),
        [0.0, 0.5, psi].map(number),
        [0.3, 0.0, 20.0].map(number),
    )
}

/// The largest difference in θ and in the velocities.
fn error(state: &Phase<f64, 3>, reference: &Phase<DoubleDouble, 3>) -> f64 {
    let found = state
        .components()
        .skip(1)
        .zip(reference.components().skip(1));
    // ψ itself is rounded.
    let found = found.enumerate().filter(|(i, _)| *i != 1);
    found.fold(0.0, |most, (_, (x, exact))| {
        most.max((DoubleDouble::from(x) - exact).to_f64().abs())
    })
}

const END: f64 = 10.0;

fn report(method: &str, (reduced, unreduced): (f64, f64), bound: f64, gain: f64) {
    println!("{method}: error {reduced:e}, without the reduction {unreduced:e}");
    assert!(reduced < bound, "{method}: {reduced:e}");
    assert!(unreduced > gain * reduced, "{method}: {unreduced:e}");
}

/// Every method, beside itself without the reduction; ψ begins with 160 000 turns.
#[test]
fn the_motion_of_a_top_is_as_accurate_after_many_turns() {
    assert_eq!(<Top as GeneralizedCoordinates<3>>::PERIODS, [1, 1, 1]);
    let reference = TOP.dynamics();
    let reference = Taylor::order_40().integrate_to(&reference, start(TURNS), END);
    let exact = reference.unwrap().x;
    let (with, without) = (&TOP.dynamics(), &Unreduced(TOP.dynamics()));
    let start = start::<f64>(TURNS);

    let method = Taylor::new();
    let found = method.integrate_to(with, start, END).unwrap().x;
    let poor = method.integrate_to(without, start, END).unwrap().x;
    let errors = (error(&found, &exact), error(&poor, &exact));
    report("Taylor", errors, 1e-14, 1000.0);

    let method = Dop853::new()
        .relative_tolerance(1e-15)
        .absolute_tolerance(1e-15);
    let found = method.integrate_to(with, start, END).unwrap().x;
    let poor = method.integrate_to(without, start, END).unwrap().x;
    let errors = (error(&found, &exact), error(&poor, &exact));
    report("Dop853", errors, 1e-13, 1000.0);
}

/// The same steps with the digits of double-doubles have the same error of the method.
#[test]
fn fixed_steps_have_small_rounding_errors_after_many_turns() {
    let method = RungeKutta::classical(0.005);
    let exact = TOP.dynamics();
    let exact = method.integrate_to(&exact, start(TURNS), 1.0).unwrap().x;
    let start = start::<f64>(TURNS);
    let found = method.integrate_to(&TOP.dynamics(), start, 1.0);
    let poor = method.integrate_to(&Unreduced(TOP.dynamics()), start, 1.0);
    let (found, poor) = (found.unwrap().x, poor.unwrap().x);
    let errors = (error(&found, &exact), error(&poor, &exact));
    report("Runge and Kutta", errors, 1e-13, 1000.0);
}

/// From small angles on, ψ grows to 1000 rad, whose rounding error is 250 times that of π. The error at one time is
/// chance: the root of its mean square over ten ends is compared, with three units in the last place of ψ̇, which is 20.
/// Series in quasi-velocities need ψ for the kinematics alone, and lose less than a digit without the reduction.
#[test]
#[ignore = "a long motion; run with `--include-ignored`"]
fn a_top_that_spins_for_long_keeps_its_digits() {
    let ends: Vec<f64> = (0..10).map(|i| 50.0 + f64::from(i)).collect();
    let exact = TOP.dynamics();
    let exact = Taylor::order_40().sample(&exact, start(0.0), &ends);
    let exact = exact.unwrap();
    let start = start::<f64>(0.0);
    let mean = |errors: [f64; 10]| (errors.iter().map(|e| e * e).sum::<f64>() / 10.0).sqrt();
    let errors = |found: Trajectory<Phase<f64, 3>>| {
        mean(core::array::from_fn(|i| {
            error(&found.samples()[i].x, &exact.samples()[i].x)
        }))
    };
    let found = Taylor::new().sample(&TOP.dynamics(), start, &ends);
    let poor = Taylor::new().sample(&Unreduced(TOP.dynamics()), start, &ends);
    let (found, poor) = (found.unwrap(), poor.unwrap());
    assert!(found.last().x.q[Top::PSI] > 900.0);
    report("A long spin", (errors(found), errors(poor)), 1.1e-14, 5.0);
}

/// States and samples go on counting turns.
#[test]
fn samples_count_turns() {
    let times: Vec<f64> = (1..40).map(|i| 0.251 * f64::from(i)).collect();
    let exact = TOP.dynamics();
    let exact = Taylor::order_40().sample(&exact, start::<DoubleDouble>(TURNS), &times);
    let exact = exact.unwrap();
    let method = Dop853::new()
        .relative_tolerance(1e-13)
        .absolute_tolerance(1e-13);
    let dynamics = TOP.dynamics();
    let start = start::<f64>(TURNS);
    let of_stages = method.sample(&dynamics, start, &times).unwrap();
    let of_series = Taylor::new().sample(&dynamics, start, &times).unwrap();
    let fixed = RungeKutta::classical(1e-3).sample(&dynamics, start, &times);
    let fixed = fixed.unwrap();
    for (i, exact) in exact.states().enumerate() {
        let ends = [&of_stages, &of_series, &fixed].map(|x| x.samples()[i]);
        for (sample, tolerance) in ends.iter().zip([1e-11, 1e-13, 1e-6]) {
            let psi = sample.x.q[Top::PSI];
            // Four units in the last place of ψ.
            let error = (DoubleDouble::from(psi) - exact.q[Top::PSI]).to_f64().abs();
            assert!(error < 4.7e-10 + tolerance, "{psi}: {error:e}");
            let error = (DoubleDouble::from(sample.x.q[Top::THETA]) - exact.q[Top::THETA]).to_f64();
            assert!(error.abs() < tolerance, "{error:e}");
        }
    }
}

#[test]
fn small_angles_have_the_same_bits() {
    let start = State::new(0.0, [0.2, 0.5, -0.7], [0.3, 0.0, 1.5]);
    let (with, without) = (TOP.dynamics(), Unreduced(TOP.dynamics()));
    let method = Dop853::new();
    let times = [0.5, 1.0, 2.0];
    let samples = method.sample(&with, start, &times).unwrap();
    let expected = method.sample(&without, start, &times).unwrap();
    assert_eq!(samples.samples(), expected.samples());
    let samples = Taylor::new().sample(&with, start, &times).unwrap();
    let expected = Taylor::new().sample(&without, start, &times).unwrap();
    assert_eq!(samples.samples(), expected.samples());
    let method = RungeKutta::classical(0.01);
    let samples = method.sample(&with, start, &times).unwrap();
    let expected = method.sample(&without, start, &times).unwrap();
    assert_eq!(samples.samples(), expected.samples());
}

/// A full turn changes the sign of the torque, two do not.
#[test]
fn half_an_angle_has_a_period_of_two_turns() {
    assert_eq!(<Rotor as GeneralizedCoordinates<1>>::PERIODS, [2]);
    let rotor = Rotor { k: 3.0 };
    let dynamics = rotor.dynamics();
    for turns in [7.0, 20.0, 1001.0, -333.0] {
        let here = Phase::new([0.7 + turns * TAU], [1.0]);
        let reduced = dynamics.reduced(&here, &here.zeroed());
        assert!(reduced.q[0].abs() <= TAU + 1e-9);
        let torque: f64 = dynamics.derivative(0.0, &reduced).v[0];
        let expected = 1.5 * (0.35 + turns * 0.5 * TAU).sin();
        assert!((torque - expected).abs() < 1e-12, "{torque} {expected}");
    }
}

#[test]
fn a_lane_is_integrated_as_it_is_alone() {
    let rotor = Rotor { k: 3.0 };
    let angles = [0.7, 1e3, -77_777.0, 4e6];
    let number = Lanes::from_f64;
    let start = State::new(number(0.0), [Lanes(angles)], [number(2.0)]);
    let method = RungeKutta::classical(0.01);
    let lanes = method
        .integrate_to(&rotor.dynamics(), start, 3.0)
        .unwrap()
        .x;
    for (lane, angle) in angles.into_iter().enumerate() {
        let start = State::new(0.0, [angle], [2.0]);
        let alone = method
            .integrate_to(&rotor.dynamics(), start, 3.0)
            .unwrap()
            .x;
        assert_eq!(lanes.q[0].lane(lane).to_bits(), alone.q[0].to_bits());
        assert_eq!(lanes.v[0].lane(lane).to_bits(), alone.v[0].to_bits());
    }
}

/// A law that turns the motor by 20 turns sees how many are left.
#[test]
fn a_control_law_counts_turns() {
    assert_eq!(<Motor as GeneralizedCoordinates<1>>::PERIODS, [1]);
    let motor = Motor { torque: 0.0 };
    let target = 20.0 * TAU;
    let most = Cell::new(0.0_f64);
    let torque = |state: &State<f64, 1>| {
        most.set(most.get().max(state.q[0]));
        [4.0 * (target - state.q[0]) - 4.0 * state.v[0]]
    };
    let start = State::new(0.0, [0.0], [0.0]);
    let end = Dop853::new().integrate_to(&motor.controlled_by(torque), start, 40.0);
    assert!((end.unwrap().x.q[0] - target).abs() < 1e-6);
    assert!(most.get() > 100.0);

    let follower = |state: &State<f64, 1>, filtered: &SVector<f64, 1>| {
        let error = [state.q[0] - filtered[0]];
        (torque(state), error)
    };
    let start = (start, [0.0]);
    let end = Dop853::new().integrate_to(&motor.with_controller(follower), start, 40.0);
    let end = end.unwrap().x;
    assert!((end.q[0] - target).abs() < 1e-6);
    assert!((end.controller[0] - target).abs() < 1e-6);
}
