//! Intervals that enclose the values of expressions for all real values of their symbols (Moore, Interval Analysis, 1966).
//!
//! Bounds are exact numbers, so that a bound above zero is a proof. Nothing is assumed of a symbol: a parameter may be
//! negative. Operands count as independent, so that an enclosure may be wider than the range; it is never narrower.

use crate::limits::MIN_REMAINDER;
use crate::{Binary, Expression, Graph, Node, Rational, Unary};

/// The least part of the magnitudes of its terms that a sum keeps.
fn least_remainder() -> Rational {
    let (numerator, denominator) = MIN_REMAINDER;
    Rational::new(numerator, denominator).unwrap_or(Rational::ONE)
}

/// An interval; without a bound it is infinite on that side.
#[derive(Clone, PartialEq, Eq, Debug)]
struct Interval {
    least: Option<Rational>,
    most: Option<Rational>,
}

impl Graph {
    /// Whether an expression keeps away from zero while parameters keep their values, whatever real values they and all
    /// other symbols have, unless it is zero by the parameters alone; and whether so much is left of its terms that rounding
    /// errors grow by `MIN_REMAINDER` at most. False where that is not known.
    #[must_use]
    pub fn never_comes_to_vanish(&mut self, expression: Expression) -> bool {
        let mut inner = expression;
        while let Node::Opaque(operand) = self.node(inner) {
            inner = *operand;
        }
        let inner = self.factored(inner);
        let mut known = vec![Interval::ALL; inner.index() + 1];
        for descendant in self.descendants(&[inner]) {
            known[descendant.index()] = enclosure(self.node(descendant), &known);
        }
        match self.node(inner) {
            Node::Product(factors) => factors.iter().all(|(x, _)| self.remains(*x, &known)),
            _ => self.remains(inner, &known),
        }
    }

    /// The same for a factor, where enclosures are known.
    fn remains(&self, factor: Expression, known: &[Interval]) -> bool {
        if !self.contents(factor).varies() {
            return true;
        }
        let value = known[factor.index()].away_from_zero();
        let Some((value, sign)) = value else {
            return false;
        };
        let Node::Sum(terms) = self.node(factor) else {
            return true;
        };
        let terms = terms.iter();
        let terms = terms.map(|(x, coefficient)| known[x.index()].scaled(&(coefficient * &sign)));
        let terms: Vec<_> = terms.collect();
        if terms.iter().all(Interval::is_nonnegative) {
            return true;
        }
        let size = terms.iter().map(Interval::magnitude);
        let size = size.fold(Interval::from([Rational::ZERO; 2]), |sum, term| {
            sum.plus(&term)
        });
        let most = size.most.map(|most| &most * &least_remainder());
        most.zip(value.least)
            .is_some_and(|(most, least)| least >= most)
    }
}

/// The enclosure of a node, where those of its operands are known.
fn enclosure(node: &Node, known: &[Interval]) -> Interval {
    let of = |operand: &Expression| &known[operand.index()];
    match node {
        Node::Constant(number) => Interval::from([number.clone(), number.clone()]),
        Node::Pi => Interval::from([3, 4].map(Rational::integer)),
        Node::Sum(terms) => terms
            .iter()
            .map(|(x, coefficient)| of(x).scaled(coefficient))
            .fold(Interval::from([Rational::ZERO; 2]), |sum, term| {
                sum.plus(&term)
            }),
        Node::Product(factors) => factors
            .iter()
            .map(|(x, exponent)| of(x).power(exponent))
            .fold(Interval::from([Rational::ONE; 2]), |product, factor| {
                product.times(&factor)
            }),
        Node::Unary(Unary::Sin | Unary::Cos | Unary::Tanh, _) => {
            Interval::from([Rational::MINUS_ONE, Rational::ONE])
        }
        Node::Unary(Unary::Cosh, _) => Interval::from_least(Rational::ONE),
        Node::Unary(Unary::Exp | Unary::Softplus | Unary::LogCosh, _) => {
            Interval::from_least(Rational::ZERO)
        }
        Node::Unary(Unary::Logistic | Unary::Sech, _) => {
            Interval::from([Rational::ZERO, Rational::ONE])
        }
        Node::Unary(Unary::Abs, x) => of(x).magnitude(),
        Node::Binary(Binary::Min, x, y) => of(x).lesser(of(y)),
        Node::Binary(Binary::Max, x, y) => {
            let [x, y] = [x, y].map(|operand| of(operand).opposite());
            x.lesser(&y).opposite()
        }
        Node::Opaque(x) => of(x).clone(),
        Node::Symbol(_) | Node::Unary(..) | Node::Binary(..) | Node::Application(..) => {
            Interval::ALL
        }
    }
}

impl From<[Rational; 2]> for Interval {
    fn from([least, most]: [Rational; 2]) -> Self {
        Self {
            least: Some(least),
            most: Some(most),
        }
    }
}

impl Interval {
    const ALL: Self = Self {
        least: None,
        most: None,
    };

    fn from_least(least: Rational) -> Self {
        Self {
            least: Some(least),
            most: None,
        }
    }

    fn is_positive(&self) -> bool {
        let least = self.least.as_ref();
        least.is_some_and(|least| !least.is_negative() && !least.is_zero())
    }

    /// The interval or its opposite, whichever is positive, and the sign.
    fn away_from_zero(&self) -> Option<(Self, Rational)> {
        let opposite = self.opposite();
        if self.is_positive() {
            Some((self.clone(), Rational::ONE))
        } else if opposite.is_positive() {
            Some((opposite, Rational::MINUS_ONE))
        } else {
            None
        }
    }

    fn is_nonnegative(&self) -> bool {
        let least = self.least.as_ref();
        least.is_some_and(|least| !least.is_negative())
    }

    fn opposite(&self) -> Self {
        let negative = |bound: &Option<Rational>| bound.as_ref().map(|bound| -bound);
        Self {
            least: negative(&self.most),
            most: negative(&self.least),
        }
    }

    fn plus(&self, other: &Self) -> Self {
        let sum = |a: &Option<Rational>, b: &Option<Rational>| Some(a.as_ref()? + b.as_ref()?);
        Self {
            least: sum(&self.least, &other.least),
            most: sum(&self.most, &other.most),
        }
    }

    fn scaled(&self, factor: &Rational) -> Self {
        if factor.is_negative() {
            return self.opposite().scaled(&-factor);
        }
        let scaled = |bound: &Option<Rational>| bound.as_ref().map(|bound| bound * factor);
        Self {
            least: scaled(&self.least),
            most: scaled(&self.most),
        }
    }

    fn times(&self, other: &Self) -> Self {
        if self.opposite().is_nonnegative() {
            return self.opposite().times(other).opposite();
        }
        if other.opposite().is_nonnegative() {
            return self.times(&other.opposite()).opposite();
        }
        let product = |a: &Option<Rational>, b: &Option<Rational>| Some(a.as_ref()? * b.as_ref()?);
        if self.is_nonnegative() && other.is_nonnegative() {
            return Self {
                least: product(&self.least, &other.least),
                most: product(&self.most, &other.most),
            };
        }
        let corners = [&self.least, &self.most].map(|a| {
            let [first, second] = [&other.least, &other.most].map(|b| product(a, b));
            Some([first?, second?])
        });
        let [Some([a, b]), Some([c, d])] = corners else {
            return Self::ALL;
        };
        Self {
            least: [&a, &b, &c, &d].into_iter().min().cloned(),
            most: [&a, &b, &c, &d].into_iter().max().cloned(),
        }
    }

    fn magnitude(&self) -> Self {
        if self.is_nonnegative() {
            return self.clone();
        }
        if self.opposite().is_nonnegative() {
            return self.opposite();
        }
        let most = self.most.as_ref().zip(self.least.as_ref());
        Self {
            least: Some(Rational::ZERO),
            most: most.map(|(most, least)| most.clone().max(-least)),
        }
    }

    fn lesser(&self, other: &Self) -> Self {
        let most = match (&self.most, &other.most) {
            (Some(a), Some(b)) => Some(a.min(b).clone()),
            (most, None) | (None, most) => most.clone(),
        };
        let least = self.least.as_ref().zip(other.least.as_ref());
        Self {
            least: least.map(|(a, b)| a.min(b).clone()),
            most,
        }
    }

    fn power(&self, exponent: &Rational) -> Self {
        let Some(integer) = exponent.to_integer() else {
            // A root, which is not negative where it is real.
            return Self::from_least(Rational::ZERO);
        };
        if integer % 2 == 0 {
            return self.magnitude().nonnegative_power(integer);
        }
        if self.opposite().is_nonnegative() {
            return self.opposite().nonnegative_power(integer).opposite();
        }
        if self.is_nonnegative() {
            return self.nonnegative_power(integer);
        }
        if integer == 1 {
            self.clone()
        } else {
            Self::ALL
        }
    }

    /// A power of an interval without negative numbers.
    fn nonnegative_power(&self, exponent: i64) -> Self {
        let power = |bound: &Option<Rational>| bound.as_ref()?.power(exponent.checked_abs()?);
        let raised = Self {
            least: Some(power(&self.least).unwrap_or(Rational::ZERO)),
            most: power(&self.most),
        };
        if exponent >= 0 {
            return raised;
        }
        // The reciprocal; 1/0 is infinite.
        let reciprocal = |bound: &Option<Rational>| bound.as_ref()?.reciprocal();
        Self {
            least: Some(reciprocal(&raised.most).unwrap_or(Rational::ZERO)),
            most: reciprocal(&raised.least),
        }
    }
}
