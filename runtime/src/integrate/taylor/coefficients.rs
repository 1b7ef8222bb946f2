//! The Taylor polynomial of a motion.

use crate::linalg::{LaneStates, VectorSpace, horner};
use crate::scalar::{Lanes, Scalar};

/// The Taylor polynomial of order 2·`HALF` of a motion about a time t₀: x(t₀ + τ·unit) = Σ xₖ τᵏ.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(target_feature = "avx", repr(align(64)))] // Lanes are loaded from whole cache lines.
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct TaylorCoefficients<X, const HALF: usize> {
    initial: X,
    /// The coefficients of order 1 and higher.
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

    /// Creates the polynomial whose coefficients are all `initial`, until they are set.
    #[inline]
    #[must_use]
    pub fn new(initial: X) -> Self {
        let pairs = core::array::from_fn(|_| [initial.clone(), initial.clone()]);
        Self { initial, pairs }
    }

    /// Returns the coefficient of order 0.
    #[inline]
    #[must_use]
    pub fn initial(&self) -> &X {
        &self.initial
    }

    /// Returns the coefficient of order 0 for modification.
    #[inline]
    pub fn initial_mut(&mut self) -> &mut X {
        &mut self.initial
    }

    /// Returns the coefficients of order 1 and higher, in order.
    #[inline]
    #[must_use]
    pub fn higher(&self) -> &[X] {
        self.pairs.as_flattened()
    }

    /// Returns the coefficients of order 1 and higher for modification.
    #[inline]
    pub fn higher_mut(&mut self) -> &mut [X] {
        self.pairs.as_flattened_mut()
    }

    /// Applies a function to each coefficient.
    #[inline]
    pub(crate) fn map<Y>(&self, function: impl Fn(&X) -> Y) -> TaylorCoefficients<Y, HALF> {
        TaylorCoefficients {
            initial: function(&self.initial),
            pairs: core::array::from_fn(|i| core::array::from_fn(|j| function(&self.pairs[i][j]))),
        }
    }

    /// Returns the larger of the last two terms at τ, over the sum of the magnitudes of all terms, in the worst
    /// component.
    pub(crate) fn last_terms<S: Scalar>(&self, tau: f64) -> f64
    where
        X: VectorSpace<S>,
    {
        self.last_terms_in(S::from_f64(tau), S::largest)
    }

    /// [`last_terms`](Self::last_terms) of the number that `read` extracts from a scalar, such as the value in a lane.
    pub(super) fn last_terms_in<S: Scalar>(&self, tau: S, read: impl Fn(S) -> f64) -> f64
    where
        X: VectorSpace<S>,
    {
        let (sum, last) = self.term_sizes(tau);
        let ratios = last.iter().flat_map(|last| {
            let pairs = last.components().zip(sum.components());
            pairs.map(|(last, sum)| read(last / sum))
        });
        ratios.fold(0.0, f64::max)
    }

    /// Returns the sum of the magnitudes of all terms but the constant at τ, in the component in which it is largest.
    pub(super) fn change_size_in<S: Scalar>(&self, tau: S, read: impl Fn(S) -> f64) -> f64
    where
        X: VectorSpace<S>,
    {
        let (sum, _) = self.term_sizes(tau);
        sum.components().map(read).fold(0.0, f64::max)
    }

    /// Returns the sum of the magnitudes of all terms but the constant at τ, and the magnitudes of the last two terms.
    fn term_sizes<S: Scalar>(&self, tau: S) -> (X, [X; 2])
    where
        X: VectorSpace<S>,
    {
        let tau = tau.abs();
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
        (sum, last)
    }

    /// Adds a change to the value at τ by the coefficient of the highest order, so that earlier values are affected
    /// least.
    pub(super) fn change_end<S: Scalar>(&mut self, tau: S, change: &X)
    where
        X: VectorSpace<S>,
    {
        if let Some((coefficient, power)) = self.last_that_counts(tau) {
            coefficient.add_scaled(S::one() / power, change);
        }
    }

    /// [`change_end`](Self::change_end) in one lane.
    pub(super) fn change_end_in<const L: usize>(&mut self, lane: usize, tau: f64, change: &X::Lane)
    where
        X: LaneStates<L>,
    {
        if let Some((coefficient, power)) = self.last_that_counts(tau) {
            let mut of_lane = coefficient.lane(lane);
            of_lane.add_scaled(1.0 / power, change);
            coefficient.set_lane(lane, &of_lane);
        }
    }

    /// Returns the coefficient of the highest order whose power of τ [divides] a change, or else of order 1, and that power.
    fn last_that_counts<S: Scalar>(&mut self, tau: S) -> Option<(&mut X, S)> {
        let (mut power, mut order) = (tau, 1);
        while order < Self::ORDER && divides(power * tau) {
            power *= tau;
            order += 1;
        }
        Some((self.higher_mut().get_mut(order - 1)?, power))
    }

    /// Returns the coefficients about τ.
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

    /// Returns x(τ) − x(0), by Horner's rule for the coefficients of odd and of even order in turn, so that neither has
    /// to wait for the other (Knuth, *The Art of Computer Programming* 2, 3rd edition 1997, section 4.6.4).
    #[inline]
    #[must_use]
    pub fn change<S: Scalar>(&self, tau: S) -> X
    where
        X: VectorSpace<S>,
    {
        let square = tau * tau;
        let mut pairs = self.pairs.iter().rev();
        let [mut odd, mut even] = self.last_pair(pairs.next());
        for [first, second] in pairs {
            odd = with_higher(first, square, &odd);
            even = with_higher(second, square, &even);
        }
        with_higher(&odd, tau, &even).map(|component| component * tau)
    }

    /// Returns dx/dτ.
    #[inline]
    #[must_use]
    pub fn derivative<S: Scalar>(&self, tau: S) -> X
    where
        X: VectorSpace<S>,
    {
        self.change_and_derivative(tau).1
    }

    /// Returns x(τ) − x(0) and dx/dτ.
    #[inline]
    #[must_use]
    pub fn change_and_derivative<S: Scalar>(&self, tau: S) -> (X, X)
    where
        X: VectorSpace<S>,
    {
        let pairs = self.pairs.iter().map(<[X; 2]>::each_ref);
        let zero = self.initial.zeroed();
        let [change, derivative] =
            horner::change_and_derivative(pairs, tau, zero, |x, tau, y| with_higher(x, tau, y));
        (change, derivative)
    }

    /// [`change_and_derivative`](Self::change_and_derivative) of states in lanes.
    #[inline]
    pub(super) fn change_and_derivative_in_lanes<const L: usize>(&self, tau: Lanes<L>) -> [X; 2]
    where
        X: LaneStates<L>,
    {
        let pairs = self.pairs.iter().map(<[X; 2]>::each_ref);
        self.initial.change_and_derivative(pairs, tau)
    }

    /// Returns the coefficients of the highest orders, with which Horner's rule begins.
    #[inline]
    fn last_pair(&self, pair: Option<&[X; 2]>) -> [X; 2] {
        match pair {
            Some(pair) => pair.clone(),
            None => [self.initial.clone(), self.initial.clone()],
        }
    }
}

/// Whether a power of τ divides changes without overflow: its square has all digits.
#[inline]
pub(super) fn divides<S: Scalar>(power: S) -> bool {
    (power * power).smallest() > S::min_positive().smallest()
}

/// Returns x + τ · higher.
#[inline]
fn with_higher<S: Scalar, X: VectorSpace<S>>(x: &X, tau: S, higher: &X) -> X {
    let mut sum = x.clone();
    sum.add_scaled(tau, higher);
    sum
}

/// Returns a power by repeated squaring.
#[inline]
pub(super) fn power<S: Scalar>(x: S, exponent: usize) -> S {
    let (mut product, mut square, mut exponent) = (S::one(), x, exponent);
    while exponent > 0 {
        if exponent % 2 == 1 {
            product *= square;
        }
        square = square * square;
        exponent /= 2;
    }
    product
}

/// Converts an order to a floating-point number.
#[allow(clippy::cast_precision_loss)] // Orders are small.
pub(super) const fn number(order: usize) -> f64 {
    order as f64
}

#[cfg(test)]
mod tests {
    use nalgebra::SVector;

    use super::{TaylorCoefficients, number};
    use crate::linalg::LaneStates;
    use crate::rigid_body::RotationState;
    use crate::scalar::Lanes;
    use crate::{CanonicalPhase, Phase};

    /// Asserts that the polynomial with the coefficients 1, 2, … agrees with its definition.
    fn check<const HALF: usize>() {
        let mut polynomial = TaylorCoefficients::<_, HALF>::new(SVector::from([7.0_f64]));
        for (index, coefficient) in polynomial.higher_mut().iter_mut().enumerate() {
            coefficient[0] = number(index + 1);
        }
        for tau in [-1.5, -0.25, 0.0, 0.5, 1.0, 1.25] {
            let terms = |power: i32| {
                (1..=2 * HALF).map(move |k| (k, f64::powi(tau, i32::try_from(k).unwrap() - power)))
            };
            let change: f64 = terms(0).map(|(k, power)| number(k) * power).sum();
            let slope: f64 = terms(1).map(|(k, power)| number(k * k) * power).sum();
            // 0⁰ is 1; the inverse of 0 does not occur.
            let size: f64 = terms(0).map(|(k, power)| number(k * k) * power.abs()).sum();
            let (found, derivative) = polynomial.change_and_derivative(tau);
            assert!((found[0] - change).abs() <= 1e-14 * size, "{tau}");
            assert!(
                (polynomial.change(tau)[0] - change).abs() <= 1e-14 * size,
                "{tau}"
            );
            assert!(
                (derivative[0] - slope).abs() <= 1e-14 * (size + slope.abs()),
                "{tau}"
            );
        }
    }

    /// Asserts that states in lanes have the polynomials of their components.
    fn check_lanes<X: LaneStates<4>>(state: &X) {
        let mut polynomial = TaylorCoefficients::<X, 6>::new(state.zeroed());
        let mut number = 0.0;
        for coefficient in polynomial.higher_mut() {
            *coefficient = state.map(|_| {
                number += 1.0;
                Lanes::from_fn(|lane| f64::sin(number + 0.3 * super::number(lane)))
            });
        }
        let tau = Lanes([-1.25, 0.0, 0.5, 1.5]);
        let (change, derivative) = polynomial.change_and_derivative(tau);
        let found = polynomial.change_and_derivative_in_lanes(tau);
        for (found, expected) in found.iter().zip([change, derivative]) {
            assert!(found.components().eq(expected.components()));
        }
    }

    #[test]
    fn polynomials_in_lanes_are_those_of_the_components() {
        let zero = Lanes([0.0; 4]);
        check_lanes(&SVector::from([zero; 3]));
        check_lanes(&(SVector::from([zero; 2]), SVector::from([zero])));
        let [q, v] = [SVector::from([zero; 2]); 2];
        check_lanes(&Phase {
            q,
            v,
            z: SVector::from([zero]),
        });
        check_lanes(&CanonicalPhase::new(q, v));
        check_lanes(&RotationState {
            quaternion: SVector::from([zero; 4]),
            angular_velocity: SVector::from([zero; 3]),
        });
    }

    #[test]
    fn polynomials_are_those_of_the_definition() {
        check::<1>();
        check::<2>();
        check::<7>();
        check::<14>();
    }
}
