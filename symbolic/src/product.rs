//! The normal form of products and of exact powers, Π xᵢ^kᵢ.
//!
//! The rules keep the semantics of real numbers: what is rewritten is equal wherever the original has
//! a value. (√x)² = x and x/x = 1 extend the domain; √(x²) = |x|; (xy)^k = x^k y^k only for integer k;
//! (−8)^⅓ has no value and stays as it is.

use crate::sum::{Split, combine};
use crate::{Expression, Graph, Node, Rational, Unary};

/// A product of more factors than this stays one factor of the product that contains it, as long sums
/// do. It is more than a formula written by hand has, so that quotients of those cancel.
const LONGEST_MERGED: usize = 16;

/// c·Π xᵢ^kᵢ.
type Opened = (Rational, Vec<(Expression, Rational)>);

impl Graph {
    /// Π xᵢ^kᵢ of pairs (xᵢ, kᵢ).
    pub fn product(
        &mut self,
        factors: impl IntoIterator<Item = (Expression, Rational)>,
    ) -> Expression {
        let mut coefficient = Rational::ONE;
        let mut pending: Vec<_> = factors.into_iter().collect();
        let mut settled = Vec::new();
        while !pending.is_empty() {
            while let Some((base, exponent)) = pending.pop() {
                if let Some((number, parts)) = self.open(base, &exponent) {
                    coefficient = &coefficient * &number;
                    pending.extend(parts);
                } else {
                    settled.push((base, exponent));
                }
            }
            let count = settled.len();
            combine(&mut settled);
            if settled.len() < count {
                // Where equal bases met, an exponent may have become one that opens: |x|·|x| = x².
                pending.append(&mut settled);
            }
        }
        if let Some((zero, _)) = settled.iter().find(|(base, _)| self.is_zero(*base)) {
            // What divides by zero has no value, 0/0 no more than 1/0, which stands for them all.
            return self.intern_product(vec![(*zero, Rational::MINUS_ONE)]);
        }
        let product = self.intern_product(settled);
        self.scale(product, &coefficient)
    }

    /// base^exponent in terms of what the base is made of, unless it is in normal form already.
    fn open(&mut self, base: Expression, exponent: &Rational) -> Option<Opened> {
        if exponent.is_zero() {
            return Some((Rational::ONE, Vec::new()));
        }
        match self.node(base) {
            Node::Constant(value) => Some((exact_power(value, exponent)?, Vec::new())),
            Node::Product(inner) if exponent.is_integer() => {
                if inner.len() > LONGEST_MERGED {
                    return None;
                }
                // (Π x^j)^k = Π x^(jk).
                let parts = inner.iter().map(|(x, j)| Some((*x, short(j * exponent)?)));
                Some((Rational::ONE, parts.collect::<Option<_>>()?))
            }
            Node::Product(inner) => {
                // Where x^j has a value with a real power, it is not negative, and so is x unless j
                // is even: (x^j)^k = |x|^(jk) or x^(jk).
                let [(x, j)] = &**inner else { return None };
                let (x, even, exponent) = (*x, j.is_even(), short(j * exponent)?);
                let base = if even { self.unary(Unary::Abs, x) } else { x };
                Some((Rational::ONE, vec![(base, exponent)]))
            }
            Node::Sum(_) if exponent.is_integer() && self.is_multiple(base) => {
                let Split {
                    number,
                    common,
                    rest,
                } = self.split(base);
                if number.is_long() {
                    return None;
                }
                // (c·Π x^j·y)^k = c^k·Π x^(jk)·y^k.
                let power = number.power(exponent.to_integer()?)?;
                let common = common
                    .into_iter()
                    .map(|(x, j)| Some((x, short(&j * exponent)?)));
                let mut parts = common.collect::<Option<Vec<_>>>()?;
                parts.push((rest, exponent.clone()));
                Some((power, parts))
            }
            Node::Unary(Unary::Abs, x) if exponent.is_even() => {
                Some((Rational::ONE, vec![(*x, exponent.clone())]))
            }
            _ => None,
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
    if value.is_one() {
        return Some(Rational::ONE);
    }
    if value.is_long() {
        return None;
    }
    let (numerator, denominator) = exponent.to_fraction()?;
    if denominator == 1 {
        return value.power(numerator);
    }
    if value.is_zero() {
        return (numerator > 0).then_some(Rational::ZERO);
    }
    value.root(denominator)?.power(numerator)
}

/// An exponent, unless it has grown beyond machine integers.
fn short(exponent: Rational) -> Option<Rational> {
    exponent.to_fraction().is_some().then_some(exponent)
}
