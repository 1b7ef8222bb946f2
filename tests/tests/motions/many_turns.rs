//! Angles that grow: an integration loses no digits with the turns that they count.

use std::cell::Cell;
use std::f64::consts::TAU;

use lagrangian::prelude::*;
use lagrangian::{
    DoubleDouble, EquationsOfMotion, ErrorTolerance, Lanes, Series, SeriesMemory,
    TaylorCoefficients,
};

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
        begin: (S, &Self::State),
        unit: S,
        coefficients: &mut TaylorCoefficients<Self::State, HALF>,
        memory: Option<&mut SeriesMemory>,
    ) {
        self.0.series(begin, unit, coefficients, memory);
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

type Motion = EquationsOfMotion<&'static Top, f64, 3>;

/// The samples of a motion of the top at some times by a method, and those without the reduction.
fn sampled<I>(method: I, start: State<f64, 3>, times: &[f64]) -> [Vec<State<f64, 3>>; 2]
where
    I: Copy + Integrator<f64, Motion> + Integrator<f64, Unreduced<Motion>>,
{
    let end = *times.last().unwrap();
    let with = Problem::new(&TOP, start).save(times).solve(end, method);
    let without = Problem::new(Unreduced(TOP.dynamics()), start);
    let without = without.save(times).solve(end, method);
    [
        with.unwrap().samples().to_vec(),
        without.unwrap().samples().to_vec(),
    ]
}

/// The errors at the end of a motion after many turns, with the reduction and without.
fn errors<I>(method: I, end: f64, exact: &Phase<DoubleDouble, 3>) -> (f64, f64)
where
    I: Copy + Integrator<f64, Motion> + Integrator<f64, Unreduced<Motion>>,
{
    let ends = sampled(method, start(TURNS), &[end]);
    let [with, without] = ends.map(|end| error(&end[0].x, exact));
    (with, without)
}

/// Every method, beside itself without the reduction; ψ begins with 160 000 turns.
#[test]
fn the_motion_of_a_top_is_as_accurate_after_many_turns() {
    assert_eq!(<Top as GeneralizedCoordinates<3>>::PERIODS, [1, 1, 1]);
    let exact = Problem::new(&TOP, start(TURNS)).solve(END, Taylor::order_40());
    let exact = exact.unwrap().x;
    let of_series = errors(Taylor::new(), END, &exact);
    report("Taylor", of_series, 1e-14, 1000.0);
    let method = Dop853::new()
        .relative_tolerance(1e-15)
        .absolute_tolerance(1e-15);
    let of_stages = errors(method, END, &exact);
    report("Dop853", of_stages, 1e-13, 1000.0);
}

/// The same steps with the digits of double-doubles have the same error of the method.
#[test]
fn fixed_steps_have_small_rounding_errors_after_many_turns() {
    let method = RungeKutta::classical(0.005);
    let exact = Problem::new(&TOP, start(TURNS)).solve(1.0, method);
    let errors = errors(method, 1.0, &exact.unwrap().x);
    report("Runge and Kutta", errors, 1e-13, 1000.0);
}

/// From small angles on, ψ grows to 1000 rad, whose rounding error is 250 times that of π. The error at one time is
/// chance: the root of its mean square over ten ends is compared, with three units in the last place of ψ̇, which is 20.
/// Series in quasi-velocities need ψ for the kinematics alone, and lose less than a digit without the reduction.
#[test]
#[ignore = "a long motion; run with `--include-ignored`"]
fn a_top_that_spins_for_long_keeps_its_digits() {
    let ends: Vec<f64> = (0..10).map(|i| 50.0 + f64::from(i)).collect();
    let exact = Problem::new(&TOP, start::<DoubleDouble>(0.0)).save(&ends);
    let exact = exact.solve(59.0, Taylor::order_40()).unwrap();
    let mean = |errors: [f64; 10]| (errors.iter().map(|e| e * e).sum::<f64>() / 10.0).sqrt();
    let errors = |found: Vec<State<f64, 3>>| {
        mean(core::array::from_fn(|i| {
            error(&found[i].x, &exact.samples()[i].x)
        }))
    };
    let [found, poor] = sampled(Taylor::new(), start(0.0), &ends);
    assert!(found[9].q[Top::PSI] > 900.0);
    report("A long spin", (errors(found), errors(poor)), 1.1e-14, 5.0);
}

/// States and samples go on counting turns.
#[test]
fn samples_count_turns() {
    let times: Vec<f64> = (1..40).map(|i| 0.251 * f64::from(i)).collect();
    let exact = Problem::new(&TOP, start::<DoubleDouble>(TURNS)).save(&times);
    let exact = exact.solve(times[38], Taylor::order_40()).unwrap();
    let method = Dop853::new()
        .relative_tolerance(1e-13)
        .absolute_tolerance(1e-13);
    let problem = Problem::new(&TOP, start::<f64>(TURNS)).save(&times);
    let of_stages = problem.clone().solve(times[38], method).unwrap();
    let of_series = problem.clone().solve(times[38], Taylor::new()).unwrap();
    let fixed = problem.solve(times[38], RungeKutta::classical(1e-3));
    let fixed = fixed.unwrap();
    for (i, exact) in exact.samples().iter().enumerate() {
        let ends = [&of_stages, &of_series, &fixed].map(|motion| motion.samples()[i]);
        for (sample, tolerance) in ends.iter().zip([1e-11, 1e-13, 1e-6]) {
            let psi = sample.q[Top::PSI];
            // Four units in the last place of ψ.
            let error = (DoubleDouble::from(psi) - exact.q[Top::PSI]).to_f64().abs();
            assert!(error < 4.7e-10 + tolerance, "{psi}: {error:e}");
            let error = (DoubleDouble::from(sample.q[Top::THETA]) - exact.q[Top::THETA]).to_f64();
            assert!(error.abs() < tolerance, "{error:e}");
        }
    }
}

#[test]
fn small_angles_have_the_same_bits() {
    let start = State::new(0.0, [0.2, 0.5, -0.7], [0.3, 0.0, 1.5]);
    let times = [0.5, 1.0, 2.0];
    let [with, without] = sampled(Dop853::new(), start, &times);
    assert_eq!(with, without);
    let [with, without] = sampled(Taylor::new(), start, &times);
    assert_eq!(with, without);
    let [with, without] = sampled(RungeKutta::classical(0.01), start, &times);
    assert_eq!(with, without);
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
    let lanes = Problem::new(&rotor, start).solve(3.0, method).unwrap();
    for (lane, angle) in angles.into_iter().enumerate() {
        let start = State::new(0.0, [angle], [2.0]);
        let alone = Problem::new(&rotor, start).solve(3.0, method).unwrap();
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
    let problem = Problem::new(&motor, start);
    let end = problem.clone().feedback(torque).solve(40.0, Dop853::new());
    assert!((end.unwrap().q[0] - target).abs() < 1e-6);
    assert!(most.get() > 100.0);

    let follower = |state: &State<f64, 1>, filtered: &SVector<f64, 1>| {
        let error = [state.q[0] - filtered[0]];
        (torque(state), error)
    };
    let problem = problem.feedback_with_states([0.0], follower);
    let end = problem.solve(40.0, Dop853::new()).unwrap();
    assert!((end.q[0] - target).abs() < 1e-6);
    assert!((end.z[0] - target).abs() < 1e-6);
}
