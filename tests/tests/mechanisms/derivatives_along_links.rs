//! Derivatives of the accelerations of a long mechanism, which are found along its links, against differences of order six.

use lagrangian::prelude::*;
use lagrangian_tests::Random;

/// Eight axially symmetric links on universal joints, under a support that is moved.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(q[8][2]),
    define(
        r[0] = rotation_x(q[0][0]) * rotation_y(q[0][1]),
        r[i] = r[i - 1] * rotation_x(q[i][0]) * rotation_y(q[i][1]) for i in 1..8,
        p[0] = [amplitude * sin(t), 0.0, 0.0],
        p[i] = p[i - 1] + r[i - 1] * [0.0, 0.0, -l] for i in 1..8,
        c[i] = p[i] + r[i] * [0.0, 0.0, -h] for i in 0..8,
        w[i] = angular_velocity(r[i]) for i in 0..8,
    ),
    kinetic = (0..8).map(|i| {
        0.5 * m[i] * dot(c[i]).norm_squared()
            + 0.5 * (i1 * (w[i].x.powi(2) + w[i].y.powi(2)) + i3 * w[i].z.powi(2))
    }).sum(),
    potential = (0..8).map(|i| m[i] * g * c[i].z).sum() + 0.5 * k * (q[2][0] - q[5][1]).powi(2),
    dissipation = 0.5 * damping * dot(q[3][0]).powi(2),
    force(q[1][1] = torque, q[7][0] = -2.0 * torque * cos(q[0][0])),
)]
struct Chain {
    m: [f64; 8],
    l: f64,
    h: f64,
    i1: f64,
    i3: f64,
    g: f64,
    k: f64,
    amplitude: f64,
    damping: f64,
    #[lagrangian(input)]
    torque: f64,
}

fn chain() -> Chain {
    Chain {
        m: [1.0, 0.8, 1.3, 0.5, 0.9, 0.7, 0.6, 0.8],
        l: 0.7,
        h: 0.4,
        i1: 0.05,
        i3: 0.02,
        g: 9.81,
        k: 0.3,
        amplitude: 0.2,
        damping: 0.4,
        torque: 0.6,
    }
}

/// By central differences of order six.
fn difference(value: impl Fn(f64) -> SVector<f64, 16>) -> SVector<f64, 16> {
    const STEP: f64 = 2e-3;
    let terms = [(1.0, 45.0), (2.0, -9.0), (3.0, 1.0)].map(|(steps, weight)| {
        let change = value(steps * STEP) - value(-steps * STEP);
        change * (weight / (60.0 * STEP))
    });
    terms.into_iter().sum()
}

#[track_caller]
fn assert_near(found: SVector<f64, 16>, expected: SVector<f64, 16>) {
    let error = (found - expected).norm() / (1.0 + expected.norm());
    assert!(error < 1e-7, "{error:e}");
}

fn assert_linearizes(chain: &Chain, state: &State<f64, 16>) {
    let found = chain.linearize(state);
    let changed = |change: &dyn Fn(&mut State<f64, 16>, f64)| {
        difference(|step| {
            let mut state = *state;
            change(&mut state, step);
            chain.accelerations(&state)
        })
    };
    for i in 0..16 {
        let by_position = changed(&|state, step| state.q[i] += step);
        assert_near(found.position.column(i).into(), by_position);
        let by_velocity = changed(&|state, step| state.v[i] += step);
        assert_near(found.velocity.column(i).into(), by_velocity);
    }
    assert_near(found.time, changed(&|state, step| state.t += step));
    let by_input = difference(|step| {
        let torque = chain.torque + step;
        Chain { torque, ..*chain }.accelerations(state)
    });
    assert_near(chain.input_jacobian(state).column(0).into(), by_input);
}

fn states() -> impl Iterator<Item = State<f64, 16>> {
    let mut random = Random::default();
    (0..3).map(move |_| {
        let mut state: State<f64, 16> = random.state();
        state.q *= 0.4;
        state
    })
}

#[test]
fn derivatives_are_those_of_differences() {
    // 2·16 + 1 columns by a numerical solution would take more for the solution alone.
    let count = Chain::OPERATIONS.linearize;
    assert!(count.total() < 23_000, "{count:?}");
    for state in states() {
        assert_linearizes(&chain(), &state);
    }
}

/// Pivots are negative or vanish where masses do: M is factored numerically, and the derivatives of M q̈ − f are taken along one
/// variation after the other.
#[test]
fn derivatives_exist_where_the_mass_matrix_is_indefinite() {
    let mut chain = chain();
    chain.m[7] = -0.7;
    chain.i1 = -0.01;
    for state in states() {
        assert!(chain.mass_matrix(&state).symmetric_eigenvalues().min() < 0.0);
        assert_linearizes(&chain, &state);
    }
}
