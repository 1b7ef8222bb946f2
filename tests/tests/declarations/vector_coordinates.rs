//! Coordinates that are vectors: bodies in space, and every way in which such coordinates are declared.

use std::f64::consts::PI;

use lagrangian::prelude::*;
use lagrangian_tests::assert_close;

/// Bodies that attract each other.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r[4]: Vector3),
    kinetic = (0..4).map(|i| 0.5 * m[i] * dot(r[i]).norm_squared()).sum(),
    potential = -(0..4).map(|i| (0..i).map(|j| g * m[i] * m[j] / (r[i] - r[j]).norm()).sum()).sum(),
    output(momentum = (0..4).map(|i| m[i] * dot(r[i])).sum(), positions = vector(r)),
)]
struct Bodies {
    m: [f64; 4],
    g: f64,
}

/// The same, coordinate by coordinate.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x[12]),
    define(r[i] = [x[3 * i], x[3 * i + 1], x[3 * i + 2]] for i in 0..4),
    kinetic = (0..4).map(|i| 0.5 * m[i] * dot(r[i]).norm_squared()).sum(),
    potential = -(0..4).map(|i| (0..i).map(|j| g * m[i] * m[j] / (r[i] - r[j]).norm()).sum()).sum(),
)]
struct BodiesByNumbers {
    m: [f64; 4],
    g: f64,
}

const POSITIONS: [[f64; 3]; 4] = [
    [0.0, 0.1, -0.2],
    [1.0, -0.3, 0.4],
    [-0.7, 0.9, 1.1],
    [0.2, -1.4, 0.8],
];

const VELOCITIES: [[f64; 3]; 4] = [
    [0.1, 0.0, -0.3],
    [-0.2, 0.5, 0.1],
    [0.4, -0.1, 0.2],
    [0.0, 0.3, -0.1],
];

fn flat<const N: usize>(vectors: [[f64; 3]; N]) -> Vec<f64> {
    vectors.into_iter().flatten().collect()
}

fn bodies() -> (Bodies, State<f64, 12>) {
    let [q, v] = [POSITIONS, VELOCITIES].map(|vectors| SVector::from_vec(flat(vectors)));
    let m = [3.0, 1.5, 0.25, 2.0];
    (Bodies { m, g: 0.8 }, State::new(0.0, q, v))
}

#[test]
fn bodies_attract_each_other_by_the_inverse_square() {
    let (bodies, state) = bodies();
    let place = POSITIONS.map(Vector3::from);
    let expected = [0, 1, 2, 3].map(|i| {
        let others = (0..4).filter(|j| *j != i);
        let pull = others.map(|j| {
            let along = place[j] - place[i];
            bodies.g * bodies.m[j] * along / along.norm().powi(3)
        });
        <[f64; 3]>::from(pull.sum::<Vector3<f64>>())
    });
    let found = bodies.accelerations(&state);
    assert_close("r̈", found.as_slice(), &flat(expected), 1e-14);
    let other = BodiesByNumbers {
        m: bodies.m,
        g: bodies.g,
    };
    let found = other.accelerations(&state);
    assert_close("by numbers", found.as_slice(), &flat(expected), 1e-14);
    let [by_vectors, by_numbers] = [Bodies::OPERATIONS, BodiesByNumbers::OPERATIONS];
    assert_eq!(by_vectors.accelerations, by_numbers.accelerations);
    assert_eq!(by_vectors.energy, by_numbers.energy);
    let positions = bodies.outputs(&state).positions;
    assert_close(
        "positions",
        positions.transpose().as_slice(),
        &flat(POSITIONS),
        1e-15,
    );
}

#[test]
fn the_momentum_of_all_bodies_is_kept() -> Result<(), IntegrationError> {
    let (bodies, start) = bodies();
    let end = Problem::new(&bodies, start).solve(1.5, Dop853::new())?.last;
    let [before, after] = [&start, &end].map(|state| bodies.outputs(state).momentum);
    assert_close("momentum", after.as_slice(), before.as_slice(), 1e-13);
    let [before, after] = [&start, &end].map(|state| bodies.energy(state));
    assert_close("energy", &[after], &[before], 1e-8);
    Ok(())
}

/// Two bodies, as one vector each.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(sun: Vector3<f64>, planet: SVector<3>),
    kinetic = 0.5 * m[0] * dot(sun).norm_squared() + 0.5 * m[1] * dot(planet).norm_squared(),
    potential = -g * m[0] * m[1] / (planet - sun).norm(),
    output(apart = planet - sun),
)]
struct TwoBodies {
    m: [f64; 2],
    g: f64,
}

/// Kepler's equation E − e sin E = M (Goldstein, Classical Mechanics, section 3.8), by Newton's method.
fn eccentric_anomaly(mean: f64, eccentricity: f64) -> f64 {
    (0..50).fold(mean, |e, _| {
        e - (e - eccentricity * e.sin() - mean) / (1.0 - eccentricity * e.cos())
    })
}

#[test]
fn two_bodies_move_on_an_ellipse() -> Result<(), IntegrationError> {
    let bodies = TwoBodies {
        m: [3.0, 0.5],
        g: 1.2,
    };
    let mu = bodies.g * (bodies.m[0] + bodies.m[1]);
    let (a, e): (f64, f64) = (1.4, 0.3);
    let n = (mu / a.powi(3)).sqrt();
    let b = a * (1.0 - e * e).sqrt();
    // From the pericentre, seen from the centre of mass.
    let [outer, inner] = [bodies.m[0] / 3.5, -bodies.m[1] / 3.5];
    let (near, fast) = (a * (1.0 - e), n * a * b / (a * (1.0 - e)));
    let state = State::new(
        0.0,
        [inner * near, 0.0, 0.0, outer * near, 0.0, 0.0],
        [0.0, inner * fast, 0.0, 0.0, outer * fast, 0.0],
    );
    for turn in [0.2, 0.55, 1.0] {
        let end = Problem::new(&bodies, state).solve(turn * 2.0 * PI / n, Dop853::new())?;
        let anomaly = eccentric_anomaly(turn * 2.0 * PI, e);
        let expected = [a * (anomaly.cos() - e), b * anomaly.sin(), 0.0];
        let apart = bodies.outputs(&end).apart;
        assert_close("ellipse", apart.as_slice(), &expected, 1e-7);
    }
    Ok(())
}

/// Scalars, families and vectors beside each other, with forces on each.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, r: Vector2, s[2]: Vector3, q[2][3], p[2][1]: Vector2, angle[2], long: SVector<5>),
    kinetic = 0.5 * (dot(x).powi(2) + dot(r).norm_squared() + (0..2).map(|i| dot(s[i]).norm_squared()).sum())
        + 0.5 * dot(vector(q)).norm_squared() + (0..2).map(|i| 0.5 * dot(p[i][0]).norm_squared()).sum()
        + 0.5 * dot(vector(angle)).norm_squared() + 0.5 * dot(long).norm_squared(),
    force(x = 1.0, r = [2.0, 3.0], s[i] = (i + 4.0) * s[i] for i in 0..2, long = -dot(long)),
    force(q[i][k] = 10 * i + k for i in 0..2 for k in 0..3, p[1][0] = [7.0, 8.0], angle[i] = -i for i in 0..2),
    force(r.y = 0.5, s[1].z = u, q[0] = [100.0, 200.0, 300.0], p[0][0][1] = 9.0),
    output(last = q[1][2] + s[0].y + r[1] + long[4], flat = p[1][0].x),
)]
struct Everything {
    #[lagrangian(input)]
    u: f64,
}

#[test]
fn every_kind_of_coordinate_has_its_place() {
    let names = [
        "x",
        "r.x",
        "r.y",
        "s[0].x",
        "s[0].y",
        "s[0].z",
        "s[1].x",
        "s[1].y",
        "s[1].z",
        "q[0][0]",
        "q[0][1]",
        "q[0][2]",
        "q[1][0]",
        "q[1][1]",
        "q[1][2]",
        "p[0][0].x",
        "p[0][0].y",
        "p[1][0].x",
        "p[1][0].y",
        "angle[0]",
        "angle[1]",
        "long[0]",
        "long[1]",
        "long[2]",
        "long[3]",
        "long[4]",
    ];
    assert_eq!(Everything::COORDINATES, names);
    assert_eq!(Everything::X, 0);
    assert_eq!(Everything::R, [1, 2]);
    assert_eq!(Everything::S, [[3, 4, 5], [6, 7, 8]]);
    assert_eq!(Everything::Q, [[9, 10, 11], [12, 13, 14]]);
    assert_eq!(Everything::P, [[[15, 16]], [[17, 18]]]);
    assert_eq!(Everything::ANGLE, [19, 20]);
    assert_eq!(Everything::LONG, [21, 22, 23, 24, 25]);
}

#[test]
fn forces_act_on_vectors_and_their_components() {
    let q: SVector<f64, 26> =
        SVector::from_fn(|i, _| 0.5 + f64::from(u8::try_from(i).unwrap_or(0)));
    let v = 0.25 * q;
    let state = State::new(0.0, q, v);
    let model = Everything { u: 0.75 };
    let mut expected = vec![1.0, 2.0, 3.5];
    expected.extend((3..6).map(|i| 4.0 * q[i]));
    expected.extend((6..9).map(|i| 5.0 * q[i]));
    expected[8] += 0.75;
    expected.extend([100.0, 201.0, 302.0, 10.0, 11.0, 12.0]);
    expected.extend([0.0, 9.0, 7.0, 8.0, 0.0, -1.0]);
    expected.extend((21..26).map(|i| -v[i]));
    let found = model.generalized_forces(&state);
    assert_close("Q", found.as_slice(), &expected, 1e-15);
    // The mass matrix is the identity.
    let found = model.accelerations(&state);
    assert_close("q̈", found.as_slice(), &expected, 1e-15);
    let outputs = model.outputs(&state);
    let last = q[14] + q[4] + q[2] + q[25];
    assert_close(
        "outputs",
        &[outputs.last, outputs.flat],
        &[last, q[17]],
        1e-15,
    );
}
