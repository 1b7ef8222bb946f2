//! The size of an angle means nothing, and neither does the place of an ignorable coordinate.

use lagrangian::ErrorTolerance;
use lagrangian::prelude::*;

/// Two angles of which det M ≥ 1 wherever they are.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(a, b),
    kinetic = 0.5 * m * (dot(a).powi(2) + dot(b).powi(2) + (dot(a) + dot(b) * cos(a - b)).powi(2)),
    potential = k * (sin(a) + sin(b)),
)]
struct Linked {
    m: f64,
    k: f64,
}

/// A free particle beside a pendulum.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, theta),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(theta).powi(2)),
    potential = -m * cos(theta),
)]
struct Particle {
    m: f64,
}

fn steps<M: Lagrangian<2>>(model: &M, q: [f64; 2], v: [f64; 2]) -> u64 {
    let motion = Problem::new(model, State::new(0.0, q, v));
    let motion = motion.solve(10.0, Dop853::new().relative_tolerance(1e-12));
    motion.expect("a regular motion").statistics.steps
}

#[test]
fn whole_turns_end_no_motion() {
    assert_eq!(<Linked as GeneralizedCoordinates<2>>::ANGLES, [true, true]);
    let model = Linked { m: 1.0, k: 0.3 };
    let turns = 5000.0 * 2.0 * std::f64::consts::PI;
    let near = steps(&model, [0.4, 1.0], [0.5, -0.2]);
    let far = steps(&model, [0.4 + turns, 1.0 + turns], [0.5, -0.2]);
    assert!(near.abs_diff(far) <= near / 5, "{near} and {far} steps");
}

#[test]
fn where_and_how_fast_a_free_particle_is_costs_nothing() {
    assert_eq!(
        <Particle as GeneralizedCoordinates<2>>::ANGLES,
        [false, true]
    );
    assert_eq!(
        <Particle as GeneralizedCoordinates<2>>::IGNORABLE,
        [true, false]
    );
    let model = Particle { m: 2.0 };
    let at_rest = steps(&model, [0.0, 1.0], [0.0, 0.0]);
    for (x, v) in [(1e6, 0.0), (0.0, 1e6), (-1e8, 7e3)] {
        let moving = steps(&model, [x, 1.0], [v, 0.0]);
        assert!(
            at_rest.abs_diff(moving) <= at_rest / 5,
            "{at_rest} and {moving} steps"
        );
    }
}

/// The symmetric top (4.7), of which neither φ nor ψ occurs anywhere.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    kinetic = 0.5 * (i * (dot(phi).powi(2) * sin(theta).powi(2) + dot(theta).powi(2))
        + i_s * (dot(phi) * cos(theta) + dot(psi)).powi(2)),
    potential = weight * cos(theta),
)]
struct Top {
    i: f64,
    i_s: f64,
    weight: f64,
}

/// What errors are compared with: how far an ignorable coordinate moves in a time near the step, 1 for an angle.
#[test]
fn sizes_do_not_depend_on_where_an_ignorable_coordinate_is() {
    let top = Top {
        i: 1.2,
        i_s: 0.5,
        weight: 5.1,
    };
    for psi in [0.0, 1e6] {
        let state = State::new(0.0, [0.0, 7.5, psi], [0.3, 0.0, -20.0]);
        let tolerance = ErrorTolerance {
            relative: 1.0,
            absolute: 0.0,
            rate: 2.0,
        };
        let sizes = top
            .dynamics()
            .allowed_error(&Phase::from(state), &tolerance);
        assert_eq!(sizes.q, SVector::from([0.15, 1.0, 10.0]));
        assert_eq!(sizes.v, SVector::from([0.3, 0.0, 20.0]));
    }
}
