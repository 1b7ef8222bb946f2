//! Equilibria, against closed forms.

mod common;

use common::assert_close;
use lagrangian::analysis::{EquilibriumError, EquilibriumSearch, Variable};
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
