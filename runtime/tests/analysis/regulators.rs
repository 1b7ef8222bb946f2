//! Regulators without a cost of states, and systems that no input stabilizes.

use lagrangian::DoubleDouble;
use lagrangian::analysis::{DiscreteStateSpace, Regulator, RegulatorError, StateSpace};
use lagrangian::prelude::*;
use nalgebra::{Matrix1, Matrix4};

fn regulator<const D: usize, const U: usize>(
    is_discrete: bool,
    [a, q]: [SMatrix<f64, D, D>; 2],
    b: SMatrix<f64, D, U>,
    r: SMatrix<f64, U, U>,
) -> Result<Regulator<D, U>, RegulatorError> {
    if is_discrete {
        DiscreteStateSpace::new(a, b, 1.0).regulator(&q, &r)
    } else {
        StateSpace::new(a, b).regulator(&q, &r)
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

/// The gain of the scalar problem: b p/r with the positive root p of b² p² = r (2 a p + q); in discrete time
/// b p a/(r + b² p) with the positive root of b² p² + (r − a² r − b² q) p = q r.
fn scalar_gain(is_discrete: bool, numbers: [f64; 4]) -> f64 {
    let [a, b, q, r] = numbers.map(DoubleDouble::from);
    let gain = if is_discrete {
        let half = DoubleDouble::from(0.5) * (r - a * a * r - b * b * q);
        let root = (half * half + b * b * q * r).sqrt();
        let p = if half.to_f64() > 0.0 {
            q * r / (half + root)
        } else {
            (root - half) / (b * b)
        };
        b * p * a / (r + b * b * p)
    } else {
        let root = (a * a + b * b * q / r).sqrt();
        let p = if a.to_f64() > 0.0 {
            r * (a + root) / (b * b)
        } else {
            q / (root - a)
        };
        b * p / r
    };
    gain.to_f64()
}

/// Systems of modes that do not influence each other, some of which cost nothing, with rates up to 10¹² apart and inputs that cost
/// up to 10⁶ times more or less: each is a problem of one variable.
#[test]
fn uncoupled_modes_are_regulated_one_by_one() {
    let rates = [
        [0.7, -1.3, -40.0, 0.02],
        [-1e-3, 1e9, -1e6, 2.0],
        [1e-6, 3e-4, 1e2, 1e6],
        [-2e6, -1e6, 5e6, -1e12],
    ];
    let costs = [
        [0.0, 0.0, 0.0, 1.0],
        [0.0; 4],
        [1.0, 0.0, 2.0, 0.0],
        [1e-6, 1e6, 0.0, 1.0],
    ];
    for (rate, cost) in rates.iter().flat_map(|x| costs.map(|y| (x, y))) {
        for is_discrete in [false, true] {
            let decay = |x: &f64| (x * 1e-3).clamp(-9.0, 5.0).exp();
            let rate = rate.map(|x| if is_discrete { decay(&x) } else { x });
            let effort = [1.0, 1e-6, 1e6, 3.0];
            let entries = [2.0, -0.5, 1.0, 1e3];
            let diagonal = |x: [f64; 4]| Matrix4::from_diagonal(&x.into());
            let [a, b, q, r] = [rate, entries, cost, effort].map(diagonal);
            let gain = regulator(is_discrete, [a, q], b, r).unwrap().gain;
            for i in 0..4 {
                let expected = scalar_gain(is_discrete, [rate[i], entries[i], cost[i], effort[i]]);
                // A mode that costs nothing has the rounding errors of double-doubles.
                let rounding = 1e-30 * gain.amax();
                let error = (gain[(i, i)] - expected).abs();
                assert!(
                    error <= 1e-14 * expected.abs() + rounding,
                    "{rate:?} {cost:?} {is_discrete}: {} {expected}",
                    gain[(i, i)]
                );
                let others = (0..4).filter(|j| *j != i).map(|j| gain[(i, j)].abs());
                assert!(others.fold(0.0, f64::max) <= rounding, "{gain}");
            }
        }
    }
}

/// A plant of four states and two inputs, with the weights.
fn coupled() -> ([Matrix4<f64>; 2], SMatrix<f64, 4, 2>, Matrix2<f64>) {
    let a = Matrix4::new(
        0.4, -0.7, 0.1, 0.9, 0.3, 0.2, -0.6, 0.5, -0.8, 0.1, -0.3, 0.2, 0.6, 0.4, 0.7, -0.1,
    );
    let root = Matrix4::new(
        0.9, 0.1, 0.3, 0.0, -0.2, 0.5, 0.0, 0.4, 0.1, 0.6, 0.8, 0.2, 0.0, -0.3, 0.1, 0.7,
    );
    let b = SMatrix::<f64, 4, 2>::from_row_slice(&[0.3, -0.5, 0.9, 0.2, -0.1, 0.8, 0.4, 0.6]);
    let r = Matrix2::new(1.5, 0.25, 0.25, 0.75);
    ([a, root * root.transpose()], b, r)
}

/// In other units of time, inputs, states and costs the gain has other units and equal digits. Powers of two do not round.
#[test]
fn units_do_not_matter() {
    let ([a, q], b, r) = coupled();
    let expected = regulator(false, [a, q], b, r).unwrap().gain;
    for n in [-40, -20, -7, 3, 10, 20, 30, 40] {
        let unit = f64::powi(2.0, n);
        let of_states = Matrix4::from_diagonal(&[unit, 1.0, 8.0, 1.0 / unit].into());
        let back = Matrix4::from_diagonal(&[1.0 / unit, 1.0, 0.125, unit].into());
        let of_inputs = Matrix2::from_diagonal(&[unit, 1.0 / unit].into());
        let faster = ([a * unit, q * (unit * unit)], b, r, expected * unit);
        let costlier = ([a, q * unit], b, r * unit, expected);
        let states = [back * a * of_states, of_states * q * of_states];
        let in_units = (states, back * b, r, expected * of_states);
        let weights = of_inputs * r * of_inputs;
        let inverse = Matrix2::from_diagonal(&[1.0 / unit, unit].into());
        let inputs = ([a, q], b * of_inputs, weights, inverse * expected);
        for (index, (states, b, r, expected)) in
            [faster, costlier, in_units, inputs].into_iter().enumerate()
        {
            let gain =
                regulator(false, states, b, r).unwrap_or_else(|e| panic!("{n} {index}: {e}"));
            for (found, expected) in gain.gain.iter().zip(&expected) {
                let error = (found / expected - 1.0).abs();
                assert!(error <= f64::EPSILON, "{n} {index}: {found} {expected}");
            }
        }
    }
}
