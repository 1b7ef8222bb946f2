//! Regulators without a cost of states, and systems that no input stabilizes.

use lagrangian::analysis::{DiscreteStateSpace, Regulator, RegulatorError, StateSpace};
use lagrangian::prelude::*;
use nalgebra::{Matrix1, Matrix4};

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
            let nearest = found
                .poles
                .iter()
                .map(|p| (p - x).norm() / (x + 1e-8 * pole));
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
