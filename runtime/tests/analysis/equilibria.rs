//! Equilibria, against closed forms.

use crate::common::assert_close;
use lagrangian::analysis::{
    EquilibriumError, EquilibriumSearch, OscillationError, SmallOscillations, Variable,
};
use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(a, b),
    define(
        p = l * [sin(a), -cos(a)],
        q = p + l * [sin(b), -cos(b)],
    ),
    kinetic = 0.5 * m * (dot(p).norm_squared() + dot(q).norm_squared()),
    potential = m * g * (p.y + q.y),
    force(a = shoulder - elbow, b = elbow),
)]
struct DoublePendulum {
    m: f64,
    l: f64,
    g: f64,
    #[lagrangian(input)]
    shoulder: f64,
    #[lagrangian(input)]
    elbow: f64,
}

const ARM: DoublePendulum = DoublePendulum {
    m: 1.5,
    l: 0.5,
    g: 9.81,
    shoulder: 0.0,
    elbow: 0.0,
};

fn rest<const N: usize>(q: [f64; N]) -> State<f64, N> {
    State::new(0.0, q, [0.0; N])
}

#[test]
fn all_equilibria_of_a_double_pendulum() {
    let pi = std::f64::consts::PI;
    for [a, b] in [[0.0, 0.0], [0.0, pi], [pi, 0.0], [pi, pi]] {
        for offset in [0.2, -0.25] {
            let guess = rest([a + offset, b - 0.7 * offset]);
            let found = EquilibriumSearch::of(&ARM).near(&guess).unwrap();
            assert_close(found.state.q[0], a, 1e-14);
            assert_close(found.state.q[1], b, 1e-14);
            assert!(found.report.residual < 1e-12, "{:?}", found.report);
            assert_eq!(found.report.rank, 2);
        }
    }
}

/// Where the Jacobian is singular, or nearly so, Newton's step is endless; it is shortened.
#[test]
fn from_a_place_without_a_slope() {
    let quarter = std::f64::consts::FRAC_PI_2;
    let found = EquilibriumSearch::of(&ARM)
        .near(&rest([quarter, quarter]))
        .unwrap();
    for angle in found.state.q.iter() {
        assert_close(angle.sin(), 0.0, 1e-13);
    }
    assert!(found.report.iterations > 1);
}

/// Torques about both joints against the weights.
#[test]
fn trim() {
    let [a, b] = [0.7, -0.4];
    let found = EquilibriumSearch::trim(&ARM)
        .unknown(&[
            Variable::Input(DoublePendulum::SHOULDER),
            Variable::Input(DoublePendulum::ELBOW),
        ])
        .near(&rest([a, b]))
        .unwrap();
    let weight = ARM.m * ARM.g * ARM.l;
    let elbow = weight * b.sin();
    assert_close(found.inputs[1], elbow, 1e-13);
    assert_close(found.inputs[0], 2.0 * weight * a.sin() + elbow, 1e-13);
    assert_eq!(found.state, rest([a, b]));

    // The elbow alone holds where its torque and the angle of the upper arm are right.
    let found = EquilibriumSearch::trim(&ARM)
        .unknown(&[
            Variable::Coordinate(DoublePendulum::A),
            Variable::Input(DoublePendulum::ELBOW),
        ])
        .near(&rest([0.1, b]))
        .unwrap();
    assert_close(found.inputs[1], elbow, 1e-13);
    assert_close(2.0 * found.state.q[0].sin(), -b.sin(), 1e-13);
}

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, z),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(z).powi(2)),
    potential = m * g * z,
)]
struct Stone {
    m: f64,
    g: f64,
}

#[test]
fn what_cannot_be_balanced() {
    let search = EquilibriumSearch::trim(&ARM);
    let error = search
        .unknown(&[Variable::Input(DoublePendulum::ELBOW)])
        .near(&rest([0.7, -0.4]))
        .unwrap_err();
    let EquilibriumError::Unbalanced { residual, last, .. } = error else {
        panic!("{error}");
    };
    assert!(residual > 1.0);
    let forces = ARM.with_inputs(last.inputs).accelerations(&last.state);
    assert_close(forces.amax(), residual, 1e-12);

    let error = EquilibriumSearch::of(&Stone { m: 1.0, g: 9.81 })
        .near(&rest([0.0, 1.0]))
        .unwrap_err();
    assert!(error.to_string().contains("do not act on `z`"), "{error}");
    assert!(error.to_string().contains("9.81"), "{error}");
}

/// A double pendulum whose upper rod has no mass: M is singular where both rods are in one line.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(a, b),
    define(
        p = l * [sin(a), -cos(a)],
        q = p + l * [sin(b), -cos(b)],
    ),
    kinetic = 0.5 * m * dot(q).norm_squared(),
    potential = m * g * q.y,
)]
struct MasslessRod {
    m: f64,
    l: f64,
    g: f64,
}

/// A body in gimbals with springs: M is singular at b = 0, where the equilibrium is.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(a, b, c),
    define(r = rotation_zxz(a, b, c), w = angular_velocity(r)),
    kinetic = 0.5 * w.dot(diagonal([i, j, k]) * w),
    potential = 0.5 * s * (a * a + b * b + c * c),
)]
struct Gimbals {
    i: f64,
    j: f64,
    k: f64,
    s: f64,
}

/// Near a singular mass matrix accelerations are small beside their derivatives everywhere: forces are balanced, too.
#[test]
fn no_equilibria_at_singular_mass_matrices() {
    let rod = MasslessRod {
        m: 1.0,
        l: 1.0,
        g: 9.81,
    };
    for guess in [[0.1, 0.2], [0.5, -0.5], [0.1, 3.0]] {
        match EquilibriumSearch::of(&rod).near(&rest(guess)) {
            Ok(found) => assert_close(rod.forcing(&found.state).norm(), 0.0, 1e-8),
            Err(error) => assert!(error.last().is_some(), "{error}"),
        }
    }
    let error = EquilibriumSearch::of(&rod).near(&rest([0.1, 0.2]));
    let error = error.unwrap_err();
    assert!(
        matches!(error, EquilibriumError::SingularMass { force, .. } if (force.abs() - 9.81).abs() < 1e-6),
        "{error}"
    );
    let gimbals = Gimbals {
        i: 1.0,
        j: 2.0,
        k: 3.0,
        s: 1.0,
    };
    for guess in [
        [0.1, 0.2, 0.1],
        [0.3, 0.2, 0.1],
        [0.5, 1.0, -0.3],
        [0.01, 0.5, 0.4],
        [1.0, 1.0, 1.0],
        [0.1, 0.1, -0.1],
        [0.2, 0.01, 0.3],
    ] {
        match EquilibriumSearch::of(&gimbals).near(&rest(guess)) {
            Ok(found) => assert_close(found.state.q.norm(), 0.0, 1e-8),
            Err(EquilibriumError::NoConvergence { .. }) => {}
            Err(error) => assert!(
                matches!(error, EquilibriumError::SingularMass { .. }),
                "{error}"
            ),
        }
    }
    // Where a search ended before.
    let state = rest([0.0908, 5.6e-7, 0.0908]);
    let about = SmallOscillations::about(&gimbals, &state).unwrap_err();
    assert!(
        matches!(about, OscillationError::Unbalanced { .. }),
        "{about}"
    );
}
