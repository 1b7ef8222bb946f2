//! Expressions with quotients in them as one quotient: a numerator over a product of denominators, in which squares of sine and
//! cosine add up and common factors cancel.
//!
//! (a/b + c)/(1 − d/b) is (a + b c)/(b − d), which is shorter to read where denominators stand within each other.

use std::collections::{BTreeMap, BTreeSet};

use crate::{Expression, Graph, Node, Rational};

/// A numerator, and the powers by which it is divided.
#[derive(Clone)]
struct Quotient {
    numerator: Expression,
    divisors: BTreeMap<Expression, Rational>,
}

impl Graph {
    /// The expression as one quotient, if there are divisors of more than one term in it; none where its terms are too many.
    pub(crate) fn as_single_quotient(&mut self, expression: Expression) -> Option<Expression> {
        let parts = self.descendants_above(expression, &BTreeSet::new());
        if !parts.iter().any(|part| self.is_divided_by_sums(*part)) {
            return None;
        }
        let mut quotients = BTreeMap::new();
        for part in parts {
            let quotient = match self.node(part).clone() {
                Node::Sum(terms) => self.quotient_of_sum(&terms, &quotients)?,
                Node::Product(factors) => self.quotient_of_product(&factors, &quotients)?,
                Node::Opaque(x) => quotients.get(&x).cloned()?,
                _ => Quotient {
                    numerator: part,
                    divisors: BTreeMap::new(),
                },
            };
            quotients.insert(part, quotient);
        }
        let whole = quotients.remove(&expression)?;
        Some(self.whole(&whole))
    }

    fn is_divided_by_sums(&self, part: Expression) -> bool {
        let Node::Product(factors) = self.node(part) else {
            return false;
        };
        let mut factors = factors.iter();
        factors.any(|(base, k)| {
            k.is_negative() && k.is_integer() && matches!(self.node(*base), Node::Sum(_))
        })
    }

    fn whole(&mut self, quotient: &Quotient) -> Expression {
        let divisors = quotient.divisors.iter().map(|(base, k)| (*base, -k));
        let divisors: Vec<_> = divisors.collect();
        let mut factors = self.factors(quotient.numerator);
        factors.extend(divisors);
        self.product(factors)
    }

    /// A numerator over divisors, without the factors that they have in common.
    fn cancelled(
        &mut self,
        numerator: Expression,
        mut divisors: BTreeMap<Expression, Rational>,
    ) -> Quotient {
        let mut rest = Vec::new();
        for (base, exponent) in self.factors_and_number(numerator) {
            let Some(below) = divisors.get(&base).cloned() else {
                rest.push((base, exponent));
                continue;
            };
            let difference = &exponent - &below;
            divisors.remove(&base);
            if difference.is_negative() {
                divisors.insert(base, -&difference);
            } else if !difference.is_zero() {
                rest.push((base, difference));
            }
        }
        Quotient {
            numerator: self.product(rest),
            divisors,
        }
    }

    /// A sum, expanded and collected.
    fn collected_sum(&mut self, sum: Expression) -> Option<Expression> {
        let polynomial = self.monomials_over(sum, &BTreeSet::new())?;
        let mut polynomial = self.joined_circular(polynomial);
        // Signs that most terms have stand before the sum.
        let negative = polynomial.values().filter(|c| c.is_negative()).count();
        let sign = if 2 * negative > polynomial.len() {
            Rational::MINUS_ONE
        } else {
            Rational::ONE
        };
        for coefficient in polynomial.values_mut() {
            *coefficient = &*coefficient * &sign;
        }
        let collected = self.collected(polynomial);
        let collected = self.with_common_sums(collected);
        Some(self.scale(collected, &sign))
    }

    /// A sum with the sums out of it that all of its terms have as a factor.
    fn with_common_sums(&mut self, x: Expression) -> Expression {
        let mut factors = Vec::new();
        for (base, k) in self.factors_and_number(x) {
            let terms = match self.node(base) {
                Node::Sum(terms) if terms.len() > 1 => terms.to_vec(),
                _ => Vec::new(),
            };
            let base = if terms.is_empty() {
                base
            } else {
                self.collected(terms.into_iter().collect())
            };
            factors.push((base, k));
        }
        self.product(factors)
    }

    /// The factors of a product or of a multiple of one, and the number.
    fn factors_and_number(&mut self, x: Expression) -> Vec<(Expression, Rational)> {
        match self.node(x).clone() {
            Node::Sum(terms) if terms.len() == 1 => {
                let number = self.constant(&terms[0].1);
                let mut factors = self.factors(terms[0].0);
                factors.push((number, Rational::ONE));
                factors
            }
            _ => self.factors(x),
        }
    }

    fn quotient_of_sum(
        &mut self,
        terms: &[(Expression, Rational)],
        quotients: &BTreeMap<Expression, Quotient>,
    ) -> Option<Quotient> {
        let mut divisors: BTreeMap<Expression, Rational> = BTreeMap::new();
        for (term, _) in terms {
            for (base, k) in &quotients.get(term)?.divisors {
                let most = divisors.entry(*base).or_insert(Rational::ZERO);
                if *k > *most {
                    *most = k.clone();
                }
            }
        }
        let mut numerators = Vec::new();
        for (term, coefficient) in terms {
            let quotient = quotients.get(term)?;
            let mut factors = vec![(quotient.numerator, Rational::ONE)];
            for (base, most) in &divisors {
                let own = quotient.divisors.get(base).unwrap_or(&Rational::ZERO);
                factors.push((*base, most - own));
            }
            numerators.push((self.product(factors), coefficient.clone()));
        }
        let numerator = self.sum(numerators);
        let numerator = self.collected_sum(numerator)?;
        Some(self.cancelled(numerator, divisors))
    }

    fn quotient_of_product(
        &mut self,
        factors: &[(Expression, Rational)],
        quotients: &BTreeMap<Expression, Quotient>,
    ) -> Option<Quotient> {
        let (mut above, mut divisors) = (Vec::new(), BTreeMap::new());
        let mut divide = |base: Expression, k: &Rational| {
            let total: &mut Rational = divisors.entry(base).or_insert(Rational::ZERO);
            *total = &*total + k;
        };
        for (base, exponent) in factors {
            let quotient = quotients.get(base)?;
            if !exponent.is_integer() {
                above.push((*base, exponent.clone()));
            } else if exponent.is_negative() {
                for (part, k) in self.factors_and_number(quotient.numerator) {
                    divide(part, &(&k * &exponent.abs()));
                }
                let back = quotient.divisors.iter();
                above.extend(back.map(|(part, k)| (*part, k * &exponent.abs())));
            } else {
                above.push((quotient.numerator, exponent.clone()));
                for (part, k) in &quotient.divisors {
                    divide(*part, &(k * exponent));
                }
            }
        }
        let numerator = self.product(above);
        Some(self.cancelled(numerator, divisors))
    }
}
