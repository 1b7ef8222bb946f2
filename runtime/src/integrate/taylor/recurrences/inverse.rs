//! Inverse circular and hyperbolic functions of series.

use super::algebraic::{Square, SquareRoot};
use super::terms::{Terms, number, weighted_convolution};
use crate::scalar::Scalar;

/// A function z with d z′ = x′, where d is known up to order k: (xₖ − Σ₀﹤ᵢ﹤ₖ i zᵢ dₖ₋ᵢ/k)/d₀.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Integral<S, const HALF: usize> {
    z: Terms<S, HALF>,
    divisor: Terms<S, HALF>,
}

impl<S: Scalar, const HALF: usize> Integral<S, HALF> {
    fn new() -> Self {
        let [z, divisor] = [Terms::new(); 2];
        Self { z, divisor }
    }

    /// Returns the next coefficient, given the next coefficients of x and of the divisor, and the value at order 0.
    fn next(&mut self, x: S, divisor: S, value: impl FnOnce() -> S) -> S {
        let k = self.z.order();
        let z = if k == 0 {
            value()
        } else {
            let lower = self.z.known().get(1..).unwrap_or_default();
            let sum = weighted_convolution(lower, self.divisor.known());
            (x - sum / number(k)) / self.divisor.first()
        };
        self.divisor.push(divisor);
        self.z.push(z);
        z
    }
}

/// A function z with z′ = x′/(a + b x²).
macro_rules! of_rational_derivative {
    ($(#[$documentation:meta])* $name:ident, $function:expr, $sign:expr) => {
        $(#[$documentation])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name<S, const HALF: usize> {
            square: Square<S, HALF>,
            integral: Integral<S, HALF>,
        }

        impl<S: Scalar, const HALF: usize> $name<S, HALF> {
            /// Creates the function of a series without any terms yet.
            #[must_use]
            pub fn new() -> Self {
                Self { square: Square::new(), integral: Integral::new() }
            }

            /// Returns the next coefficient, given the next coefficient of x.
            pub fn next(&mut self, x: S) -> S {
                let sign: S = $sign;
                let constant = if self.integral.z.order() == 0 { S::one() } else { S::zero() };
                let divisor = constant + sign * self.square.next(x);
                let function: fn(S) -> S = $function;
                self.integral.next(x, divisor, || function(x))
            }
        }

        impl<S: Scalar, const HALF: usize> Default for $name<S, HALF> {
            fn default() -> Self {
                Self::new()
            }
        }
    };
}

of_rational_derivative! {
    /// The inverse tangent, z′ = x′/(1 + x²).
    ArcTangent, Scalar::atan, S::one()
}

of_rational_derivative! {
    /// The inverse hyperbolic tangent, z′ = x′/(1 − x²).
    InverseHyperbolicTangent, Scalar::atanh, -S::one()
}

/// A function z with z′ = ± x′/√(a + b x²).
macro_rules! of_irrational_derivative {
    ($(#[$documentation:meta])* $name:ident, $function:expr, $constant:expr, $square:expr, $sign:expr) => {
        $(#[$documentation])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name<S, const HALF: usize> {
            square: Square<S, HALF>,
            root: SquareRoot<S, HALF>,
            integral: Integral<S, HALF>,
        }

        impl<S: Scalar, const HALF: usize> $name<S, HALF> {
            /// Creates the function of a series without any terms yet.
            #[must_use]
            pub fn new() -> Self {
                Self { square: Square::new(), root: SquareRoot::new(), integral: Integral::new() }
            }

            /// Returns the next coefficient, given the next coefficient of x.
            pub fn next(&mut self, x: S) -> S {
                let (constant, of_square, sign): (S, S, S) = ($constant, $square, $sign);
                let constant = if self.integral.z.order() == 0 { constant } else { S::zero() };
                let divisor = self.root.next(constant + of_square * self.square.next(x));
                let function: fn(S) -> S = $function;
                self.integral.next(sign * x, divisor, || function(x))
            }
        }

        impl<S: Scalar, const HALF: usize> Default for $name<S, HALF> {
            fn default() -> Self {
                Self::new()
            }
        }
    };
}

of_irrational_derivative! {
    /// The inverse sine, z′ = x′/√(1 − x²).
    ArcSine, Scalar::asin, S::one(), -S::one(), S::one()
}

of_irrational_derivative! {
    /// The inverse cosine, z′ = −x′/√(1 − x²).
    ArcCosine, Scalar::acos, S::one(), -S::one(), -S::one()
}

of_irrational_derivative! {
    /// The inverse hyperbolic sine, z′ = x′/√(1 + x²).
    InverseHyperbolicSine, Scalar::asinh, S::one(), S::one(), S::one()
}

of_irrational_derivative! {
    /// The inverse hyperbolic cosine, z′ = x′/√(x² − 1).
    InverseHyperbolicCosine, Scalar::acosh, -S::one(), S::one(), S::one()
}

/// The angle θ of the point (x, y), from (x² + y²) θ′ = x y′ − y x′.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArcTangent2<S, const HALF: usize> {
    /// The factor by which x and y are multiplied, so that their squares neither underflow nor overflow.
    scale: S,
    x: Terms<S, HALF>,
    y: Terms<S, HALF>,
    squares: [Square<S, HALF>; 2],
    integral: Integral<S, HALF>,
}

impl<S: Scalar, const HALF: usize> ArcTangent2<S, HALF> {
    /// Creates the angle of two series without any terms yet.
    #[must_use]
    pub fn new() -> Self {
        let [x, y] = [Terms::new(); 2];
        Self {
            scale: S::one(),
            x,
            y,
            squares: [Square::new(); 2],
            integral: Integral::new(),
        }
    }

    /// Returns the next coefficient, given the next coefficients of y and x, in the order of the arguments of `atan2`.
    pub fn next(&mut self, y: S, x: S) -> S {
        let k = self.integral.z.order();
        if k == 0 {
            self.scale = y.common_scale(x);
        }
        let [along, across] = [x, y].map(|z| z * self.scale);
        self.x.push(along);
        self.y.push(across);
        let divisor = self.squares[0].next(along) + self.squares[1].next(across);
        let swept = if k == 0 {
            S::zero()
        } else {
            let [of_x, of_y] = [&self.x, &self.y].map(Terms::known);
            let swept = |[of, along]: [&[S]; 2]| {
                let higher = along.get(1..).unwrap_or_default();
                weighted_convolution(higher, &of[..of.len().saturating_sub(1)])
            };
            let sum = swept([of_x, of_y]) - swept([of_y, of_x]);
            sum / number(k)
        };
        self.integral.next(swept, divisor, || y.atan2(x))
    }
}

impl<S: Scalar, const HALF: usize> Default for ArcTangent2<S, HALF> {
    fn default() -> Self {
        Self::new()
    }
}
