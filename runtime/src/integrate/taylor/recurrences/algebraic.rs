//! Products, quotients, powers and roots of series.

use super::terms::{Terms, convolution, number};
use crate::scalar::Scalar;

/// The product x y: Σ xᵢ yₖ₋ᵢ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Product<S, const HALF: usize> {
    x: Terms<S, HALF>,
    y: Terms<S, HALF>,
}

impl<S: Scalar, const HALF: usize> Product<S, HALF> {
    /// A product of series of which nothing is known.
    #[must_use]
    pub fn new() -> Self {
        let [x, y] = [Terms::new(); 2];
        Self { x, y }
    }

    /// The next coefficient, given those of the factors.
    pub fn next(&mut self, x: S, y: S) -> S {
        self.x.push(x);
        self.y.push(y);
        convolution(self.x.known(), self.y.known())
    }
}

/// The square x², for half the price of the product x x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Square<S, const HALF: usize> {
    x: Terms<S, HALF>,
}

impl<S: Scalar, const HALF: usize> Square<S, HALF> {
    /// The square of a series of which nothing is known.
    #[must_use]
    pub fn new() -> Self {
        Self { x: Terms::new() }
    }

    /// The next coefficient, given that of x.
    pub fn next(&mut self, x: S) -> S {
        self.x.push(x);
        square(self.x.known())
    }
}

/// The last coefficient of x².
fn square<S: Scalar>(x: &[S]) -> S {
    let half = x.len() / 2;
    let lower = convolution(&x[..half], x);
    let middle = if x.len() % 2 == 1 {
        x[half] * x[half]
    } else {
        S::zero()
    };
    lower + lower + middle
}

/// The quotient z = x/y: (xₖ − Σ₀﹤ᵢ yᵢ zₖ₋ᵢ)/y₀.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quotient<S, const HALF: usize> {
    y: Terms<S, HALF>,
    z: Terms<S, HALF>,
}

impl<S: Scalar, const HALF: usize> Quotient<S, HALF> {
    /// A quotient of series of which nothing is known.
    #[must_use]
    pub fn new() -> Self {
        let [y, z] = [Terms::new(); 2];
        Self { y, z }
    }

    /// The next coefficient, given those of the dividend and the divisor.
    pub fn next(&mut self, x: S, y: S) -> S {
        self.y.push(y);
        let higher = self.y.known().get(1..).unwrap_or_default();
        let z = (x - convolution(higher, self.z.known())) / self.y.first();
        self.z.push(z);
        z
    }
}

/// The square root z = √x: (xₖ − Σ₀﹤ᵢ﹤ₖ zᵢ zₖ₋ᵢ)/(2 z₀).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SquareRoot<S, const HALF: usize> {
    z: Terms<S, HALF>,
}

impl<S: Scalar, const HALF: usize> SquareRoot<S, HALF> {
    /// The root of a series of which nothing is known.
    #[must_use]
    pub fn new() -> Self {
        Self { z: Terms::new() }
    }

    /// The next coefficient, given that of x.
    pub fn next(&mut self, x: S) -> S {
        let z = if self.z.order() == 0 {
            x.sqrt()
        } else {
            let first = self.z.first();
            let higher = self.z.known().get(1..).unwrap_or_default();
            (x - square(higher)) / (first + first)
        };
        self.z.push(z);
        z
    }
}

/// The power z = xᵃ with a constant exponent: Σ₀﹤ᵢ (a i − (k − i)) xᵢ zₖ₋ᵢ/(k x₀). x₀ is not 0; powers with small whole
/// exponents are products.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Power<S, const HALF: usize> {
    exponent: S,
    x: Terms<S, HALF>,
    z: Terms<S, HALF>,
}

impl<S: Scalar, const HALF: usize> Power<S, HALF> {
    /// A power of a series of which nothing is known.
    #[must_use]
    pub fn new(exponent: S) -> Self {
        let [x, z] = [Terms::new(); 2];
        Self { exponent, x, z }
    }

    /// The next coefficient, given that of x.
    pub fn next(&mut self, x: S) -> S {
        self.x.push(x);
        let k = self.z.order();
        let z = if k == 0 {
            x.powf(self.exponent)
        } else {
            let order = number::<S>(k);
            let higher = self.x.known().get(1..).unwrap_or_default();
            let mut sum = S::zero();
            let mut i = S::one();
            for (x, z) in higher.iter().zip(self.z.known().iter().rev()) {
                let weight = self.exponent.mul_add(i, i - order);
                sum = (weight * *x).mul_add(*z, sum);
                i += S::one();
            }
            sum / (order * self.x.first())
        };
        self.z.push(z);
        z
    }
}

impl<S: Scalar, const HALF: usize> Default for Product<S, HALF> {
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Scalar, const HALF: usize> Default for Square<S, HALF> {
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Scalar, const HALF: usize> Default for Quotient<S, HALF> {
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Scalar, const HALF: usize> Default for SquareRoot<S, HALF> {
    fn default() -> Self {
        Self::new()
    }
}
