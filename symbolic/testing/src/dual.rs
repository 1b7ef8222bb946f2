//! Dual numbers a + b ε with ε² = 0: derivatives without limits and without algebra.

use lagrangian_symbolic::{Binary, Rational, Unary};

use crate::Number;
use crate::bounded::Bounded;

/// A value and its derivative.
#[derive(Clone, Copy, Debug)]
pub struct Dual<N> {
    pub value: N,
    pub slope: N,
}

fn constant<N: Number>(value: i64) -> N {
    N::rational(&Rational::integer(value))
}

fn power<N: Number>(x: N, numerator: i64, denominator: i64) -> N {
    x.power(&Rational::new(numerator, denominator).unwrap())
}

/// f′(x), written down independently of the library's table.
fn slope<N: Number>(function: Unary, x: N) -> N {
    let one: N = constant(1);
    let minus: N = constant(-1);
    let square = x.multiply(x);
    let below = one.add(minus.multiply(square));
    let above = one.add(square);
    match function {
        Unary::Sin => x.unary(Unary::Cos),
        Unary::Cos => minus.multiply(x.unary(Unary::Sin)),
        Unary::Tan => power(x.unary(Unary::Cos), -2, 1),
        Unary::Asin => power(below, -1, 2),
        Unary::Acos => minus.multiply(power(below, -1, 2)),
        Unary::Atan => power(above, -1, 1),
        Unary::Sinh => x.unary(Unary::Cosh),
        Unary::Cosh => x.unary(Unary::Sinh),
        Unary::Tanh => {
            let tanh = x.unary(Unary::Tanh);
            one.add(minus.multiply(tanh.multiply(tanh)))
        }
        Unary::Sech => {
            let slope = x.unary(Unary::Sech).multiply(x.unary(Unary::Tanh));
            minus.multiply(slope)
        }
        Unary::Asinh => power(above, -1, 2),
        Unary::Acosh => power(square.add(minus), -1, 2),
        Unary::Atanh => power(below, -1, 1),
        Unary::Exp => x.unary(Unary::Exp),
        Unary::Ln => power(x, -1, 1),
        Unary::Logistic => {
            let logistic = x.unary(Unary::Logistic);
            logistic.add(minus.multiply(logistic.multiply(logistic)))
        }
        Unary::Softplus => x.unary(Unary::Logistic),
        Unary::LogCosh => x.unary(Unary::Tanh),
        Unary::Abs => x.unary(Unary::Signum),
        Unary::Signum => constant(0),
    }
}

impl<N: Number> Number for Dual<N> {
    fn rational(value: &Rational) -> Self {
        Self {
            value: N::rational(value),
            slope: constant(0),
        }
    }

    fn pi() -> Self {
        Self {
            value: N::pi(),
            slope: constant(0),
        }
    }

    fn add(self, other: Self) -> Self {
        Self {
            value: self.value.add(other.value),
            slope: self.slope.add(other.slope),
        }
    }

    fn multiply(self, other: Self) -> Self {
        let (first, second) = (
            self.slope.multiply(other.value),
            self.value.multiply(other.slope),
        );
        Self {
            value: self.value.multiply(other.value),
            slope: first.add(second),
        }
    }

    fn power(self, exponent: &Rational) -> Self {
        if exponent.is_zero() {
            return Self::rational(&Rational::ONE);
        }
        let lower = self.value.power(&(exponent - &Rational::ONE));
        Self {
            value: self.value.power(exponent),
            slope: N::rational(exponent).multiply(lower).multiply(self.slope),
        }
    }

    fn unary(self, function: Unary) -> Self {
        Self {
            value: self.value.unary(function),
            slope: slope(function, self.value).multiply(self.slope),
        }
    }

    fn binary(self, function: Binary, other: Self) -> Self {
        let (x, y) = (self.value, other.value);
        let minus: N = constant(-1);
        let (over_x, over_y) = match function {
            Binary::Atan2 => {
                let inverse = power(x.multiply(x).add(y.multiply(y)), -1, 1);
                (y.multiply(inverse), minus.multiply(x.multiply(inverse)))
            }
            Binary::Min | Binary::Max => {
                let sign = x.add(minus.multiply(y)).unary(Unary::Signum);
                let half: N = N::rational(&Rational::HALF);
                let first = half.multiply(constant::<N>(1).add(sign));
                let second = half.multiply(constant::<N>(1).add(minus.multiply(sign)));
                if function == Binary::Max {
                    (first, second)
                } else {
                    (second, first)
                }
            }
            Binary::Scale => (constant(0), constant(0)),
            Binary::Power => {
                let whole = x.binary(function, y);
                let over_x = y.multiply(whole).multiply(power(x, -1, 1));
                (over_x, whole.multiply(x.unary(Unary::Ln)))
            }
        };
        Self {
            value: x.binary(function, y),
            slope: over_x
                .multiply(self.slope)
                .add(over_y.multiply(other.slope)),
        }
    }
}

impl Dual<Bounded> {
    /// The variable itself, or a constant.
    pub fn variable(value: f64, varies: bool) -> Self {
        Self {
            value: Bounded::exact(value),
            slope: Bounded::exact(f64::from(u8::from(varies))),
        }
    }
}
