//! Sums with exponential terms as the one that grows most, times a sum that is bounded where the coefficients are:
//! r + c·eᵘ = (1 + eᵘ)·(r·σ(−u) + c·σ(u)), and r + c·cosh u = cosh u·(r·sech u + c).

use crate::algebra::growth::{Growing, Scaled};
use crate::limits::MAX_SCALED_TERMS;
use crate::{Expression, Graph, Node, Rational, Unary};

/// A term c·Π·eᵘ of a sum.
struct Term {
    /// c·Π.
    coefficient: Expression,
    /// u, unless there is no exponential.
    exponent: Option<Expression>,
}

impl Graph {
    /// A sum with exponential terms by the one that grows most, as far as that is known.
    pub(super) fn scaled(&mut self, sum: Expression) -> Option<Scaled> {
        if !matches!(self.node(sum), Node::Sum(_)) {
            return None;
        }
        if let Some(known) = self.scales.get(&sum) {
            return known.clone();
        }
        let found = self.find_scaled(sum);
        self.scales.insert(sum, found.clone());
        found
    }

    fn find_scaled(&mut self, sum: Expression) -> Option<Scaled> {
        let Some(terms) = self.exponential_terms(sum) else {
            return self.scaled_by_cosine(sum);
        };
        let exponents = terms.iter().filter_map(|term| term.exponent);
        let exponents: Vec<Expression> = exponents.collect();
        let first = *exponents.first()?;
        // Of several multiples of one exponent the largest, so that the others become roots of its logistic function.
        let mut pivot = first;
        let mut most = Rational::ONE;
        for other in &exponents {
            if let Some(ratio) = self.ratio(*other, first).map(|ratio| ratio.abs())
                && ratio > most
            {
                (pivot, most) = (*other, ratio);
            }
        }
        if exponents.len() == terms.len() {
            return self.without_common_exponential(&terms, pivot);
        }
        let (mut with, mut without) = (Vec::new(), Vec::new());
        for term in terms {
            if term.exponent == Some(pivot) {
                with.push((term.coefficient, Rational::ONE));
            } else {
                let power = term.exponent.map(|u| self.unary(Unary::Exp, u));
                let power = power.unwrap_or(self.one());
                without.push((self.multiply(term.coefficient, power), Rational::ONE));
            }
        }
        let with = self.sum(with);
        let part = without.iter().position(|(x, _)| *x == with);
        let rest = if let Some(part) = part.filter(|_| without.len() > 1) {
            // c·(1 + eᵘ) and what is left.
            without.remove(part);
            let others = self.sum(without);
            let complement = self.logistic_complement(pivot);
            let others = self.multiply(others, complement);
            self.add(with, others)
        } else {
            let without = self.sum(without);
            self.between(without, with, pivot)
        };
        let scale = Growing::OneMore(pivot);
        Some(Scaled {
            scale,
            power: Rational::ONE,
            rest,
        })
    }

    /// A sum with hyperbolic sines and cosines by the highest power of a cosine that is as large.
    fn scaled_by_cosine(&mut self, sum: Expression) -> Option<Scaled> {
        let Node::Sum(terms) = self.node(sum) else {
            return None;
        };
        if !self.has_hyperbolic || terms.len() < 2 {
            return None;
        }
        let terms = terms.clone();
        let mut found: Option<(Expression, Rational)> = None;
        for (x, _) in &terms {
            let mut power = Rational::ZERO;
            let mut argument = found.as_ref().map(|(u, _)| *u);
            for (base, k) in self.factors(*x) {
                if let Node::Unary(Unary::Sinh | Unary::Cosh, u) = self.node(base)
                    && argument.is_none_or(|argument| argument == *u)
                    && k.is_integer()
                {
                    argument = Some(*u);
                    power = &power + &k;
                }
            }
            let most = found
                .as_ref()
                .map_or(Rational::ZERO, |(_, most)| most.clone());
            if let Some(u) = argument.filter(|_| power > most) {
                found = Some((u, power));
            }
        }
        let (u, power) = found.filter(|(u, _)| self.contents(*u).varies())?;
        let scale = Growing::Cosine(u);
        let [cosine, sine] = [Unary::Cosh, Unary::Sinh].map(|function| self.unary(function, u));
        let square = self.square(sine);
        // c + c·sinh² u.
        if let [(first, c), (second, d)] = &*terms
            && c == d
            && [(*first, *second), (*second, *first)].contains(&(self.one(), square))
        {
            let rest = self.constant(c);
            return Some(Scaled { scale, power, rest });
        }
        let mut divided = Vec::new();
        for (x, c) in &terms {
            let term = self.product([(*x, Rational::ONE), (cosine, -&power)]);
            divided.push((term, c.clone()));
        }
        let rest = self.sum(divided);
        Some(Scaled { scale, power, rest })
    }

    /// r·σ(−u) + c·σ(u).
    fn between(&mut self, r: Expression, c: Expression, u: Expression) -> Expression {
        if r == c {
            return r;
        }
        if self.negate(r) == c {
            // −r·tanh ½u.
            let half = self.scale(u, &Rational::HALF);
            let tangent = self.unary(Unary::Tanh, half);
            return self.multiply(c, tangent);
        }
        let complement = self.logistic_complement(u);
        let logistic = self.unary(Unary::Logistic, u);
        let [below, above] = [(r, complement), (c, logistic)].map(|(x, y)| self.multiply(x, y));
        self.add(below, above)
    }

    /// A sum of exponential terms alone: eᵘ·(c + Σ …), or a hyperbolic function.
    fn without_common_exponential(&mut self, terms: &[Term], pivot: Expression) -> Option<Scaled> {
        if let [first, second] = terms
            && let (Some(u), Some(v)) = (first.exponent, second.exponent)
            && self.negate(u) == v
        {
            let two = Rational::integer(2);
            if first.coefficient == second.coefficient {
                let rest = self.scale(first.coefficient, &two);
                let scale = Growing::Cosine(u);
                return Some(Scaled {
                    scale,
                    power: Rational::ONE,
                    rest,
                });
            }
            if self.negate(first.coefficient) == second.coefficient {
                let tangent = self.unary(Unary::Tanh, u);
                let rest = self.multiply(first.coefficient, tangent);
                let rest = self.scale(rest, &two);
                let scale = Growing::Cosine(u);
                return Some(Scaled {
                    scale,
                    power: Rational::ONE,
                    rest,
                });
            }
        }
        let mut divided = Vec::new();
        for term in terms {
            let difference = self.subtract(term.exponent?, pivot);
            let power = self.unary(Unary::Exp, difference);
            divided.push((self.multiply(term.coefficient, power), Rational::ONE));
        }
        let rest = self.sum(divided);
        let scale = Growing::Exponential(pivot);
        Some(Scaled {
            scale,
            power: Rational::ONE,
            rest,
        })
    }

    /// The terms of a sum of several, if one of them is exponential.
    fn exponential_terms(&mut self, sum: Expression) -> Option<Vec<Term>> {
        let Node::Sum(terms) = self.node(sum) else {
            return None;
        };
        let is_exponential = |x: Expression| match self.node(x) {
            Node::Product(factors) => factors
                .iter()
                .any(|(base, _)| self.exponent(*base).is_some()),
            _ => self.exponent(x).is_some(),
        };
        if terms.len() < 2 || !terms.iter().any(|(x, _)| is_exponential(*x)) {
            return None;
        }
        let terms = terms.clone();
        // Beside a term without an exponential, one that is at most 1 does not matter: it is neither too large, nor is the
        // sum 0 without it.
        let are_all = terms.iter().all(|(x, _)| is_exponential(*x));
        if !are_all && terms.len() > MAX_SCALED_TERMS {
            return None;
        }
        let mut found = Vec::with_capacity(terms.len());
        for (x, c) in terms {
            let mut term = self.exponential_term(x, &c);
            if !are_all && term.exponent.is_some_and(|u| self.is_never_positive(u)) {
                term = Term {
                    coefficient: self.scale(x, &c),
                    exponent: None,
                };
            }
            found.push(term);
        }
        found
            .iter()
            .any(|term| term.exponent.is_some())
            .then_some(found)
    }

    /// Whether an expression is seen to be at most 0: minus a sum of even powers.
    pub(super) fn is_never_positive(&self, x: Expression) -> bool {
        let is_even = |x: Expression| match self.node(x) {
            Node::Product(factors) => factors.iter().all(|(_, k)| k.is_even()),
            Node::Unary(Unary::Abs | Unary::Exp, _) => true,
            _ => false,
        };
        match self.node(x) {
            Node::Sum(terms) => terms
                .iter()
                .all(|(x, c)| c.is_negative() && (*x == self.one() || is_even(*x))),
            _ => false,
        }
    }

    fn exponential_term(&mut self, x: Expression, number: &Rational) -> Term {
        let mut exponents = Vec::new();
        let mut others = Vec::new();
        for (base, power) in self.factors(x) {
            match self.exponent(base) {
                Some(u) => exponents.push((u, power)),
                None => others.push((base, power)),
            }
        }
        let product = self.product(others);
        let exponent = (!exponents.is_empty()).then(|| self.sum(exponents));
        Term {
            coefficient: self.scale(product, number),
            exponent,
        }
    }
}
