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
