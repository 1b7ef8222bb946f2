//! Powers and logarithms of what grows exponentially: of sums of exponentials, of hyperbolic cosines, and of products of
//! these, by the logarithm of what they grow like, which `scaled_sum.rs` finds.

use crate::algebra::growth::{Growing, Scaled};
use crate::{Binary, Expression, Graph, Node, Rational, Unary};

/// Π xᵢ^kᵢ, as pairs (xᵢ, kᵢ).
type Factors = Vec<(Expression, Rational)>;

impl Graph {
    /// The factors of a negative power of a sum with exponential terms.
    pub(crate) fn distribute_over_exponentials(
        &mut self,
        base: Expression,
        exponent: &Rational,
    ) -> Option<Factors> {
        if self.leaves_exponentials || !exponent.is_negative() {
            return None;
        }
        if !(self.has_exponential || self.has_hyperbolic) {
            return None;
        }
        let Scaled { scale, power, rest } = self.scaled(base)?;
        let power = self.growing_power(scale, &(&power * exponent));
        Some(vec![power, (rest, exponent.clone())])
    }

    /// What is growing to a power, as a power.
    pub(super) fn growing_power(
        &mut self,
        scale: Growing,
        exponent: &Rational,
    ) -> (Expression, Rational) {
        let (base, exponent) = match scale {
            Growing::Exponential(u) => {
                let power = self.scale(u, exponent);
                (self.unary(Unary::Exp, power), Rational::ONE)
            }
            Growing::OneMore(u) => (self.logistic_complement(u), -exponent),
            Growing::Cosine(u) => (self.unary(Unary::Sech, u), -exponent),
        };
        (base, exponent)
    }

    /// The logarithm of what is growing.
    pub(super) fn growing_logarithm(&mut self, scale: Growing) -> Expression {
        match scale {
            Growing::Exponential(u) => u,
            Growing::OneMore(u) => self.unary(Unary::Softplus, u),
            Growing::Cosine(u) => self.unary(Unary::LogCosh, u),
        }
    }

    /// ln x by the logarithms of the factors of x that grow, where it has some.
    pub(crate) fn logarithm_of_growing(&mut self, x: Expression) -> Option<Expression> {
        if self.leaves_exponentials || !(self.has_exponential || self.has_hyperbolic) {
            return None;
        }
        let (parts, rest) = match self.node(x) {
            Node::Sum(terms) if terms.len() == 1 => {
                let (y, number) = terms[0].clone();
                if number.is_negative() || self.logarithm_of_growing(y).is_none() {
                    return None;
                }
                let number = self.constant(&number);
                return Some(self.sum_of_logarithms(&[number, y]));
            }
            Node::Sum(_) => {
                let Scaled { scale, power, rest } = self.scaled(x)?;
                (vec![(scale, power)], rest)
            }
            Node::Product(factors) => {
                let factors = factors.clone();
                let mut parts = Vec::new();
                let mut others = Vec::new();
                for (base, exponent) in factors {
                    match self.growing(base) {
                        Some((scale, sign)) => parts.push((scale, &exponent * &sign)),
                        None => others.push((base, exponent)),
                    }
                }
                (parts, self.product(others))
            }
            _ => {
                let (scale, sign) = self.growing(x)?;
                (vec![(scale, sign)], self.one())
            }
        };
        if parts.is_empty() {
            return None;
        }
        let mut terms = Vec::new();
        for (scale, exponent) in parts {
            terms.push((self.growing_logarithm(scale), exponent));
        }
        terms.push((self.unary(Unary::Ln, rest), Rational::ONE));
        Some(self.sum(terms))
    }

    /// arctan(c·eᵘ) as the angle of the point (σ(−u), c·σ(u)), for a number c.
    pub(crate) fn angle_of_exponential(&mut self, x: Expression) -> Option<Expression> {
        let (power, number) = match self.node(x) {
            Node::Sum(terms) if terms.len() == 1 => terms[0].clone(),
            _ => (x, Rational::ONE),
        };
        let u = self.exponent(power).filter(|_| !self.leaves_exponentials)?;
        let logistic = self.unary(Unary::Logistic, u);
        let above = self.scale(logistic, &number);
        let beside = self.logistic_complement(u);
        Some(self.binary(Binary::Atan2, above, beside))
    }

    fn sum_of_logarithms(&mut self, factors: &[Expression]) -> Expression {
        let mut terms = Vec::new();
        for x in factors {
            terms.push((self.unary(Unary::Ln, *x), Rational::ONE));
        }
        self.sum(terms)
    }

    /// A function that grows, and the sign of its exponent.
    fn growing(&mut self, x: Expression) -> Option<(Growing, Rational)> {
        match *self.node(x) {
            Node::Unary(Unary::Exp, u) if self.contents(u).varies() => {
                Some((Growing::Exponential(u), Rational::ONE))
            }
            Node::Unary(Unary::Cosh, u) => Some((Growing::Cosine(u), Rational::ONE)),
            Node::Unary(Unary::Sech, u) => Some((Growing::Cosine(u), Rational::MINUS_ONE)),
            Node::Unary(Unary::Logistic, u) => {
                let opposite = self.negate(u);
                Some((Growing::OneMore(opposite), Rational::MINUS_ONE))
            }
            _ => None,
        }
    }

    /// x^y of a base that grows, for an exponent that is no number.
    pub(crate) fn power_of_growing(&mut self, x: Expression, y: Expression) -> Option<Expression> {
        if self.leaves_exponentials || !(self.has_exponential || self.has_hyperbolic) {
            return None;
        }
        let (scale, sign, rest) = if let Node::Sum(_) = self.node(x) {
            let Scaled { scale, power, rest } = self.scaled(x)?;
            (scale, power, rest)
        } else {
            let (scale, sign) = self.growing(x)?;
            (scale, sign, self.one())
        };
        let logarithm = self.growing_logarithm(scale);
        let exponent = self.multiply(y, logarithm);
        let exponent = self.scale(exponent, &sign);
        let power = self.unary(Unary::Exp, exponent);
        let rest = self.binary(Binary::Power, rest, y);
        Some(self.multiply(power, rest))
    }
}
