//! `f64` and `f32` as scalars.

use super::{Scalar, sine_cosine};

/// Forwards the elementary functions to the standard library, or to `libm` without it.
macro_rules! elementary {
    ($($name:ident $libm:ident ($($argument:ident)?);)*) => {$(
        #[inline]
        fn $name(self $(, $argument: Self)?) -> Self {
            #[cfg(feature = "std")]
            return self.$name($($argument)?);
            #[cfg(not(feature = "std"))]
            return libm::$libm(self $(, $argument)?);
        }
    )*};
}

/// Forwards the inverse hyperbolic functions to `libm`. The functions of the standard library overflow at half of the
/// largest number, and are inaccurate for acosh near 1 and for atanh near ±1.
macro_rules! inverse_hyperbolic {
    ($($name:ident $libm:ident;)*) => {$(
        #[inline]
        fn $name(self) -> Self {
            libm::$libm(self)
        }
    )*};
}

macro_rules! float_scalar {
    ($float:ident, $bits:ident, $from:expr, $fma:ident, $ln_1p:ident, { $($own:tt)* } $($table:tt)*) => {
        impl Scalar for $float {
            #[inline]
            fn from_f64(value: f64) -> Self {
                $from(value)
            }

            #[inline]
            fn min_positive() -> Self {
                $float::MIN_POSITIVE
            }

            #[inline]
            fn smallest(self) -> f64 {
                f64::from(self)
            }

            #[inline]
            fn largest(self) -> f64 {
                f64::from(self)
            }

            #[inline]
            fn machine_epsilon() -> f64 {
                $float::EPSILON.into()
            }

            // Without the instruction, a fused multiply-add is a call of the mathematics library, many times slower
            // than the two operations.
            #[cfg(target_feature = "fma")]
            #[inline]
            fn mul_add(self, factor: Self, summand: Self) -> Self {
                #[cfg(feature = "std")]
                return self.mul_add(factor, summand);
                #[cfg(not(feature = "std"))]
                return libm::$fma(self, factor, summand);
            }

            #[inline]
            fn abs(self) -> Self {
                $float::abs(self)
            }

            #[inline]
            fn signum(self) -> Self {
                if self == 0.0 { 0.0 } else { $float::signum(self) }
            }

            #[inline]
            fn floor(self) -> Self {
                // From here on all numbers are integers, so that adding this number rounds a smaller one to an integer.
                const ALL_WHOLE: $float = 1.0 / $float::EPSILON;
                let rounded = ((self.abs() + ALL_WHOLE) - ALL_WHOLE).copysign(self);
                let floor = rounded - if rounded > self { 1.0 } else { 0.0 };
                if self.abs() < ALL_WHOLE { floor } else { self }
            }

            #[inline]
            fn log_cosh(self) -> Self {
                let size = self.abs();
                // Near 0 by the square of sinh, which is accurate.
                let (half, small) = if size < 0.5 {
                    let sine = Scalar::sinh(size);
                    (0.5, sine * sine)
                } else {
                    (1.0, Scalar::exp(-(size + size)))
                };
                #[cfg(feature = "std")]
                let logarithm = half * small.ln_1p();
                #[cfg(not(feature = "std"))]
                let logarithm = half * libm::$ln_1p(small);
                if size < 0.5 {
                    logarithm
                } else {
                    size + (logarithm - core::$float::consts::LN_2)
                }
            }

            #[inline]
            fn softplus(self) -> Self {
                let small = Scalar::exp(-self.abs());
                #[cfg(feature = "std")]
                let logarithm = small.ln_1p();
                #[cfg(not(feature = "std"))]
                let logarithm = libm::$ln_1p(small);
                $float::max(self, 0.0) + logarithm
            }

            // The exponent n of 2ⁿ is read and written in the bits of the format.
            #[inline]
            fn common_scale(self, other: Self) -> Self {
                const DIGITS: u32 = $float::MANTISSA_DIGITS - 1;
                const INFINITE: $bits = $float::INFINITY.to_bits() >> DIGITS;
                let exponent = |x: Self| x.abs().to_bits() >> DIGITS;
                let greatest = exponent(self).max(exponent(other));
                $float::from_bits((INFINITE - 1).saturating_sub(greatest).max(1) << DIGITS)
            }

            #[inline]
            fn min(self, other: Self) -> Self {
                $float::min(self, other)
            }

            #[inline]
            fn max(self, other: Self) -> Self {
                $float::max(self, other)
            }

            #[inline]
            fn clamp(self, least: Self, most: Self) -> Self {
                if self < least {
                    least
                } else if self > most {
                    most
                } else {
                    self
                }
            }

            $($own)*

            elementary! { $($table)* }
        }
    };
}

/// Returns sine and cosine from one function that is not inlined, so that the compiler merges the two calls into one.
#[cfg(feature = "std")]
#[inline(never)]
fn sine_and_cosine_f32(x: f32) -> (f32, f32) {
    x.sin_cos()
}

#[allow(clippy::cast_possible_truncation)] // Rounding to the narrower format is what is asked for.
const fn nearest_f32(value: f64) -> f32 {
    value as f32
}

float_scalar! { f64, u64, core::convert::identity, fma, log1p,
    {
        #[inline]
        fn sin_cos(self) -> (Self, Self) {
            sine_cosine::sine_and_cosine(self)
        }

        #[inline]
        fn sines_and_cosines<const K: usize>(angles: [Self; K]) -> ([Self; K], [Self; K]) {
            sine_cosine::sines_and_cosines(angles)
        }

        inverse_hyperbolic! { asinh asinh; acosh acosh; atanh atanh; }

        // The compiler removes the unused half.
        #[inline]
        fn sin(self) -> Self {
            sine_cosine::sine_and_cosine(self).0
        }

        #[inline]
        fn cos(self) -> Self {
            sine_cosine::sine_and_cosine(self).1
        }
    }
    tan tan();
    asin asin(); acos acos(); atan atan(); atan2 atan2(x);
    sinh sinh(); cosh cosh(); tanh tanh();
    exp exp(); ln log(); sqrt sqrt(); powf pow(exponent);
}

float_scalar! { f32, u32, nearest_f32, fmaf, log1pf,
    {
        #[inline]
        fn sin_cos(self) -> (Self, Self) {
            #[cfg(feature = "std")]
            return sine_and_cosine_f32(self);
            #[cfg(not(feature = "std"))]
            return libm::sincosf(self);
        }

        inverse_hyperbolic! { asinh asinhf; acosh acoshf; atanh atanhf; }
    }
    sin sinf(); cos cosf(); tan tanf();
    asin asinf(); acos acosf(); atan atanf(); atan2 atan2f(x);
    sinh sinhf(); cosh coshf(); tanh tanhf();
    exp expf(); ln logf(); sqrt sqrtf(); powf powf(exponent);
}
