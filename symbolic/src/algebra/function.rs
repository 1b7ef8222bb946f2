//! The table of elementary functions: one row each.
//!
//! A new function does not compile until every column is filled: name, value, symmetry, exact values, cost, and its derivative in
//! `function_derivatives.rs`. The table is closed under differentiation. Square roots and rational powers are
//! not here: they are products, Π xᵢ^kᵢ.

use crate::Rational;

/// Writes the enumeration and the properties of the functions from one row for each.
macro_rules! unary_functions {
    ($($(#[$about:meta])* $function:ident: $name:literal, $c_name:expr, $symmetry:ident, $cost:literal;)*) => {
        /// An elementary function of one argument.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        #[allow(missing_docs)] // Each is the function of that name.
        pub enum Unary {
            $($(#[$about])* $function,)*
        }

        impl Unary {
            /// All of them, in order.
            pub const ALL: [Self; [$($name),*].len()] = [$(Self::$function),*];

            /// The name in a declaration and in Rust.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$function => $name,)*
                }
            }

            /// The name in `<math.h>`; `None` where C has no such function, or one that rounds differently from Rust's.
            #[must_use]
            pub const fn c_name(self) -> Option<&'static str> {
                match self {
                    $(Self::$function => $c_name,)*
                }
            }

            /// How the function behaves when its argument changes sign.
            #[must_use]
            pub const fn symmetry(self) -> Symmetry {
                match self {
                    $(Self::$function => Symmetry::$symmetry,)*
                }
            }

            /// The cost in multiplications: an estimate for x86-64 with the platform's library.
            #[must_use]
            pub const fn cost(self) -> usize {
                match self {
                    $(Self::$function => $cost,)*
                }
            }
        }
    };
}

unary_functions! {
    // function  name         in C            symmetry cost
    Sin:       "sin",       None,           Odd,  12;
    Cos:       "cos",       None,           Even, 12;
    Tan:       "tan",       Some("tan"),    Odd,  20;
    Asin:      "asin",      Some("asin"),   Odd,  20;
    Acos:      "acos",      Some("acos"),   None, 20;
    Atan:      "atan",      Some("atan"),   Odd,  20;
    Sinh:      "sinh",      Some("sinh"),   Odd,  20;
    Cosh:      "cosh",      Some("cosh"),   Even, 20;
    Tanh:      "tanh",      Some("tanh"),   Odd,  20;
    /// 1/cosh: what a quotient by a hyperbolic cosine becomes, see `algebra/hyperbolic.rs`.
    Sech:      "sech",      None,           Even, 22;
    Asinh:     "asinh",     Some("asinh"),  Odd,  20;
    Acosh:     "acosh",     Some("acosh"),  None, 20;
    Atanh:     "atanh",     Some("atanh"),  Odd,  20;
    Exp:       "exp",       Some("exp"),    None, 12;
    Ln:        "ln",        Some("log"),    None, 12;
    /// 1/(1 + e⁻ˣ), an exponential and a quotient: see `algebra/logistic.rs`.
    Logistic:  "logistic",  None,           None, 18;
    /// ln(1 + eˣ), of which the logistic function is the derivative: an exponential and a logarithm.
    Softplus:  "softplus",  None,           None, 26;
    /// ln cosh x: an exponential and a logarithm.
    LogCosh:   "log_cosh",  None,           Even, 26;
    Abs:       "abs",       Some("fabs"),   Even, 1;
    Signum:    "signum",    None,           Odd,  1;
}

/// An elementary function of two arguments.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Binary {
    /// The angle of the point (second, first).
    Atan2,
    /// The lesser.
    Min,
    /// The greater.
    Max,
    /// The first to the power of the second, both expressions.
    Power,
    /// The power of two that takes the larger of |first| and |second| to about 1; a constant to derivatives. Programs alone
    /// have it, see `program/angle_slopes.rs`.
    Scale,
}

/// The parity of a function: f(−x) in terms of f(x).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Symmetry {
    /// f(−x) = f(x).
    Even,
    /// f(−x) = −f(x).
    Odd,
    /// Neither.
    None,
}

impl Unary {
    /// Whether a declaration can call the function by its name; the others stand for what is written by exponentials
    /// or hyperbolic cosines.
    #[must_use]
    pub const fn is_written(self) -> bool {
        !matches!(
            self,
            Self::Sech | Self::Logistic | Self::Softplus | Self::LogCosh
        )
    }

    /// The value at `x`, in binary64, the same on every host.
    #[must_use]
    pub fn value(self, x: f64) -> f64 {
        match self {
            Self::Sin => libm::sin(x),
            Self::Cos => libm::cos(x),
            Self::Tan => libm::tan(x),
            Self::Asin => libm::asin(x),
            Self::Acos => libm::acos(x),
            Self::Atan => libm::atan(x),
            Self::Sinh => libm::sinh(x),
            Self::Cosh => libm::cosh(x),
            Self::Tanh => libm::tanh(x),
            Self::Sech => 1.0 / libm::cosh(x),
            Self::Asinh => libm::asinh(x),
            Self::Acosh => libm::acosh(x),
            Self::Atanh => libm::atanh(x),
            Self::Exp => libm::exp(x),
            Self::Ln => libm::log(x),
            Self::Logistic => 1.0 / (1.0 + libm::exp(-x)),
            Self::Softplus => x.max(0.0) + libm::log1p(libm::exp(-x.abs())),
            // Near 0 by the square of the sine, which keeps the digits.
            Self::LogCosh if x.abs() < 0.5 => 0.5 * libm::log1p(libm::sinh(x) * libm::sinh(x)),
            Self::LogCosh => {
                x.abs() + libm::log1p(libm::exp(-2.0 * x.abs())) - core::f64::consts::LN_2
            }
            Self::Abs => x.abs(),
            Self::Signum if x == 0.0 => 0.0,
            Self::Signum => x.signum(),
        }
    }

    /// The value at an exact number, where that is exact too.
    #[must_use]
    pub fn exact(self, x: &Rational) -> Option<Rational> {
        match self {
            Self::Sin
            | Self::Tan
            | Self::Asin
            | Self::Atan
            | Self::Sinh
            | Self::Tanh
            | Self::Asinh
            | Self::Atanh
            | Self::LogCosh => x.is_zero().then_some(Rational::ZERO),
            Self::Cos | Self::Cosh | Self::Sech | Self::Exp => x.is_zero().then_some(Rational::ONE),
            Self::Acos | Self::Acosh | Self::Ln => x.is_one().then_some(Rational::ZERO),
            Self::Logistic => x.is_zero().then_some(Rational::HALF),
            Self::Softplus => None,
            Self::Abs => Some(x.abs()),
            Self::Signum if x.is_zero() => Some(Rational::ZERO),
            Self::Signum if x.is_negative() => Some(Rational::MINUS_ONE),
            Self::Signum => Some(Rational::ONE),
        }
    }
}

impl Binary {
    /// All that a declaration can call, in order.
    pub const ALL: [Self; 4] = [Self::Atan2, Self::Min, Self::Max, Self::Power];

    /// The name in a declaration and in Rust.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Atan2 => "atan2",
            Self::Min => "min",
            Self::Max => "max",
            Self::Power => "powf",
            Self::Scale => "common_scale",
        }
    }

    /// The name in `<math.h>`; `None` where C has no such function.
    #[must_use]
    pub const fn c_name(self) -> Option<&'static str> {
        match self {
            Self::Atan2 => Some("atan2"),
            Self::Min => Some("fmin"),
            Self::Max => Some("fmax"),
            Self::Power => Some("pow"),
            Self::Scale => None,
        }
    }

    /// The value at (`x`, `y`), in binary64, the same on every host.
    #[must_use]
    pub fn value(self, x: f64, y: f64) -> f64 {
        match self {
            Self::Atan2 => libm::atan2(x, y),
            Self::Min => x.min(y),
            Self::Max => x.max(y),
            Self::Power => libm::pow(x, y),
            Self::Scale => common_scale(x, y),
        }
    }

    /// The cost in multiplications: an estimate for x86-64 with the platform's library.
    #[must_use]
    pub const fn cost(self) -> usize {
        match self {
            Self::Min | Self::Max => 1,
            Self::Scale => 4,
            Self::Atan2 => 25,
            Self::Power => 40,
        }
    }
}

/// 2ⁿ so that the larger of |x| and |y| times it is in [1, 2), as far as 2ⁿ is a normal number.
fn common_scale(x: f64, y: f64) -> f64 {
    let exponent = |x: f64| (x.to_bits() >> 52) & 0x7ff;
    let greatest = exponent(x).max(exponent(y));
    f64::from_bits(2046_u64.saturating_sub(greatest).max(1) << 52)
}
