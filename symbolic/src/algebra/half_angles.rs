//! Quotients by sin² x in functions of the half angle, 1 − cos x = 2 sin² ½x and 1 + cos x = 2 cos² ½x:
//!
//! N(cos x) / sin² x = Q(cos x) + N(1) / (4 sin² ½x) + N(−1) / (4 cos² ½x),
//! (P(cos x) / sin x)² = (sin x Q(cos x) + ½ P(1) cot ½x + ½ P(−1) tan ½x)².
//!
//! The numerator of an effective potential, P² with P = C − K cos x, cancels at a pole where constants are equal, and with it half
//! of the digits nearby; in partial fractions nothing does. These have the shortest derivatives. Where P vanishes between the
//! poles their sum cancels, though, and its error is that of their terms, however small P² is: the square is what has all digits
//! everywhere, and values are evaluated by it.
//!
//! Where N(±1) or P(±1) is made of parameters alone and vanishes, the quotient is 0 at the pole, too: a number times
//! 1 − signum² N is added to its divisor. In partial fractions of a square it is 1, since N and its derivatives by parameters are 0;
//! of what is evaluated, whose derivatives dual numbers take, it is so small that it changes no divisor that is not 0.

#[cfg(test)]
mod tests;

use std::collections::BTreeMap;

use crate::{Expression, Graph, Node, Rational, Symbol, Unary};

/// How quotients by sin² x are written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum HalfAngleForm {
    /// In partial fractions, to be differentiated.
    PartialFractions,
    /// As squares where they are squares, to be evaluated.
    Squares,
}

impl Graph {
    /// Writes expressions in functions of half the angle `x`, if one of them has a pole that can be removed; says whether one
    /// has.
    pub(crate) fn write_in_half_angles(
        &mut self,
        expressions: &mut [Expression],
        x: Symbol,
        form: HalfAngleForm,
    ) -> bool {
        let angle = HalfAngle::of(self, x);
        let mut written = expressions.to_vec();
        let mut found = false;
        for expression in &mut written {
            found |= angle.resolve_poles(self, expression, form);
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
    fn resolve_poles(
        &self,
        graph: &mut Graph,
        expression: &mut Expression,
        form: HalfAngleForm,
    ) -> bool {
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
        let resolved = match form {
            HalfAngleForm::Squares => self
                .squares(graph, &numerators)
                .or_else(|| self.times_cosines(graph, &numerators)),
            HalfAngleForm::PartialFractions => None,
        };
        let resolved = resolved.or_else(|| {
            let numerator = graph.sum(numerators);
            let numerator = graph.product([(numerator, Rational::ONE)]);
            self.partial_fractions(graph, numerator, form)
        });
        let Some(resolved) = resolved else {
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
    fn partial_fractions(
        &self,
        graph: &mut Graph,
        numerator: Expression,
        form: HalfAngleForm,
    ) -> Option<Expression> {
        let by_power = self.powers_of_cosine(graph, numerator)?;
        if by_power.keys().all(|power| *power == 0) {
            return None;
        }
        let mut terms = vec![(self.quotient(graph, by_power), Rational::ONE)];
        for (at_pole, function, _) in self.at_poles(graph, numerator) {
            let quotient = share(graph, at_pole, &Rational::new(1, 4)?);
            let square = graph.square(function);
            let divisor = guarded(graph, at_pole, square, form);
            terms.push((graph.divide(quotient, divisor), Rational::ONE));
        }
        Some(graph.sum(terms))
    }

    /// The sum of numerators over sin² x where each is the square of a polynomial in cos x times what does not depend on x, one
    /// of them contains x, and all have the same sign, so that no poles cancel between them.
    fn squares(
        &self,
        graph: &mut Graph,
        numerators: &[(Expression, Rational)],
    ) -> Option<Expression> {
        let (_, first) = numerators.first()?;
        if numerators
            .iter()
            .any(|(_, coefficient)| coefficient.is_negative() != first.is_negative())
        {
            return None;
        }
        let mut terms = Vec::new();
        let mut varies = false;
        for (numerator, coefficient) in numerators {
            let (weight, polynomial) = self.weighted_square(graph, *numerator)?;
            let by_power = self.powers_of_cosine(graph, polynomial)?;
            varies |= by_power.keys().any(|power| *power > 0);
            let root = self.over_sine(graph, polynomial, by_power);
            let square = graph.square(root);
            terms.push((graph.multiply(weight, square), coefficient.clone()));
        }
        varies.then(|| graph.sum(terms))
    }

    /// w and P of N = w P², where w does not depend on x.
    fn weighted_square(
        &self,
        graph: &mut Graph,
        numerator: Expression,
    ) -> Option<(Expression, Expression)> {
        let (mut weight, mut root) = (Vec::new(), Vec::new());
        for (base, exponent) in factors(graph, numerator) {
            if graph.contains(&[base], |symbol| symbol == self.symbol) {
                let half = &exponent * &Rational::HALF;
                half.to_integer().filter(|half| *half > 0)?;
                root.push((base, half));
            } else {
                weight.push((base, exponent));
            }
        }
        Some((graph.product(weight), graph.product(root)))
    }

    /// P / sin x of a polynomial P in cos x.
    fn over_sine(
        &self,
        graph: &mut Graph,
        polynomial: Expression,
        by_power: BTreeMap<i64, Expression>,
    ) -> Expression {
        let quotient = self.quotient(graph, by_power);
        let mut terms = vec![(graph.multiply(self.sine, quotient), Rational::ONE)];
        for (at_pole, function, other) in self.at_poles(graph, polynomial) {
            let quotient = share(graph, at_pole, &Rational::HALF);
            let dividend = graph.multiply(quotient, other);
            let divisor = guarded(graph, at_pole, function, HalfAngleForm::Squares);
            terms.push((graph.divide(dividend, divisor), Rational::ONE));
        }
        graph.sum(terms)
    }

    /// A single numerator over sin² x, in partial fractions without its factors cos x, which have no zero at a pole: beside
    /// cos x = 0 they are small, and partial fractions of the product are not.
    fn times_cosines(
        &self,
        graph: &mut Graph,
        numerators: &[(Expression, Rational)],
    ) -> Option<Expression> {
        let [(numerator, coefficient)] = numerators else {
            return None;
        };
        let mut factors = factors(graph, *numerator);
        let place = factors.iter().position(|(base, _)| *base == self.cosine)?;
        let (_, exponent) = factors.remove(place);
        exponent.to_integer().filter(|power| *power > 0)?;
        let rest = graph.product(factors);
        let resolved = self.partial_fractions(graph, rest, HalfAngleForm::Squares)?;
        let cosines = graph.power(self.cosine, &exponent);
        let product = graph.multiply(cosines, resolved);
        Some(graph.scale(product, coefficient))
    }

    /// Q of a polynomial N = (1 − u²) Q + R in u = cos x, with R of degree one.
    fn quotient(&self, graph: &mut Graph, by_power: BTreeMap<i64, Expression>) -> Expression {
        let mut terms = Vec::new();
        for (power, coefficient) in by_power {
            let mut lower = power - 2;
            while lower >= 0 {
                let cosine = graph.power(self.cosine, &Rational::integer(lower));
                terms.push((graph.multiply(coefficient, cosine), Rational::MINUS_ONE));
                lower -= 2;
            }
        }
        graph.sum(terms)
    }

    /// The values of a polynomial at cos x = 1 and −1, with the functions of half the angle that vanish and do not vanish there.
    fn at_poles(
        &self,
        graph: &mut Graph,
        polynomial: Expression,
    ) -> [(Expression, Expression, Expression); 2] {
        let (zero, pi) = (graph.zero(), graph.pi());
        let (sine, cosine) = (self.half_sine, self.half_cosine);
        [(zero, sine, cosine), (pi, cosine, sine)].map(|(pole, function, other)| {
            let place = BTreeMap::from([(self.symbol, pole)]);
            let at_pole = graph.substitute(&[polynomial], &place)[0];
            (graph.simplest(at_pole), function, other)
        })
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
            let mut factors = factors(graph, monomial);
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

/// The factors of a product, or one.
fn factors(graph: &Graph, expression: Expression) -> Vec<(Expression, Rational)> {
    match graph.node(expression) {
        Node::Product(factors) => factors.to_vec(),
        _ => vec![(expression, Rational::ONE)],
    }
}

/// A part of what is at a pole.
fn share(graph: &mut Graph, at_pole: Expression, part: &Rational) -> Expression {
    let quotient = graph.scale(at_pole, part);
    if graph.contents(at_pole).varies() {
        return quotient;
    }
    // The numbers in it do not spread.
    graph.opaque(quotient)
}

/// A divisor, and where a numerator made of parameters is 0, its sum with a number.
fn guarded(
    graph: &mut Graph,
    numerator: Expression,
    divisor: Expression,
    form: HalfAngleForm,
) -> Expression {
    if graph.contents(numerator).varies() {
        return divisor;
    }
    let guard = graph.guard(numerator);
    let guard = match form {
        HalfAngleForm::PartialFractions => guard,
        HalfAngleForm::Squares => {
            let guard = graph.scale(guard, &small());
            // The number is no factor of the quotient, whose square would have no value in single precision.
            graph.opaque(guard)
        }
    };
    graph.add(divisor, guard)
}

/// 2⁻¹²⁰, whose reciprocal single precision has, too.
fn small() -> Rational {
    let power = Rational::HALF.power(120);
    power.unwrap_or(Rational::ONE)
}
