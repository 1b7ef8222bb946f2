//! Products, quotients, powers and roots of series.

use super::terms::{Terms, convolution, number};
use crate::linalg::lane_select::{is_zero, one_if_zero};
use crate::scalar::Scalar;

/// The product x y: Σ xᵢ yₖ₋ᵢ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Product<S, const HALF: usize> {
    x: Terms<S, HALF>,
    y: Terms<S, HALF>,
}

impl<S: Scalar, const HALF: usize> Product<S, HALF> {
    /// Creates the product of two series without any terms yet.
    #[must_use]
    pub fn new() -> Self {
        let [x, y] = [Terms::new(); 2];
        Self { x, y }
    }

    /// Returns the next coefficient, given the next coefficients of the factors.
    pub fn next(&mut self, x: S, y: S) -> S {
        self.x.push(x);
        self.y.push(y);
        convolution(self.x.known(), self.y.known())
    }
}

/// The square x², at half the cost of the product x x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Square<S, const HALF: usize> {
    x: Terms<S, HALF>,
}

impl<S: Scalar, const HALF: usize> Square<S, HALF> {
    /// Creates the square of a series without any terms yet.
    #[must_use]
    pub fn new() -> Self {
        Self { x: Terms::new() }
    }

    /// Returns the next coefficient, given the next coefficient of x.
    pub fn next(&mut self, x: S) -> S {
        self.x.push(x);
        square(self.x.known())
    }
}

/// Returns the last coefficient of x².
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
    /// Creates the quotient of two series without any terms yet.
    #[must_use]
    pub fn new() -> Self {
        let [y, z] = [Terms::new(); 2];
        Self { y, z }
    }

    /// Returns the next coefficient, given the next coefficients of the dividend and the divisor.
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
    /// Creates the square root of a series without any terms yet.
    #[must_use]
    pub fn new() -> Self {
        Self { z: Terms::new() }
    }

    /// Returns the next coefficient, given the next coefficient of x.
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

/// The power z = xᵃ with a constant exponent, from x z′ = a z x′.
///
/// zₖ is Σₘ﹤ᵢ (a i − (k + m − i)) xᵢ zₖ₊ₘ₋ᵢ/((k − a m) xₘ), where xₘ is the first coefficient that is not 0; for k = a
/// m, zₖ is xₘᵃ. If x begins at 0 and z has no series, for example if the exponent is not an integer, terms that do not
/// exist count as 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Power<S, const HALF: usize> {
    exponent: S,
    x: Terms<S, HALF>,
    z: Terms<S, HALF>,
}

impl<S: Scalar, const HALF: usize> Power<S, HALF> {
    /// Creates the power of a series without any terms yet.
    #[must_use]
    pub fn new(exponent: S) -> Self {
        let [x, z] = [Terms::new(); 2];
        Self { exponent, x, z }
    }

    /// Returns the next coefficient, given the next coefficient of x.
    pub fn next(&mut self, x: S) -> S {
        self.x.push(x);
        let k = self.z.order();
        let z = if k == 0 {
            x.powf(self.exponent)
        } else {
            self.by_first_terms(k)
        };
        self.z.push(z);
        z
    }

    /// Returns zₖ if the first term of x that is not 0 may differ between lanes.
    fn by_first_terms(&self, k: usize) -> S {
        let mut vanishing = S::one();
        let mut z = S::zero();
        for (m, first) in self.x.known().iter().enumerate() {
            let is_zero = is_zero(*first);
            if m == 0 && (is_zero.largest().is_nan() || is_zero.largest() <= 0.0) {
                return self.by_first_term(k, m);
            }
            let lanes = vanishing * (S::one() - is_zero);
            if lanes.largest() > 0.0 {
                z += self.by_first_term(k, m).masked(lanes);
            }
            vanishing *= is_zero;
        }
        z
    }

    /// Returns zₖ if xₘ is the first term that is not 0.
    fn by_first_term(&self, k: usize, m: usize) -> S {
        let (x, z) = (self.x.known(), self.z.known());
        let order = number::<S>(k);
        let rest = order - self.exponent * number(m);
        let mut sum = S::zero();
        let mut i = number::<S>(m + 1);
        for (n, x) in x.iter().enumerate().skip(m + 1) {
            let Some(z) = (k + m).checked_sub(n).and_then(|index| z.get(index)) else {
                continue;
            };
            let weight = self.exponent.mul_add(i, i - number(k + m));
            sum = (weight * *x).mul_add(*z, sum);
            i += S::one();
        }
        let first = x.get(m).copied().unwrap_or(S::zero());
        if m == 0 {
            return sum / (order * first);
        }
        let is_least = is_zero(rest);
        let least = first.powf(self.exponent).masked(is_least);
        let later = sum / (one_if_zero(rest) * first);
        least + later.masked(S::one() - is_least)
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
