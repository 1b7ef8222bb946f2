//! Velocities that have given momenta, for convex Lagrangians whose mass matrix vanishes or is infinite at rest.

use lagrangian::prelude::*;
use lagrangian::quantities::Hamiltonian;
use lagrangian::{CanonicalPhase, DoubleDouble, Dual, Lanes, NoVelocities};

/// Declares L(q̇) in one coordinate.
macro_rules! line {
    ($name:ident, $($lagrangian:tt)*) => {
        #[derive(Lagrangian)]
        #[lagrangian(coordinates(x), lagrangian = $($lagrangian)*, hamiltonian)]
        struct $name;
    };
}

line!(
    ThreeHalves,
    abs(dot(x)).powf(1.5) + 0.5 * dot(x).powi(2) - 0.5 * x.powi(2)
);
line!(Pure, abs(dot(x)).powf(1.5) - 0.5 * x.powi(2));
line!(Steep, abs(dot(x)).powf(1.1) - 0.5 * x.powi(2));
line!(Fourth, 0.25 * dot(x).powi(4) - 0.5 * x.powi(2));
line!(
    Tenth,
    0.1 * dot(x).powi(10) + 0.001 * dot(x).powi(4) - 0.5 * x.powi(2)
);
line!(Cosh, cosh(dot(x)) - 0.5 * x.powi(2));
line!(Exponential, exp(dot(x)) - 0.5 * x.powi(2));
line!(
    Relativistic,
    -4 * sqrt(1 - dot(x).powi(2) / 4) - 0.5 * x.powi(2)
);
line!(
    Shifted,
    abs(dot(x) - 3).powf(1.5) + dot(x) - 0.5 * x.powi(2)
);
line!(
    DoubleWell,
    dot(x).powi(4) - dot(x).powi(2) - 0.5 * x.powi(2)
);
line!(Third, dot(x).powi(3) - 0.5 * x.powi(2));

fn round_trip<M: Lagrangian<1, Model: Hamiltonian<1>>>(
    name: &str,
    model: &M,
    velocities: &[f64],
    tolerance: f64,
) {
    for v in velocities {
        let state = State::new(0.0, [0.1], [*v]);
        let phase = model.canonical_equations().canonical(&state).x;
        let found = model.velocities(0.0, &phase);
        let found = found.unwrap_or_else(|error| panic!("{name} at {v}: {error}"))[0];
        let error = (found - v).abs();
        assert!(
            error <= tolerance * v.abs(),
            "{name} at {v}: {found}, {error:e}"
        );
    }
}

#[test]
fn strictly_convex_lagrangians_have_velocities() {
    let all = [0.0, 1.0, -1.0, 1e-3, -0.3, 7.0, 1e3, -1e6, 1e-8, -1e-12];
    round_trip("|v|^1.5 + v²/2", &ThreeHalves, &all, 1e-14);
    round_trip("|v|^1.5", &Pure, &all, 1e-14);
    round_trip("|v|^1.1", &Steep, &all, 1e-13);
    round_trip("v⁴", &Fourth, &all, 1e-14);
    round_trip("v¹⁰", &Tenth, &[0.0, 1.0, -1.0, 0.3, -7.0, 1e3], 1e-13);
    round_trip(
        "cosh v",
        &Cosh,
        &[0.0, 1.0, -1e-3, 10.0, -50.0, 300.0],
        1e-13,
    );
    round_trip(
        "exp v",
        &Exponential,
        &[1.0, -1.0, 1e-3, 30.0, -20.0, 300.0],
        1e-12,
    );
    round_trip(
        "relativistic",
        &Relativistic,
        &[0.0, 1.0, -1.9, 1e-9, 1.999_999],
        1e-9,
    );
    round_trip(
        "|v − 3|^1.5",
        &Shifted,
        &[4.0, 2.0, 3.1, 0.0, -50.0, 2.9],
        1e-13,
    );
}

#[test]
fn others_have_none() {
    // The momentum exp v is positive.
    for p in [0.0, -1.0] {
        let phase = CanonicalPhase::new([0.0], [p]);
        let error = Exponential.velocities(0.0, &phase).unwrap_err();
        assert!(matches!(error, NoVelocities::NotFound { .. }), "{error}");
    }
    // At rest with p = 0, to which other velocities belong, too.
    for velocity in [0.0, 0.1, 0.7] {
        let state = State::new(0.0, [0.0], [velocity]);
        let phase = DoubleWell.canonical_equations().canonical(&state).x;
        let found = DoubleWell.velocities(0.0, &phase);
        assert!(
            velocity > 0.5 || found == Err(NoVelocities::NotConvex),
            "{found:?}"
        );
    }
    let error = Third.velocities(0.0, &CanonicalPhase::new([0.0], [0.0]));
    assert!(error.is_err(), "{error:?}");
}

/// Strictly convex, coupled, and neither regular at rest nor where a velocity vanishes.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y, z),
    lagrangian = abs(dot(x)).powf(1.5) + 0.25 * (dot(y) - dot(x)).powi(4) + 0.5 * (dot(z) + 2 * dot(y)).powi(2)
        + abs(dot(x) + dot(z)).powf(1.25) - 0.5 * (x * x + y * y + z * z),
    hamiltonian,
)]
struct Coupled;

#[test]
fn several_velocities() {
    let mut seed = 1_u64;
    let mut random = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        f64::from(u32::try_from(seed >> 40).unwrap()) / f64::from(1 << 23) - 1.0
    };
    for n in 0..200 {
        let size = [1.0, 10.0, 0.1, 1e3][n % 4];
        let mut v: [f64; 3] = core::array::from_fn(|_| size * random());
        if n % 5 == 0 {
            v[n % 3] = 0.0;
        }
        let state = State::new(0.0, [0.0; 3], v);
        let phase = Coupled.canonical_equations().canonical(&state).x;
        let found = Coupled.velocities(0.0, &phase);
        let found = found.unwrap_or_else(|error| panic!("{v:?}: {error}"));
        let back = Coupled.momenta(&State::new(state.t, state.q, found));
        assert!(
            (back - phase.p).norm() <= 1e-12 * phase.p.norm(),
            "{v:?} {found:?}"
        );
        assert!((found - state.v).norm() <= 1e-6 * size, "{v:?} {found:?}");
    }
}

#[test]
fn other_scalars() {
    let phase = |p: f64| CanonicalPhase::new([0.1], [p]);
    let numbers = [1e-3, 0.7, -2.5, 0.0, 1e4, -1e-5, 3.0, 2.5];
    let alone = numbers.map(|p| ThreeHalves.velocities(0.0, &phase(p)).unwrap()[0]);
    let lanes = CanonicalPhase::new([Lanes::<8>::from_f64(0.1)], [Lanes::from(numbers)]);
    let found = ThreeHalves
        .velocities(Lanes::from_f64(0.0), &lanes)
        .unwrap()[0];
    for (lane, v) in alone.iter().enumerate() {
        assert!((found.lane(lane) - v).abs() <= 1e-14 * v.abs(), "{lane}");
    }
    for p in numbers {
        let precise = CanonicalPhase::new([DoubleDouble::from(0.1)], [DoubleDouble::from(p)]);
        let v = ThreeHalves
            .velocities(DoubleDouble::from(0.0), &precise)
            .unwrap()[0];
        // √v = (−3/2 + √(9/4 + 4 |p|))/2.
        let number = DoubleDouble::from_f64;
        let root = (number(2.25) + number(4.0) * number(p.abs())).sqrt();
        let root = number(p.abs()) * number(2.0) / (root + number(1.5));
        let error = (v.abs() - root * root).to_f64().abs();
        assert!(error <= 1e-28 * v.to_f64().abs(), "{p} {error:e}");
        let single = CanonicalPhase::new([0.1_f32], [<f32 as Scalar>::from_f64(p)]);
        let single = ThreeHalves.velocities(0.0_f32, &single).unwrap()[0];
        assert!((f64::from(single) - v.to_f64()).abs() <= 1e-6 * v.to_f64().abs());
    }
}

#[test]
fn derivatives_by_momenta_are_those_of_the_inverse() {
    for p in [1e-6, 0.3, 2.5, -40.0] {
        let phase = CanonicalPhase::new([Dual::from(0.1)], [Dual::new(p, [1.0])]);
        let v = ThreeHalves.velocities(Dual::from(0.0), &phase).unwrap()[0];
        let slope = 1.0 / (0.75 / v.value.abs().sqrt() + 1.0);
        assert!(
            (v.derivative[0] / slope - 1.0).abs() < 1e-12,
            "{p} {v} {slope}"
        );
    }
}

/// ẋ = ∂H/∂p through the rest, where M is infinite: a period of the motion keeps the energy.
#[test]
fn motions_through_rest() {
    let equations = ThreeHalves.canonical_equations();
    let start = equations.canonical(&State::new(0.0, [1.0], [0.0]));
    let end = Problem::new(&equations, start)
        .solve(20.0, Dop853::new())
        .unwrap();
    let [before, after] = [start.x, end.x].map(|x| ThreeHalves.hamiltonian(0.0, &x).unwrap());
    assert!((after - before).abs() < 1e-7, "{before} {after}");
}
