//! The known coefficients of a series.

use crate::scalar::Scalar;

/// The coefficients of order 0, 1, …; at most 2·`HALF` of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Terms<S, const HALF: usize> {
    terms: [[S; 2]; HALF],
    count: usize,
}

impl<S: Scalar, const HALF: usize> Terms<S, HALF> {
    pub(super) fn new() -> Self {
        Self {
            terms: [[S::zero(); 2]; HALF],
            count: 0,
        }
    }

    /// Returns the known coefficients.
    pub(super) fn known(&self) -> &[S] {
        let terms = self.terms.as_flattened();
        &terms[..self.count.min(terms.len())]
    }

    /// Returns the coefficient of order 0; NaN before it is known.
    pub(super) fn first(&self) -> S {
        let not_known = S::from_f64(f64::NAN);
        self.known().first().copied().unwrap_or(not_known)
    }

    pub(super) fn push(&mut self, term: S) {
        if let Some(place) = self.terms.as_flattened_mut().get_mut(self.count) {
            *place = term;
        }
        self.count += 1;
    }

    /// Returns the number of known coefficients, which is the order of the next one.
    pub(super) fn order(&self) -> usize {
        self.count
    }
}

/// Returns Σ xᵢ yₖ₋ᵢ over all i for which both are given; the last term of one factor is paired with the first of the
/// other.
pub(in crate::integrate::taylor) fn convolution<S: Scalar>(x: &[S], y: &[S]) -> S {
    let pairs = x.iter().zip(y.iter().rev());
    pairs.fold(S::zero(), |sum, (x, y)| x.mul_add(*y, sum))
}

/// Returns Σ i xᵢ yₖ₋ᵢ, where the first element of `x` is of order 1.
pub(super) fn weighted_convolution<S: Scalar>(x: &[S], y: &[S]) -> S {
    let mut sum = S::zero();
    let mut weight = S::one();
    for (x, y) in x.iter().zip(y.iter().rev()) {
        sum = (weight * *x).mul_add(*y, sum);
        weight += S::one();
    }
    sum
}

/// Converts an order to a scalar.
pub(super) fn number<S: Scalar>(order: usize) -> S {
    S::from_f64(super::super::coefficients::number(order))
}
