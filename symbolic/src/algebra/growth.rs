//! What grows exponentially, and sums as the term that grows most times a rest.

use crate::algebra::hashing::Table;
use crate::{Expression, Rational};

/// What is positive everywhere and may be too large for a number.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Growing {
    /// eᵘ.
    Exponential(Expression),
    /// 1 + eᵘ.
    OneMore(Expression),
    /// cosh u.
    Cosine(Expression),
}

impl Growing {
    /// u.
    pub(super) fn argument(self) -> Expression {
        match self {
            Self::Exponential(u) | Self::OneMore(u) | Self::Cosine(u) => u,
        }
    }
}

/// The sums that have been scaled: products ask for the same ones again and again.
pub(crate) type KnownScales = Table<Expression, Option<Scaled>>;

/// A sum as a growing function times what is left.
#[derive(Clone, Debug)]
pub(crate) struct Scaled {
    pub(super) scale: Growing,
    /// The exponent of what grows, a positive integer.
    pub(super) power: Rational,
    pub(super) rest: Expression,
}
