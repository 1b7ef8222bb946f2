//! The sums of products in recurrences for Taylor coefficients.

use crate::scalar::Scalar;

/// How many terms a loop of constant length takes: a vector register of 256 bits holds as many `f64`.
const CHUNK: usize = 4;

/// Convolutions order after order, as each order is known only after the one before (relaxed multiplication: J. van der
/// Hoeven, *Relax, but Don't be Too Lazy*, Journal of Symbolic Computation **34** (2002) 479–542).
pub(crate) trait OnlineConvolutions<S, const FACTORS: usize, const PAIRS: usize> {
    /// The sums of the present order.
    fn sums(&self) -> [S; PAIRS];

    /// Goes on to the next order, given the terms of the present one, and the indices of the factors that are paired.
    fn advance(&mut self, factors: &[S; FACTORS], pairs: &[[usize; 2]; PAIRS]);
}

/// The convolutions Σ₀﹤ᵢ﹤ₖ xᵢ yₖ₋ᵢ of several pairs of factors, order after order.
///
/// The coefficient k of a product is that sum and x₀ yₖ + xₖ y₀. As soon as the factors of order k are known, they are
/// multiplied by those of lower orders, and the products added to the sums of higher orders: loops of constant length
/// without a reduction, for which the compiler uses vector registers. A product of two terms of order above `HALF`
/// is of no order below 2·`HALF`, so that half of the terms and half of the sums are enough.
#[derive(Clone, Debug)]
pub struct Convolutions<S, const FACTORS: usize, const PAIRS: usize, const HALF: usize> {
    /// The sums of the next order, of the one after it, and so on.
    sums: [[S; HALF]; PAIRS],
    /// The terms of order 1, 2, … of each factor.
    terms: [[S; HALF]; FACTORS],
    order: usize,
}

impl<S: Scalar, const FACTORS: usize, const PAIRS: usize, const HALF: usize>
    Convolutions<S, FACTORS, PAIRS, HALF>
{
    /// The convolutions of order 1, which are empty sums.
    #[inline]
    #[must_use]
    pub fn new() -> Self {
        Self {
            sums: [[S::zero(); HALF]; PAIRS],
            terms: [[S::zero(); HALF]; FACTORS],
            order: 1,
        }
    }

    /// The sums of the present order.
    #[inline]
    #[must_use]
    pub fn sums(&self) -> [S; PAIRS] {
        core::array::from_fn(|pair| self.sums[pair][0])
    }

    /// Goes on to the next order, given the terms of the present one, and the indices of the factors that are paired.
    #[inline]
    pub fn advance(&mut self, factors: &[S; FACTORS], pairs: &[[usize; 2]; PAIRS]) {
        let place = self.order - 1;
        // Beyond are sums of no order that is asked for, and terms that are 0.
        let reach = self.order.min((2 * HALF).saturating_sub(self.order + 1));
        let chunks = reach.div_ceil(CHUNK);
        for (sums, [first, second]) in self.sums.iter_mut().zip(pairs) {
            let (x, y) = (factors[*first], factors[*second]);
            let (of_x, of_y) = (&self.terms[*first], &self.terms[*second]);
            for chunk in 0..chunks {
                let start = chunk * CHUNK;
                if start + CHUNK < HALF {
                    for i in start..start + CHUNK {
                        sums[i] = x.mul_add(of_y[i], y.mul_add(of_x[i], sums[i + 1]));
                    }
                } else {
                    for i in start..HALF - 1 {
                        sums[i] = x.mul_add(of_y[i], y.mul_add(of_x[i], sums[i + 1]));
                    }
                    sums[HALF - 1] = x.mul_add(of_y[HALF - 1], y * of_x[HALF - 1]);
                }
            }
            if let Some(sum) = sums.get_mut(place) {
                *sum = x.mul_add(y, *sum);
            }
        }
        for (terms, factor) in self.terms.iter_mut().zip(factors) {
            if let Some(term) = terms.get_mut(place) {
                *term = *factor;
            }
        }
        self.order += 1;
    }
}

impl<S: Scalar, const FACTORS: usize, const PAIRS: usize, const HALF: usize> Default
    for Convolutions<S, FACTORS, PAIRS, HALF>
{
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Scalar, const FACTORS: usize, const PAIRS: usize, const HALF: usize>
    OnlineConvolutions<S, FACTORS, PAIRS> for Convolutions<S, FACTORS, PAIRS, HALF>
{
    #[inline]
    fn sums(&self) -> [S; PAIRS] {
        self.sums()
    }

    #[inline]
    fn advance(&mut self, factors: &[S; FACTORS], pairs: &[[usize; 2]; PAIRS]) {
        self.advance(factors, pairs);
    }
}
