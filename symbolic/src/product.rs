//! The normal form of products and of exact powers, Π xᵢ^kᵢ.
//!
//! The rules keep the semantics of real numbers: what is rewritten is equal wherever the original has
//! a value. (√x)² = x and x/x = 1 extend the domain; √(x²) = |x|; (xy)^k = x^k y^k only for integer k;
//! (−8)^⅓ has no value and stays as it is.

use crate::sum::{Split, combine};
use crate::{Expression, Graph, Node, Rational, Unary};

impl Graph {
    /// Π xᵢ^kᵢ of pairs (xᵢ, kᵢ).
    pub fn product(
        &mut self,
        factors: impl IntoIterator<Item = (Expression, Rational)>,
    ) -> Expression {
        let mut coefficient = Rational::ONE;
        let mut merged = Vec::new();
        for (base, exponent) in factors {
            self.merge_factor(&mut coefficient, &mut merged, base, &exponent);
        }
        combine(&mut merged);
        self.settle(&mut coefficient, &mut merged);
        if coefficient.is_zero() {
            return self.zero();
        }
        let product = self.intern_product(merged);
        self.scale(product, &coefficient)
    }

    /// Multiplies by base^exponent: numbers into the coefficient, the rest into the factors.
    fn merge_factor(
        &mut self,
        coefficient: &mut Rational,
        factors: &mut Vec<(Expression, Rational)>,
        base: Expression,
        exponent: &Rational,
    ) {
        if exponent.is_zero() {
            return;
        }
        if !exponent.is_integer() {
            return self.merge_root(coefficient, factors, base, exponent);
        }
        // For an integer k: (c·x)^k = c^k·x^k, and (Π x^j)^k = Π x^(jk).
        let Split {
            number,
            common,
            rest,
        } = self.split(base);
        if let Some(power) = exponent.to_integer().and_then(|k| number.power(k)) {
            *coefficient = &*coefficient * &power;
        } else {
            let number = self.constant(&number);
            factors.push((number, exponent.clone()));
        }
        factors.extend(common.into_iter().map(|(x, j)| (x, &j * exponent)));
        match self.node(rest) {
            Node::Product(inner) => factors.extend(inner.iter().map(|(x, j)| (*x, j * exponent))),
            _ if rest == self.one() => {}
            _ => factors.push((rest, exponent.clone())),
        }
    }

    /// Multiplies by base^exponent for an exponent that is no integer.
    fn merge_root(
        &mut self,
        coefficient: &mut Rational,
        factors: &mut Vec<(Expression, Rational)>,
        base: Expression,
        exponent: &Rational,
    ) {
        if let Some(power) = self
            .as_constant(base)
            .and_then(|value| exact_power(value, exponent))
        {
            *coefficient = &*coefficient * &power;
            return;
        }
        if let Node::Product(inner) = self.node(base)
            && let [(x, j)] = &**inner
        {
            let (x, product) = (*x, j * exponent);
            if j.is_even() {
                // x² is never negative: (x^j)^k = |x|^(jk).
                let magnitude = self.unary(Unary::Abs, x);
                return self.merge_factor(coefficient, factors, magnitude, &product);
            }
            if !j.is_integer() {
                // Where x^j has a value, neither it nor x is negative.
                return self.merge_factor(coefficient, factors, x, &product);
            }
        }
        factors.push((base, exponent.clone()));
    }

    /// Resolves what merging equal bases has made exact: |x|² = x², 2^½·2^½ = 2.
    fn settle(&mut self, coefficient: &mut Rational, factors: &mut Vec<(Expression, Rational)>) {
        let unsettled =
            |graph: &Self, (base, exponent): &(Expression, Rational)| match graph.node(*base) {
                Node::Unary(Unary::Abs, _) => exponent.is_even(),
                Node::Constant(value) => exact_power(value, exponent).is_some(),
                Node::Sum(_) | Node::Product(_) => {
                    exponent.is_integer() && {
                        // A root that has become a whole power opens up: (√(2x+2))² = 2(x+1).
                        matches!(graph.node(*base), Node::Product(_)) || graph.is_multiple(*base)
                    }
                }
                _ => false,
            };
        while factors.iter().any(|factor| unsettled(self, factor)) {
            for (base, exponent) in core::mem::take(factors) {
                match *self.node(base) {
                    Node::Unary(Unary::Abs, x) if exponent.is_even() => {
                        self.merge_factor(coefficient, factors, x, &exponent);
                    }
                    Node::Constant(ref value) => match exact_power(value, &exponent) {
                        Some(power) => *coefficient = &*coefficient * &power,
                        None => factors.push((base, exponent)),
                    },
                    _ => self.merge_factor(coefficient, factors, base, &exponent),
                }
            }
            combine(factors);
        }
    }

    fn intern_product(&mut self, factors: Vec<(Expression, Rational)>) -> Expression {
        match factors.as_slice() {
            [] => self.one(),
            [(x, k)] if k.is_one() => *x,
            _ => self.intern(Node::Product(factors.into())),
        }
    }
}

/// value^exponent, if it is rational: an integer power, or an exact root of a positive number.
fn exact_power(value: &Rational, exponent: &Rational) -> Option<Rational> {
    let (numerator, denominator) = exponent.to_fraction()?;
    if denominator == 1 {
        return value.power(numerator);
    }
    if value.is_zero() {
        return (numerator > 0).then_some(Rational::ZERO);
    }
    value.root(denominator)?.power(numerator)
}
