//! Exponential, circular and hyperbolic functions of series.

use super::algebraic::Square;
use super::terms::{Terms, number, weighted_convolution};
use crate::scalar::Scalar;

/// Returns the coefficient of order k of ∫ y dx, Σ i xᵢ yₖ₋ᵢ/k, given x up to order k and y up to order k − 1.
fn integral<S: Scalar, const HALF: usize>(x: &Terms<S, HALF>, y: &Terms<S, HALF>) -> S {
    let higher = x.known().get(1..).unwrap_or_default();
    weighted_convolution(higher, y.known()) / number(y.order())
}

/// The exponential function z = eˣ, from z′ = z x′.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exponential<S, const HALF: usize> {
    x: Terms<S, HALF>,
    z: Terms<S, HALF>,
}

impl<S: Scalar, const HALF: usize> Exponential<S, HALF> {
    /// Creates the exponential of a series without any terms yet.
    #[must_use]
    pub fn new() -> Self {
        let [x, z] = [Terms::new(); 2];
        Self { x, z }
    }

    /// Returns the next coefficient, given the next coefficient of x.
    pub fn next(&mut self, x: S) -> S {
        self.x.push(x);
        let z = if self.z.order() == 0 {
            x.exp()
        } else {
            integral(&self.x, &self.z)
        };
        self.z.push(z);
        z
    }
}

/// The natural logarithm z = ln x, from x z′ = x′.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Logarithm<S, const HALF: usize> {
    x: Terms<S, HALF>,
    z: Terms<S, HALF>,
}

impl<S: Scalar, const HALF: usize> Logarithm<S, HALF> {
    /// Creates the logarithm of a series without any terms yet.
    #[must_use]
    pub fn new() -> Self {
        let [x, z] = [Terms::new(); 2];
        Self { x, z }
    }

    /// Returns the next coefficient, given the next coefficient of x.
    pub fn next(&mut self, x: S) -> S {
        let k = self.z.order();
        let z = if k == 0 {
            x.ln()
        } else {
            let lower = self.z.known().get(1..).unwrap_or_default();
            let sum = weighted_convolution(lower, self.x.known());
            (x - sum / number(k)) / self.x.first()
        };
        self.x.push(x);
        self.z.push(z);
        z
    }
}

/// Two functions s and c with s′ = c x′ and c′ = ± s x′.
macro_rules! pair_of_functions {
    ($(#[$documentation:meta])* $name:ident, $at_zero:expr, $sign:expr, $values:literal) => {
        $(#[$documentation])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name<S, const HALF: usize> {
            x: Terms<S, HALF>,
            s: Terms<S, HALF>,
            c: Terms<S, HALF>,
        }

        impl<S: Scalar, const HALF: usize> $name<S, HALF> {
            /// Creates both functions of a series without any terms yet.
            #[must_use]
            pub fn new() -> Self {
                let [x, s, c] = [Terms::new(); 3];
                Self { x, s, c }
            }

            #[doc = concat!("The next coefficients of ", $values, ", given that of x.")]
            pub fn next(&mut self, x: S) -> (S, S) {
                self.x.push(x);
                let (s, c) = if self.s.order() == 0 {
                    let at_zero: fn(S) -> (S, S) = $at_zero;
                    at_zero(x)
                } else {
                    let sign: S = $sign;
                    (integral(&self.x, &self.c), sign * integral(&self.x, &self.s))
                };
                self.s.push(s);
                self.c.push(c);
                (s, c)
            }
        }

        impl<S: Scalar, const HALF: usize> Default for $name<S, HALF> {
            fn default() -> Self {
                Self::new()
            }
        }
    };
}

pair_of_functions! {
    /// Sine and cosine, from s′ = c x′ and c′ = −s x′.
    SineCosine, Scalar::sin_cos, -S::one(), "sine and cosine"
}

pair_of_functions! {
    /// Hyperbolic sine and cosine, from s′ = c x′ and c′ = s x′.
    HyperbolicSineCosine, |x| (x.sinh(), x.cosh()), S::one(), "hyperbolic sine and cosine"
}

/// A function z with z′ = (1 ± z²) x′.
macro_rules! tangent {
    ($(#[$documentation:meta])* $name:ident, $function:expr, $sign:expr) => {
        $(#[$documentation])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name<S, const HALF: usize> {
            x: Terms<S, HALF>,
            square: Square<S, HALF>,
            /// 1 ± z².
            slope: Terms<S, HALF>,
        }

        impl<S: Scalar, const HALF: usize> $name<S, HALF> {
            /// Creates the tangent of a series without any terms yet.
            #[must_use]
            pub fn new() -> Self {
                let [x, slope] = [Terms::new(); 2];
                Self { x, square: Square::new(), slope }
            }

            /// Returns the next coefficient, given the next coefficient of x.
            pub fn next(&mut self, x: S) -> S {
                self.x.push(x);
                let sign: S = $sign;
                let (z, one) = if self.slope.order() == 0 {
                    let function: fn(S) -> S = $function;
                    (function(x), S::one())
                } else {
                    (integral(&self.x, &self.slope), S::zero())
                };
                self.slope.push(one + sign * self.square.next(z));
                z
            }
        }

        impl<S: Scalar, const HALF: usize> Default for $name<S, HALF> {
            fn default() -> Self {
                Self::new()
            }
        }
    };
}

tangent! {
    /// The tangent z = tan x, from z′ = (1 + z²) x′.
    Tangent, Scalar::tan, S::one()
}

tangent! {
    /// The hyperbolic tangent z = tanh x, from z′ = (1 − z²) x′.
    HyperbolicTangent, Scalar::tanh, -S::one()
}

impl<S: Scalar, const HALF: usize> Default for Exponential<S, HALF> {
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Scalar, const HALF: usize> Default for Logarithm<S, HALF> {
    fn default() -> Self {
        Self::new()
    }
}
