//! What holds on one branch of a root, an absolute value, a minimum or a maximum only is not used.
//!
//! Each model is compared on both sides of its branches with equations written by hand.

use lagrangian::prelude::*;

/// Whether numbers agree to 1e-13 of the largest.
#[track_caller]
fn assert_near(found: &[f64], expected: &[f64]) {
    let size = expected.iter().fold(1.0_f64, |most, x| most.max(x.abs()));
    for (x, y) in found.iter().zip(expected) {
        assert!(
            (x - y).abs() < 1e-13 * size,
            "{found:?} is not {expected:?}"
        );
    }
}

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y, z),
    kinetic = 0.5 * a * dot(x).powi(2)
        + 0.5 * b * dot(y).powi(2)
        + 0.5 * c * (dot(z) + abs(x - 2.0) * dot(y)).powi(2),
)]
struct Distance {
    a: f64,
    b: f64,
    c: f64,
}

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y, z),
    kinetic = 0.5 * a * dot(x).powi(2)
        + 0.5 * b * dot(y).powi(2)
        + 0.5 * c * (dot(z) + max(x, 2.0) * dot(y)).powi(2),
)]
struct Greater {
    a: f64,
    b: f64,
    c: f64,
}

/// The accelerations of T = ½ a ẋ² + ½ b ẏ² + ½ c (ż + u ẏ)² with u = u(x), by hand: with w = ż + u ẏ, the
/// momenta are a ẋ, b ẏ + c u w and c w, of which the last two are constant.
fn by_hand([a, b, c]: [f64; 3], [u, slope]: [f64; 2], v: [f64; 3]) -> [f64; 3] {
    let w = v[2] + u * v[1];
    let x = c * w * slope * v[1] / a;
    // d(c w)/dt = 0, so that d(b ẏ + c u w)/dt = b ÿ + c w du/dt = 0.
    let y = -c * w * slope * v[0] / b;
    let z = -(slope * v[0] * v[1] + u * y);
    [x, y, z]
}

#[test]
fn gyroscopic_terms_follow_the_sign_of_an_absolute_value() {
    let inertias = [1.3, 1.7, 2.1];
    let [a, b, c] = inertias;
    let (distance, greater) = (Distance { a, b, c }, Greater { a, b, c });
    for x in [5.7, 2.5, 1.4, -3.0] {
        let v = [1.0, 1.5, 2.0];
        let state = State::new(0.0, [x, -5.8, -6.0], v);
        let side = if x > 2.0 { 1.0 } else { -1.0 };
        let expected = by_hand(inertias, [side * (x - 2.0), side], v);
        assert_near(distance.accelerations(&state).as_slice(), &expected);
        let slope = if x > 2.0 { 1.0 } else { 0.0 };
        let expected = by_hand(inertias, [x.max(2.0), slope], v);
        assert_near(greater.accelerations(&state).as_slice(), &expected);
    }
}

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2))
        + 0.5 * m * ((sqrt(2 * (1 + cos(y))) + 2 * cos(0.5 * y)) * dot(x)).powi(2),
)]
struct HalfAngle {
    m: f64,
}

#[test]
fn a_root_of_a_square_is_positive() {
    // √(2 (1 + cos y)) = 2 |cos ½y|: the factor k of ẋ is 4 cos ½y or 0, M = diag (1 + k², 1) m.
    for (y, k, slope) in [
        (0.5, 4.0 * 0.25_f64.cos(), -2.0 * 0.25_f64.sin()),
        (4.0, 0.0, 0.0),
    ] {
        let (vx, vy) = (1.0, 2.0);
        let state = State::new(0.0, [0.3, y], [vx, vy]);
        let found = HalfAngle { m: 1.0 }.accelerations(&state);
        let expected = [
            -2.0 * k * slope * vx * vy / (1.0 + k * k),
            k * slope * vx * vx,
        ];
        assert_near(found.as_slice(), &expected);
    }
}

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * a * (dot(x).powi(2) + dot(y).powi(2)),
    potential = (sqrt(x.powi(2) - 12 * x + 36) + x - 6) * dot(y),
)]
struct Charge {
    a: f64,
}

#[test]
fn a_potential_of_velocities_is_in_the_energy_where_it_is_not_zero() {
    // V = (|x − 6| + x − 6) ẏ = 2 (x − 6) ẏ beyond 6 and 0 before. It is linear in the velocities, so that the
    // energy function is T.
    for (x, slope) in [(8.0, 2.0), (3.0, 0.0)] {
        let charge = Charge { a: 1.0 };
        let state = State::new(0.0, [x, 0.0], [0.5, 2.0]);
        assert_near(&[charge.energy(&state)], &[2.125]);
        // a ẍ = −(∂V/∂x) and a ÿ = d/dt ∂V/∂ẏ.
        let found = charge.accelerations(&state);
        assert_near(found.as_slice(), &[-slope * 2.0, slope * 0.5]);
    }
}

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * m * dot(x).powi(2) + 0.5 * m * (abs(sin(x)) + sin(x) + 1.0).powi(2) * dot(y).powi(2),
)]
struct Ridge {
    m: f64,
}

#[test]
fn a_mass_matrix_that_is_regular_on_one_branch_is_regular() {
    for x in [0.7_f64, -0.7] {
        let state = State::new(0.0, [x, 0.0], [1.2, 0.8]);
        let found = Ridge { m: 2.0 }.accelerations(&state);
        let (k, slope) = if x > 0.0 {
            (2.0 * x.sin() + 1.0, 2.0 * x.cos())
        } else {
            (1.0, 0.0)
        };
        let expected = [k * slope * 0.8 * 0.8, -2.0 * slope * 1.2 * 0.8 / k];
        assert_near(found.as_slice(), &expected);
    }
}

/// Turned by the angle of which (√(1 − s²), s) are cosine and sine.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(s),
    define(
        c = sqrt(1.0 - s.powi(2)),
        r = [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]],
        w = angular_velocity(r),
    ),
    kinetic = 0.5 * inertia * w.norm_squared(),
)]
struct BySine {
    inertia: f64,
}

#[test]
fn a_rotation_with_a_root_turns_at_the_rate_of_its_angle() {
    // s = sin α: T = ½ I ṡ²/(1 − s²), s̈ = −s ṡ²/(1 − s²).
    let state = State::new(0.0, [0.6], [0.5]);
    let found = BySine { inertia: 1.5 }.accelerations(&state);
    assert_near(found.as_slice(), &[-0.6 * 0.25 / 0.64]);
}

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, theta, phi),
    define(p = [sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)]),
    lagrangian = 0.5 * m * dot(x).powi(2)
        + 0.5 * m * dot(p).norm_squared()
        + c * dot(x) * atan2(dot(x), 0.0) * (1.0 + theta.powi(2))
        - k * acosh(x - 40.0),
)]
struct Piecewise {
    m: f64,
    c: f64,
    k: f64,
}

#[test]
fn what_is_linear_in_a_velocity_piece_by_piece_is_no_quadratic_form() {
    // ẋ atan2(ẋ, 0) = ½π |ẋ|: p_x = m ẋ ± ½π c (1 + θ²), m ẍ = ∓ ½π c 2 θ θ̇ − k/√((x − 40)² − 1).
    let [m, c, k] = [2.0, 0.7, 1.0];
    let half_turn = core::f64::consts::FRAC_PI_2;
    for side in [1.0, -1.0] {
        let (x, theta) = (42.5_f64, 0.8);
        let [vx, vt, vp] = [side * 0.9, 0.4, -0.3];
        let state = State::new(0.0, [x, theta, 0.3], [vx, vt, vp]);
        let model = Piecewise { m, c, k };
        let momentum = m * vx + side * half_turn * c * (1.0 + theta * theta);
        assert_near(&[model.momenta(&state)[0]], &[momentum]);
        let slope = k / ((x - 40.0).powi(2) - 1.0).sqrt();
        let found = model.accelerations(&state);
        let across =
            (side * half_turn * c * 2.0 * theta * vx) / m + theta.sin() * theta.cos() * vp * vp;
        let along = -(side * half_turn * c * 2.0 * theta * vt + slope) / m;
        assert_near(&found.as_slice()[..2], &[along, across]);
    }
}
