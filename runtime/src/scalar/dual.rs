//! The dual numbers of the crate `num-dual` as scalars. Needs the feature `num-dual`.

use num_dual::{Dual2_64, Dual64, DualNum, DualSVec64, HyperDual64};

use super::Scalar;

macro_rules! forwarded {
    ($($function:ident)*) => {$(
        #[inline]
        fn $function(self) -> Self {
            DualNum::$function(&self)
        }
    )*};
}

/// Implements [`Scalar`] for a type of dual numbers, given a function that tells whether all derivative parts are zero,
/// their number, and the part of an index.
macro_rules! dual_scalar {
    ([$($generics:tt)*] $dual:ty, $is_constant:expr, $derivatives:expr, $part:expr) => {
        impl<$($generics)*> crate::SingleNumber for $dual {}

        impl<$($generics)*> Scalar for $dual {
            const DERIVATIVES: usize = $derivatives;

            #[inline]
            fn derivative_part(self, index: usize) -> f64 {
                let part: fn(&Self, usize) -> Option<f64> = $part;
                part(&self, index).unwrap_or(0.0)
            }

            forwarded! { sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh exp ln }

            #[inline]
            fn from_f64(value: f64) -> Self {
                Self::from_re(value)
            }

            #[inline]
            fn min_positive() -> Self {
                Self::from_re(f64::MIN_POSITIVE)
            }

            #[inline]
            fn smallest(self) -> f64 {
                self.re
            }

            #[inline]
            fn largest(self) -> f64 {
                self.re
            }

            #[inline]
            fn machine_epsilon() -> f64 {
                f64::EPSILON
            }

            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                DualNum::sin_cos(&self)
            }

            // The exponential of what is not positive does not overflow.
            #[inline]
            fn logistic(self) -> Self {
                if self.re < 0.0 {
                    let small = DualNum::exp(&self);
                    small / (Self::from_re(1.0) + small)
                } else {
                    DualNum::recip(&(Self::from_re(1.0) + DualNum::exp(&-self)))
                }
            }

            #[inline]
            fn sech(self) -> Self {
                let exponent = if self.re < 0.0 { self } else { -self };
                let small = DualNum::exp(&exponent);
                (small + small) / (Self::from_re(1.0) + small * small)
            }

            #[inline]
            fn softplus(self) -> Self {
                if self.re < 0.0 {
                    DualNum::ln_1p(&DualNum::exp(&self))
                } else {
                    self + DualNum::ln_1p(&DualNum::exp(&-self))
                }
            }

            // The slope of a root is infinite at 0; times derivative parts that are 0, it is none.
            #[inline]
            fn sqrt(self) -> Self {
                let is_constant: fn(&Self) -> bool = $is_constant;
                if is_constant(&self) {
                    Self::from_re(self.re.sqrt())
                } else {
                    DualNum::sqrt(&self)
                }
            }

            #[inline]
            fn common_scale(self, other: Self) -> Self {
                Self::from_re(self.re.common_scale(other.re))
            }

            // Derivative parts are those of arctan y/x, or of −arctan x/y where x may be 0. A quotient's derivatives divide
            // by squares.
            #[inline]
            fn atan2(self, x: Self) -> Self {
                let angle = self.re.atan2(x.re);
                let scale = self.re.common_scale(x.re);
                let (sine, cosine) = (self * scale, x * scale);
                let mut result = if self.re.abs() > x.re.abs() {
                    -DualNum::atan(&(cosine / sine))
                } else {
                    DualNum::atan(&(sine / cosine))
                };
                result.re = angle;
                result
            }

            // With a constant exponent there is a value for every base that has a real power.
            #[inline]
            fn powf(self, exponent: Self) -> Self {
                let is_constant: fn(&Self) -> bool = $is_constant;
                // At 0 a power above the second has neither slope nor curvature, where quotients by the base have no value.
                let is_flat = Scalar::signum(self.re) == 0.0 && exponent.re > 2.0;
                if is_flat {
                    Self::from_re(0.0)
                } else if is_constant(&exponent) {
                    DualNum::powf(&self, exponent.re)
                } else {
                    DualNum::powd(&self, exponent)
                }
            }

            #[inline]
            fn abs(self) -> Self {
                self * Scalar::signum(self)
            }

            #[inline]
            fn signum(self) -> Self {
                Self::from_re(Scalar::signum(self.re))
            }

            #[inline]
            fn min(self, other: Self) -> Self {
                if other.re < self.re { other } else { self }
            }

            #[inline]
            fn max(self, other: Self) -> Self {
                if other.re > self.re { other } else { self }
            }
        }
    };
}

/// Whether numbers are all zero.
fn vanish<'a>(derivatives: impl IntoIterator<Item = &'a f64>) -> bool {
    derivatives
        .into_iter()
        .all(|derivative| derivative.abs() <= 0.0)
}

dual_scalar! {
    [] Dual64, |x| vanish([&x.eps]), 1, |x, index| [x.eps].get(index).copied()
}
dual_scalar! {
    [] Dual2_64, |x| vanish([&x.v1, &x.v2]), 2, |x, index| [x.v1, x.v2].get(index).copied()
}
dual_scalar! {
    [] HyperDual64, |x| vanish([&x.eps1, &x.eps2, &x.eps1eps2]),
    3, |x, index| [x.eps1, x.eps2, x.eps1eps2].get(index).copied()
}
dual_scalar! {
    [const N: usize] DualSVec64<N>, |x| x.eps.0.as_ref().is_none_or(vanish),
    N, |x, index| x.eps.0.as_ref().and_then(|parts| parts.get(index).copied())
}
