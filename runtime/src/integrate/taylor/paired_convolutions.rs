//! The sums of products in recurrences for Taylor coefficients, several pairs at a time.

// If they are not inlined, these functions return the sums through memory, and the double pendulum takes 1.4 times as
// long.
#![allow(clippy::inline_always)]

use super::convolutions::{FactorPairs, ORDERS, OnlineConvolutions};
use crate::scalar::Scalar;

/// The convolutions Σ₀﹤ᵢ﹤ₖ xᵢ yₖ₋ᵢ of pairs of factors, order by order.
///
/// In contrast to [`Convolutions`](super::Convolutions), the terms of both factors of each pair are stored side by
/// side, so that `LANES` pairs are summed at once in vector registers. A factor is stored for each pair that it belongs
/// to.
///
/// At every fourth order, the sums of four orders are begun together: each loaded term is used in four products. Only
/// two products of a sum contain a term of the previous order; all others can be added while that term is being
/// computed.
///
/// The factors of each pair are selected by `arrange`, which is code rather than a table. Indices that are read in a
/// loop over the blocks would become gather instructions, with which an arm of three joints takes 1.18 times as long.
#[derive(Clone, Debug)]
#[repr(align(64))] // Rows begin at multiples of a vector register.
pub(crate) struct PairedConvolutions<
    S,
    const PAIRS: usize,
    const LANES: usize,
    const HALF: usize,
    A = (),
> {
    /// The terms of the first factors: blocks of `LANES` pairs, each with a row for each order.
    first: [[[S; PAIRS]; 2]; HALF],
    /// The terms of the second factors.
    second: [[[S; PAIRS]; 2]; HALF],
    /// The known parts of the sums of orders n + 1 to n + 4, where n is the multiple of 4 below the next order: blocks
    /// of `LANES` pairs, each with a row for each order.
    begun: [[S; PAIRS]; ORDERS],
    /// The sums of the next order without the products that contain a term of the present order.
    partial: [S; PAIRS],
    order: usize,
    /// Returns the first and the second factors of all pairs.
    arrange: A,
}

impl<S: Scalar, const PAIRS: usize, const LANES: usize, const HALF: usize, A>
    PairedConvolutions<S, PAIRS, LANES, HALF, A>
{
    /// Creates the convolutions before any term is known. `PAIRS` is a multiple of `LANES`.
    #[inline(always)]
    pub(crate) fn new(arrange: A) -> Self {
        const { assert!(PAIRS.is_multiple_of(LANES)) }
        // A number that the compiler does not know is written by vector stores. Zeros are written by a call of `memset`, which takes
        // longer to begin.
        let zero = core::hint::black_box(S::zero());
        Self {
            first: [[[zero; PAIRS]; 2]; HALF],
            second: [[[zero; PAIRS]; 2]; HALF],
            begun: [[zero; PAIRS]; ORDERS],
            partial: [zero; PAIRS],
            order: 1,
            arrange,
        }
    }

    /// Returns the sums of the next order, given the terms of the present one. `partial` computes the sums of the order
    /// after that from the known terms, given the sums that were begun.
    #[inline(always)]
    fn advance_by<const BEGIN: bool>(
        &mut self,
        [all_x, all_y]: &[[S; PAIRS]; 2],
        partial: impl Fn(&mut [[S; LANES]], &[[S; LANES]], &[[S; LANES]]) -> [S; LANES],
    ) -> [S; PAIRS] {
        let order = self.order;
        let first = self.first.as_flattened_mut().as_flattened_mut();
        let second = self.second.as_flattened_mut().as_flattened_mut();
        let begun = self.begun.as_flattened_mut();
        let blocks = first
            .chunks_exact_mut(2 * HALF * LANES)
            .zip(second.chunks_exact_mut(2 * HALF * LANES))
            .zip(begun.chunks_exact_mut(ORDERS * LANES));
        let mut sums = self.partial;
        let partials = self.partial.as_chunks_mut::<LANES>().0.iter_mut();
        let results = sums.as_chunks_mut::<LANES>().0.iter_mut();
        let [all_x, all_y] = [all_x, all_y].map(|terms| terms.as_chunks::<LANES>().0.iter());
        let terms = all_x.zip(all_y);
        for (((((first, second), begun), partials), sums), (&new_x, &new_y)) in
            blocks.zip(partials).zip(results).zip(terms)
        {
            let x = first.as_chunks_mut::<LANES>().0;
            let y = second.as_chunks_mut::<LANES>().0;
            let begun = begun.as_chunks_mut::<LANES>().0;
            *sums = match (x.first(), y.first()) {
                (Some(first_x), Some(first_y)) if order > 1 => {
                    plus(&plus(sums, first_x, &new_y), &new_x, first_y)
                }
                _ => plus(sums, &new_x, &new_y),
            };
            if order + 1 >= x.len() {
                continue;
            }
            if BEGIN {
                products(begun, &x[..=order], &y[..=order]);
            }
            let mut next = partial(begun, &x[..order - 1], &y[..order - 1]);
            if order > 2 {
                // The new terms are not read back from memory, which would have to wait until they are stored.
                next = plus(&plus(&next, &x[1], &new_y), &new_x, &y[1]);
            } else if order == 2 {
                next = plus(&next, &new_x, &new_y);
            }
            *partials = next;
            x[order - 1] = new_x;
            y[order - 1] = new_y;
        }
        self.order += 1;
        sums
    }
}

impl<S, A, const FACTORS: usize, const PAIRS: usize, const LANES: usize, const HALF: usize>
    OnlineConvolutions<S, FACTORS, PAIRS> for PairedConvolutions<S, PAIRS, LANES, HALF, A>
where
    S: Scalar,
    A: Fn(&[S; FACTORS]) -> [[S; PAIRS]; 2],
{
    #[inline(always)]
    fn advance<P: FactorPairs<PAIRS>>(&mut self, factors: &[S; FACTORS]) -> [S; PAIRS] {
        let terms = &(self.arrange)(factors);
        match self.order % ORDERS {
            _ if self.order < ORDERS => {
                self.advance_by::<false>(terms, |_, _, _| [S::zero(); LANES])
            }
            0 if self.order == ORDERS => {
                self.advance_by::<false>(terms, |_, x, y| middle::<S, LANES, 1>(x, y))
            }
            1 if self.order < 2 * ORDERS => {
                self.advance_by::<false>(terms, |_, x, y| middle::<S, LANES, 2>(x, y))
            }
            2 if self.order < 2 * ORDERS => {
                self.advance_by::<false>(terms, |_, x, y| middle::<S, LANES, 3>(x, y))
            }
            3 => {
                self.advance_by::<true>(terms, |begun, x, y| with_last::<S, LANES, 0>(begun, x, y))
            }
            0 => {
                self.advance_by::<false>(terms, |begun, x, y| with_last::<S, LANES, 1>(begun, x, y))
            }
            1 => {
                self.advance_by::<false>(terms, |begun, x, y| with_last::<S, LANES, 2>(begun, x, y))
            }
            _ => {
                self.advance_by::<false>(terms, |begun, x, y| with_last::<S, LANES, 3>(begun, x, y))
            }
        }
    }
}

/// Returns sum + x y in each lane.
#[inline(always)]
fn plus<S: Scalar, const LANES: usize>(
    sum: &[S; LANES],
    x: &[S; LANES],
    y: &[S; LANES],
) -> [S; LANES] {
    core::array::from_fn(|lane| x[lane].mul_add(y[lane], sum[lane]))
}

/// The number of lanes that are summed at once; `HALF_MORE` is one and a half times as many. The sums of four orders
/// then stay in registers, and there are enough of them to hide the latency of an addition.
const LANES_AT_ONCE: usize = 8;
const HALF_MORE: usize = 12;

/// Computes the sums of the products whose orders add up to n + 1, …, n + 4, over the n known terms, where n is a
/// multiple of 4.
#[inline(always)]
fn products<S: Scalar, const LANES: usize>(
    begun: &mut [[S; LANES]],
    x: &[[S; LANES]],
    y: &[[S; LANES]],
) {
    let mut first = 0;
    if !LANES.is_multiple_of(LANES_AT_ONCE) && LANES >= HALF_MORE {
        products_of::<S, LANES, HALF_MORE>(first, begun, x, y);
        first += HALF_MORE;
    }
    while first + LANES_AT_ONCE <= LANES {
        products_of::<S, LANES, LANES_AT_ONCE>(first, begun, x, y);
        first += LANES_AT_ONCE;
    }
    while first + ORDERS <= LANES {
        products_of::<S, LANES, ORDERS>(first, begun, x, y);
        first += ORDERS;
    }
    while first < LANES {
        products_of::<S, LANES, 1>(first, begun, x, y);
        first += 1;
    }
}

/// [`products`] in `PART` of the lanes, from `first` on.
#[inline(always)]
fn products_of<S: Scalar, const LANES: usize, const PART: usize>(
    first: usize,
    begun: &mut [[S; LANES]],
    x: &[[S; LANES]],
    y: &[[S; LANES]],
) {
    let part = |row: &[S; LANES]| -> [S; PART] { core::array::from_fn(|lane| row[first + lane]) };
    let zero = [S::zero(); PART];
    let [mut s0, mut s1, mut s2, mut s3] = [zero; ORDERS];
    // The last terms of y that were read.
    let [mut w1, mut w2, mut w3] = [zero; 3];
    let fours = x
        .as_chunks::<4>()
        .0
        .iter()
        .zip(y.as_chunks::<4>().0.iter().rev());
    for (x, y) in fours {
        let [y3, y2, y1, y0] = [part(&y[0]), part(&y[1]), part(&y[2]), part(&y[3])];
        let x0 = part(&x[0]);
        s0 = plus(&s0, &x0, &y0);
        s1 = plus(&s1, &x0, &w1);
        s2 = plus(&s2, &x0, &w2);
        s3 = plus(&s3, &x0, &w3);
        let x1 = part(&x[1]);
        s0 = plus(&s0, &x1, &y1);
        s1 = plus(&s1, &x1, &y0);
        s2 = plus(&s2, &x1, &w1);
        s3 = plus(&s3, &x1, &w2);
        let x2 = part(&x[2]);
        s0 = plus(&s0, &x2, &y2);
        s1 = plus(&s1, &x2, &y1);
        s2 = plus(&s2, &x2, &y0);
        s3 = plus(&s3, &x2, &w1);
        let x3 = part(&x[3]);
        s0 = plus(&s0, &x3, &y3);
        s1 = plus(&s1, &x3, &y2);
        s2 = plus(&s2, &x3, &y1);
        s3 = plus(&s3, &x3, &y0);
        [w1, w2, w3] = [y3, y2, y1];
    }
    for (row, sum) in begun.iter_mut().zip([s0, s1, s2, s3]) {
        row[first..first + PART].copy_from_slice(&sum);
    }
}

/// Returns the sum of the `COUNT` products of the terms of order 3 and higher.
#[inline(always)]
fn middle<S: Scalar, const LANES: usize, const COUNT: usize>(
    x: &[[S; LANES]],
    y: &[[S; LANES]],
) -> [S; LANES] {
    let (Some(x), Some(y)) = (x.last_chunk(), y.last_chunk()) else {
        return [S::zero(); LANES];
    };
    let [x, y]: [&[[S; LANES]; COUNT]; 2] = [x, y];
    (0..COUNT).fold([S::zero(); LANES], |sum, i| {
        plus(&sum, &x[i], &y[COUNT - 1 - i])
    })
}

/// Returns a sum that was begun plus its products with one of the last terms, without the products of the first two
/// terms.
#[inline(always)]
fn with_last<S: Scalar, const LANES: usize, const LAST: usize>(
    begun: &[[S; LANES]],
    x: &[[S; LANES]],
    y: &[[S; LANES]],
) -> [S; LANES] {
    let ends = (
        x.get(2..).and_then(|x| x.first_chunk()),
        x.last_chunk(),
        y.get(2..).and_then(|y| y.first_chunk()),
        y.last_chunk(),
    );
    let (Some(x_first), Some(x_last), Some(y_first), Some(y_last)) = ends else {
        return [S::zero(); LANES];
    };
    let _: [&[[S; LANES]; LAST]; 4] = [x_first, x_last, y_first, y_last];
    // The newest terms are added last.
    let mut sum = begun[LAST];
    for i in 0..LAST {
        sum = plus(&sum, &x_first[LAST - 1 - i], &y_last[i]);
        sum = plus(&sum, &x_last[i], &y_first[LAST - 1 - i]);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::PairedConvolutions;
    use crate::integrate::taylor::{
        Convolutions, FactorPairs, OnlineConvolutions, PairSums, UnrolledConvolutions,
    };

    /// Small integers, so that sums are exact in any order.
    fn factor(index: usize, order: usize) -> f64 {
        f64::from(u8::try_from((7 * index + 5 * order + index * order) % 11).unwrap()) - 5.0
    }

    fn pairs_of<const PAIRS: usize>() -> [[usize; 2]; PAIRS] {
        core::array::from_fn(|i| [i % 5, (2 * i + i / 5) % 5])
    }

    struct Pairs;

    impl<const PAIRS: usize> FactorPairs<PAIRS> for Pairs {
        fn each<S>(sums: &mut impl PairSums<S>) -> [S; PAIRS] {
            let pairs = pairs_of::<PAIRS>();
            core::array::from_fn(|place| sums.of(place, pairs[place][0], pairs[place][1]))
        }
    }

    /// Asserts that the sums of all orders agree with the definition.
    fn check<const PAIRS: usize, const HALF: usize>(
        mut convolutions: impl OnlineConvolutions<f64, 5, PAIRS>,
    ) {
        let pairs = pairs_of::<PAIRS>();
        let mut sums = [0.0; PAIRS];
        for order in 1..2 * HALF {
            let expected = pairs.map(|[x, y]| {
                let products = (1..order).map(|i| factor(x, i) * factor(y, order - i));
                products.sum::<f64>()
            });
            let mut pairs_of_sums = sums.iter().zip(expected);
            assert!(
                pairs_of_sums.all(|(sum, expected)| (sum - expected).abs() == 0.0),
                "order {order} of {HALF}: {sums:?}"
            );
            let factors = core::array::from_fn(|index| factor(index, order));
            sums = convolutions.advance::<Pairs>(&factors);
        }
    }

    /// Selects the factors of the pairs by their indices.
    fn arranged<const PAIRS: usize>(
        pairs: [[usize; 2]; PAIRS],
    ) -> impl Fn(&[f64; 5]) -> [[f64; PAIRS]; 2] {
        move |factors| core::array::from_fn(|side| pairs.map(|pair| factors[pair[side]]))
    }

    fn both<const PAIRS: usize, const LANES: usize, const HALF: usize>() {
        let arrange = arranged(pairs_of());
        check::<PAIRS, HALF>(PairedConvolutions::<f64, PAIRS, LANES, HALF, _>::new(
            arrange,
        ));
        check::<PAIRS, HALF>(UnrolledConvolutions::<f64, 5, PAIRS, HALF>::new());
        check::<PAIRS, HALF>(Convolutions::<f64, 5, PAIRS, HALF>::of(&Pairs));
    }

    #[test]
    fn sums_are_those_of_the_definition() {
        both::<1, 1, 1>();
        both::<4, 4, 2>();
        both::<12, 12, 3>();
        both::<16, 16, 5>();
        both::<20, 20, 7>();
        both::<24, 12, 14>();
        both::<64, 32, 20>();
    }

    const REPEATED: [[usize; 2]; 4] = [[0, 1], [1, 1], [2, 3], [2, 3]];

    struct ThreePairs;

    impl FactorPairs<4> for ThreePairs {
        fn each<S>(sums: &mut impl PairSums<S>) -> [S; 4] {
            [
                sums.of(0, 0, 1),
                sums.of(1, 1, 1),
                sums.of(2, 2, 3),
                sums.none(),
            ]
        }
    }

    /// Returns the sums of three pairs, in the last of four places the last one again or none, up to order 12.
    fn with_repeated(mut convolutions: impl OnlineConvolutions<f64, 5, 4>) -> [[f64; 3]; 11] {
        core::array::from_fn(|i| {
            let factors = core::array::from_fn(|index| factor(index, i + 1));
            let [first, second, third, _] = convolutions.advance::<ThreePairs>(&factors);
            [first, second, third]
        })
    }

    #[test]
    fn places_without_a_pair_change_nothing() {
        assert_eq!(
            with_repeated(PairedConvolutions::<f64, 4, 4, 6, _>::new(arranged(
                REPEATED
            ))),
            with_repeated(Convolutions::<f64, 5, 4, 6>::of(&ThreePairs))
        );
    }
}
