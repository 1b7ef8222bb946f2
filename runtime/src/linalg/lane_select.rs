//! Branch-free selection, lane by lane, as with the masks of SIMD instructions.
//!
//! The lanes of a [`Scalar`] may need different branches, and a scalar cannot be asked which lane needs which.
//! A mask is therefore a scalar itself, 1 in the lanes where a condition holds and 0 in the others, and the value
//! that is not selected is removed by arithmetic, also where it is not finite.

use nalgebra::SMatrix;

use crate::scalar::Scalar;

/// The mask of left > right.
#[inline]
pub(crate) fn greater<S: Scalar>(left: S, right: S) -> S {
    (left - right).signum().max(S::zero())
}

/// The mask of x = 0.
#[inline]
pub(crate) fn is_zero<S: Scalar>(x: S) -> S {
    S::one() - x.signum().abs()
}

/// x, or 1 where it is zero, so that it can be divided by.
#[inline]
pub(crate) fn one_if_zero<S: Scalar>(x: S) -> S {
    x + is_zero(x)
}

/// An index as a scalar, of which lanes can have different values.
#[inline]
pub(crate) fn from_index<S: Scalar>(index: usize) -> S {
    (0..index).fold(S::zero(), |number, _| number + S::one())
}

/// What can be selected lane by lane.
pub trait LaneSelect<S: Scalar>: Sized {
    /// This value in the lanes where the mask is 1, `other` where it is 0.
    #[must_use]
    fn select(self, other: Self, mask: S) -> Self;
}

/// One of two values where all lanes agree; their blend where they do not.
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
