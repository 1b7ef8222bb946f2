//! A pendulum in Cartesian coordinates, against its solution in Jacobi's functions.

use lagrangian::elliptic::Modulus;
use lagrangian::prelude::*;
use lagrangian_tests::{Figures, relative_error};

/// Of positions and tensions, relative to the length and to the weight.
const TOLERANCE: f64 = 1e-9;
/// Of the energy, relative to the greatest kinetic energy.
const ENERGY_TOLERANCE: f64 = 1e-12;
/// Residuals, in lengths and in terms of the greatest speed times the length.
const ROUNDING: f64 = 1e-15;

/// A bob on a rod from the origin: x sideways, y upwards.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = m * g * y,
    constraint(rod = x.powi(2) + y.powi(2) - l.powi(2)),
    output(tension = -2.0 * l * reaction(rod)),
    taylor,
)]
struct CartesianPendulum {
    m: f64,
    g: f64,
    l: f64,
}

/// The pendulum of the tests, which is released with a horizontal rod.
const PENDULUM: CartesianPendulum = CartesianPendulum {
    m: 1.0,
    g: 9.81,
    l: 1.0,
};

#[test]
fn position_and_tension_follow_the_closed_form() {
    follow(&by_taylor(50.0));
}

#[test]
fn dormand_and_prince_follow_the_closed_form() {
    let method = Dop853::new()
        .relative_tolerance(1e-13)
        .absolute_tolerance(1e-13);
    let motion = Problem::new(&PENDULUM, release()).save(Every(0.1));
    follow(motion.solve(10.0, method).expect("a motion").samples());
}

#[test]
#[ignore = "a long integration; run with `--include-ignored`"]
fn eight_hundred_and_forty_five_swings_follow_the_closed_form() {
    follow(&by_taylor(2000.0));
}

#[test]
fn a_turning_pendulum_has_a_rod_that_pushes() {
    // It comes to rest at the top of its circle in an infinite time: the rod carries the weight.
    let CartesianPendulum { m, g, l } = PENDULUM;
    let top = State::new(0.0, [0.0, l], [0.0, 0.0]);
    let tension = PENDULUM.outputs(&top).tension;
    assert!((tension + m * g).abs() < 1e-14, "{tension}");
    assert_eq!(CartesianPendulum::CONSTRAINTS, ["rod"]);
}

/// At rest, with the rod to the left.
fn release() -> State<f64, 2> {
    State::new(0.0, [-PENDULUM.l, 0.0], [0.0, 0.0])
}

fn by_taylor(end: f64) -> Vec<State<f64, 2>> {
    let problem = Problem::new(&PENDULUM, release()).max_steps(10_000_000);
    let motion = problem.save(Every(end / 500.0)).solve(end, Taylor::new());
    motion.expect("a motion").samples().to_vec()
}

fn follow(samples: &[State<f64, 2>]) {
    let CartesianPendulum { m, g, l } = PENDULUM;
    let mut figures = Figures::new();
    let speed_squared = 2.0 * g * l;
    for state in samples {
        let at = format!("t = {}", state.t);
        let (position, tension) = closed_form(state.t);
        let error = relative_error(state.q.as_slice(), &position.map(|x| l * x), l);
        figures.record("position", &at, error, TOLERANCE);
        let found = PENDULUM.outputs(state).tension;
        let error = (found - m * g * tension).abs() / (m * g);
        figures.record("tension", &at, error, TOLERANCE);
        let energy = PENDULUM.energy(state) / (0.5 * m * speed_squared);
        figures.record("energy", &at, energy.abs(), ENERGY_TOLERANCE);
        let (positions, velocities) = PENDULUM.constraint_residuals(state);
        figures.record("length", &at, positions.amax() / (l * l), ROUNDING);
        let error = velocities.amax() / (l * speed_squared.sqrt());
        figures.record("rate of the length", &at, error, ROUNDING);
    }
    figures.finish();
}

/// The position over the length, and the tension over the weight, after the release from the left: sin ½θ = −k sn(K + ω t) with
/// k² = ½ and ω² = g/l.
fn closed_form(t: f64) -> ([f64; 2], f64) {
    let CartesianPendulum { g, l, .. } = PENDULUM;
    let modulus = Modulus::new(0.5, 0.5);
    let argument = modulus.complete_first() + (g / l).sqrt() * t;
    let (sn, cn, dn) = modulus.jacobi(argument);
    let k = 0.5_f64.sqrt();
    let cosine = 1.0 - sn * sn;
    // θ̇ = −2 k ω cn.
    ([-2.0 * k * sn * dn, -cosine], cosine + 2.0 * cn * cn)
}
