//! The factorization of the mass matrix against the solvers of nalgebra.

use crate::common::assert_close;
use lagrangian::Factorization;
use nalgebra::{SMatrix, SVector};

/// Numbers in [−1, 1): a linear congruential generator, Knuth's MMIX.
struct Numbers(u64);

impl Numbers {
    #[allow(clippy::cast_precision_loss)] // 53 bits fit.
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / f64::from(1 << 26) / f64::from(1 << 26) - 1.0
    }

    fn matrix<const R: usize, const C: usize>(&mut self) -> SMatrix<f64, R, C> {
        SMatrix::from_fn(|_, _| self.next())
    }
}

/// Solves A X = B for random symmetric positive definite A, also by nalgebra.
fn positive_definite<const N: usize>(numbers: &mut Numbers) {
    let root = numbers.matrix::<N, N>();
    let a = root * root.transpose() + SMatrix::<f64, N, N>::identity() * 0.1;
    let b = numbers.matrix::<N, 2>();
    let x = Factorization::new(a).solve(&b);
    let expected = a.cholesky().unwrap().solve(&b);
    // λ_max ≤ N², λ_min ≥ 0.1: the error is at most about N ε κ |x|.
    let condition = a.norm() * a.try_inverse().unwrap().norm();
    let n = f64::from(u8::try_from(N).unwrap());
    assert_close(
        (x - expected).norm(),
        0.0,
        4.0 * n * f64::EPSILON * condition * expected.norm(),
    );
    assert_close(
        (a * x - b).norm(),
        0.0,
        4.0 * n * f64::EPSILON * a.norm() * x.norm(),
    );
}

#[test]
fn positive_definite_matrices_are_solved_as_by_cholesky() {
    let mut numbers = Numbers(1);
    for _ in 0..200 {
        positive_definite::<1>(&mut numbers);
        positive_definite::<2>(&mut numbers);
        positive_definite::<3>(&mut numbers);
        positive_definite::<6>(&mut numbers);
        positive_definite::<12>(&mut numbers);
    }
}

#[test]
fn indefinite_matrices_are_solved_as_by_lu() {
    let mut numbers = Numbers(2);
    let mut indefinite = 0;
    for _ in 0..500 {
        let root = numbers.matrix::<5, 5>();
        let a = root + root.transpose();
        let b: SVector<f64, 5> = numbers.matrix();
        let x = Factorization::new(a).solve(&b);
        let expected = a.lu().solve(&b).unwrap();
        let condition = a.norm() * a.try_inverse().unwrap().norm();
        // The growth factor of partial pivoting is at most 2⁴.
        let tolerance = 16.0 * 5.0 * f64::EPSILON * condition * expected.norm();
        assert_close((x - expected).norm(), 0.0, tolerance);
        indefinite += usize::from(a.cholesky().is_none());
    }
    assert!(indefinite > 400, "the cold path is what is tested");
}

#[test]
fn only_the_lower_triangle_is_read() {
    let a = SMatrix::from([[2.0, 1.0], [f64::NAN, 3.0]]);
    let x = Factorization::new(a).solve(&SVector::from([5.0, 10.0]));
    assert_close(x[0], 1.0, 1e-15);
    assert_close(x[1], 3.0, 1e-15);
}

#[test]
fn zeros_on_the_diagonal_need_pivoting() {
    let a = SMatrix::from([[0.0, 1.0], [1.0, 0.0]]);
    let factors = Factorization::new(a);
    assert_eq!(
        factors.solve(&SVector::from([3.0, 4.0])),
        SVector::from([4.0, 3.0])
    );
    assert_eq!(factors.relative_pivots(), SVector::from([1.0, 1.0]));
}

#[test]
fn relative_pivots_tell_how_near_a_matrix_is_to_a_singular_one() {
    for closeness in [1e-2, 1e-6, 1e-10] {
        let a = SMatrix::from([[1.0, 1.0], [1.0, 1.0 + closeness]]);
        let pivots = Factorization::new(a).relative_pivots();
        assert_close(pivots[0], 1.0, 0.0);
        // The cancellation in the subtraction is that of the pivot.
        assert_close(pivots[1] * (1.0 + closeness), closeness, 2.0 * f64::EPSILON);
    }
}

#[test]
fn a_singular_matrix_has_a_pivot_that_is_zero_or_nan() {
    let singular: [SMatrix<f64, 2, 2>; 4] = [
        SMatrix::from([[1.0, 1.0], [1.0, 1.0]]),
        SMatrix::from([[0.0, 0.0], [0.0, 0.0]]),
        SMatrix::from([[0.0, 0.0], [0.0, 1.0]]),
        SMatrix::from([[1.0, 0.0], [0.0, 0.0]]),
    ];
    for a in singular {
        let factors = Factorization::new(a);
        let pivots = factors.relative_pivots();
        assert!(
            pivots
                .iter()
                .any(|pivot| pivot.abs() == 0.0 || pivot.is_nan()),
            "{pivots}"
        );
        let x = factors.solve(&SVector::from([1.0, 2.0]));
        assert!(x.iter().any(|component| !component.is_finite()), "{x}");
    }
}

#[test]
fn only_a_zero_row_has_a_zero_pivot() {
    let mut matrix = SMatrix::<f64, 6, 6>::identity() * 2.0;
    matrix[(1, 0)] = 0.5;
    matrix[(3, 3)] = 0.0;
    let pivots = Factorization::new(matrix).relative_pivots();
    for (i, pivot) in pivots.iter().enumerate() {
        assert!(pivot.is_finite(), "{pivots}");
        assert_eq!(*pivot == 0.0, i == 3, "{pivots}");
    }
}
