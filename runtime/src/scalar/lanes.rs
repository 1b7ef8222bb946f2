//! SIMD lanes as a scalar.

#![allow(clippy::inline_always)] // An operation is one instruction.

use core::array;
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::simd::{LaneOperation, SimdVector, in_vectors};
use super::{Scalar, arithmetic::arithmetic};

/// Without optimization, a vector operation consists of many calls, and a loop over the lanes takes a quarter of the
/// time.
const IN_LOOPS: bool = cfg!(debug_assertions);

/// `L` numbers of type `f64` on which every operation acts lane by lane: models with different parameters, or motions
/// with different initial values, computed at once.
///
/// The compiler translates the operations into vector instructions if the target has them; sines and cosines of all
/// lanes are computed together. 4 or 8 lanes suit most processors, with `-C target-cpu=native`. A lane agrees bit for
/// bit with the computation on `f64`, with two exceptions: another lane may require a different factorization of M
/// ([`Scalar`]), and Taylor series add their sums in another order on single numbers.
///
/// In an [`Ensemble`](crate::Ensemble) each lane has its own steps. Elsewhere all lanes share the time and the steps of
/// an integration: an adaptive method takes the steps that the most demanding lane requires.
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian::Lanes;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     coordinates(theta),
///     kinetic = 0.5 * (l * dot(theta)).powi(2),
///     potential = -g * l * cos(theta),
/// )]
/// struct Pendulum<T: Scalar> { l: T, g: T }
///
/// // Four lengths at once.
/// let lengths = [0.5, 1.0, 1.5, 2.0];
/// let pendulums = Pendulum { l: Lanes(lengths), g: Lanes::from_f64(9.81) };
/// let start = State::new(Lanes::from_f64(0.0), [Lanes::from_f64(0.3)], [Lanes::from_f64(0.0)]);
/// let method = RungeKutta::classical(0.01);
/// let end = Problem::new(&pendulums, start).solve(1.0, method)?;
///
/// for (lane, l) in lengths.into_iter().enumerate() {
///     let alone = Pendulum { l, g: 9.81 };
///     let start = State::new(0.0, [0.3], [0.0]);
///     let alone = Problem::new(&alone, start).solve(1.0, method)?;
///     assert_eq!(end.q[0].lane(lane), alone.q[0]);
/// }
/// # Ok::<(), IntegrationError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Lanes<const L: usize>(
    #[cfg_attr(feature = "serde", serde(with = "crate::array_as_tuple"))] pub [f64; L],
);

impl<const L: usize> Lanes<L> {
    /// Creates the lanes 0, 1, … from a function of the index.
    #[inline]
    #[must_use]
    pub fn from_fn(number: impl FnMut(usize) -> f64) -> Self {
        Self(array::from_fn(number))
    }

    /// Returns the number in a lane; NaN if there is no such lane.
    #[inline]
    #[must_use]
    pub fn lane(self, lane: usize) -> f64 {
        self.0.get(lane).copied().unwrap_or(f64::NAN)
    }

    /// Sets the number in a lane; does nothing if there is no such lane.
    #[inline]
    pub fn set(&mut self, lane: usize, number: f64) {
        if let Some(place) = self.0.get_mut(lane) {
            *place = number;
        }
    }

    #[inline]
    fn both(self, other: Self, function: impl Fn(f64, f64) -> f64) -> Self {
        Self::from_fn(|lane| function(self.0[lane], other.0[lane]))
    }

    /// Returns the larger number in each lane; the one of `other` if one of them is NaN. This is a single instruction of a
    /// processor, in contrast to [`Scalar::max`].
    #[inline]
    pub(crate) fn larger(self, other: Self) -> Self {
        self.both(other, |x, y| if x > y { x } else { y })
    }

    /// Reduces all lanes by `keep`, in halves, which are vectors. Returns NaN if a lane is NaN, and `none` if there are
    /// no lanes.
    #[inline]
    fn extreme(self, none: f64, keep: impl Fn(f64, f64) -> f64) -> f64 {
        let Self(mut lanes) = self;
        let has_nan = lanes.iter().fold(false, |any, lane| any | lane.is_nan());
        let mut count = L;
        while count > 1 {
            let half = count.div_ceil(2);
            for lane in 0..count / 2 {
                lanes[lane] = keep(lanes[lane], lanes[lane + half]);
            }
            count = half;
        }
        if has_nan {
            f64::NAN
        } else {
            lanes.first().copied().unwrap_or(none)
        }
    }
}

impl<const L: usize> From<[f64; L]> for Lanes<L> {
    fn from(numbers: [f64; L]) -> Self {
        Self(numbers)
    }
}

macro_rules! operators {
    ($($operator:ident $function:ident $operation:ident)*) => {$(
        struct $operation;

        impl LaneOperation<2> for $operation {
            #[inline(always)]
            fn apply<const WIDTH: usize, V: SimdVector<WIDTH>>([x, y]: [V; 2]) -> V {
                $operator::$function(x, y)
            }
        }

        impl<const L: usize> $operator for Lanes<L> {
            type Output = Self;

            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                if IN_LOOPS {
                    return self.both(other, $operator::$function);
                }
                Self(in_vectors::<$operation, 2, L>([&self.0, &other.0]))
            }
        }
    )*};
}

operators! { Add add Sum Sub sub Difference Mul mul Product Div div Quotient }

struct Opposite;

impl LaneOperation<1> for Opposite {
    #[inline(always)]
    fn apply<const WIDTH: usize, V: SimdVector<WIDTH>>([x]: [V; 1]) -> V {
        -x
    }
}

impl<const L: usize> Neg for Lanes<L> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        if IN_LOOPS {
            return Self(self.0.map(Neg::neg));
        }
        Self(in_vectors::<Opposite, 1, L>([&self.0]))
    }
}

struct Magnitude;

impl LaneOperation<1> for Magnitude {
    #[inline(always)]
    fn apply<const WIDTH: usize, V: SimdVector<WIDTH>>([x]: [V; 1]) -> V {
        x.abs()
    }
}

struct FusedProduct;

impl LaneOperation<3> for FusedProduct {
    #[inline(always)]
    fn apply<const WIDTH: usize, V: SimdVector<WIDTH>>([x, y, summand]: [V; 3]) -> V {
        x.mul_add(y, summand)
    }
}

arithmetic! { [const L: usize] Lanes<L> }

macro_rules! lane_by_lane {
    ($($unary:ident)*; $($binary:ident)*) => {
        $(
            #[inline]
            fn $unary(self) -> Self {
                Self(self.0.map(Scalar::$unary))
            }
        )*
        $(
            #[inline]
            fn $binary(self, other: Self) -> Self {
                self.both(other, Scalar::$binary)
            }
        )*
    };
}

impl<const L: usize> Scalar for Lanes<L> {
    lane_by_lane! {
        tan asin acos atan sinh cosh tanh sech asinh acosh atanh exp ln logistic softplus log_cosh sqrt signum;
        atan2 powf min max common_scale
    }

    #[inline]
    fn from_f64(value: f64) -> Self {
        Self([value; L])
    }

    #[inline]
    fn min_positive() -> Self {
        Self([f64::MIN_POSITIVE; L])
    }

    #[inline]
    fn smallest(self) -> f64 {
        self.extreme(f64::INFINITY, |x, y| if y < x { y } else { x })
    }

    #[inline]
    fn largest(self) -> f64 {
        self.extreme(f64::NEG_INFINITY, |x, y| if y > x { y } else { x })
    }

    #[inline]
    fn in_lane(self, lane: usize) -> f64 {
        self.lane(lane)
    }

    #[inline]
    fn is_finite(self) -> bool {
        self.0.iter().fold(true, |all, lane| all & lane.is_finite())
    }

    #[inline]
    fn machine_epsilon() -> f64 {
        f64::EPSILON
    }

    #[inline(always)]
    fn mul_add(self, factor: Self, summand: Self) -> Self {
        if IN_LOOPS {
            let product = |lane| Scalar::mul_add(self.0[lane], factor.0[lane], summand.0[lane]);
            return Self::from_fn(product);
        }
        Self(in_vectors::<FusedProduct, 3, L>([
            &self.0, &factor.0, &summand.0,
        ]))
    }

    #[inline(always)]
    fn abs(self) -> Self {
        if IN_LOOPS {
            return Self(self.0.map(f64::abs));
        }
        Self(in_vectors::<Magnitude, 1, L>([&self.0]))
    }

    #[inline]
    fn floor(self) -> Self {
        // From here on all numbers are integers, so that adding this number rounds a smaller one to an integer.
        const ALL_WHOLE: f64 = 1.0 / f64::EPSILON;
        Self(self.0.map(|x| {
            let rounded = ((x.abs() + ALL_WHOLE) - ALL_WHOLE).copysign(x);
            let floor = rounded - if rounded > x { 1.0 } else { 0.0 };
            if x.abs() < ALL_WHOLE { floor } else { x }
        }))
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sines, cosines) = Scalar::sines_and_cosines(self.0);
        (Self(sines), Self(cosines))
    }

    #[inline]
    fn sin(self) -> Self {
        self.sin_cos().0
    }

    #[inline]
    fn cos(self) -> Self {
        self.sin_cos().1
    }
}

#[cfg(test)]
mod tests {
    use super::{Difference, FusedProduct, Lanes, Opposite, Product, Quotient, Scalar, Sum};
    use crate::scalar::simd::{LaneOperation, in_vectors};

    /// Asserts that an operation in vectors agrees bit for bit with the operation on numbers.
    fn compare<Operation: LaneOperation<K>, const K: usize, const L: usize>(
        function: impl Fn([f64; K]) -> f64,
    ) {
        let special = [0.0, -0.0, f64::MIN_POSITIVE / 3.0, f64::INFINITY, 1.0 / 3.0];
        for turn in 0_u32..40 {
            let operand = |i: u32, lane: usize| {
                let angle =
                    f64::from(turn + 7 * i) + 0.37 * f64::from(u32::try_from(lane).unwrap());
                match special.get((turn as usize + 3 * lane + i as usize) % 11) {
                    Some(number) => *number,
                    None => libm::ldexp(libm::sin(angle), (turn % 9).cast_signed() - 4),
                }
            };
            let mut i = 0;
            let operands: [[f64; L]; K] = core::array::from_fn(|_| {
                i += 1;
                core::array::from_fn(|lane| operand(i, lane))
            });
            let found = in_vectors::<Operation, K, L>(operands.each_ref());
            for lane in 0..L {
                let expected = function(operands.map(|lanes| lanes[lane]));
                let same = found[lane].to_bits() == expected.to_bits();
                assert!(
                    same || (found[lane].is_nan() && expected.is_nan()),
                    "{operands:?}"
                );
            }
        }
    }

    fn compare_all<const L: usize>() {
        compare::<Sum, 2, L>(|[x, y]| x + y);
        compare::<Difference, 2, L>(|[x, y]| x - y);
        compare::<Product, 2, L>(|[x, y]| x * y);
        compare::<Quotient, 2, L>(|[x, y]| x / y);
        compare::<Opposite, 1, L>(|[x]| -x);
        compare::<FusedProduct, 3, L>(|[x, y, z]| Scalar::mul_add(x, y, z));
    }

    #[test]
    fn vectors_have_the_bits_of_numbers() {
        compare_all::<1>();
        compare_all::<3>();
        compare_all::<4>();
        compare_all::<8>();
        compare_all::<12>();
        compare_all::<16>();
    }

    #[test]
    fn the_floor_is_that_of_each_lane() {
        let numbers = [
            0.0,
            0.5,
            1.0 - f64::EPSILON,
            2.5,
            -0.1,
            -3.0,
            1e15 + 0.5,
            -1e15 - 0.5,
        ];
        let more = [
            7.999,
            -8.5,
            123_456.7,
            -0.0,
            4e15 + 0.5,
            1e300,
            -1e300,
            2.0_f64.powi(52) - 1.0,
        ];
        for numbers in [numbers, more] {
            let found = Lanes(numbers).floor().0;
            for (found, number) in found.into_iter().zip(numbers) {
                assert!((found - number.floor()).abs() == 0.0, "{number}: {found}");
                assert!(
                    (Scalar::floor(number) - number.floor()).abs() == 0.0,
                    "{number}"
                );
            }
        }
    }

    /// Asserts that the extreme lanes are found wherever they are.
    fn extremes<const L: usize>() {
        for special in 0..L {
            let lanes =
                |number| Lanes::<L>::from_fn(|lane| if lane == special { number } else { 1.0 });
            let found = [lanes(2.0).largest(), lanes(-2.0).smallest()];
            assert_eq!(
                found.map(f64::to_bits),
                [2.0, -2.0].map(f64::to_bits),
                "{special} of {L}"
            );
            assert!(lanes(f64::NAN).largest().is_nan() && lanes(f64::NAN).smallest().is_nan());
            assert!(lanes(2.0).is_finite() && !lanes(f64::NEG_INFINITY).is_finite());
        }
    }

    #[test]
    fn the_extremes_of_any_number_of_lanes() {
        extremes::<1>();
        extremes::<2>();
        extremes::<3>();
        extremes::<5>();
        extremes::<7>();
        extremes::<8>();
        extremes::<12>();
        assert!(Lanes::<0>([]).largest() <= f64::NEG_INFINITY);
    }

    #[test]
    fn a_lane_that_is_no_number_is_the_smallest_and_the_largest() {
        for odd in 0..3 {
            let lanes = Lanes::<3>::from_fn(|lane| if lane == odd { f64::NAN } else { 1.0 });
            assert!(lanes.smallest().is_nan() && lanes.largest().is_nan());
            assert!(!lanes.is_finite());
        }
        let lanes = Lanes([2.0, -3.0, 0.5]);
        assert_eq!((lanes.smallest(), lanes.largest()), (-3.0, 2.0));
        assert!(lanes.is_finite());
        assert!(!Lanes([1.0, f64::INFINITY]).is_finite());
        assert!(lanes.lane(3).is_nan());
    }
}
