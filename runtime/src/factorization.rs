//! Solving M q̈ = f for the accelerations.
//!
//! Comes in: the symmetric mass matrix. Goes out: solutions for any number of right-hand sides, and
//! how much was lost on the way. A positive definite M is factored as L D Lᵀ without pivoting, which
//! is stable; a regular M that is not (L = ẋ ẏ) takes a cold path with row pivoting. A singular M
//! gives values that are not finite, and no panic. Lanes do not depend on each other: where no exchange
//! of rows suits all of them, M is inverted (`inverse.rs`).

use nalgebra::{SMatrix, SVector};

use crate::Scalar;
use crate::inverse::Inverse;

/// A factored mass matrix.
#[derive(Clone, Copy, Debug)]
pub struct Factorization<S: Scalar, const N: usize> {
    /// Below the diagonal the unit lower factor; above it U of the cold path. Or the inverse.
    factors: SMatrix<S, N, N>,
    /// The reciprocals of the pivots.
    reciprocals: SVector<S, N>,
    /// Each pivot in relation to what it was before elimination.
    relative_pivots: SVector<S, N>,
    form: Form<N>,
}

/// What the factors are those of.
#[derive(Clone, Copy, Debug)]
enum Form<const N: usize> {
    /// L D Lᵀ.
    Symmetric,
    /// L U, whose rows were exchanged, with the row of M that each was.
    Exchanged([usize; N]),
    /// M⁻¹ itself.
    Inverse,
}

/// Right-hand sides that are solved for together.
const WIDTH: usize = 4;

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
        if definite {
            Self {
                factors,
                reciprocals,
                relative_pivots,
                form: Form::Symmetric,
            }
        } else {
            Self::with_pivoting(&mass)
        }
    }

    /// The cold path: L U with exchange of rows, for a matrix that is not positive definite.
    #[cold]
    #[inline(never)]
    fn with_pivoting(lower: &SMatrix<S, N, N>) -> Self {
        let full = |i: usize, j: usize| lower[(i.max(j), i.min(j))];
        let mut factors = SMatrix::<S, N, N>::from_fn(full);
        let scale: SVector<S, N> = SVector::from_fn(|i, _| {
            (0..N).fold(S::zero(), |most, j| most.max(factors[(i, j)].abs()))
        });
        let mut rows: [usize; N] = core::array::from_fn(|i| i);
        let mut reciprocals = SVector::zeros();
        let mut relative_pivots = SVector::zeros();
        for j in 0..N {
            let weight = |i: usize| (factors[(i, j)] / scale[rows[i]]).abs();
            let best = (j + 1..N).fold(j, |best, i| {
                if weight(i).smallest() > weight(best).smallest() {
                    i
                } else {
                    best
                }
            });
            // A lane whose greatest weight is another row's, or that has none.
            let differs = |i: usize| {
                let advantage = (weight(i) - weight(best)).largest();
                advantage > 0.0 || advantage.is_nan()
            };
            if (j..N).any(differs)
                || (weight(best).smallest() == 0.0 && weight(best).largest() > 0.0)
            {
                return Self::inverting(&SMatrix::from_fn(full));
            }
            factors.swap_rows(j, best);
            rows.swap(j, best);
            let pivot = factors[(j, j)];
            reciprocals[j] = S::one() / pivot;
            relative_pivots[rows[j]] = (pivot / scale[rows[j]]).abs();
            // Nothing can be eliminated with nothing: the other rows keep what they have.
            if pivot.abs().smallest() == 0.0 {
                relative_pivots[rows[j]] = S::zero();
                continue;
            }
            for i in j + 1..N {
                let multiplier = factors[(i, j)] * reciprocals[j];
                factors[(i, j)] = multiplier;
                for k in j + 1..N {
                    let change = multiplier * factors[(j, k)];
                    factors[(i, k)] -= change;
                }
            }
        }
        Self {
            factors,
            reciprocals,
            relative_pivots,
            form: Form::Exchanged(rows),
        }
    }

    #[cold]
    #[inline(never)]
    fn inverting(mass: &SMatrix<S, N, N>) -> Self {
        let Inverse {
            matrix,
            relative_pivots,
        } = Inverse::new(mass);
        Self {
            factors: matrix,
            reciprocals: SVector::zeros(),
            relative_pivots,
            form: Form::Inverse,
        }
    }

    /// For each row, the pivot in relation to what it was before elimination: the diagonal entry of
    /// a positive definite matrix, the largest entry of the row of another. NaN or 0 if singular.
    #[inline]
    #[must_use]
    pub fn relative_pivots(&self) -> SVector<S, N> {
        self.relative_pivots
    }

    /// The solutions X of M X = B, column by column.
    #[inline]
    #[must_use]
    pub fn solve<const K: usize>(&self, right: &SMatrix<S, N, K>) -> SMatrix<S, N, K> {
        match &self.form {
            Form::Symmetric => self.solve_symmetric(right),
            Form::Exchanged(rows) => self.solve_pivoted(right, rows),
            Form::Inverse => self.factors * right,
        }
    }

    #[inline]
    fn solve_symmetric<const K: usize>(&self, right: &SMatrix<S, N, K>) -> SMatrix<S, N, K> {
        let mut x = *right;
        let mut column = 0;
        while column + WIDTH <= K {
            self.solve_columns::<K, WIDTH>(&mut x, column);
            column += WIDTH;
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
        rows: &[usize; N],
    ) -> SMatrix<S, N, K> {
        let lu = &self.factors;
        let mut x = SMatrix::from_fn(|i, column| right[(rows[i], column)]);
        for column in 0..K {
            for i in 0..N {
                for k in 0..i {
                    let change = lu[(i, k)] * x[(k, column)];
                    x[(i, column)] -= change;
                }
            }
            for i in (0..N).rev() {
                for k in i + 1..N {
                    let change = lu[(i, k)] * x[(k, column)];
                    x[(i, column)] -= change;
                }
                x[(i, column)] *= self.reciprocals[i];
            }
        }
        x
    }
}

/// row −= factor · other.
#[inline]
fn subtract<S: Scalar, const W: usize>(row: &mut [S; W], factor: S, other: [S; W]) {
    for (entry, other) in row.iter_mut().zip(other) {
        *entry = (-factor).mul_add(other, *entry);
    }
}
