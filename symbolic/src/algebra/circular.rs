//! Exact values of the circular functions at multiples of π, and of their inverses.
//!
//! Of sin cπ and cos cπ, with a rational c, those with 0 ≤ c ≤ ¼ stand for all others, since quarter turns
//! exchange the two and change their signs; so do integer multiples of ½π in a sum, sin(x + ½π) = cos x.
//! At 0, π/6 and π/4 they are roots of rationals (Abramowitz and Stegun, Handbook of Mathematical Functions,
//! 1964, 4.3.46), as tan cπ is at π/3. At π/12 they are differences of roots, which cancel: (√6 − √2)/4 in
//! binary64 is off by 1.4 units in the last place and its eighth power, expanded, by 2400, where the sine
//! is off by 0.4 and 4. So sin π/12 and cos π/12 stay functions, of one constant, and their squares add up to 1.

use crate::{Expression, Graph, Node, Rational, Unary};

/// The angle (quarters·½ + rest)·π, by argument reduction.
struct Angle {
    /// Between 0 and 3.
    quarters: u8,
    /// Between −¼ and ¼.
    rest: Rational,
}

/// The sine or cosine of x + quarters·½π as that of x: the function and whether the sign changes.
fn shifted_by_quarters(function: Unary, quarters: u8) -> (Unary, bool) {
    // cos x = sin(x + ½π).
    let quarters = quarters + u8::from(function == Unary::Cos);
    let function = if quarters.is_multiple_of(2) {
        Unary::Sin
    } else {
        Unary::Cos
    };
    (function, quarters % 4 > 1)
}

impl Graph {
    /// A circular function of an angle that contains a multiple of π, where that makes it simpler.
    pub(crate) fn exact_circular(&mut self, function: Unary, x: Expression) -> Option<Expression> {
        if !matches!(function, Unary::Sin | Unary::Cos | Unary::Tan) {
            return None;
        }
        let (multiple, others) = self.multiple_of_pi(x)?;
        if others.is_empty() {
            return if function == Unary::Tan {
                self.tangent(&multiple)
            } else {
                self.sine_or_cosine(function, &multiple)
            };
        }
        let Angle { quarters, rest } = Angle::of(&multiple)?;
        if !rest.is_zero() {
            return None;
        }
        let (function, negative) = match function {
            // A quarter of a turn would make this −1/tan x, which has no value where tan x has none.
            Unary::Tan if quarters % 2 == 1 => return None,
            Unary::Tan => (Unary::Tan, false),
            _ => shifted_by_quarters(function, quarters),
        };
        let others = self.sum(others);
        let value = self.unary(function, others);
        Some(if negative { self.negate(value) } else { value })
    }

    /// The multiple of π in an angle, and the other terms.
    fn multiple_of_pi(&self, x: Expression) -> Option<(Rational, Vec<(Expression, Rational)>)> {
        let terms = match self.node(x) {
            Node::Pi => return Some((Rational::ONE, Vec::new())),
            Node::Sum(terms) => terms,
            _ => return None,
        };
        let is_pi = |x: Expression| matches!(self.node(x), Node::Pi);
        let position = terms.iter().position(|(x, _)| is_pi(*x))?;
        let multiple = terms[position].1.clone();
        let mut others = terms.to_vec();
        others.remove(position);
        Some((multiple, others))
    }

    /// sin cπ or cos cπ.
    fn sine_or_cosine(&mut self, function: Unary, c: &Rational) -> Option<Expression> {
        let Angle { quarters, rest } = Angle::of(c)?;
        let (function, mut negative) = shifted_by_quarters(function, quarters);
        negative ^= function == Unary::Sin && rest.is_negative();
        let value = match (function, rest.abs().to_fraction()?) {
            (Unary::Sin, (0, _)) => self.zero(),
            (_, (0, _)) => self.one(),
            (Unary::Sin, (1, 6)) => self.constant(&Rational::HALF),
            (_, (1, 6)) => self.half_of_root(3),
            (_, (1, 4)) => self.half_of_root(2),
            _ => self.at_multiple_of_pi(function, &rest.abs()),
        };
        Some(if negative { self.negate(value) } else { value })
    }

    /// tan cπ.
    fn tangent(&mut self, c: &Rational) -> Option<Expression> {
        let Angle { quarters, rest } = Angle::of(c)?;
        // Between −½ and ½; at ½ there is a pole, and nothing to be known.
        let positive = !rest.is_negative() && !rest.is_zero();
        let rest = match (quarters % 2 == 1, positive) {
            (false, _) => rest,
            (true, true) => &rest - &Rational::HALF,
            (true, false) => &rest + &Rational::HALF,
        };
        let power = match rest.abs().to_fraction()? {
            (0, _) => return Some(self.zero()),
            (1, 6) => -&Rational::HALF,
            (1, 4) => Rational::ZERO,
            (1, 3) => Rational::HALF,
            _ => Rational::ONE,
        };
        let value = if power.is_one() {
            self.at_multiple_of_pi(Unary::Tan, &rest.abs())
        } else {
            let three = self.integer(3);
            self.power(three, &power)
        };
        Some(if rest.is_negative() {
            self.negate(value)
        } else {
            value
        })
    }

    /// ½√n.
    fn half_of_root(&mut self, n: i64) -> Expression {
        let number = self.integer(n);
        let root = self.square_root(number);
        self.scale(root, &Rational::HALF)
    }

    /// f(cπ) as a call, without rewriting.
    fn at_multiple_of_pi(&mut self, function: Unary, c: &Rational) -> Expression {
        let angle = self.times_pi(c);
        self.intern(Node::Unary(function, angle))
    }

    /// The principal value of the inverse of a circular function, where it is a known multiple of π.
    pub(crate) fn exact_inverse_circular(
        &mut self,
        function: Unary,
        x: Expression,
    ) -> Option<Expression> {
        if !matches!(function, Unary::Asin | Unary::Acos | Unary::Atan) {
            return None;
        }
        let (negative, square) = self.signed_square(x)?;
        let size = if function == Unary::Atan {
            inverse_tangent(&square)
        } else {
            inverse_sine(&square)
        }?;
        let angle = if negative { -&size } else { size };
        // acos x = ½π − asin x.
        Some(self.times_pi(&if function == Unary::Acos {
            &Rational::HALF - &angle
        } else {
            angle
        }))
    }

    /// The angle of the point (x, y), in (−π, π], where it is a known multiple of π.
    pub(crate) fn exact_atan2(&mut self, y: Expression, x: Expression) -> Option<Expression> {
        let (below, y) = self.signed_square(y)?;
        let (left, x) = self.signed_square(x)?;
        let size = match x.reciprocal() {
            // At the origin there is no angle.
            None if y.is_zero() => return None,
            None => Rational::HALF,
            Some(inverse) => inverse_tangent(&(&y * &inverse))?,
        };
        let angle = if left { &Rational::ONE - &size } else { size };
        Some(self.times_pi(&if below { -&angle } else { angle }))
    }

    /// cπ.
    fn times_pi(&mut self, c: &Rational) -> Expression {
        let pi = self.pi();
        self.scale(pi, c)
    }

    /// Whether a rational or a multiple of square roots of rationals is negative, and its square.
    fn signed_square(&self, x: Expression) -> Option<(bool, Rational)> {
        let (coefficient, product) = match self.node(x) {
            Node::Constant(number) => return Some((number.is_negative(), number.power(2)?)),
            Node::Sum(terms) => match &**terms {
                [(product, coefficient)] => (coefficient.clone(), *product),
                _ => return None,
            },
            _ => (Rational::ONE, x),
        };
        let Node::Product(factors) = self.node(product) else {
            return None;
        };
        let mut square = coefficient.power(2)?;
        for (base, exponent) in factors {
            // Of what is not positive there is no root, and a lone power of it stands for no value.
            let base = self.as_constant(*base)?;
            let twice = (exponent + exponent).to_integer()?;
            if base.is_negative() || base.is_zero() {
                return None;
            }
            square = &square * &base.power(twice)?;
        }
        Some((coefficient.is_negative(), square))
    }
}

impl Angle {
    /// The angle cπ, unless c is too long.
    fn of(c: &Rational) -> Option<Self> {
        let (numerator, denominator) = c.to_fraction()?;
        let (numerator, denominator) = (i128::from(numerator), i128::from(denominator));
        // The nearest integer to 2c.
        let quarters = (4 * numerator + denominator).div_euclid(2 * denominator);
        let half = Rational::new(i64::try_from(quarters).ok()?, 2)?;
        Some(Self {
            quarters: u8::try_from(quarters.rem_euclid(4)).ok()?,
            rest: c - &half,
        })
    }
}

/// asin √s as a multiple of π.
fn inverse_sine(s: &Rational) -> Option<Rational> {
    let (numerator, denominator) = match s.to_fraction()? {
        (0, 1) => (0, 1),
        (1, 4) => (1, 6),
        (1, 2) => (1, 4),
        (3, 4) => (1, 3),
        (1, 1) => (1, 2),
        _ => return None,
    };
    Rational::new(numerator, denominator)
}

/// atan √s as a multiple of π.
fn inverse_tangent(s: &Rational) -> Option<Rational> {
    let (numerator, denominator) = match s.to_fraction()? {
        (0, 1) => (0, 1),
        (1, 3) => (1, 6),
        (1, 1) => (1, 4),
        (3, 1) => (1, 3),
        _ => return None,
    };
    Rational::new(numerator, denominator)
}
