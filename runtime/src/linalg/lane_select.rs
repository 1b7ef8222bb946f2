//! Decisions taken lane by lane.
//!
//! The lanes of a [`Scalar`] may want different things, and of a scalar it cannot be asked which lane wants
//! what. A decision is therefore a number itself, 1 in the lanes that want something and 0 in the others,
//! and what was not chosen vanishes by arithmetic, also where it is not finite.

use nalgebra::SMatrix;

use crate::scalar::Scalar;

/// 1 where `left` is greater than `right`, in every lane that is so; 0 elsewhere.
#[inline]
pub(crate) fn greater<S: Scalar>(left: S, right: S) -> S {
    (left - right).signum().max(S::zero())
}

/// 1 where a number is zero; 0 elsewhere.
#[inline]
pub(crate) fn is_zero<S: Scalar>(number: S) -> S {
    S::one() - number.signum().abs()
}

/// The number itself; 1 where it is zero, so that it can be divided by.
#[inline]
pub(crate) fn divisor<S: Scalar>(number: S) -> S {
    number + is_zero(number)
}

/// An index as a number that lanes can have different ones of.
#[inline]
pub(crate) fn number<S: Scalar>(index: usize) -> S {
    (0..index).fold(S::zero(), |number, _| number + S::one())
}

/// The number where `chosen` is 1; 0 where it is 0, whatever the number is.
///
/// The least of two numbers, one of which is none, is the other; so is the greatest. The bounds are therefore
/// no numbers where nothing is to be bounded.
fn kept<S: Scalar>(number: S, chosen: S) -> S {
    let bound = S::zero() / (S::one() - chosen);
    number.max(bound).min(bound)
}

/// What consists of scalars, and can be put together lane by lane.
pub trait Lanewise<S: Scalar>: Sized {
    /// Its entries where `chosen` is 1, those of `other` where it is 0.
    #[must_use]
    fn or(self, other: Self, chosen: S) -> Self;
}

/// One of two, where all lanes agree; else what `blend` makes of them.
fn decided<S: Scalar, T>(first: T, other: T, chosen: S, blend: impl FnOnce(T, T) -> T) -> T {
    if chosen.largest() <= 0.0 {
        other
    } else if chosen.smallest() > 0.0 {
        first
    } else {
        blend(first, other)
    }
}

impl<S: Scalar, const R: usize, const C: usize> Lanewise<S> for SMatrix<S, R, C> {
    fn or(self, other: Self, chosen: S) -> Self {
        let rest = S::one() - chosen;
        decided(self, other, chosen, |first, other| {
            first.zip_map(&other, |x, y| kept(x, chosen) + kept(y, rest))
        })
    }
}

/// Exchanges two rows of a matrix in the lanes in which `wanted` is 1.
pub(crate) fn exchange_rows<S: Scalar, const R: usize, const C: usize>(
    matrix: &mut SMatrix<S, R, C>,
    upper: usize,
    lower: usize,
    wanted: S,
) {
    if wanted.largest() <= 0.0 {
        return;
    }
    if wanted.smallest() > 0.0 {
        matrix.swap_rows(upper, lower);
        return;
    }
    let rest = S::one() - wanted;
    for k in 0..C {
        let (x, y) = (matrix[(upper, k)], matrix[(lower, k)]);
        matrix[(upper, k)] = kept(x, rest) + kept(y, wanted);
        matrix[(lower, k)] = kept(y, rest) + kept(x, wanted);
    }
}
