//! The sums of products in recurrences for Taylor coefficients, of a few pairs at a time.

use super::convolutions::OnlineConvolutions;
use crate::scalar::Scalar;

/// Up to as many lanes, four vector registers of sums, two sums of each lane hide the latency of an addition. More lanes
/// hide it by themselves, and two sums would not stay in the sixteen registers.
const FEW_LANES: usize = 16;

/// The convolutions Σ₀﹤ᵢ﹤ₖ xᵢ yₖ₋ᵢ of pairs of factors, order after order, as [`Convolutions`](super::Convolutions) are,
/// but with the terms of both factors of each pair side by side, so that `LANES` pairs are summed at once in vector
/// registers. A factor is stored for each pair that it belongs to.
///
/// Only two products of a sum have a term of the order before: all others can be added while that term is computed.
#[derive(Clone, Debug)]
#[repr(align(64))] // Rows begin at multiples of a vector register.
pub(crate) struct PairedConvolutions<S, const PAIRS: usize, const LANES: usize, const HALF: usize> {
    /// The terms of the first factors: blocks of `LANES` pairs, and in each a row for each order.
    first: [[[S; PAIRS]; 2]; HALF],
    /// Those of the second ones.
    second: [[[S; PAIRS]; 2]; HALF],
    /// The sums of the present order.
    sums: [S; PAIRS],
    order: usize,
}

impl<S: Scalar, const PAIRS: usize, const LANES: usize, const HALF: usize>
    PairedConvolutions<S, PAIRS, LANES, HALF>
{
    /// The convolutions of order 1, which are empty sums. `PAIRS` is a multiple of `LANES`.
    #[inline]
    pub(crate) fn new() -> Self {
        const { assert!(PAIRS.is_multiple_of(LANES)) }
        Self {
            first: [[[S::zero(); PAIRS]; 2]; HALF],
            second: [[[S::zero(); PAIRS]; 2]; HALF],
            sums: [S::zero(); PAIRS],
            order: 1,
        }
    }
}

impl<S: Scalar, const FACTORS: usize, const PAIRS: usize, const LANES: usize, const HALF: usize>
    OnlineConvolutions<S, FACTORS, PAIRS> for PairedConvolutions<S, PAIRS, LANES, HALF>
{
    #[inline]
    fn sums(&self) -> [S; PAIRS] {
        self.sums
    }

    #[inline]
    fn advance(&mut self, factors: &[S; FACTORS], pairs: &[[usize; 2]; PAIRS]) {
        let first = self.first.as_flattened_mut().as_flattened_mut();
        let second = self.second.as_flattened_mut().as_flattened_mut();
        let blocks = first
            .chunks_exact_mut(2 * HALF * LANES)
            .zip(second.chunks_exact_mut(2 * HALF * LANES));
        let sums = self.sums.as_chunks_mut::<LANES>().0.iter_mut();
        let pairs = pairs.as_chunks::<LANES>().0.iter();
        for (((first, second), sums), pairs) in blocks.zip(sums).zip(pairs) {
            let x = first.as_chunks_mut::<LANES>().0;
            let y = second.as_chunks_mut::<LANES>().0;
            let lower = products(x, y, self.order);
            let x_k: [S; LANES] = core::array::from_fn(|lane| factors[pairs[lane][0]]);
            let y_k: [S; LANES] = core::array::from_fn(|lane| factors[pairs[lane][1]]);
            if self.order == 1 {
                for lane in 0..LANES {
                    sums[lane] = x_k[lane] * y_k[lane];
                }
            } else {
                for lane in 0..LANES {
                    sums[lane] =
                        x_k[lane].mul_add(y[0][lane], x[0][lane].mul_add(y_k[lane], lower[lane]));
                }
            }
            x[self.order - 1] = x_k;
            y[self.order - 1] = y_k;
        }
        self.order += 1;
    }
}

/// Σ₁﹤ᵢ﹤ₖ xᵢ yₖ₊₁₋ᵢ: two sums, so that one need not wait for the other.
#[inline]
fn products<S: Scalar, const LANES: usize>(
    x: &[[S; LANES]],
    y: &[[S; LANES]],
    order: usize,
) -> [S; LANES] {
    if const { LANES > FEW_LANES } {
        let mut sums = [S::zero(); LANES];
        if order > 2 {
            for (x, y) in x[1..order - 1].iter().zip(y[1..order - 1].iter().rev()) {
                for lane in 0..LANES {
                    sums[lane] = x[lane].mul_add(y[lane], sums[lane]);
                }
            }
        }
        return sums;
    }
    let mut even = [S::zero(); LANES];
    let mut odd = [S::zero(); LANES];
    if order > 2 {
        let (x, rest) = x[1..order - 1].as_chunks::<2>();
        let (last, y) = y[1..order - 1].as_rchunks::<2>();
        for ([x0, x1], [y1, y0]) in x.iter().zip(y.iter().rev()) {
            for lane in 0..LANES {
                even[lane] = x0[lane].mul_add(y0[lane], even[lane]);
            }
            for lane in 0..LANES {
                odd[lane] = x1[lane].mul_add(y1[lane], odd[lane]);
            }
        }
        for (x, y) in rest.iter().zip(last) {
            for lane in 0..LANES {
                even[lane] = x[lane].mul_add(y[lane], even[lane]);
            }
        }
    }
    core::array::from_fn(|lane| even[lane] + odd[lane])
}

#[cfg(test)]
mod tests {
    use super::PairedConvolutions;
    use crate::integrate::taylor::{Convolutions, OnlineConvolutions};

    /// Small whole numbers, so that sums are exact in any order.
    fn factor(index: usize, order: usize) -> f64 {
        f64::from(u8::try_from((7 * index + 5 * order + index * order) % 11).unwrap()) - 5.0
    }

    /// Fails unless the sums of all orders are those of the definition.
    fn check<const PAIRS: usize, const HALF: usize>(
        mut convolutions: impl OnlineConvolutions<f64, 5, PAIRS>,
    ) {
        let pairs: [[usize; 2]; PAIRS] = core::array::from_fn(|i| [i % 5, (2 * i + i / 5) % 5]);
        for order in 1..2 * HALF {
            let expected = pairs.map(|[x, y]| {
                let products = (1..order).map(|i| factor(x, i) * factor(y, order - i));
                products.sum::<f64>()
            });
            let sums = convolutions.sums();
            let mut pairs_of_sums = sums.iter().zip(expected);
            assert!(
                pairs_of_sums.all(|(sum, expected)| (sum - expected).abs() == 0.0),
                "order {order} of {HALF}: {sums:?}"
            );
            let factors = core::array::from_fn(|index| factor(index, order));
            convolutions.advance(&factors, &pairs);
        }
    }

    fn both<const PAIRS: usize, const LANES: usize, const HALF: usize>() {
        check::<PAIRS, HALF>(PairedConvolutions::<f64, PAIRS, LANES, HALF>::new());
        check::<PAIRS, HALF>(Convolutions::<f64, 5, PAIRS, HALF>::new());
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

    /// The sums of three pairs, of which the last is repeated, up to order 11.
    fn with_repeated(mut convolutions: impl OnlineConvolutions<f64, 5, 4>) -> [[f64; 3]; 11] {
        core::array::from_fn(|i| {
            let [first, second, third, _] = convolutions.sums();
            let factors = core::array::from_fn(|index| factor(index, i + 1));
            convolutions.advance(&factors, &[[0, 1], [1, 1], [2, 3], [2, 3]]);
            [first, second, third]
        })
    }

    #[test]
    fn repeated_pairs_change_nothing() {
        assert_eq!(
            with_repeated(PairedConvolutions::<f64, 4, 4, 6>::new()),
            with_repeated(Convolutions::<f64, 5, 4, 6>::new())
        );
    }
}
