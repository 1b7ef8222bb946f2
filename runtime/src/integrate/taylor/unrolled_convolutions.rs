//! The sums of products in recurrences for Taylor coefficients, as straight-line code.

// If they are not inlined, the sums of single pairs return through memory.
#![allow(clippy::inline_always)]

use super::convolutions::{FactorPairs, ORDERS, OnlineConvolutions, PairSums};
use crate::scalar::Scalar;

/// The terms of order 1, 2, … of each factor.
type Terms<S, const FACTORS: usize, const HALF: usize> = [[[S; 2]; HALF]; FACTORS];

/// The convolutions Σ₀﹤ᵢ﹤ₖ xᵢ yₖ₋ᵢ of a few pairs of factors, order by order.
///
/// In contrast to [`Convolutions`](super::Convolutions), the pairs are not in a loop: each row of terms has a constant address.
#[derive(Clone, Debug)]
#[repr(align(64))] // Lanes are loaded from whole cache lines.
pub(crate) struct UnrolledConvolutions<
    S,
    const FACTORS: usize,
    const PAIRS: usize,
    const HALF: usize,
> {
    terms: Terms<S, FACTORS, HALF>,
    /// The known parts of the sums of orders n + 2 to n + 4, where n is the multiple of 4 below the present order.
    begun: [[S; ORDERS - 1]; PAIRS],
    order: usize,
}

impl<S: Scalar, const FACTORS: usize, const PAIRS: usize, const HALF: usize>
    UnrolledConvolutions<S, FACTORS, PAIRS, HALF>
{
    /// Creates the convolutions of order 1, which are empty sums.
    #[inline]
    pub(crate) fn new() -> Self {
        Self {
            terms: [[[S::zero(); 2]; HALF]; FACTORS],
            begun: [[S::zero(); ORDERS - 1]; PAIRS],
            order: 1,
        }
    }

    /// Returns to order 1. The terms of higher orders are written before they are read.
    #[inline]
    pub(crate) fn restart(&mut self) {
        self.order = 1;
    }

    /// Returns the sums of the next order; `STAGE` is the present order up to 4, then 5, 6, 7, 8, 5, ….
    #[inline(always)]
    fn sums<P: FactorPairs<PAIRS>, const STAGE: usize>(
        &mut self,
        factors: &[S; FACTORS],
        before: usize,
    ) -> [S; PAIRS] {
        P::each(&mut NextSums::<S, FACTORS, PAIRS, HALF, STAGE> {
            factors,
            terms: &self.terms,
            before,
            begun: &mut self.begun,
        })
    }
}

impl<S: Scalar, const FACTORS: usize, const PAIRS: usize, const HALF: usize>
    OnlineConvolutions<S, FACTORS, PAIRS> for UnrolledConvolutions<S, FACTORS, PAIRS, HALF>
{
    #[inline(always)]
    fn advance<P: FactorPairs<PAIRS>>(&mut self, factors: &[S; FACTORS]) -> [S; PAIRS] {
        let before = self.order - 1;
        if before >= 2 * HALF {
            return [S::zero(); PAIRS];
        }
        let sums = match (before, before % ORDERS) {
            (0, _) => self.sums::<P, 1>(factors, 0),
            (1, _) => self.sums::<P, 2>(factors, 1),
            (2, _) => self.sums::<P, 3>(factors, 2),
            (3, _) => self.sums::<P, 4>(factors, 3),
            (_, 0) => self.sums::<P, 5>(factors, before),
            (_, 1) => self.sums::<P, 6>(factors, before),
            (_, 2) => self.sums::<P, 7>(factors, before),
            _ => self.sums::<P, 8>(factors, before),
        };
        for (terms, factor) in self.terms.iter_mut().zip(factors) {
            terms.as_flattened_mut()[before] = *factor;
        }
        self.order += 1;
        sums
    }
}

/// The sums of the order after the present one.
struct NextSums<
    'a,
    S,
    const FACTORS: usize,
    const PAIRS: usize,
    const HALF: usize,
    const STAGE: usize,
> {
    /// The present terms.
    factors: &'a [S; FACTORS],
    /// The terms of the orders before.
    terms: &'a Terms<S, FACTORS, HALF>,
    before: usize,
    begun: &'a mut [[S; ORDERS - 1]; PAIRS],
}

impl<S, const FACTORS: usize, const PAIRS: usize, const HALF: usize, const STAGE: usize> PairSums<S>
    for NextSums<'_, S, FACTORS, PAIRS, HALF, STAGE>
where
    S: Scalar,
{
    #[inline(always)]
    fn of(&mut self, place: usize, x: usize, y: usize) -> S {
        let present = [self.factors[x], self.factors[y]];
        let [x, y] = [x, y].map(|factor| self.terms[factor].as_flattened());
        // The products with present terms come last, so that the others do not wait for these.
        let with_present = |sum: S, i: usize| {
            let sum = present[0].mul_add(y[i], sum);
            x[i].mul_add(present[1], sum)
        };
        let crossed = |sum: S, i: usize, j: usize| x[j].mul_add(y[i], x[i].mul_add(y[j], sum));
        let (begun, before) = (&mut self.begun[place], self.before);
        match STAGE {
            1 => present[0] * present[1],
            2 => with_present(S::zero(), 0),
            3 => with_present(x[1] * y[1], 0),
            4 => {
                let [second, third] = [with_present(x[2] * y[2], 1), with_present(S::zero(), 2)];
                *begun = [second, third, present[0] * present[1]];
                with_present(crossed(S::zero(), 1, 2), 0)
            }
            5 => with_present(begun[0], 0),
            6 => with_present(crossed(begun[1], 1, before - 1), 0),
            7 => {
                let sum = crossed(begun[2], 2, before - 2);
                with_present(crossed(sum, 1, before - 1), 0)
            }
            _ => {
                let [first, second, third, fourth] = products(&x[..before], &y[..before]);
                *begun = [
                    with_present(second, 1),
                    with_present(third, 2),
                    with_present(fourth, 3),
                ];
                with_present(first, 0)
            }
        }
    }

    #[inline(always)]
    fn none(&self) -> S {
        S::zero()
    }
}

/// Returns the sums of the products whose orders add up to n + 1, …, n + 4, over the terms of order 2 to n − 1, where n is a
/// multiple of 4 above 4.
#[inline(always)]
fn products<S: Scalar>(x: &[S], y: &[S]) -> [S; ORDERS] {
    let mut sums = [S::zero(); ORDERS];
    let ends = (x.first_chunk(), y.last_chunk());
    let (Some([_, x1, x2, x3, x4, x5, x6]), Some([y6, y5, y4, y3, y2, y1])) = ends else {
        return sums;
    };
    let mut plus = |x: &S, y: &[&S]| {
        for (sum, y) in sums.iter_mut().zip(y) {
            *sum = x.mul_add(**y, *sum);
        }
    };
    plus(x1, &[y1]);
    plus(x2, &[y2, y1]);
    plus(x3, &[y3, y2, y1]);
    plus(x4, &[y4, y3, y2, y1]);
    plus(x5, &[y5, y4, y3, y2]);
    plus(x6, &[y6, y5, y4, y3]);
    let fours = x[7..].as_chunks::<ORDERS>().0.iter();
    let mut window = [y6, y5, y4];
    for (x, y) in fours.zip(y[1..y.len() - 6].as_rchunks::<ORDERS>().1.iter().rev()) {
        let [w1, w2, w3] = window;
        let [y3, y2, y1, y0] = y;
        plus(&x[0], &[y0, w1, w2, w3]);
        plus(&x[1], &[y1, y0, w1, w2]);
        plus(&x[2], &[y2, y1, y0, w1]);
        plus(&x[3], &[y3, y2, y1, y0]);
        window = [y3, y2, y1];
    }
    sums
}
