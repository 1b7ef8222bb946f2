//! The Taylor polynomial of a motion.

use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

/// The Taylor polynomial of order 2·`HALF` of a motion about a time t₀: x(t₀ + τ·unit) = Σ xₖ τᵏ.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct TaylorCoefficients<X, const HALF: usize> {
    initial: X,
    /// The coefficients of order 1 and more.
    #[cfg_attr(feature = "serde", serde(with = "crate::array_as_tuple"))]
    #[cfg_attr(
        feature = "serde",
        serde(bound(
            serialize = "X: serde::Serialize",
            deserialize = "X: Clone + serde::Deserialize<'de>"
        ))
    )]
    pairs: [[X; 2]; HALF],
}

impl<X: Clone, const HALF: usize> TaylorCoefficients<X, HALF> {
    /// The order of the polynomial.
    pub const ORDER: usize = 2 * HALF;

    /// The polynomial whose coefficients are all `initial`, until they are set.
    #[inline]
    #[must_use]
    pub fn new(initial: X) -> Self {
        let pairs = core::array::from_fn(|_| [initial.clone(), initial.clone()]);
        Self { initial, pairs }
    }

    /// The coefficient of order 0.
    #[inline]
    #[must_use]
    pub fn initial(&self) -> &X {
        &self.initial
    }

    /// The coefficient of order 0, to be set.
    #[inline]
    pub fn initial_mut(&mut self) -> &mut X {
        &mut self.initial
    }

    /// The coefficients of order 1 and more, in order.
    #[inline]
    #[must_use]
    pub fn higher(&self) -> &[X] {
        self.pairs.as_flattened()
    }

    /// The coefficients of order 1 and more, to be set.
    #[inline]
    pub fn higher_mut(&mut self) -> &mut [X] {
        self.pairs.as_flattened_mut()
    }

    /// The greater of the last two terms at τ, over the sum of the magnitudes of all, in the worst component.
    pub(crate) fn last_terms<S: Scalar>(&self, tau: f64) -> f64
    where
        X: VectorSpace<S>,
    {
        let tau = S::from_f64(tau.abs());
        let sizes = |x: &X| x.map(Scalar::abs);
        let (mut sum, mut power) = (self.initial.zeroed(), S::one());
        let mut last = [sum.clone(), sum.clone()];
        for coefficient in self.higher() {
            power *= tau;
            let size = sizes(coefficient).map(|x| x * power);
            sum.add_scaled(S::one(), &size);
            let [_, before] = last;
            last = [before, size];
        }
        let ratios = last.iter().flat_map(|last| {
            let pairs = last.components().zip(sum.components());
            pairs.map(|(last, sum)| (last / sum).largest())
        });
        ratios.fold(0.0, f64::max)
    }

    /// The coefficients about τ.
    pub(crate) fn shifted<S: Scalar>(&self, tau: S) -> Self
    where
        X: VectorSpace<S>,
    {
        let mut shifted = self.clone();
        let order = Self::ORDER;
        for i in 0..order {
            for j in (i..order).rev() {
                if let Some([lower, upper]) = shifted.higher_mut().get_mut(j.saturating_sub(1)..=j)
                    && j > 0
                {
                    lower.add_scaled(tau, upper);
                } else if let Some(first) = shifted.higher().first().cloned() {
                    shifted.initial.add_scaled(tau, &first);
                }
            }
        }
        shifted
    }

    /// x(τ) − x(0), by Horner's rule.
    #[inline]
    #[must_use]
    pub fn change<S: Scalar>(&self, tau: S) -> X
    where
        X: VectorSpace<S>,
    {
        let mut sum = self.initial.zeroed();
        for coefficient in self.higher().iter().rev() {
            let mut next = coefficient.clone();
            next.add_scaled(tau, &sum);
            sum = next;
        }
        sum.map(|component| component * tau)
    }

    /// dx/dτ.
    #[inline]
    #[must_use]
    pub fn derivative<S: Scalar>(&self, tau: S) -> X
    where
        X: VectorSpace<S>,
    {
        self.change_and_derivative(tau).1
    }

    /// x(τ) − x(0) and dx/dτ, by Horner's rule for a polynomial and its derivative.
    #[inline]
    #[must_use]
    pub fn change_and_derivative<S: Scalar>(&self, tau: S) -> (X, X)
    where
        X: VectorSpace<S>,
    {
        let mut quotient = self.initial.zeroed();
        let mut derivative = quotient.clone();
        for coefficient in self.higher().iter().rev() {
            let mut next = quotient.clone();
            next.add_scaled(tau, &derivative);
            derivative = next;
            let mut next = coefficient.clone();
            next.add_scaled(tau, &quotient);
            quotient = next;
        }
        let mut slope = quotient.clone();
        slope.add_scaled(tau, &derivative);
        (quotient.map(|component| component * tau), slope)
    }
}

/// An order as a number.
#[allow(clippy::cast_precision_loss)] // Orders are small.
pub(super) const fn number(order: usize) -> f64 {
    order as f64
}
