//! The sums of products in recurrences for Taylor coefficients.

// If they are not inlined, as in programs with several models, the sums of single pairs return through memory, and a step of the
// symmetric top takes 1.1 times as many instructions.
#![allow(clippy::inline_always)]

use super::recurrences::convolution;
use crate::scalar::Scalar;

/// Convolutions, order by order, as each order is known only after the previous one (relaxed multiplication: J. van der
/// Hoeven, *Relax, but Don't be Too Lazy*, Journal of Symbolic Computation **34** (2002) 479–542).
pub(crate) trait OnlineConvolutions<S, const FACTORS: usize, const PAIRS: usize> {
    /// Returns the sums of the next order, given the terms of the present one, which is 1 at first.
    fn advance<P: FactorPairs<PAIRS>>(&mut self, factors: &[S; FACTORS]) -> [S; PAIRS];
}

impl<S, C, const FACTORS: usize, const PAIRS: usize> OnlineConvolutions<S, FACTORS, PAIRS>
    for &mut C
where
    C: OnlineConvolutions<S, FACTORS, PAIRS>,
{
    #[inline(always)]
    fn advance<P: FactorPairs<PAIRS>>(&mut self, factors: &[S; FACTORS]) -> [S; PAIRS] {
        (**self).advance::<P>(factors)
    }
}

/// The pairs of factors whose products are summed, as code instead of a table: where the code is inlined, each row of terms has a
/// constant address.
pub trait FactorPairs<const PAIRS: usize> {
    /// Returns the values of `sums` at all pairs.
    fn each<S>(sums: &mut impl PairSums<S>) -> [S; PAIRS];
}

/// A function of pairs of factors.
pub trait PairSums<S> {
    /// Returns the value at a pair, given its place and the indices of its factors.
    fn of(&mut self, place: usize, x: usize, y: usize) -> S;

    /// Returns the value for a place without a pair.
    fn none(&self) -> S;
}

/// The number of orders that are summed together: each loaded term is used in this number of products, and the sums
/// stay in registers.
pub(super) const ORDERS: usize = 4;

/// The convolutions Σ₀﹤ᵢ﹤ₖ xᵢ yₖ₋ᵢ of several pairs of factors, order by order.
///
/// The coefficient of order k of a product is this sum plus x₀ yₖ + xₖ y₀.
#[derive(Clone, Debug)]
#[repr(align(64))] // Lanes are loaded from whole cache lines.
pub(crate) struct Convolutions<S, const FACTORS: usize, const PAIRS: usize, const HALF: usize> {
    /// The terms of order 1, 2, … of each factor.
    terms: [[[S; 2]; HALF]; FACTORS],
    /// The known parts of the sums of orders n + 1 to n + 4, where n is the multiple of 4 below the present order.
    sums: [[S; ORDERS]; PAIRS],
    /// The indices of the factors of each pair.
    pairs: [Option<[usize; 2]>; PAIRS],
    order: usize,
}

impl<S: Scalar, const FACTORS: usize, const PAIRS: usize, const HALF: usize>
    Convolutions<S, FACTORS, PAIRS, HALF>
{
    /// Creates the convolutions of these pairs of order 1, which are empty sums.
    #[inline]
    pub(crate) fn of<P: FactorPairs<PAIRS>>(_: &P) -> Self {
        Self {
            terms: [[[S::zero(); 2]; HALF]; FACTORS],
            sums: [[S::zero(); ORDERS]; PAIRS],
            pairs: P::each(&mut Indices),
            order: 1,
        }
    }

    /// Returns to order 1, with these pairs. The terms of higher orders are written before they are read.
    #[inline]
    pub(crate) fn restart<P: FactorPairs<PAIRS>>(&mut self, _: &P) {
        (self.pairs, self.order) = (P::each(&mut Indices), 1);
    }

    /// Updates the sums of each pair from the terms that are known.
    #[inline]
    fn each(&mut self, known: usize, change: impl Fn(&mut [S; ORDERS], &[S], &[S])) {
        let known = known.min(2 * HALF);
        let pairs = self.pairs.iter().flatten();
        for (sums, pair) in self.sums.iter_mut().zip(pairs) {
            let [x, y] = pair.map(|factor| &self.terms[factor].as_flattened()[..known]);
            change(sums, x, y);
        }
    }
}

impl<S: Scalar, const FACTORS: usize, const PAIRS: usize, const HALF: usize>
    OnlineConvolutions<S, FACTORS, PAIRS> for Convolutions<S, FACTORS, PAIRS, HALF>
{
    #[inline]
    fn advance<P: FactorPairs<PAIRS>>(&mut self, factors: &[S; FACTORS]) -> [S; PAIRS] {
        let known = self.order;
        for (terms, factor) in self.terms.iter_mut().zip(factors) {
            if let Some(term) = terms.as_flattened_mut().get_mut(known - 1) {
                *term = *factor;
            }
        }
        self.order += 1;
        let place = known % ORDERS;
        match place {
            0 => self.each(known, |sums, x, y| *sums = products(x, y)),
            1 if known < ORDERS => self.each(1, |sums, x, y| {
                sums[1] = of_few::<S, 1>(x, y);
            }),
            2 if known < ORDERS => self.each(2, |sums, x, y| {
                sums[2] = of_few::<S, 2>(x, y);
            }),
            3 if known < ORDERS => self.each(3, |sums, x, y| {
                sums[3] = of_few::<S, 3>(x, y);
            }),
            1 => self.each(known, |sums, x, y| {
                sums[1] = with_last::<S, 1>(x, y, sums[1]);
            }),
            2 => self.each(known, |sums, x, y| {
                sums[2] = with_last::<S, 2>(x, y, sums[2]);
            }),
            _ => self.each(known, |sums, x, y| {
                sums[3] = with_last::<S, 3>(x, y, sums[3]);
            }),
        }
        core::array::from_fn(|pair| self.sums[pair][place])
    }
}

/// Convolutions up to such a low order that the pairs of factors need no memory for sums: the sums of all pairs are
/// computed side by side, term by term.
#[derive(Clone, Debug)]
pub(crate) struct FewConvolutions<S, const FACTORS: usize, const HALF: usize> {
    /// The terms of order 1, 2, … of all factors.
    terms: [[[S; FACTORS]; 2]; HALF],
    order: usize,
}

impl<S: Scalar, const FACTORS: usize, const HALF: usize> FewConvolutions<S, FACTORS, HALF> {
    #[inline]
    pub(crate) fn new() -> Self {
        Self {
            terms: [[[S::zero(); FACTORS]; 2]; HALF],
            order: 1,
        }
    }
}

impl<S: Scalar, const FACTORS: usize, const PAIRS: usize, const HALF: usize>
    OnlineConvolutions<S, FACTORS, PAIRS> for FewConvolutions<S, FACTORS, HALF>
{
    #[inline]
    fn advance<P: FactorPairs<PAIRS>>(&mut self, factors: &[S; FACTORS]) -> [S; PAIRS] {
        let known = self.order;
        let terms = self.terms.as_flattened_mut();
        if let Some(term) = terms.get_mut(known - 1) {
            *term = *factors;
        }
        self.order += 1;
        P::each(&mut AllProducts(&terms[..known.min(terms.len())]))
    }
}

/// The sums of all products of known terms.
struct AllProducts<'a, S, const FACTORS: usize>(&'a [[S; FACTORS]]);

impl<S: Scalar, const FACTORS: usize> PairSums<S> for AllProducts<'_, S, FACTORS> {
    #[inline(always)]
    fn of(&mut self, _: usize, x: usize, y: usize) -> S {
        let products = self.0.iter().zip(self.0.iter().rev());
        products.fold(S::zero(), |sum, (of_x, of_y)| of_x[x].mul_add(of_y[y], sum))
    }

    #[inline(always)]
    fn none(&self) -> S {
        S::zero()
    }
}

/// The indices of the factors of each pair.
struct Indices;

impl PairSums<Option<[usize; 2]>> for Indices {
    fn of(&mut self, _: usize, x: usize, y: usize) -> Option<[usize; 2]> {
        Some([x, y])
    }

    fn none(&self) -> Option<[usize; 2]> {
        None
    }
}

/// Returns the [`convolution`] of the first `COUNT` terms.
#[inline(always)]
fn of_few<S: Scalar, const COUNT: usize>(x: &[S], y: &[S]) -> S {
    let (Some(x), Some(y)) = (x.first_chunk(), y.first_chunk()) else {
        return convolution(x, y);
    };
    let _: [&[S; COUNT]; 2] = [x, y];
    (0..COUNT).fold(S::zero(), |sum, i| x[i].mul_add(y[COUNT - 1 - i], sum))
}

/// Returns the sums of the products whose orders add up to n + 1, …, n + 4, over the n known terms, where n is a
/// multiple of 4.
#[inline(always)]
fn products<S: Scalar>(x: &[S], y: &[S]) -> [S; ORDERS] {
    let mut sums = [S::zero(); ORDERS];
    let (Some((x_first, x)), Some(y_last)) = (x.split_first_chunk(), y.last_chunk()) else {
        return sums;
    };
    let _: [&[S; ORDERS]; 2] = [x_first, y_last];
    for i in 0..ORDERS {
        for (sum, y) in sums.iter_mut().zip(&y_last[ORDERS - 1 - i..]) {
            *sum = x_first[i].mul_add(*y, *sum);
        }
    }
    // There are two sums for each order, so that neither has to wait for the other.
    let mut others = [S::zero(); ORDERS];
    let mut before = y;
    for x in x.as_chunks::<ORDERS>().0 {
        let Some(y) = before.last_chunk::<{ 2 * ORDERS }>() else {
            break;
        };
        for (i, x) in x.iter().enumerate() {
            let sums = if i % 2 == 0 { &mut sums } else { &mut others };
            for (sum, y) in sums.iter_mut().zip(&y[ORDERS - 1 - i..]) {
                *sum = x.mul_add(*y, *sum);
            }
        }
        before = &before[..before.len() - ORDERS];
    }
    for (sum, other) in sums.iter_mut().zip(others) {
        *sum += other;
    }
    sums
}

/// Adds the products that contain one of the last terms to a sum.
#[inline(always)]
fn with_last<S: Scalar, const LAST: usize>(x: &[S], y: &[S], sum: S) -> S {
    let ends = (
        x.first_chunk(),
        x.last_chunk(),
        y.first_chunk(),
        y.last_chunk(),
    );
    let (Some(x_first), Some(x_last), Some(y_first), Some(y_last)) = ends else {
        return sum;
    };
    let _: [&[S; LAST]; 4] = [x_first, x_last, y_first, y_last];
    (0..LAST).fold(sum, |sum, i| {
        let sum = x_first[i].mul_add(y_last[LAST - 1 - i], sum);
        x_last[i].mul_add(y_first[LAST - 1 - i], sum)
    })
}
