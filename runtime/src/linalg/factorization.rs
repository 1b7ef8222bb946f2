//! Factorization of the mass matrix, to solve M q̈ = f for the accelerations.
//!
//! The input is the symmetric mass matrix; the output consists of solutions for any number of right-hand sides, and an
//! estimate of their accuracy. A positive definite M is factored as L D Lᵀ without pivoting, which is stable (N. J.
//! Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd edition (2002), chapter 10). An indefinite regular M,
//! for example of L = ẋ ẏ, takes a cold path with pivoting (`pivoting.rs`). A singular M gives values that are not
//! finite, but does not panic. SIMD lanes do not depend on each other.

use nalgebra::{SMatrix, SVector};

use super::lane_select::{LaneSelect, greater};
use super::pivoting::{self, PivotedLu};
use crate::limits::{RIGHT_HAND_SIDES_AT_ONCE, ROWS_AT_ONCE};
use crate::scalar::Scalar;

/// A factored mass matrix.
#[derive(Clone, Copy, Debug)]
pub struct Factorization<S: Scalar, const N: usize> {
    /// The unit lower triangular factor L below the diagonal; above it, U of the cold path.
    factors: SMatrix<S, N, N>,
    /// The reciprocals of the pivots.
    reciprocals: SVector<S, N>,
    /// The ratio of each pivot to the diagonal entry of M in positive definite lanes; 0 in the others.
    relative_pivots: SVector<S, N>,
    kind: Kind<S, N>,
}

/// The kind of factorization.
#[derive(Clone, Copy, Debug)]
enum Kind<S, const N: usize> {
    /// L D Lᵀ.
    Ldlt,
    /// P M = L U, with the row interchanges, in the lanes in which the mask of those with L D Lᵀ is 0.
    PivotedLu {
        interchanges: SVector<S, N>,
        ldlt: S,
    },
}

impl<S: Scalar, const N: usize> Factorization<S, N> {
    /// Factors the symmetric matrix `mass`, whose lower triangle alone is read.
    #[inline]
    #[must_use]
    pub fn new(mass: SMatrix<S, N, N>) -> Self {
        let (ldlt, is_definite) = Self::ldlt(&mass, N, 0.0);
        if is_definite.smallest() > 0.0 {
            ldlt
        } else {
            ldlt.with_pivoting(&mass, is_definite)
        }
    }

    /// Factors a symmetric matrix, whose lower triangle alone is read, of which so many pivots are positive and the others
    /// negative, as L D Lᵀ. Returns the factors, and the mask of the lanes in which all pivots have their sign and are at
    /// least `least` times the diagonal entry, for negative pivots as the positive ones leave it.
    #[inline]
    pub(super) fn ldlt(matrix: &SMatrix<S, N, N>, positive: usize, least: f64) -> (Self, S) {
        let mut factors = *matrix;
        let mut reciprocals = SVector::zeros();
        let mut relative_pivots = SVector::zeros();
        let mut is_stable = S::one();
        for j in 0..N {
            let mut pivot = matrix[(j, j)];
            let mut diagonal = pivot;
            for k in 0..j {
                // The columns to the left hold L D until the row is scaled below.
                let scaled = factors[(j, k)];
                let unscaled = scaled * reciprocals[k];
                factors[(j, k)] = unscaled;
                pivot -= unscaled * scaled;
                if k + 1 == positive {
                    diagonal = pivot;
                }
            }
            let mut i = j + 1;
            while i < N {
                // The last rows are computed with the ones before them, twice if need be.
                if let Some(last) = N.checked_sub(ROWS_AT_ONCE) {
                    Self::eliminate::<ROWS_AT_ONCE>(matrix, &mut factors, (i.min(last), j));
                    i += ROWS_AT_ONCE;
                } else {
                    Self::eliminate::<1>(matrix, &mut factors, (i, j));
                    i += 1;
                }
            }
            reciprocals[j] = S::one() / pivot;
            relative_pivots[j] = pivot / diagonal;
            let sign = if j < positive { pivot } else { -pivot };
            is_stable *= greater(sign, S::zero());
            if least > 0.0 {
                is_stable *= greater(relative_pivots[j], S::from_f64(least));
            }
        }
        let ldlt = Self {
            factors,
            reciprocals,
            relative_pivots,
            kind: Kind::Ldlt,
        };
        (ldlt, is_stable)
    }

    /// Computes `W` rows of column `j` of L D from the columns to the left, starting at row `first`. They are neighbours in
    /// memory, and stay in a vector register. Entries above the diagonal, which are not read, may be among them.
    #[inline]
    fn eliminate<const W: usize>(
        matrix: &SMatrix<S, N, N>,
        factors: &mut SMatrix<S, N, N>,
        (first, j): (usize, usize),
    ) {
        let (left, right) = factors.as_mut_slice().split_at_mut(j * N);
        let from = matrix.as_slice()[j * N..][first..].first_chunk::<W>();
        let (Some(from), Some(to)) = (from, right[first..].first_chunk_mut::<W>()) else {
            return;
        };
        let mut rows = *from;
        for column in left.chunks_exact(N) {
            let factor = column[j];
            if let Some(others) = column[first..].first_chunk::<W>() {
                for (row, other) in rows.iter_mut().zip(others) {
                    *row -= *other * factor;
                }
            }
        }
        *to = rows;
    }

    /// Factors a matrix with pivoting in the lanes in which L D Lᵀ is not stable, on the cold path.
    #[cold]
    #[inline(never)]
    pub(super) fn with_pivoting(&self, lower: &SMatrix<S, N, N>, ldlt: S) -> Self {
        let full = SMatrix::from_fn(|i, j| lower[(i.max(j), i.min(j))]);
        let PivotedLu {
            factors,
            reciprocals,
            interchanges,
        } = PivotedLu::new(full);
        Self {
            factors: self.factors.select(factors, ldlt),
            reciprocals: self.reciprocals.select(reciprocals, ldlt),
            relative_pivots: self.relative_pivots.select(SVector::zeros(), ldlt),
            kind: Kind::PivotedLu { interchanges, ldlt },
        }
    }

    /// Returns a measure of the conditioning of M for each coordinate.
    ///
    /// For a positive definite matrix it is the ratio of the pivot to the diagonal entry, otherwise the reciprocal of
    /// (|M⁻¹| |M|)ᵢᵢ (Bauer, 1963). It is NaN or 0 if M is singular. Neither measure depends on the units of the
    /// coordinates.
    #[inline]
    #[must_use]
    pub fn relative_pivots(&self) -> SVector<S, N> {
        match &self.kind {
            Kind::Ldlt => self.relative_pivots,
            Kind::PivotedLu { ldlt, .. } => self.reciprocal_conditions(*ldlt),
        }
    }

    #[cold]
    #[inline(never)]
    fn reciprocal_conditions(&self, ldlt: S) -> SVector<S, N> {
        let conditions = pivoting::reciprocal_conditions(&self.factors);
        self.relative_pivots.select(conditions, ldlt)
    }

    /// Returns the solutions X of M X = B, column by column.
    #[inline]
    #[must_use]
    pub fn solve<const K: usize>(&self, right: &SMatrix<S, N, K>) -> SMatrix<S, N, K> {
        match &self.kind {
            Kind::Ldlt => self.solve_ldlt(right, 0),
            Kind::PivotedLu { interchanges, ldlt } => {
                self.solve_pivoted(right, interchanges, *ldlt)
            }
        }
    }

    /// Returns the solutions by L D Lᵀ, for right-hand sides that are zero in the first `zeros` rows.
    #[inline]
    pub(super) fn solve_ldlt<const K: usize>(
        &self,
        right: &SMatrix<S, N, K>,
        zeros: usize,
    ) -> SMatrix<S, N, K> {
        let mut x = *right;
        let mut column = 0;
        while column + RIGHT_HAND_SIDES_AT_ONCE <= K {
            self.solve_columns::<K, RIGHT_HAND_SIDES_AT_ONCE>(&mut x, (column, zeros));
            column += RIGHT_HAND_SIDES_AT_ONCE;
        }
        while column < K {
            self.solve_columns::<K, 1>(&mut x, (column, zeros));
            column += 1;
        }
        x
    }

    /// Solves for `W` columns at once, starting at column `first`, which are zero in the first `zeros` rows.
    #[inline]
    fn solve_columns<const K: usize, const W: usize>(
        &self,
        x: &mut SMatrix<S, N, K>,
        (first, zeros): (usize, usize),
    ) {
        let l = &self.factors;
        let mut rows: [[S; W]; N] =
            core::array::from_fn(|i| core::array::from_fn(|lane| x[(i, first + lane)]));
        for i in zeros..N {
            let mut row = rows[i];
            for k in zeros..i {
                subtract(&mut row, l[(i, k)], rows[k]);
            }
            rows[i] = row;
        }
        for i in (0..N).rev() {
            let mut row = rows[i].map(|entry| entry * self.reciprocals[i]);
            for k in i + 1..N {
                subtract(&mut row, l[(k, i)], rows[k]);
            }
            rows[i] = row;
            for (lane, entry) in row.into_iter().enumerate() {
                x[(i, first + lane)] = entry;
            }
        }
    }

    #[cold]
    #[inline(never)]
    fn solve_pivoted<const K: usize>(
        &self,
        right: &SMatrix<S, N, K>,
        interchanges: &SVector<S, N>,
        ldlt: S,
    ) -> SMatrix<S, N, K> {
        let pivoted = pivoting::solve(&self.factors, &self.reciprocals, interchanges, right);
        if ldlt.largest() <= 0.0 {
            return pivoted;
        }
        self.solve_ldlt(right, 0).select(pivoted, ldlt)
    }
}

/// Computes row −= factor · other.
#[inline]
fn subtract<S: Scalar, const W: usize>(row: &mut [S; W], factor: S, other: [S; W]) {
    for (entry, other) in row.iter_mut().zip(other) {
        *entry = (-factor).mul_add(other, *entry);
    }
}
