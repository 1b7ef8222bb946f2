//! The saddle point problem of a constrained system, for the accelerations x and the multipliers λ:
//!
//! ⎡ M  −Gᵀ⎤ ⎡x⎤   ⎡f⎤
//! ⎣−G   0 ⎦ ⎣λ⎦ = ⎣γ⎦
//!
//! M. Benzi, G. H. Golub & J. Liesen, *Numerical solution of saddle point problems*, Acta Numerica **14** (2005) 1–137.
//!
//! Where M is well-conditioned and the gradients are independent, the matrix is quasidefinite, and L D Lᵀ without pivoting
//! is stable (R. J. Vanderbei, *Symmetric quasidefinite matrices*, SIAM J. Optim. **5** (1995) 100–113; P. E. Gill, M. A.
//! Saunders & J. R. Shinnerl, SIAM J. Matrix Anal. Appl. **17** (1996) 35–46). Elsewhere it is factored with pivoting,
//! without the constraints that depend on others.
//!
//! L D Lᵀ eliminates accelerations first, whatever the inertias: the acceleration of a light body that transmits the reaction of
//! a heavy one would be what is left of forces that cancel. One step of iterative refinement by the residuals of the
//! constraints, G x + γ, restores its digits (Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd edition (2002), chapter 12).

use nalgebra::{SMatrix, SVector};

use super::factorization::Factorization;
use super::independent_rows::IndependentRows;
use super::lane_select::{LaneSelect, greater};
use crate::limits::MIN_STABLE_PIVOT;
use crate::scalar::Scalar;

/// The factored matrix for `N` coordinates and `C` constraints, which are `K` unknowns.
#[derive(Clone, Copy, Debug)]
pub struct SaddlePoint<S: Scalar, const N: usize, const C: usize, const K: usize> {
    factors: Factorization<S, K>,
    /// −G.
    constraints: SMatrix<S, C, N>,
    /// What is known of the rows of G in the lanes in which the matrix is factored with pivoting.
    rows: Option<IndependentRows<S, C>>,
    /// The mask of the lanes in which it is not.
    ldlt: S,
}

impl<S: Scalar, const N: usize, const C: usize, const K: usize> SaddlePoint<S, N, C, K> {
    /// Factors a matrix, whose lower triangle alone is read. `rank` is the number of independent constraints, or 0 where
    /// that is to be found at this state.
    #[inline]
    #[must_use]
    pub fn new(lower: SMatrix<S, K, K>, rank: S) -> Self {
        let (factors, ldlt) = Factorization::ldlt(&lower, N, MIN_STABLE_PIVOT);
        let constraints = SMatrix::from_fn(|i, j| lower[(N + i, j)]);
        if ldlt.smallest() > 0.0 {
            Self {
                factors,
                constraints,
                rows: None,
                ldlt,
            }
        } else {
            Self::with_pivoting(&lower, rank, (&factors, ldlt), constraints)
        }
    }

    /// Weighs the squares of the multipliers by positive compliances, where constraints depend on others. Where one is not
    /// positive, these multipliers are not finite.
    #[inline]
    #[must_use]
    pub fn with_compliances(mut self, compliances: &SVector<S, C>) -> Self {
        if let Some(rows) = &mut self.rows {
            rows.compliances = compliances.map(|c| c / greater(c, S::zero()));
        }
        self
    }

    /// The matrix of this mass matrix and Jacobian, in the lower triangle.
    #[inline]
    #[must_use]
    pub fn lower(mass: &SMatrix<S, N, N>, jacobian: &SMatrix<S, C, N>) -> SMatrix<S, K, K> {
        SMatrix::from_fn(|i, j| {
            if i < N && j < N {
                mass[(i, j)]
            } else if i >= N && j < N {
                -jacobian[(i - N, j)]
            } else {
                S::zero()
            }
        })
    }

    #[cold]
    #[inline(never)]
    fn with_pivoting(
        lower: &SMatrix<S, K, K>,
        rank: S,
        (factors, ldlt): (&Factorization<S, K>, S),
        constraints: SMatrix<S, C, N>,
    ) -> Self {
        let mass = SVector::from_fn(|i, _| lower[(i, i)]);
        let rows = IndependentRows::of::<N>(&-constraints, &mass, rank);
        let mut independent = *lower;
        for j in 0..C {
            let dependent = rows.dependent[j];
            for i in 0..N {
                independent[(N + j, i)] = lower[(N + j, i)].masked(S::one() - dependent);
            }
            independent[(N + j, N + j)] = -dependent;
        }
        Self {
            factors: factors.with_pivoting(&independent, ldlt),
            constraints,
            rows: Some(rows),
            ldlt,
        }
    }

    /// Returns the solutions for some right-hand sides, column by column. Where constraints depend on others, the multipliers
    /// have the least norm, with the squares weighed by the compliances.
    #[inline]
    #[must_use]
    pub fn solve<const P: usize>(&self, right: &SMatrix<S, K, P>) -> SMatrix<S, K, P> {
        match &self.rows {
            None => self.solve_ldlt(right),
            Some(rows) => self.solve_with_pivoting(right, rows),
        }
    }

    /// Returns the solutions by L D Lᵀ, refined.
    #[inline]
    fn solve_ldlt<const P: usize>(&self, right: &SMatrix<S, K, P>) -> SMatrix<S, K, P> {
        let mut solution = self.factors.solve_ldlt(right, 0);
        let mut residuals = SMatrix::<S, K, P>::zeros();
        for column in 0..P {
            for j in 0..C {
                let mut residual = right[(N + j, column)];
                for i in 0..N {
                    residual -= self.constraints[(j, i)] * solution[(i, column)];
                }
                residuals[(N + j, column)] = residual;
            }
        }
        solution += self.factors.solve_ldlt(&residuals, N);
        solution
    }

    #[cold]
    #[inline(never)]
    fn solve_with_pivoting<const P: usize>(
        &self,
        right: &SMatrix<S, K, P>,
        rows: &IndependentRows<S, C>,
    ) -> SMatrix<S, K, P> {
        let mut independent = *right;
        for j in 0..C {
            let is_independent = S::one() - rows.dependent[j];
            for column in 0..P {
                independent[(N + j, column)] = right[(N + j, column)].masked(is_independent);
            }
        }
        let pivoted = self.factors.solve(&independent);
        let multipliers = SMatrix::<S, C, P>::from_fn(|i, j| pivoted[(N + i, j)]);
        let least = rows.least_norm(&multipliers);
        let mut solution = pivoted;
        for column in 0..P {
            for j in 0..C {
                solution[(N + j, column)] = least[(j, column)];
            }
        }
        if self.ldlt.largest() <= 0.0 {
            return solution;
        }
        self.solve_ldlt(right).select(solution, self.ldlt)
    }

    /// Returns measures of the conditioning for each coordinate, and for each constraint the sine of the angle between its
    /// gradient and the span of the gradients chosen before it, or 1 for one that depends on them.
    #[must_use]
    pub fn relative_pivots(&self) -> (SVector<S, N>, SVector<S, C>) {
        let pivots = self.factors.relative_pivots();
        let coordinates = SVector::from_fn(|i, _| pivots[i]);
        let constraints = SVector::from_fn(|i, _| pivots[N + i].abs().sqrt());
        match &self.rows {
            None => (coordinates, constraints),
            Some(rows) => (coordinates, constraints.select(rows.sines, self.ldlt)),
        }
    }

    /// Returns the mask of the lanes in which the matrix is factored with pivoting.
    #[must_use]
    pub fn pivoted(&self) -> S {
        S::one() - self.ldlt
    }

    /// Returns the number of independent constraints.
    #[must_use]
    pub fn rank(&self) -> S {
        let all = (0..C).fold(S::zero(), |sum, _| sum + S::one());
        match &self.rows {
            None => all,
            Some(rows) => {
                all - rows
                    .dependent
                    .iter()
                    .fold(S::zero(), |sum, x| sum + *x)
                    .masked(S::one() - self.ldlt)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unreadable_literal, reason = "numbers of a reference")]

    use super::*;

    /// λ and q̈ of M q̈ = f + Gᵀ λ, G q̈ = −γ.
    fn solution<const N: usize, const C: usize, const K: usize>(
        (mass, forcing): (SMatrix<f64, N, N>, [f64; N]),
        (jacobian, rates): (SMatrix<f64, C, N>, [f64; C]),
    ) -> SVector<f64, K> {
        let lower = SaddlePoint::<f64, N, C, K>::lower(&mass, &jacobian);
        let right = forcing.into_iter().chain(rates);
        let factors = SaddlePoint::<f64, N, C, K>::new(lower, 0.0);
        factors.solve(&SVector::from_iterator(right))
    }

    /// A body that is pulled by a light hook: both have the acceleration of the force over the sum of the masses.
    #[test]
    fn a_light_body_transmits_the_force_on_a_heavy_one() {
        let mass = SMatrix::from_diagonal(&SVector::from([1e6, 1e-6]));
        let jacobian = SMatrix::from_row_slice(&[-0.7, 0.7]);
        let found: SVector<f64, 3> = solution((mass, [0.0, 3e5]), (jacobian, [0.0]));
        let expected = 3e5 / (1e6 + 1e-6);
        assert!((found[0] / expected - 1.0).abs() < 1e-15);
        assert!((found[1] / expected - 1.0).abs() < 1e-15);
        assert!((found[2] * 0.7 / (1e-6 * expected - 3e5) - 1.0).abs() < 1e-15);
    }

    /// A slider-crank mechanism in relative angles with masses apart by 10¹⁴, where L D Lᵀ is not stable, beside multipliers that were
    /// computed with 240 bits. If pivots are chosen in rows that are scaled by their largest entries, the last one is off by 3.3.
    #[test]
    fn masses_in_relative_angles_leave_the_digits_of_multipliers() {
        let mass = SMatrix::<f64, 4, 4>::from_row_slice(&[
            1779868382227.0005,
            1779941177482.3555,
            7348.0266904998925,
            0.0,
            1779941177482.3555,
            1780014014696.6182,
            7347.354161149313,
            0.0,
            7348.0266904998925,
            7347.354161149313,
            0.4200546216760456,
            0.0,
            0.0,
            0.0,
            0.0,
            19000.0,
        ]);
        let jacobian = SMatrix::<f64, 3, 4>::from_row_slice(&[
            3478.4652228407153,
            3479.994901289212,
            -4.054627483402521e-05,
            -0.1318764666329031,
            -9375.078659606179,
            -9374.94731387849,
            -0.0001031044787578557,
            -1.5,
            1.0,
            0.0,
            0.0,
            0.0,
        ]);
        let forcing = [
            -641378433.1833781,
            -1073533166.8081613,
            -19789215.91437716,
            0.0,
        ];
        let rates = [15381.584554052804, 5703.508139339508, 0.9603874251625055];
        let found: SVector<f64, 7> = solution((mass, forcing), (jacobian, rates));
        for (found, expected) in found.iter().skip(4).zip([
            -2499557512.1676416,
            -169911690.62218183,
            -4032737467.2478056,
        ]) {
            assert!((found - expected).abs() < 1e-2, "{found} {expected}");
        }
    }
}
