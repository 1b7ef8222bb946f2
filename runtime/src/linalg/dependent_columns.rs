//! Some components of a vector in terms of the others, on the null space of a matrix: Gauss–Jordan elimination with complete
//! pivoting (G. H. Golub & C. F. Van Loan, *Matrix Computations*, 4th edition (2013), 3.4.8).

use nalgebra::{SMatrix, SVector};

use crate::limits::MIN_INDEPENDENT_SINE;
use crate::scalar::Scalar;

/// The dependent components of the solutions of G x = r as functions of r.
pub(crate) struct DependentColumns<S: Scalar, const C: usize, const N: usize> {
    jacobian: SMatrix<S, C, N>,
    /// X, with which x = X r solves G x = r for right-hand sides in the range of G; its rows of independent components are zero.
    solver: SMatrix<S, N, C>,
}

/// The reason why the other components of a vector do not determine it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Undetermined {
    /// A component that others should determine and do not.
    pub(crate) free: usize,
    /// One of the others that follows from the rest of them.
    pub(crate) bound: Option<usize>,
    /// The largest pivot that is left, where rows and columns are scaled to length 1 in the metric of M.
    pub(crate) pivot: f64,
}

impl<S: Scalar, const C: usize, const N: usize> DependentColumns<S, C, N> {
    /// Solves the rows of `jacobian` for all components that are not independent. `widths` are the roots of the diagonal of M.
    pub(crate) fn of(
        jacobian: &SMatrix<S, C, N>,
        widths: &SVector<S, N>,
        independent: &[bool; N],
    ) -> Result<Self, Undetermined> {
        let mut left = SMatrix::<S, C, N>::from_fn(|i, j| jacobian[(i, j)] / widths[j]);
        let scales = SVector::<S, C>::from_fn(|i, _| {
            let square = left.row(i).iter().fold(S::zero(), |sum, x| sum + *x * *x);
            if square.largest() > 0.0 {
                S::one() / square.sqrt()
            } else {
                S::one()
            }
        });
        left = SMatrix::from_fn(|i, j| left[(i, j)] * scales[i]);
        let mut right =
            SMatrix::<S, C, C>::from_fn(|i, j| if i == j { scales[i] } else { S::zero() });
        let mut row_of = [None; N];
        for _ in independent
            .iter()
            .filter(|is_independent| !**is_independent)
        {
            let is_open = |i: usize, j: usize| {
                !independent[j] && row_of[j].is_none() && !row_of.contains(&Some(i))
            };
            match largest(&left, is_open) {
                Some((i, j, pivot)) if pivot > MIN_INDEPENDENT_SINE => {
                    eliminate(&mut left, &mut right, (i, j));
                    row_of[j] = Some(i);
                }
                found => return Err(undetermined(&left, independent, &row_of, found)),
            }
        }
        let solver = SMatrix::from_fn(|j, k| {
            row_of[j].map_or(S::zero(), |i: usize| right[(i, k)] / widths[j])
        });
        Ok(Self {
            jacobian: *jacobian,
            solver,
        })
    }

    /// Returns the solution x of G x = r whose independent components are those of `given`.
    pub(crate) fn completed(&self, given: &SVector<S, N>, right: &SVector<S, C>) -> SVector<S, N> {
        let mut x = *given;
        // The second time takes away what the rounding errors of the elimination have left.
        for _ in 0..2 {
            let residual = right - self.jacobian * x;
            x += self.solver * residual;
        }
        x
    }
}

/// Returns the place of the largest entry among some, and its size.
fn largest<S: Scalar, const C: usize, const N: usize>(
    matrix: &SMatrix<S, C, N>,
    is_open: impl Fn(usize, usize) -> bool,
) -> Option<(usize, usize, f64)> {
    let places = (0..N).flat_map(|j| (0..C).map(move |i| (i, j)));
    let mut most: Option<(usize, usize, f64)> = None;
    for (i, j) in places.filter(|(i, j)| is_open(*i, *j)) {
        let size = matrix[(i, j)].abs().largest();
        if most.is_none_or(|(.., other)| size > other) {
            most = Some((i, j, size));
        }
    }
    most
}

/// Sets a column to a column of the identity matrix.
fn eliminate<S: Scalar, const C: usize, const N: usize>(
    left: &mut SMatrix<S, C, N>,
    right: &mut SMatrix<S, C, C>,
    (i, j): (usize, usize),
) {
    let reciprocal = S::one() / left[(i, j)];
    let pivot_left = SVector::<S, N>::from_fn(|l, _| left[(i, l)]);
    let pivot_right = SVector::<S, C>::from_fn(|l, _| right[(i, l)]);
    for k in (0..C).filter(|k| *k != i) {
        let factor = left[(k, j)] * reciprocal;
        for l in 0..N {
            left[(k, l)] -= factor * pivot_left[l];
        }
        for l in 0..C {
            right[(k, l)] -= factor * pivot_right[l];
        }
    }
    left.row_mut(i).iter_mut().for_each(|x| *x *= reciprocal);
    right.row_mut(i).iter_mut().for_each(|x| *x *= reciprocal);
}

/// Names a component that stays free, and one of the independent components that the rows left over relate.
fn undetermined<S: Scalar, const C: usize, const N: usize>(
    left: &SMatrix<S, C, N>,
    independent: &[bool; N],
    row_of: &[Option<usize>; N],
    found: Option<(usize, usize, f64)>,
) -> Undetermined {
    let first = (0..N).find(|j| !independent[*j] && row_of[*j].is_none());
    let bound = largest(left, |i, j| independent[j] && !row_of.contains(&Some(i)));
    Undetermined {
        free: found.map_or(first.unwrap_or_default(), |(_, j, _)| j),
        bound: bound
            .filter(|(.., size)| *size > MIN_INDEPENDENT_SINE)
            .map(|(_, j, _)| j),
        pivot: found.map_or(0.0, |(.., pivot)| pivot),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WIDTHS: [f64; 3] = [1.0, 1e3, 1e-2];

    /// x + 2 y = 1 and y − z = 3 with x given, and twice the first.
    #[test]
    fn dependent_components_follow_from_the_others() {
        let jacobian = SMatrix::<f64, 3, 3>::new(1.0, 2.0, 0.0, 0.0, 1.0, -1.0, 2.0, 4.0, 0.0);
        let independent = [true, false, false];
        let columns =
            DependentColumns::of(&jacobian, &WIDTHS.into(), &independent).expect("it has rank 2");
        let found = columns.completed(&[0.5, 0.0, 0.0].into(), &[1.0, 3.0, 2.0].into());
        assert!((found - SVector::from([0.5, 0.25, -2.75])).amax() < 1e-15);
    }

    /// x − y = 0 leaves z free, whatever x is.
    #[test]
    fn what_stays_free_and_what_follows_is_named() {
        let jacobian = SMatrix::<f64, 2, 3>::new(1.0, -1.0, 0.0, 2.0, -2.0, 0.0);
        let found = DependentColumns::of(&jacobian, &WIDTHS.into(), &[true, true, false]).err();
        let found = found.expect("z is not determined");
        assert_eq!((found.free, found.pivot), (2, 0.0));
        assert!(found.bound.is_some_and(|j| j < 2));
    }
}
