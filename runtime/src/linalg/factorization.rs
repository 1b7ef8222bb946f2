//! Solving M q̈ = f for the accelerations.
//!
//! Comes in: the symmetric mass matrix. Goes out: solutions for any number of right-hand sides, and
//! how much was lost on the way. A positive definite M is factored as L D Lᵀ without pivoting, which
//! is stable; a regular M that is not (L = ẋ ẏ) takes a cold path with exchange of rows (`pivoting.rs`). A
//! singular M gives values that are not finite, and no panic. Lanes do not depend on each other.

use nalgebra::{SMatrix, SVector};

use super::lane_select::{Lanewise, greater};
use super::pivoting::{self, Pivoted};
use crate::limits::RIGHT_HAND_SIDES_AT_ONCE;
use crate::scalar::Scalar;

/// A factored mass matrix.
#[derive(Clone, Copy, Debug)]
pub struct Factorization<S: Scalar, const N: usize> {
    /// Below the diagonal the unit lower factor; above it U of the cold path.
    factors: SMatrix<S, N, N>,
    /// The reciprocals of the pivots.
    reciprocals: SVector<S, N>,
    /// In lanes that are positive definite, each pivot in relation to what it was before elimination; 0 in
    /// the others.
    relative_pivots: SVector<S, N>,
    form: Form<S, N>,
}

/// What the factors are those of.
#[derive(Clone, Copy, Debug)]
enum Form<S, const N: usize> {
    /// L D Lᵀ.
    Symmetric,
    /// L U, whose rows were exchanged, with the exchanges.
    Exchanged(SVector<S, N>),
}

impl<S: Scalar, const N: usize> Factorization<S, N> {
    /// Factors the symmetric matrix `mass`, of which only the lower triangle is read.
    #[inline]
    #[must_use]
    pub fn new(mass: SMatrix<S, N, N>) -> Self {
        let mut factors = mass;
        let mut reciprocals = SVector::zeros();
        let mut relative_pivots = SVector::zeros();
        let mut definite = true;
        for j in 0..N {
            let mut pivot = mass[(j, j)];
            for k in 0..j {
                // The columns to the left hold L D until the row is scaled below.
                let scaled = factors[(j, k)];
                let unscaled = scaled * reciprocals[k];
                factors[(j, k)] = unscaled;
                pivot -= unscaled * scaled;
            }
            for i in j + 1..N {
                let mut entry = mass[(i, j)];
                for k in 0..j {
                    entry -= factors[(i, k)] * factors[(j, k)];
                }
                factors[(i, j)] = entry;
            }
            reciprocals[j] = S::one() / pivot;
            relative_pivots[j] = pivot / mass[(j, j)];
            definite &= pivot.smallest() > 0.0;
        }
        let symmetric = Self {
            factors,
            reciprocals,
            relative_pivots,
            form: Form::Symmetric,
        };
        if definite {
            symmetric
        } else {
            symmetric.with_pivoting(&mass)
        }
    }

    /// The cold path, for a matrix that is not positive definite in every lane.
    #[cold]
    #[inline(never)]
    fn with_pivoting(&self, lower: &SMatrix<S, N, N>) -> Self {
        let full = SMatrix::from_fn(|i, j| lower[(i.max(j), i.min(j))]);
        let positive = self.reciprocals.iter();
        let definite = positive.fold(S::one(), |all, pivot| all * greater(*pivot, S::zero()));
        let Pivoted {
            factors,
            reciprocals,
            exchanges,
        } = Pivoted::new(full);
        Self {
            factors,
            reciprocals,
            relative_pivots: self.relative_pivots.or(SVector::zeros(), definite),
            form: Form::Exchanged(exchanges),
        }
    }

    /// For each coordinate, how much is left of a relative accuracy of 1: the pivot in relation to the diagonal
    /// entry of a positive definite matrix, and the reciprocal of (|M⁻¹| |M|)ᵢᵢ (Bauer, 1963) of another. NaN
    /// or 0 if M is singular. Neither depends on the units of the coordinates.
    #[inline]
    #[must_use]
    pub fn relative_pivots(&self) -> SVector<S, N> {
        match &self.form {
            Form::Symmetric => self.relative_pivots,
            Form::Exchanged(_) => self.reciprocal_conditions(),
        }
    }

    #[cold]
    #[inline(never)]
    fn reciprocal_conditions(&self) -> SVector<S, N> {
        let conditions = pivoting::reciprocal_conditions(&self.factors);
        let pivots = self.relative_pivots.iter();
        let definite = pivots.fold(S::one(), |all, pivot| all * greater(*pivot, S::zero()));
        self.relative_pivots.or(conditions, definite)
    }

    /// The solutions X of M X = B, column by column.
    #[inline]
    #[must_use]
    pub fn solve<const K: usize>(&self, right: &SMatrix<S, N, K>) -> SMatrix<S, N, K> {
        match &self.form {
            Form::Symmetric => self.solve_symmetric(right),
            Form::Exchanged(exchanges) => self.solve_pivoted(right, exchanges),
        }
    }

    #[inline]
    fn solve_symmetric<const K: usize>(&self, right: &SMatrix<S, N, K>) -> SMatrix<S, N, K> {
        let mut x = *right;
        let mut column = 0;
        while column + RIGHT_HAND_SIDES_AT_ONCE <= K {
            self.solve_columns::<K, RIGHT_HAND_SIDES_AT_ONCE>(&mut x, column);
            column += RIGHT_HAND_SIDES_AT_ONCE;
        }
        while column < K {
            self.solve_columns::<K, 1>(&mut x, column);
            column += 1;
        }
        x
    }

    /// Solves for as many columns at once as the processor has lanes, beginning with one.
    #[inline]
    fn solve_columns<const K: usize, const W: usize>(
        &self,
        x: &mut SMatrix<S, N, K>,
        first: usize,
    ) {
        let l = &self.factors;
        let mut rows: [[S; W]; N] =
            core::array::from_fn(|i| core::array::from_fn(|lane| x[(i, first + lane)]));
        for i in 0..N {
            let mut row = rows[i];
            for k in 0..i {
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
        exchanges: &SVector<S, N>,
    ) -> SMatrix<S, N, K> {
        pivoting::solve(&self.factors, &self.reciprocals, exchanges, right)
    }
}

/// row −= factor · other.
#[inline]
fn subtract<S: Scalar, const W: usize>(row: &mut [S; W], factor: S, other: [S; W]) {
    for (entry, other) in row.iter_mut().zip(other) {
        *entry = (-factor).mul_add(other, *entry);
    }
}
