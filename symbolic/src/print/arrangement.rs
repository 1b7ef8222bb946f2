//! Expressions arranged as a person writes them: expanded, what cancels cancelled, products of sines and cosines
//! joined, and common factors taken out again (a multivariate Horner scheme by the most frequent factor: Ceberio and
//! Kreinovich, Greedy algorithms for optimizing multivariate Horner schemes, 2004).
//!
//! The graph keeps expressions as they cost least to evaluate; this is about what is short to read. Of the expression
//! itself and its arrangements the one that is shortest in print is taken.

use std::collections::{BTreeMap, BTreeSet};

use crate::algebra::expansion::Polynomial;
use crate::limits::{MAX_ARRANGED_IN_FULL_LENGTH, MAX_ARRANGED_TERMS};
use crate::print::names::Letters;
use crate::{Expression, Graph, Node, Rational, Unary};

/// A monomial as a product of powers.
type Factors = Vec<(Expression, Rational)>;

impl Graph {
    /// The shortest way to write `expression`, where other expressions are called by their names in `letters`.
    #[must_use]
    pub fn arranged(&mut self, expression: Expression, letters: &Letters) -> Expression {
        self.shortest(expression, letters, 1)
    }

    /// The same, with the terms of each product of velocities together unless that is much longer.
    #[must_use]
    pub fn arranged_by_velocities(
        &mut self,
        expression: Expression,
        letters: &Letters,
    ) -> Expression {
        self.shortest(expression, letters, 2)
    }

    /// The shortest arrangement, where one by velocities may be so many times as long. It is taken where an exact test
    /// says that it is the same.
    fn shortest(&mut self, expression: Expression, letters: &Letters, margin: usize) -> Expression {
        if self.is_product_of_symbols(expression) {
            return expression;
        }
        let parts = self.descendants_above(expression, &BTreeSet::new());
        let names = letters.named();
        let names: BTreeSet<Expression> = names
            .filter(|named| *named != expression && parts.contains(named))
            .collect();
        let mut candidates = vec![(expression, margin)];
        let mut spaces = vec![&names];
        let none = BTreeSet::new();
        if !names.is_empty()
            && self.symbols_in_full(expression, letters) <= MAX_ARRANGED_IN_FULL_LENGTH
        {
            spaces.push(&none);
        }
        for atoms in spaces {
            let Some(polynomial) = self.monomials_over(expression, atoms) else {
                continue;
            };
            let polynomial = self.joined_circular(polynomial);
            candidates.push((self.by_velocities(&polynomial), 1));
            candidates.push((self.collected(polynomial), margin));
        }
        let quotient = self.as_single_quotient(expression);
        candidates.extend(quotient.map(|quotient| (quotient, margin)));
        let best = self.shortest_of(&candidates, letters);
        if best == expression {
            return expression;
        }
        let difference = self.subtract(best, expression);
        if self.is_zero(difference)
            || self.vanishes_over(difference, &names)
            || self.vanishes(&[difference])
        {
            best
        } else {
            expression
        }
    }

    /// Whether there is neither a sum outside of functions nor anything opaque, so that there is no other arrangement.
    fn is_product_of_symbols(&self, expression: Expression) -> bool {
        let parts = self.descendants_above(expression, &BTreeSet::new());
        parts.into_iter().all(|part| match self.node(part) {
            Node::Sum(terms) => terms.len() == 1,
            Node::Opaque(_) => false,
            _ => true,
        })
    }

    /// `expression` as Σ cᵢ·mᵢ, where `atoms` are not taken apart, unless there are too many terms.
    pub(crate) fn monomials_over(
        &mut self,
        expression: Expression,
        atoms: &BTreeSet<Expression>,
    ) -> Option<Polynomial> {
        let mut polynomials: BTreeMap<Expression, Polynomial> = BTreeMap::new();
        for part in self.descendants_above(expression, atoms) {
            let mut polynomial = Polynomial::new();
            match self.node(part).clone() {
                _ if part != expression && atoms.contains(&part) => {
                    polynomial.insert(part, Rational::ONE);
                }
                Node::Constant(value) => {
                    polynomial.insert(self.one(), value);
                }
                Node::Opaque(x) => polynomial.clone_from(polynomials.get(&x)?),
                Node::Sum(terms) => {
                    for (x, c) in terms {
                        add(&mut polynomial, polynomials.get(&x)?, &c);
                    }
                }
                Node::Product(factors) => {
                    polynomial.insert(self.one(), Rational::ONE);
                    for (x, k) in factors {
                        polynomial = self.expand_power(&polynomial, x, &k, polynomials.get(&x)?)?;
                    }
                }
                Node::Pi
                | Node::Symbol(_)
                | Node::Unary(..)
                | Node::Binary(..)
                | Node::Application(..) => {
                    polynomial.insert(part, Rational::ONE);
                }
            }
            if polynomial.len() > MAX_ARRANGED_TERMS {
                return None;
            }
            polynomials.insert(part, polynomial);
        }
        polynomials.remove(&expression)
    }

    /// The expressions that a polynomial over `atoms` is made of, operands first.
    pub(crate) fn descendants_above(
        &self,
        expression: Expression,
        atoms: &BTreeSet<Expression>,
    ) -> BTreeSet<Expression> {
        let mut found = BTreeSet::new();
        let mut open = vec![expression];
        while let Some(part) = open.pop() {
            if !found.insert(part) || (part != expression && atoms.contains(&part)) {
                continue;
            }
            match self.node(part) {
                Node::Sum(parts) | Node::Product(parts) => open.extend(parts.iter().map(|p| p.0)),
                Node::Opaque(x) => open.push(*x),
                _ => {}
            }
        }
        found
    }

    /// A polynomial with pairs of terms joined by sin²a + cos²a = 1 and by the addition theorems, as long as there
    /// are pairs.
    pub(crate) fn joined_circular(&mut self, mut polynomial: Polynomial) -> Polynomial {
        loop {
            let mut changed = false;
            let monomials: Vec<_> = polynomial.keys().copied().collect();
            for monomial in monomials {
                changed |= self.join_monomial(&mut polynomial, monomial);
            }
            if !changed {
                return polynomial;
            }
        }
    }

    /// Joins a monomial with another one, if there is one that fits.
    fn join_monomial(&mut self, polynomial: &mut Polynomial, monomial: Expression) -> bool {
        let Some(coefficient) = polynomial.get(&monomial).cloned() else {
            return false;
        };
        let factors = self.factors(monomial);
        let circular: Vec<_> = factors
            .iter()
            .filter_map(|(base, k)| match self.node(*base) {
                Node::Unary(function @ (Unary::Sin | Unary::Cos), angle)
                    if k.is_integer() && !k.is_negative() =>
                {
                    Some((*base, *function, *angle, k.clone()))
                }
                _ => None,
            })
            .collect();
        for (i, first) in circular.iter().enumerate() {
            if first.3 != Rational::ONE
                && self.join_squares(
                    polynomial,
                    &factors,
                    &coefficient,
                    (first.0, first.1, first.2),
                )
            {
                polynomial.remove(&monomial);
                return true;
            }
            for second in &circular[i + 1..] {
                let pair = [(first.0, first.1, first.2), (second.0, second.1, second.2)];
                if self.join_pair(polynomial, &factors, &coefficient, pair) {
                    polynomial.remove(&monomial);
                    return true;
                }
            }
        }
        false
    }

    /// c·m·f² with c·m·g², or with −c·m, where f² + g² = 1: adds what they are together, and removes the other.
    fn join_squares(
        &mut self,
        polynomial: &mut Polynomial,
        factors: &Factors,
        coefficient: &Rational,
        (base, function, angle): (Expression, Unary, Expression),
    ) -> bool {
        let other = match function {
            Unary::Sin => self.unary(Unary::Cos, angle),
            _ => self.unary(Unary::Sin, angle),
        };
        let two = Rational::integer(2);
        let rest = self.with_powers(factors, &[(base, -&two)]);
        let squared = self.with_powers(factors, &[(base, -&two), (other, two)]);
        if polynomial.get(&squared) == Some(coefficient) {
            polynomial.remove(&squared);
            add_term(polynomial, rest, coefficient);
            return true;
        }
        if polynomial.get(&rest) == Some(&-coefficient) {
            polynomial.remove(&rest);
            add_term(polynomial, squared, &-coefficient);
            return true;
        }
        false
    }

    /// c·m·f(a)·g(b) with ±c·m·f′(a)·g′(b) by an addition theorem: adds the one function, and removes the other term.
    fn join_pair(
        &mut self,
        polynomial: &mut Polynomial,
        factors: &Factors,
        coefficient: &Rational,
        [(f, of_a, a), (g, of_b, b)]: [(Expression, Unary, Expression); 2],
    ) -> bool {
        if a == b {
            return false;
        }
        let conjugate = |graph: &mut Self, function, angle| match function {
            Unary::Sin => graph.unary(Unary::Cos, angle),
            _ => graph.unary(Unary::Sin, angle),
        };
        let (f_other, g_other) = (conjugate(self, of_a, a), conjugate(self, of_b, b));
        let less = [(f, Rational::MINUS_ONE), (g, Rational::MINUS_ONE)];
        let mut swapped = less.to_vec();
        swapped.extend([(f_other, Rational::ONE), (g_other, Rational::ONE)]);
        let partner = self.with_powers(factors, &swapped);
        let Some(found) = polynomial.get(&partner).cloned() else {
            return false;
        };
        let same = found == *coefficient;
        if !same && found != -coefficient {
            return false;
        }
        // cos a cos b ± sin a sin b = cos(a ∓ b), and sin a cos b ± cos a sin b = sin(a ± b).
        let (function, sum, sign) = match (of_a, of_b) {
            (Unary::Cos, Unary::Cos) => (Unary::Cos, !same, true),
            (Unary::Sin, Unary::Sin) => (Unary::Cos, !same, same),
            (Unary::Sin, _) => (Unary::Sin, same, true),
            _ => (Unary::Sin, same, same),
        };
        let angle = if sum {
            self.add(a, b)
        } else {
            self.subtract(a, b)
        };
        let joined = self.unary(function, angle);
        let rest = self.with_powers(factors, &less);
        let mut factors = self.factors(rest);
        factors.push((joined, Rational::ONE));
        let product = self.product(factors);
        polynomial.remove(&partner);
        let coefficient = if sign {
            coefficient.clone()
        } else {
            -coefficient
        };
        let (product, number) = self.without_number(product);
        add_term(polynomial, product, &(&coefficient * &number));
        true
    }

    /// c·x as x and c.
    fn without_number(&self, x: Expression) -> (Expression, Rational) {
        match self.node(x) {
            Node::Sum(terms) if terms.len() == 1 => terms[0].clone(),
            Node::Constant(value) => (self.one(), value.clone()),
            _ => (x, Rational::ONE),
        }
    }

    fn with_powers(&mut self, factors: &Factors, others: &[(Expression, Rational)]) -> Expression {
        self.product(factors.iter().chain(others).cloned())
    }

    /// The terms with the same velocities together, each group with its coefficient collected.
    fn by_velocities(&mut self, polynomial: &Polynomial) -> Expression {
        let mut groups: BTreeMap<Factors, Polynomial> = BTreeMap::new();
        for (monomial, coefficient) in polynomial {
            let (moving, rest): (Factors, Factors) =
                self.factors(*monomial).into_iter().partition(|(base, _)| {
                    let contents = self.contents(*base);
                    contents.has_velocity() || contents.has_acceleration()
                });
            let rest = self.product(rest);
            let group = groups.entry(moving).or_default();
            add_term(group, rest, coefficient);
        }
        let mut terms = Vec::new();
        for (moving, group) in groups {
            let mut factors = moving;
            factors.push((self.collected(group), Rational::ONE));
            terms.push((self.product(factors), Rational::ONE));
        }
        self.sum(terms)
    }

    /// A polynomial with common factors taken out, the most frequent first.
    pub(crate) fn collected(&mut self, polynomial: Polynomial) -> Expression {
        let common = self.common(&polynomial);
        let inverse: Factors = common.iter().map(|(x, k)| (*x, -k)).collect();
        let mut rest: Polynomial = Polynomial::new();
        for (monomial, coefficient) in polynomial {
            let factors = self.factors(monomial);
            let divided = self.with_powers(&factors, &inverse);
            add_term(&mut rest, divided, &coefficient);
        }
        let mut terms = Vec::new();
        while let Some(group) = self.most_frequent(&rest) {
            rest.retain(|monomial, _| !group.contains_key(monomial));
            terms.push((self.collected(group), Rational::ONE));
        }
        terms.extend(rest);
        let sum = self.sum(terms);
        let mut factors = common;
        factors.push((sum, Rational::ONE));
        self.product(factors)
    }

    /// The powers that all terms have in common.
    fn common(&self, polynomial: &Polynomial) -> Factors {
        let mut monomials = polynomial.keys();
        let Some(first) = monomials.next() else {
            return Factors::new();
        };
        let mut common = self.factors(*first);
        for monomial in monomials {
            let factors: BTreeMap<_, _> = self.factors(*monomial).into_iter().collect();
            common.retain_mut(|(base, exponent)| {
                let other = factors.get(base);
                let shared = other.filter(|k| k.is_negative() == exponent.is_negative());
                if let Some(k) = shared.filter(|k| k.abs() < exponent.abs()) {
                    *exponent = k.clone();
                }
                shared.is_some()
            });
        }
        common.retain(|(base, _)| *base != self.one());
        common
    }

    /// The terms with the power that saves most when it is taken out of them, if it is worth the parentheses.
    fn most_frequent(&self, polynomial: &Polynomial) -> Option<Polynomial> {
        let mut terms: BTreeMap<(Expression, bool), Vec<Expression>> = BTreeMap::new();
        for monomial in polynomial.keys().filter(|x| **x != self.one()) {
            for (base, exponent) in self.factors(*monomial) {
                let sharing = terms.entry((base, exponent.is_negative())).or_default();
                sharing.push(*monomial);
            }
        }
        let mut best: Option<(usize, Polynomial)> = None;
        for sharing in terms.into_values().filter(|sharing| sharing.len() > 1) {
            let group: Polynomial = sharing
                .into_iter()
                .map(|monomial| (monomial, polynomial[&monomial].clone()))
                .collect();
            let common = self.common(&group);
            let weight: usize = common.iter().map(|(base, _)| self.weight(*base)).sum();
            let saved = weight * (group.len() - 1);
            let better = best.as_ref().is_none_or(|(most, _)| saved > *most);
            if saved > 0 && better {
                best = Some((saved, group));
            }
        }
        best.map(|(_, group)| group)
    }

    /// How long a factor is in print, roughly.
    fn weight(&self, base: Expression) -> usize {
        match self.node(base) {
            Node::Symbol(_) | Node::Pi | Node::Constant(_) => 1,
            _ => 3,
        }
    }
}

/// total += factor · other.
fn add(total: &mut Polynomial, other: &Polynomial, factor: &Rational) {
    for (x, c) in other {
        add_term(total, *x, &(c * factor));
    }
}

/// total += c·x.
fn add_term(total: &mut Polynomial, x: Expression, c: &Rational) {
    let sum = total.entry(x).or_insert(Rational::ZERO);
    *sum = &*sum + c;
    if sum.is_zero() {
        total.remove(&x);
    }
}
