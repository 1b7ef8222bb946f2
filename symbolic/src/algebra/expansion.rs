//! Expansion into polynomials, where that makes an expression cheaper.
//!
//! The normal form never expands products, which bounds expression swell (Geddes, Czapor and Labahn, Algorithms
//! for Computer Algebra, 1992, chapter 3, on normal forms). What cancels only in
//! expanded form, such as sin²ψ·c + cos²ψ·c across two products, is found here: a small expression is expanded
//! over its subexpressions that are neither sums nor products, the rules of sums are applied, and the result is
//! taken only if it costs less.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use crate::limits::{HIGHEST_EXPANDED_POWER, MAX_EXPANDED_TERMS};
use crate::{Expression, Graph, Node, Pass, Rational};

/// Σ cᵢ·mᵢ with monomials (products of powers) mᵢ.
pub(crate) type Polynomial = BTreeMap<Expression, Rational>;

impl Graph {
    /// The cheapest of `expression`, its factored form, and both expanded.
    #[must_use]
    pub fn simplest(&mut self, expression: Expression) -> Expression {
        let mut candidates = vec![expression, self.factored(expression)];
        if let Some(expanded) = self.expanded(expression) {
            candidates.extend([expanded, self.factored(expanded)]);
        }
        candidates
            .into_iter()
            .min_by_key(|candidate| self.cost(&[*candidate]))
            .unwrap_or(expression)
    }

    /// A sum as the product of its common factors and the rest.
    #[must_use]
    pub fn factored(&mut self, expression: Expression) -> Expression {
        self.product([(expression, Rational::ONE)])
    }

    /// `expression` as a sum of monomials, unless there are too many.
    fn expanded(&mut self, expression: Expression) -> Option<Expression> {
        if !self.passes.has(Pass::Expansion) {
            return None;
        }
        let terms = self.monomials(expression)?;
        Some(self.sum(terms))
    }

    /// `expression` as Σ cᵢ·mᵢ with products of powers mᵢ, unless there are too many.
    pub(crate) fn monomials(&mut self, expression: Expression) -> Option<Polynomial> {
        let parts = self.descendants(&[expression]);
        if parts.iter().any(|part| self.swollen.contains(part)) {
            return None;
        }
        let mut polynomials = BTreeMap::new();
        for part in parts {
            let Some(polynomial) = self.polynomial(part, &polynomials) else {
                self.swollen.insert(part);
                return None;
            };
            polynomials.insert(part, polynomial);
        }
        polynomials.remove(&expression)
    }

    /// A part of an expression as a polynomial, from the polynomials of its operands, unless it has too many terms.
    fn polynomial(
        &mut self,
        part: Expression,
        polynomials: &BTreeMap<Expression, Polynomial>,
    ) -> Option<Polynomial> {
        let polynomial = match self.node(part).clone() {
            Node::Constant(value) => Polynomial::from([(self.one(), value)]),
            Node::Sum(terms) => {
                let mut total = Polynomial::new();
                for (x, c) in terms {
                    add_multiple(&mut total, polynomials.get(&x)?, &c);
                }
                total
            }
            Node::Product(factors) => {
                let mut total = Polynomial::from([(self.one(), Rational::ONE)]);
                for (x, k) in factors {
                    total = self.expand_power(&total, x, &k, polynomials.get(&x)?)?;
                }
                total
            }
            Node::Pi
            | Node::Symbol(_)
            | Node::Unary(..)
            | Node::Binary(..)
            | Node::Application(..)
            | Node::Opaque(_) => Polynomial::from([(part, Rational::ONE)]),
        };
        (polynomial.len() <= MAX_EXPANDED_TERMS).then_some(polynomial)
    }

    /// A polynomial times x^k, where x is known as a polynomial.
    pub(crate) fn expand_power(
        &mut self,
        total: &Polynomial,
        x: Expression,
        exponent: &Rational,
        inner: &Polynomial,
    ) -> Option<Polynomial> {
        let repeats = exponent
            .to_integer()
            .filter(|k| (1..=HIGHEST_EXPANDED_POWER).contains(k));
        let (Some(repeats), true) = (repeats, inner.len() > 1) else {
            let power = self.power(x, exponent);
            let single = Polynomial::from([(power, Rational::ONE)]);
            return Some(self.multiply_polynomials(total, &single));
        };
        let mut product = total.clone();
        for _ in 0..repeats {
            if product.len() * inner.len() > 4 * MAX_EXPANDED_TERMS {
                return None;
            }
            product = self.multiply_polynomials(&product, inner);
        }
        Some(product)
    }

    fn multiply_polynomials(&mut self, left: &Polynomial, right: &Polynomial) -> Polynomial {
        let mut product = Polynomial::new();
        for (x, c) in left {
            for (y, d) in right {
                let monomial = self.multiply(*x, *y);
                match self.node(monomial) {
                    // A number that a power left in front.
                    Node::Sum(terms) if terms.len() == 1 => {
                        let (monomial, number) = &terms[0];
                        add_term(&mut product, *monomial, &(c * d) * number);
                    }
                    _ => add_term(&mut product, monomial, c * d),
                }
            }
        }
        product
    }
}

/// total += factor · other.
fn add_multiple(total: &mut Polynomial, other: &Polynomial, factor: &Rational) {
    for (x, c) in other {
        add_term(total, *x, c * factor);
    }
}

/// total += term · x.
fn add_term(total: &mut Polynomial, x: Expression, term: Rational) {
    match total.entry(x) {
        Entry::Vacant(entry) => {
            if !term.is_zero() {
                entry.insert(term);
            }
        }
        Entry::Occupied(mut entry) => {
            let sum = entry.get() + &term;
            if sum.is_zero() {
                entry.remove();
            } else {
                entry.insert(sum);
            }
        }
    }
}
