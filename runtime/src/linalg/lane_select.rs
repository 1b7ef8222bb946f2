//! Branch-free selection, lane by lane, like the masks of SIMD instructions.
//!
//! The lanes of a [`Scalar`] may need different branches, but a scalar cannot be asked which lane needs which branch. A
//! mask is therefore a scalar itself, 1 in the lanes where a condition holds and 0 in the others. The value that is not
//! selected is removed by arithmetic, even where it is not finite.

use nalgebra::SMatrix;

use crate::scalar::Scalar;

/// Returns the mask of left > right.
#[inline]
pub(crate) fn greater<S: Scalar>(left: S, right: S) -> S {
    (left - right).signum().max(S::zero())
}

/// Returns the mask of x = 0.
#[inline]
pub(crate) fn is_zero<S: Scalar>(x: S) -> S {
    S::one() - x.signum().abs()
}

/// Returns x, or 1 where x is zero, so that it can be used as a divisor.
#[inline]
pub(crate) fn one_if_zero<S: Scalar>(x: S) -> S {
    x + is_zero(x)
}

/// Returns √x, with the derivative 0 at 0.
#[inline]
pub(crate) fn square_root<S: Scalar>(x: S) -> S {
    let is_zero = is_zero(x);
    (x + is_zero).sqrt() - is_zero
}

/// Returns an index as a scalar, whose lanes may later have different values.
#[inline]
pub(crate) fn from_index<S: Scalar>(index: usize) -> S {
    S::from_f64(f64::from(u32::try_from(index).unwrap_or(u32::MAX)))
}

/// A value that can be selected lane by lane.
pub trait LaneSelect<S: Scalar>: Sized {
    /// Returns `self` in the lanes where the mask is 1, and `other` where it is 0.
    #[must_use]
    fn select(self, other: Self, mask: S) -> Self;
}

/// Returns one of two values if all lanes agree, and their blend if they do not.
#[inline]
fn select_or_blend<S: Scalar, T>(first: T, other: T, mask: S, blend: impl FnOnce(T, T) -> T) -> T {
    if mask.largest() <= 0.0 {
        other
    } else if mask.smallest() > 0.0 {
        first
    } else {
        blend(first, other)
    }
}

impl<S: Scalar, const R: usize, const C: usize> LaneSelect<S> for SMatrix<S, R, C> {
    #[inline]
    fn select(self, other: Self, mask: S) -> Self {
        let complement = S::one() - mask;
        select_or_blend(self, other, mask, |first, other| {
            first.zip_map(&other, |x, y| x.masked(mask) + y.masked(complement))
        })
    }
}

/// Interchanges two rows of a matrix in the lanes where the mask is 1.
pub(crate) fn swap_rows<S: Scalar, const R: usize, const C: usize>(
    matrix: &mut SMatrix<S, R, C>,
    upper: usize,
    lower: usize,
    mask: S,
) {
    if mask.largest() <= 0.0 {
        return;
    }
    if mask.smallest() > 0.0 {
        matrix.swap_rows(upper, lower);
        return;
    }
    let complement = S::one() - mask;
    for k in 0..C {
        let (x, y) = (matrix[(upper, k)], matrix[(lower, k)]);
        matrix[(upper, k)] = x.masked(complement) + y.masked(mask);
        matrix[(lower, k)] = y.masked(complement) + x.masked(mask);
    }
}
