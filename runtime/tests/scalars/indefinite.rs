//! Models with an indefinite mass matrix, regular and singular.

use crate::common::assert_close;
use lagrangian::Factorization;
use lagrangian::prelude::*;

fn tight() -> Dop853 {
    Dop853::new()
        .relative_tolerance(1e-12)
        .absolute_tolerance(1e-12)
}

/// ½ a ẋ² + b ẋ ẏ + ½ c ẏ² − k x y.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * a * dot(x).powi(2) + b * dot(x) * dot(y) + 0.5 * c * dot(y).powi(2),
    potential = k * x * y,
)]
struct Two {
    a: f64,
    b: f64,
    c: f64,
    k: f64,
}

/// With a = 0 and b = k = 1: ÿ = −y and ẍ = −x + c y, which is driven in resonance.
#[test]
fn two_coordinates_of_which_one_has_no_inertia_of_its_own() {
    for c in [0.0, 1.0, -3.0] {
        let model = Two {
            a: 0.0,
            b: 1.0,
            c,
            k: 1.0,
        };
        let start = State::new(0.0, [0.3, 1.0], [0.0, 0.0]);
        let pivots = model.relative_pivots(&start);
        assert!(pivots.iter().all(|pivot| *pivot > 0.9), "{pivots}");
        let end = Problem::new(&model, start).solve(5.0, tight()).unwrap();
        let (sin, cos) = end.t.sin_cos();
        assert_close(end.q[0], 0.3 * cos + 0.5 * c * end.t * sin, 1e-10);
        assert_close(end.q[1], cos, 1e-10);
        assert_close(model.energy(&end), model.energy(&start), 1e-10);
    }
}

/// a < 0 and a > 0, with det M = a c − b² on both sides of zero: q̈ = −M⁻¹ V′ in closed form, by the other method.
#[test]
fn two_coordinates_with_inertias_of_either_sign() {
    for (a, b, c) in [(-1.0, 0.5, 1.0), (-1.0, 0.2, -2.0), (1.0, 2.0, 1.0)] {
        let model = Two { a, b, c, k: 0.7 };
        let start = State::new(0.0, [0.3, 0.2], [0.1, -0.2]);
        let end = Problem::new(&model, start).solve(2.0, tight()).unwrap();
        let written = crate::common::equation::<4, _>(|_, x| {
            let determinant = a * c - b * b;
            let [f, g] = [-0.7 * x[1], -0.7 * x[0]];
            let accelerations = [(c * f - b * g) / determinant, (a * g - b * f) / determinant];
            SVector::from([x[2], x[3], accelerations[0], accelerations[1]])
        });
        let initial = At::from((0.0, SVector::from([0.3, 0.2, 0.1, -0.2])));
        let expected = Problem::new(&written, initial)
            .solve(2.0, RungeKutta::classical(1e-3))
            .unwrap();
        assert_close(end.q[0], expected[0], 1e-10);
        assert_close(end.q[1], expected[1], 1e-10);
        assert_close(model.energy(&end), model.energy(&start), 1e-10);
    }
}

/// M = [0 s 0; s w 0; 0 0 m] with s = 1 + ½ sin z and w = sin x: indefinite wherever it is, and without a
/// diagonal where x = 0.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y, z),
    kinetic = (1.0 + 0.5 * sin(z)) * dot(x) * dot(y) + 0.5 * sin(x) * dot(y).powi(2) + 0.5 * m * dot(z).powi(2),
    potential = 0.5 * (x + y).powi(2) - cos(z),
)]
struct Three {
    m: f64,
}

#[test]
fn three_coordinates_keep_their_energy() {
    for m in [1.0, -2.0] {
        let model = Three { m };
        let start = State::new(0.0, [0.0, -0.2, 0.5], [0.1, 0.2, 0.3]);
        let expected = model.mass_matrix(&start).lu();
        let expected = expected.solve(&model.forcing(&start)).unwrap();
        for (found, expected) in model.accelerations(&start).iter().zip(&expected) {
            assert_close(*found, *expected, 1e-14);
        }
        let end = Problem::new(&model, start).solve(2.0, tight()).unwrap();
        assert_close(model.energy(&end), model.energy(&start), 1e-10);
        assert!((end.q - start.q).norm() > 0.1, "it has moved");
    }
}

/// ½ ẋᵀ M ẋ − ½ xᵀ M x, with a constant matrix and an inertia that depends on the coordinates.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x[5]),
    kinetic = (0..5).map(|i| (0..5).map(|j| 0.5 * a[i][j] * dot(x[i]) * dot(x[j])).sum()).sum()
        + 0.5 * bend * x[0].powi(2) * dot(x[0]).powi(2),
    potential = (0..5).map(|i| (0..5).map(|j| 0.5 * a[i][j] * x[i] * x[j]).sum()).sum(),
)]
struct Five {
    a: [[f64; 5]; 5],
    bend: f64,
}

/// Symmetric, with zeros on the diagonal and eigenvalues of both signs.
const MATRIX: [[f64; 5]; 5] = [
    [0.0, 1.0, 0.3, 0.2, 0.1],
    [1.0, 0.0, 0.4, 0.0, 0.2],
    [0.3, 0.4, -2.0, 1.0, 0.0],
    [0.2, 0.0, 1.0, 0.0, 0.6],
    [0.1, 0.2, 0.0, 0.6, 3.0],
];

/// Without the bend ẍ = −x, whatever M is.
#[test]
fn five_coordinates_oscillate() {
    let start = State::new(0.0, [0.1, 0.2, 0.3, 0.4, 0.5], [0.0; 5]);
    let straight = Five {
        a: MATRIX,
        bend: 0.0,
    };
    let end = Problem::new(&straight, start).solve(3.0, tight()).unwrap();
    for i in 0..5 {
        assert_close(end.q[i], start.q[i] * 3.0_f64.cos(), 1e-10);
    }
    let bent = Five {
        bend: 20.0,
        ..straight
    };
    let end = Problem::new(&bent, start).solve(3.0, tight()).unwrap();
    assert_close(bent.energy(&end), bent.energy(&start), 1e-10);
    assert!((end.q[1] - start.q[1] * 3.0_f64.cos()).abs() > 1e-3);
}

/// A coordinate in other units, x′ = s x, has the same equations: M is as regular as before.
#[test]
fn units_make_no_matrix_singular() {
    for s in [1e-9, 1e-3, 1e3, 1e9] {
        let model = Two {
            a: 0.0,
            b: s,
            c: s * s,
            k: s,
        };
        let start = State::new(0.0, [0.3, 1.0 / s], [0.0, 0.0]);
        let pivots = model.relative_pivots(&start);
        assert!(pivots.iter().all(|pivot| *pivot > 0.9), "{s}: {pivots}");
        let end = Problem::new(&model, start).solve(2.0, Dop853::new());
        assert!(end.is_ok(), "{s}: {end:?}");
        let matrix = SMatrix::<f64, 5, 5>::from(MATRIX);
        let mut scaled = matrix;
        scaled.row_mut(1).scale_mut(s);
        scaled.column_mut(1).scale_mut(s);
        let [found, expected] =
            [scaled, matrix].map(|matrix| Factorization::new(matrix).relative_pivots());
        for (found, expected) in found.iter().zip(&expected) {
            assert_close(*found, *expected, 1e-12);
        }
    }
}

/// The reciprocals of (|M⁻¹| |M|)ᵢᵢ, by nalgebra's inverse.
#[test]
fn relative_pivots_of_an_indefinite_matrix_are_those_of_its_inverse() {
    let matrix = SMatrix::<f64, 5, 5>::from(MATRIX);
    let inverse = matrix.try_inverse().unwrap();
    let product = inverse.abs() * matrix.abs();
    let found = Factorization::new(matrix).relative_pivots();
    for i in 0..5 {
        assert_close(found[i] * product[(i, i)], 1.0, 1e-13);
    }
}

/// x ẋ ẏ + ½ ż²: regular and indefinite unless x = 0.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y, z),
    kinetic = x * dot(x) * dot(y) + 0.5 * dot(z).powi(2),
    potential = 0.5 * (x.powi(2) + z.powi(2)),
)]
struct Pinched;

#[test]
fn where_it_is_singular_the_coordinates_are_named() {
    let start = State::new(0.0, [0.0, 0.2, 0.3], [0.0; 3]);
    let error = Problem::new(&Pinched, start)
        .solve(1.0, tight())
        .unwrap_err()
        .error();
    let IntegrationError::SingularConfiguration {
        estimated_error,
        singularity,
        ..
    } = error
    else {
        panic!("{error:?}")
    };
    assert!(estimated_error.is_infinite());
    assert!(
        ["x", "y"].contains(&singularity.coordinate()),
        "{singularity}"
    );
    let named: Vec<_> = singularity.coordinates().collect();
    assert_eq!(named, [("x", 0.0)]);

    // ẋ² + 2 ẋ ẏ + ẏ² and the same with another sign are squares of one velocity.
    for (a, b, c) in [
        (1.0, 1.0, 1.0),
        (-1.0, 1.0, -1.0),
        (0.0, 0.0, 1.0),
        (0.0, 0.0, 0.0),
    ] {
        let model = Two { a, b, c, k: 1.0 };
        let start = State::new(0.0, [0.3, 0.2], [0.0; 2]);
        let error = Problem::new(&model, start)
            .solve(1.0, tight())
            .unwrap_err()
            .error();
        assert!(
            matches!(error, IntegrationError::SingularConfiguration { .. }),
            "{error}"
        );
    }
}

/// M = [1 1; 1 1 − δ] is indefinite, and the nearer to a singular matrix the smaller δ is.
#[test]
fn nearness_to_a_singular_matrix_is_measured() {
    for closeness in [1e-2, 1e-6, 1e-10] {
        let model = Two {
            a: 1.0,
            b: 1.0,
            c: 1.0 - closeness,
            k: 1.0,
        };
        let state = State::new(0.0, [0.3, 0.2], [0.0; 2]);
        for pivot in &model.relative_pivots(&state) {
            // (|a c| + b²) / |a c − b²|, where rounding c takes ε from δ.
            let expected = closeness / (2.0 - closeness);
            assert_close(*pivot, expected, 4.0 * f64::EPSILON);
        }
        let ended = Problem::new(&model, state).solve(1e-6, Dop853::new());
        assert_eq!(ended.is_ok(), closeness > 1e-5, "{ended:?}");
    }
}
