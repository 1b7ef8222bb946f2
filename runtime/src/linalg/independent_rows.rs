//! A choice of independent rows of a matrix, and the others in terms of them: Gram–Schmidt orthogonalization with row
//! pivoting (Å. Björck, *Numerical Methods for Least Squares Problems* (1996), 2.4 and 2.7). Lanes do not depend on each
//! other.

use nalgebra::{SMatrix, SVector};

use super::factorization::Factorization;
use super::lane_select::{from_index, greater, is_zero, one_if_zero, square_root};
use crate::limits::MIN_INDEPENDENT_SINE;
use crate::scalar::Scalar;

/// What is known of the rows of a matrix.
#[derive(Clone, Copy, Debug)]
pub(super) struct IndependentRows<S: Scalar, const C: usize> {
    /// 1 for a row that depends on others, 0 for an independent one.
    pub(super) dependent: SVector<S, C>,
    /// For an independent row the sine of its angle to those chosen before it, 1 for the others.
    pub(super) sines: SVector<S, C>,
    /// X, by which dependent rows are combinations of independent ones; zeros elsewhere.
    combinations: SMatrix<S, C, C>,
    /// The weights of the squares of multipliers.
    pub(super) compliances: SVector<S, C>,
}

/// An orthonormal basis of the rows of a matrix, in the metric of the diagonal of a mass matrix: of G D^(−1/2).
pub(crate) struct RowSpace<S: Scalar, const C: usize, const N: usize> {
    /// 1 for a row that depends on others, 0 for an independent one.
    pub(crate) dependent: SVector<S, C>,
    /// The orthonormal rows, as many as there are independent ones, and behind them rows of zeros.
    pub(crate) directions: SMatrix<S, C, N>,
}

impl<S: Scalar, const C: usize, const N: usize> RowSpace<S, C, N> {
    /// Decides as [`IndependentRows`] which rows of `jacobian` depend on others at this matrix.
    pub(crate) fn of(jacobian: &SMatrix<S, C, N>, mass: &SVector<S, N>) -> Self {
        let mut steps = Orthogonalization::<S, C, N>::new(jacobian, mass);
        let mut directions = SMatrix::<S, C, N>::zeros();
        for step in 0..C {
            let direction = steps.choose(step, S::zero(), S::zero());
            directions.set_row(step, &direction.transpose());
        }
        Self {
            dependent: steps.used.map(|used| S::one() - used),
            directions,
        }
    }
}

/// Returns in each lane the smallest sine of the angle between an independent row of `jacobian` and the rows chosen before it, in
/// the metric of the diagonal of a mass matrix.
pub(crate) fn smallest_sine<S: Scalar, const C: usize, const N: usize>(
    jacobian: &SMatrix<S, C, N>,
    mass: &SVector<S, N>,
    rank: S,
) -> S {
    let steps = Orthogonalization::of(jacobian, mass, rank);
    let sines = steps.sines.iter();
    sines.fold(S::one(), |least, sine| least.min(*sine))
}

/// Returns the roots of the diagonal of a mass matrix, by which columns of `jacobian` are divided; of coordinates without mass the
/// largest entry of the column.
pub(crate) fn column_widths<S: Scalar, const C: usize, const N: usize>(
    jacobian: &SMatrix<S, C, N>,
    mass: &SVector<S, N>,
) -> SVector<S, N> {
    SVector::from_fn(|i, _| {
        let column = jacobian.column(i);
        let largest = column.iter().fold(S::zero(), |most, x| most.max(x.abs()));
        let has_mass = greater(mass[i], S::zero());
        let length = one_if_zero(mass[i]).abs().sqrt();
        length.masked(has_mass) + one_if_zero(largest).masked(S::one() - has_mass)
    })
}

/// Rows in the course of orthogonalization.
struct Orthogonalization<S: Scalar, const C: usize, const N: usize> {
    /// The rest of each row, as a column, scaled to length 1 at the beginning.
    rows: SMatrix<S, N, C>,
    /// The factors by which rows were scaled.
    scales: SVector<S, C>,
    /// The coefficients of each row in terms of the orthonormal rows, column by column.
    coefficients: SMatrix<S, C, C>,
    /// The row that is chosen in each step, or −1 for none.
    chosen: SVector<S, C>,
    /// 1 for a row that is chosen.
    used: SVector<S, C>,
    sines: SVector<S, C>,
}

impl<S: Scalar, const C: usize> IndependentRows<S, C> {
    /// Chooses rows of `jacobian`, in the metric of the diagonal of a mass matrix: as many as the rank, or where that is 0 all
    /// whose sine is not negligible.
    pub(super) fn of<const N: usize>(
        jacobian: &SMatrix<S, C, N>,
        mass: &SVector<S, N>,
        rank: S,
    ) -> Self {
        Orthogonalization::of(jacobian, mass, rank).rows()
    }

    /// Returns the multipliers of least norm with the reactions Gᵀ λ, for multipliers λ that are 0 for dependent rows. The norm
    /// is √(Σ cᵢ λᵢ²), with the compliances cᵢ.
    ///
    /// The gradients of dependent constraints are X times the gradients of the independent ones. With multipliers μ of the
    /// dependent and λ − Xᵀ μ of the independent constraints the reactions are Gᵀ λ for any μ, and the norm is least for
    /// μ = (D + X C Xᵀ)⁻¹ X C λ, with the compliances C of the independent constraints and D of the dependent ones.
    pub(super) fn least_norm<const P: usize>(
        &self,
        multipliers: &SMatrix<S, C, P>,
    ) -> SMatrix<S, C, P> {
        if self.dependent.iter().all(|x| x.largest() <= 0.0) {
            return *multipliers;
        }
        let (x, c) = (&self.combinations, &self.compliances);
        let normal = SMatrix::<S, C, C>::from_fn(|i, j| {
            let diagonal = if i == j { c[i] } else { S::zero() };
            (0..C).fold(diagonal, |sum, k| sum + x[(i, k)] * c[k] * x[(j, k)])
        });
        let right = SMatrix::<S, C, P>::from_fn(|i, j| {
            (0..C).fold(S::zero(), |sum, k| {
                sum + x[(i, k)] * c[k] * multipliers[(k, j)]
            })
        });
        let of_dependent = Factorization::new(normal).solve(&right);
        SMatrix::from_fn(|i, j| {
            let taken = (0..C).fold(S::zero(), |sum, k| sum + x[(k, i)] * of_dependent[(k, j)]);
            multipliers[(i, j)] - taken + of_dependent[(i, j)]
        })
    }
}

impl<S: Scalar, const C: usize, const N: usize> Orthogonalization<S, C, N> {
    /// Chooses as many rows as the rank, or where that is 0 all whose sine is not negligible.
    fn of(jacobian: &SMatrix<S, C, N>, mass: &SVector<S, N>, rank: S) -> Self {
        let mut steps = Self::new(jacobian, mass);
        let is_known = S::one() - is_zero(rank);
        for step in 0..C {
            // A row is chosen while fewer than the rank are.
            let is_within = greater(rank, from_index(step));
            let _ = steps.choose(step, is_known, is_within);
        }
        steps
    }

    fn new(jacobian: &SMatrix<S, C, N>, mass: &SVector<S, N>) -> Self {
        let widths = column_widths(jacobian, mass);
        let mut rows = SMatrix::<S, N, C>::from_fn(|j, i| jacobian[(i, j)] / widths[j]);
        let scales =
            SVector::from_fn(|i, _| S::one() / one_if_zero(norm(rows.column(i).as_slice())));
        for i in 0..C {
            for x in &mut rows.column_mut(i) {
                *x *= scales[i];
            }
        }
        Self {
            rows,
            scales,
            coefficients: SMatrix::zeros(),
            chosen: SVector::from_element(-S::one()),
            used: SVector::zeros(),
            sines: SVector::from_element(S::one()),
        }
    }

    /// Chooses the row with the longest rest, where fewer rows than the known rank are chosen, or where the rest of one is not
    /// negligible, and takes its direction, which it returns, out of the others.
    fn choose(&mut self, step: usize, is_known: S, is_within: S) -> SVector<S, N> {
        let (mut best, mut longest) = (S::zero(), -S::one());
        for i in 0..C {
            let length =
                norm(self.rows.column(i).as_slice()).masked(S::one() - self.used[i]) - self.used[i];
            let mask = greater(length, longest);
            best += (from_index::<S>(i) - best).masked(mask);
            longest = longest.max(length);
        }
        let is_longer = greater(longest, S::from_f64(MIN_INDEPENDENT_SINE));
        let is_new =
            is_known * is_within * greater(longest, S::zero()) + (S::one() - is_known) * is_longer;
        self.chosen[step] = best.masked(is_new) - (S::one() - is_new);
        let mut direction = SVector::<S, N>::zeros();
        for i in 0..C {
            let mask = is_zero(best - from_index(i)) * is_new;
            let scale = S::one() / one_if_zero(longest);
            if mask.largest() > 0.0 {
                direction += self.rows.column(i).map(|x| (x * scale).masked(mask));
            }
            self.used[i] += mask;
            self.sines[i] = self.sines[i].masked(S::one() - mask) + longest.masked(mask);
        }
        for i in 0..C {
            let mut row = self.rows.column_mut(i);
            let is_chosen = is_zero(best - from_index(i)) * is_new;
            // What is chosen before has no part in this direction.
            let open = S::one() - self.used[i] + is_chosen;
            let part = dot(row.as_slice(), direction.as_slice()).masked(open);
            self.coefficients[(i, step)] = part;
            for (x, along) in row.iter_mut().zip(&direction) {
                *x -= part * *along;
            }
        }
        direction
    }

    /// The dependent rows in terms of the independent ones.
    fn rows(&self) -> IndependentRows<S, C> {
        let dependent = self.used.map(|used| S::one() - used);
        let combinations = if dependent.iter().any(|x| x.largest() > 0.0) {
            self.combinations(&dependent)
        } else {
            SMatrix::zeros()
        };
        IndependentRows {
            dependent,
            sines: self.sines,
            combinations,
            compliances: SVector::from_element(S::one()),
        }
    }

    /// X, by which dependent rows are combinations of independent ones.
    fn combinations(&self, dependent: &SVector<S, C>) -> SMatrix<S, C, C> {
        // The coefficients of the row that is chosen in each step.
        let triangle = SMatrix::<S, C, C>::from_fn(|step, k| {
            (0..C).fold(S::zero(), |sum, i| {
                let mask = is_zero(self.chosen[step] - from_index(i));
                sum + self.coefficients[(i, k)].masked(mask)
            })
        });
        let mut combinations = SMatrix::<S, C, C>::zeros();
        for i in 0..C {
            let mut parts = SVector::<S, C>::zeros();
            for k in (0..C).rev() {
                let later = (k + 1..C).fold(S::zero(), |sum, l| sum + parts[l] * triangle[(l, k)]);
                let rest = self.coefficients[(i, k)] - later;
                parts[k] = rest / one_if_zero(triangle[(k, k)]);
            }
            for j in 0..C {
                let part = (0..C).fold(S::zero(), |sum, step| {
                    let mask = is_zero(self.chosen[step] - from_index(j));
                    sum + parts[step].masked(mask)
                });
                let unscaled = part * self.scales[j] / self.scales[i];
                combinations[(i, j)] = unscaled.masked(dependent[i]);
            }
        }
        combinations
    }
}

fn dot<S: Scalar>(x: &[S], y: &[S]) -> S {
    let pairs = x.iter().zip(y);
    pairs.fold(S::zero(), |sum, (x, y)| sum + *x * *y)
}

fn norm<S: Scalar>(x: &[S]) -> S {
    square_root(dot(x, x))
}
