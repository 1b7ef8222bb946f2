//! Where accelerations can come to be singular, and what an integration makes of it.

use lagrangian::prelude::*;
use lagrangian::{GeneralizedCoordinates, IntegrationError};

/// The symmetric top, which is solved by its angular velocity.
#[derive(Lagrangian, Clone)]
#[lagrangian(
    coordinates(phi, theta, psi),
    kinetic = 0.5 * (i * (dot(phi).powi(2) * sin(theta).powi(2) + dot(theta).powi(2))
        + i_s * (dot(phi) * cos(theta) + dot(psi)).powi(2)),
    potential = mgl * cos(theta),
)]
struct Top {
    i: f64,
    i_s: f64,
    mgl: f64,
}

/// Two equal links, of which M is regular whatever m and l are, unless one is zero.
#[derive(Lagrangian, Clone)]
#[lagrangian(
    coordinates(q1, q2),
    kinetic = m * l.powi(2)
        * (dot(q1).powi(2) + 0.5 * dot(q2).powi(2) + dot(q1) * dot(q2) * cos(q1 - q2)),
    potential = -m * g * l * (2.0 * cos(q1) + cos(q2)),
)]
struct EqualLinks {
    m: f64,
    g: f64,
    l: f64,
}

/// Two links of which M is singular where a mass is negative: det M ∝ m₂ (m₁ + m₂ sin²(q₁ − q₂)).
#[derive(Lagrangian, Clone)]
#[lagrangian(
    coordinates(q1, q2),
    define(x1 = sin(q1), y1 = -cos(q1), x2 = x1 + sin(q2), y2 = y1 - cos(q2)),
    kinetic = 0.5 * m1 * (dot(x1).powi(2) + dot(y1).powi(2))
        + 0.5 * m2 * (dot(x2).powi(2) + dot(y2).powi(2)),
)]
struct Links {
    m1: f64,
    m2: f64,
}

fn top() -> Top {
    Top {
        i: 1.2,
        i_s: 0.5,
        mgl: 5.1,
    }
}

#[test]
fn only_what_cannot_vanish_is_not_looked_at() {
    const { assert!(!<Top as GeneralizedCoordinates<3>>::STAYS_REGULAR) };
    const { assert!(<EqualLinks as GeneralizedCoordinates<2>>::STAYS_REGULAR) };
    // A mass may be negative.
    const { assert!(!<Links as GeneralizedCoordinates<2>>::STAYS_REGULAR) };
}

#[test]
fn the_pivots_of_a_top_are_those_of_its_kinematics() {
    for theta in [1e-3, 0.5, 2.0, 3.0, 3.1] {
        let state = State::new(0.0, [0.3, theta, 0.2], [0.1, 0.2, 0.3]);
        let sine = f64::sin(theta);
        let expected = sine / (sine + theta.min(1.0) * f64::cos(theta).abs());
        let pivots = top().relative_pivots(&state);
        assert!((pivots[0] / expected - 1.0).abs() < 1e-12, "{pivots}");
        assert!((pivots[1] - 1.0).abs() < 1e-12 && (pivots[2] - 1.0).abs() < 1e-12);
    }
}

#[test]
fn a_pole_and_a_zero_inertia_are_errors_that_name_the_coordinate() {
    let pole = State::new(0.0, [0.0; 3], [0.0, 0.1, 0.2]);
    let regular = State::new(0.0, [0.0, 0.5, 0.0], [0.0, 0.1, 0.2]);
    let flat = Top { i_s: 0.0, ..top() };
    for (model, start, name) in [(top(), pole, "phi"), (flat, regular, "psi")] {
        let error = Problem::new(&model, start).solve(1.0, Dop853::new());
        let error = error.unwrap_err().error();
        let IntegrationError::SingularConfiguration { singularity, .. } = &error else {
            panic!("{error:?}");
        };
        assert_eq!(singularity.coordinate(), name);
    }
}

#[test]
fn a_mass_of_zero_is_an_error_where_nothing_is_looked_at_later() {
    let model = EqualLinks {
        m: 0.0,
        g: 9.81,
        l: 1.0,
    };
    let start = State::new(0.0, [0.3, 0.4], [0.0, 0.0]);
    let error = Problem::new(&model, start).solve(1.0, Dop853::new());
    assert!(matches!(
        error.unwrap_err().error(),
        IntegrationError::SingularConfiguration { .. }
    ));
}

#[test]
fn a_negative_mass_meets_its_singularity() {
    // m₁ + m₂ sin² = 0.5 sin² − 0.25: singular where links are at 45°.
    let model = Links { m1: -0.25, m2: 0.5 };
    let start = State::new(0.0, [0.0, 1.2], [0.5, -0.5]);
    let error = Problem::new(&model, start).solve(10.0, Dop853::new());
    let error = error.map_err(IntegrationError::from);
    let Err(
        IntegrationError::SingularConfiguration { time, .. }
        | IntegrationError::VanishingInertia { time, .. },
    ) = error
    else {
        panic!("{error:?}");
    };
    assert!(time > 0.0 && time < 10.0);
}
