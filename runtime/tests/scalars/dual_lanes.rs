//! Dual numbers of lanes: each lane has the values and the derivatives that it has alone.
#![allow(clippy::float_cmp)] // Exact comparisons are meant.

use lagrangian::prelude::*;
use lagrangian::{Dual, Factorization, Lanes};

/// What depends on the sign or the order of numbers, and what does not.
fn functions<S: Scalar>(x: S, y: S) -> Vec<S> {
    let one = S::one();
    vec![
        x + y * x,
        x / (y + one),
        x.mul_add(y, x),
        x.sin() * y.cos(),
        x.tan(),
        x.atan2(y),
        x.sinh() + y.cosh(),
        x.tanh(),
        x.asinh(),
        (x.abs() + one).acosh(),
        x.exp(),
        (x.abs() + one).ln(),
        x.abs().sqrt(),
        x.powf(S::from_f64(2.0)),
        (y.abs() + one).powf(x),
        x.abs() * y.signum(),
        x.min(y),
        x.max(y),
        (x * x).min(y),
        x.logistic() + y.softplus(),
        x.sech() + y.log_cosh(),
    ]
}

#[test]
fn a_lane_has_the_derivatives_that_it_has_alone() {
    let x = [-1.5, 0.0, 0.25, 0.25];
    let y = [0.5, -0.75, 0.25, 1.5];
    let [along_x, along_y] = Dual::variables([Lanes(x), Lanes(y)]);
    let found = functions(along_x, along_y);
    for lane in 0..4 {
        let [along_x, along_y] = Dual::variables([x[lane], y[lane]]);
        for (index, (found, alone)) in found.iter().zip(functions(along_x, along_y)).enumerate() {
            assert_eq!(found.in_lane(lane), alone.value, "{index} in {lane}");
            let derivative = found.derivative.map(|slopes| slopes.lane(lane));
            assert_eq!(derivative, alone.derivative, "{index} in {lane}");
        }
    }
}

/// Rows that have to be interchanged, with derivatives beside zeros.
fn solution<S: Scalar>(upper_left: [S; 2], others: [S; 2]) -> SVector<S, 2> {
    let [first, second] = others;
    let matrix = SMatrix::<S, 2, 2>::new(upper_left[0], first, second, upper_left[1]);
    let right = SVector::from([S::from_f64(1.0), S::from_f64(3.0)]);
    Factorization::new(matrix).solve(&right)
}

/// The solution of [a b; b d] x = (1, 3) by Cramer's rule.
fn closed<S: Scalar>([a, d]: [S; 2], [b, c]: [S; 2]) -> [S; 2] {
    let determinant = a * d - b * c;
    let three = S::from_f64(3.0);
    [(d - three * b) / determinant, (three * a - c) / determinant]
}

#[test]
fn a_pivot_that_is_zero_leaves_its_derivative_behind() {
    for values in [
        [0.0, 0.0, 2.0, 2.0],
        [0.0, 0.5, 1.0, 1.0],
        [0.0, -3.0, 4.0, 4.0],
    ] {
        let [a, d, b, c] = Dual::variables(values);
        // Symmetric: both off-diagonal entries are one.
        let b = (b + c) * 0.5;
        let found = solution([a, d], [b, b]);
        let expected = closed([a, d], [b, b]);
        for (found, expected) in found.iter().zip(expected) {
            assert!((found.value - expected.value).abs() < 1e-14);
            for (found, expected) in found.derivative.iter().zip(expected.derivative) {
                let error = (found - expected).abs();
                assert!(error < 1e-14, "{values:?}: {found} {expected}");
            }
        }
    }
}

/// One lane needs the interchange, and another does not.
#[test]
fn lanes_interchange_rows_with_their_derivatives() {
    let values = [[0.0, 3.0], [0.5, -2.0], [1.0, 1.0]].map(Lanes);
    let [a, d, b] = Dual::variables(values);
    let found = solution([a, d], [b, b]);
    for lane in 0..2 {
        let [a, d, b] = Dual::variables(values.map(|lanes| lanes.lane(lane)));
        let expected = closed([a, d], [b, b]);
        for (found, expected) in found.iter().zip(expected) {
            assert!((found.in_lane(lane) - expected.value).abs() < 1e-14);
            for (found, expected) in found.derivative.iter().zip(expected.derivative) {
                let error = (found.lane(lane) - expected).abs();
                assert!(error < 1e-14, "{lane}: {found:?} {expected}");
            }
        }
    }
}
