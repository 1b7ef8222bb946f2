//! Regulators of badly scaled problems, against reference values (`data/regulators.json`), and what has none.

use lagrangian::analysis::{DiscreteStateSpace, Regulator, RegulatorError, StateSpace};
use lagrangian::prelude::*;
use lagrangian_tests::{Figures, list, regulators, relative_error};
use nalgebra::{Matrix1, Matrix4};
use serde_json::Value;

fn matrix<const R: usize, const C: usize>(value: &Value) -> SMatrix<f64, R, C> {
    SMatrix::from_fn(|i, j| value[i][j].as_f64().unwrap())
}

fn regulator<const D: usize, const U: usize>(
    is_discrete: bool,
    [a, q]: [SMatrix<f64, D, D>; 2],
    b: SMatrix<f64, D, U>,
    r: SMatrix<f64, U, U>,
) -> Result<Regulator<D, U>, RegulatorError> {
    let (c, d) = (SMatrix::<f64, D, D>::identity(), SMatrix::zeros());
    let (nothing, output) = (SVector::zeros(), SVector::zeros());
    if is_discrete {
        let plant = DiscreteStateSpace {
            a,
            b,
            c,
            d,
            increment: nothing,
            output,
            period: 1.0,
        };
        plant.regulator(&q, &r)
    } else {
        let plant = StateSpace {
            a,
            b,
            c,
            d,
            derivative: nothing,
            output,
        };
        plant.regulator(&q, &r)
    }
}

#[test]
fn badly_scaled_problems_are_solved() {
    let mut figures = Figures::new();
    for (index, case) in list(&regulators()).iter().enumerate() {
        let is_discrete = case["discrete"].as_bool().unwrap();
        let at = format!("case {index}, {}", case["kind"]);
        let (a, q) = (matrix::<4, 4>(&case["a"]), matrix(&case["q"]));
        let (b, r) = (matrix::<4, 2>(&case["b"]), matrix(&case["r"]));
        let found = regulator(is_discrete, [a, q], b, r);
        let found = found.unwrap_or_else(|error| panic!("{at}: {error}"));
        let expected = matrix::<2, 4>(&case["gain"]);
        let error = relative_error(found.gain.as_slice(), expected.as_slice(), 1e-30);
        figures.record("gain", &at, error, 1e-9);
        let scaled = regulator(is_discrete, [a, q * 1e6], b, r * 1e6).unwrap();
        let error = relative_error(scaled.gain.as_slice(), expected.as_slice(), 1e-30);
        figures.record("gain of other units of cost", &at, error, 1e-9);
    }
    figures.finish();
}

/// With Q = 0 the stable modes are left as they are and the unstable ones are mirrored, at the border of stability.
#[test]
fn the_least_effort_mirrors_unstable_modes() {
    for (pole, other) in [(2.0, -1.0), (1e-3, -1e3), (1e6, -1.0), (5.0, 7.0)] {
        let a = Matrix2::new(pole, 0.3, 0.0, other);
        let b = Vector2::new(1.0, 0.5);
        let one = Matrix1::identity();
        let found = regulator(false, [a, Matrix2::zeros()], b, one).unwrap();
        for x in [pole, other] {
            let mirrored = -f64::abs(x);
            let nearest = found
                .poles
                .iter()
                .map(|p| (p - mirrored).norm() / mirrored.abs());
            assert!(
                nearest.fold(f64::INFINITY, f64::min) < 1e-8,
                "{:?}",
                found.poles
            );
        }
        let a = Matrix2::new(1.0 + pole, 0.3, 0.0, 0.5);
        let found = regulator(true, [a, Matrix2::zeros()], b, one).unwrap();
        for x in [1.0 / (1.0 + pole), 0.5] {
            let nearest = found.poles.iter().map(|p| (p - x).norm() / x);
            assert!(
                nearest.fold(f64::INFINITY, f64::min) < 1e-6,
                "{:?}",
                found.poles
            );
        }
    }
    let stable = Matrix2::new(-1.0, 5.0, 0.0, -2.0);
    let found = regulator(
        false,
        [stable, Matrix2::zeros()],
        Vector2::new(1.0, 1.0),
        Matrix1::identity(),
    );
    assert!(found.unwrap().gain.amax() < 1e-15);
}

/// Systems without a stabilizing regulator say why, also beside others of which rounding is larger.
#[test]
fn what_no_input_stabilizes_is_refused() {
    let none = Matrix4::zeros();
    for size in [1.0, 1e4, 1e8] {
        for is_discrete in [false, true] {
            // An unstable mode without an input.
            let a = Matrix4::from_diagonal(&[size + 1.5, 1.3, 0.1, -0.2].into());
            let b = SMatrix::<f64, 4, 1>::new(size, 0.0, 1.0, 1.0);
            for q in [none, Matrix4::identity()] {
                let error = regulator(is_discrete, [a, q], b, Matrix1::identity()).unwrap_err();
                assert!(
                    matches!(error, RegulatorError::NotStabilizable { .. }),
                    "{size} {error}"
                );
            }
            // A mode on the border of stability without a cost.
            let border = if is_discrete { 1.0 } else { 0.0 };
            let a = Matrix4::from_diagonal(&[size + 1.5, border, 0.1, -0.2].into());
            let b = SMatrix::<f64, 4, 1>::repeat(1.0);
            let error = regulator(is_discrete, [a, none], b, Matrix1::identity()).unwrap_err();
            assert!(
                matches!(error, RegulatorError::NoCost { .. }),
                "{size} {error}"
            );
        }
    }
    // Two equal unstable modes with one input, turned, so that rounding seems to reach the second one.
    for k in 1..20 {
        let angle = 0.1 * f64::from(k);
        let (s, c) = angle.sin_cos();
        let turn = Matrix2::new(c, -s, s, c);
        let a = turn * Matrix2::new(0.7, 0.0, 0.0, 0.7) * turn.transpose();
        let b = turn * Vector2::new(1.0, 0.4);
        for is_discrete in [false, true] {
            let a = if is_discrete { a * 2.0 } else { a };
            let found = regulator(
                is_discrete,
                [a, Matrix2::identity()],
                b,
                Matrix1::identity(),
            );
            assert!(
                matches!(found, Err(RegulatorError::NotStabilizable { .. })),
                "{k} {found:?}"
            );
        }
    }
}
