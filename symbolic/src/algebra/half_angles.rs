//! Quotients by sin² x in partial fractions of the half angle, 1 − cos x = 2 sin² ½x and 1 + cos x = 2 cos² ½x:
//!
//! N(cos x) / sin² x = Q(cos x) + N(1) / (4 sin² ½x) + N(−1) / (4 cos² ½x).
//!
//! The numerator of an effective potential, (C − K cos x)², cancels at a pole where constants are equal, and with it half of
//! the digits nearby; in partial fractions nothing does. Where N(±1) is made of parameters alone and vanishes, the quotient is
//! 0: its divisor is then sin² ½x + 1, by 1 − signum² N, which is 0 for all other N and in derivatives.

use std::collections::BTreeMap;

use crate::{Expression, Graph, Node, Rational, Symbol, Unary};

impl Graph {
    /// Writes expressions in functions of half the angle `x`, if one of them has a pole that can be removed; says whether one
    /// has.
    pub(crate) fn write_in_half_angles(
        &mut self,
        expressions: &mut [Expression],
        x: Symbol,
    ) -> bool {
        let angle = HalfAngle::of(self, x);
        let mut written = expressions.to_vec();
        let mut found = false;
        for expression in &mut written {
            found |= angle.resolve_poles(self, expression);
        }
        if found {
            let whole = angle.whole(self);
            expressions.copy_from_slice(&self.replace(&written, &whole));
        }
        found
    }
}

/// An angle, and the functions of it and of its half.
pub(crate) struct HalfAngle {
    symbol: Symbol,
    pub(crate) sine: Expression,
    pub(crate) cosine: Expression,
    half_sine: Expression,
    half_cosine: Expression,
}

impl HalfAngle {
    pub(crate) fn of(graph: &mut Graph, symbol: Symbol) -> Self {
        let x = graph.symbol(symbol);
        let half = graph.scale(x, &Rational::HALF);
        Self {
            symbol,
            sine: graph.unary(Unary::Sin, x),
            cosine: graph.unary(Unary::Cos, x),
            half_sine: graph.unary(Unary::Sin, half),
            half_cosine: graph.unary(Unary::Cos, half),
        }
    }

    /// What the functions of the whole angle are: sin x = 2 sin ½x cos ½x and cos x = 1 − 2 sin² ½x.
    fn whole(&self, graph: &mut Graph) -> BTreeMap<Expression, Expression> {
        let product = graph.multiply(self.half_sine, self.half_cosine);
        let sine = graph.scale(product, &Rational::integer(2));
        let square = graph.square(self.half_sine);
        let cosine = graph.sum([
            (graph.one(), Rational::ONE),
            (square, Rational::integer(-2)),
        ]);
        BTreeMap::from([(self.sine, sine), (self.cosine, cosine)])
    }

    /// Replaces the terms of a sum that have a removable pole; whether there is one.
    fn resolve_poles(&self, graph: &mut Graph, expression: &mut Expression) -> bool {
        let terms = match graph.node(*expression) {
            Node::Sum(terms) => terms.to_vec(),
            _ => vec![(*expression, Rational::ONE)],
        };
        let (mut numerators, mut rest) = (Vec::new(), Vec::new());
        for (term, coefficient) in terms {
            match self.numerator(graph, term) {
                Some(numerator) => numerators.push((numerator, coefficient)),
                None => rest.push((term, coefficient)),
            }
        }
        let numerator = graph.sum(numerators);
        let numerator = graph.product([(numerator, Rational::ONE)]);
        let Some(resolved) = self.partial_fractions(graph, numerator) else {
            return false;
        };
        rest.push((resolved, Rational::ONE));
        *expression = graph.sum(rest);
        true
    }

    /// The numerator of a quotient by sin² x, multiplied out of the other terms; none for other terms.
    pub(crate) fn numerator(&self, graph: &mut Graph, term: Expression) -> Option<Expression> {
        let Node::Product(factors) = graph.node(term) else {
            return None;
        };
        let mut factors = factors.to_vec();
        let place = factors.iter().position(|(base, _)| *base == self.sine)?;
        if factors.remove(place).1 != Rational::integer(-2) {
            return None;
        }
        Some(graph.product(factors))
    }

    /// N / sin² x, if N is a polynomial in cos x and contains it.
    fn partial_fractions(&self, graph: &mut Graph, numerator: Expression) -> Option<Expression> {
        let by_power = self.powers_of_cosine(graph, numerator)?;
        if by_power.keys().all(|power| *power == 0) {
            return None;
        }
        let mut terms = Vec::new();
        for (power, coefficient) in by_power {
            let mut lower = power - 2;
            while lower >= 0 {
                let cosine = graph.power(self.cosine, &Rational::integer(lower));
                terms.push((graph.multiply(coefficient, cosine), Rational::MINUS_ONE));
                lower -= 2;
            }
        }
        let zero = graph.zero();
        let pi = graph.pi();
        for (pole, function) in [(zero, self.half_sine), (pi, self.half_cosine)] {
            let at_pole = graph.substitute(&[numerator], &BTreeMap::from([(self.symbol, pole)]))[0];
            let at_pole = graph.simplest(at_pole);
            let quarter = Rational::new(1, 4)?;
            let mut quotient = graph.scale(at_pole, &quarter);
            if !graph.contents(at_pole).varies() {
                // The numbers in it do not spread.
                quotient = graph.opaque(quotient);
            }
            let divisor = divisor(graph, at_pole, function);
            terms.push((graph.divide(quotient, divisor), Rational::ONE));
        }
        Some(graph.sum(terms))
    }

    /// The coefficients of a polynomial in cos x, by exponent; none where x occurs otherwise.
    pub(crate) fn powers_of_cosine(
        &self,
        graph: &mut Graph,
        polynomial: Expression,
    ) -> Option<BTreeMap<i64, Expression>> {
        let monomials = graph.monomials(polynomial)?;
        let mut by_power: BTreeMap<i64, Vec<(Expression, Rational)>> = BTreeMap::new();
        for (monomial, number) in monomials {
            let mut factors = match graph.node(monomial) {
                Node::Product(factors) => factors.to_vec(),
                _ => vec![(monomial, Rational::ONE)],
            };
            let mut power = 0;
            if let Some(place) = factors.iter().position(|(base, _)| *base == self.cosine) {
                power = factors
                    .remove(place)
                    .1
                    .to_integer()
                    .filter(|power| *power > 0)?;
            }
            let coefficient = graph.product(factors);
            if graph.contains(&[coefficient], |symbol| symbol == self.symbol) {
                return None;
            }
            by_power
                .entry(power)
                .or_default()
                .push((coefficient, number));
        }
        let sums = by_power.into_iter();
        Some(
            sums.map(|(power, terms)| (power, graph.sum(terms)))
                .collect(),
        )
    }
}

/// f², or f² + 1 where a numerator made of parameters is 0.
fn divisor(graph: &mut Graph, numerator: Expression, function: Expression) -> Expression {
    let square = graph.square(function);
    if graph.contents(numerator).varies() {
        return square;
    }
    let guard = graph.guard(numerator);
    graph.add(square, guard)
}
