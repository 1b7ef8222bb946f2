//! Sums of quotients by powers of one base, over their common denominator.
//!
//! a/x³ − b/x becomes (a − b x²)/x³ where that costs less: one division is left, and numerators meet in which squares of sine
//! and cosine add up. Common factors of the terms stand before the sum.

use std::collections::BTreeSet;

use crate::{Expression, Graph, Node, Rational};

/// A term of a sum.
type Term = (Expression, Rational);

impl Graph {
    /// The cheaper of a sum and of the same over common denominators.
    #[must_use]
    pub(crate) fn over_common_denominators(&mut self, expression: Expression) -> Expression {
        let mut cheapest = expression;
        for base in self.repeated_divisors(expression) {
            if let Some(joined) = self.over_common_powers(cheapest, base)
                && self.cost(&[joined]) < self.cost(&[cheapest])
            {
                cheapest = joined;
            }
        }
        cheapest
    }

    /// The bases by which several terms of a sum are divided.
    fn repeated_divisors(&self, sum: Expression) -> BTreeSet<Expression> {
        let (mut seen, mut repeated) = (BTreeSet::new(), BTreeSet::new());
        for (term, _) in self.terms(sum) {
            for (base, exponent) in self.factors(term) {
                let varies = self.contents(base).varies();
                if varies && exponent.is_negative() && !seen.insert(base) {
                    repeated.insert(base);
                }
            }
        }
        repeated
    }

    /// The terms of a sum that are divided by `base` as one quotient, beside the others.
    fn over_common_powers(&mut self, sum: Expression, base: Expression) -> Option<Expression> {
        let (divided, mut rest): (Vec<Term>, Vec<Term>) =
            self.terms(sum).into_iter().partition(|(term, _)| {
                let mut factors = self.factors(*term).into_iter();
                factors.any(|(other, exponent)| other == base && exponent.is_negative())
            });
        let common = self.factors_of_all(&divided);
        if divided.len() < 2 || common.is_empty() {
            return None;
        }
        let inverse: Vec<Term> = common.iter().map(|(x, k)| (*x, -k)).collect();
        let mut terms = Vec::new();
        for (term, coefficient) in divided {
            let factors = [(term, Rational::ONE)].into_iter().chain(inverse.clone());
            terms.push((self.product(factors), coefficient));
        }
        let numerator = self.sum(terms);
        let numerator = self.simplest(numerator);
        let whole = self.product(common.into_iter().chain([(numerator, Rational::ONE)]));
        rest.push((whole, Rational::ONE));
        Some(self.sum(rest))
    }

    /// The factors that all terms have, with the least of their exponents.
    fn factors_of_all(&self, terms: &[Term]) -> Vec<Term> {
        let bases: BTreeSet<Expression> = terms
            .iter()
            .flat_map(|(term, _)| self.factors(*term))
            .map(|(base, _)| base)
            .collect();
        let zero = Rational::ZERO;
        let least = bases.into_iter().map(|base| {
            let exponents = terms.iter().map(|(term, _)| {
                let mut factors = self.factors(*term).into_iter();
                let found = factors.find(|(other, _)| *other == base);
                found.map_or_else(|| zero.clone(), |(_, exponent)| exponent)
            });
            (base, exponents.min().unwrap_or_else(|| zero.clone()))
        });
        least.filter(|(_, exponent)| !exponent.is_zero()).collect()
    }

    /// An expression as a sum of multiples.
    pub(crate) fn terms(&self, expression: Expression) -> Vec<Term> {
        match self.node(expression) {
            Node::Sum(terms) => terms.to_vec(),
            _ => vec![(expression, Rational::ONE)],
        }
    }
}
