//! Trigonometric polynomials, reduced modulo sin² + cos² − 1 (the division algorithm: Cox, Little and O'Shea, Ideals,
//! Varieties, and Algorithms, 4th edition 2015, section 2.3).
//!
//! The rewrite rules of sums compare two terms at a time. Here an expression is expanded, and the squares of all
//! sines are replaced by those of cosines, or the other way round: an identity then vanishes term by term. Terms
//! that differ in squares only form a group. Where all terms of a group have one sign, a result with both signs is
//! not taken, so that no sum becomes a difference. The cheapest result is taken, which may be the expression itself.

use std::collections::BTreeMap;

use crate::algebra::expansion::Polynomial;
use crate::limits::{HIGHEST_REDUCED_POWER, MAX_REDUCED_TERMS};
use crate::{Expression, Graph, Node, Pass, Rational, Unary};

impl Graph {
    /// The cheapest of what `simplest` finds and of the reductions of the same expression.
    pub(crate) fn reduced(&mut self, expression: Expression) -> Expression {
        let mut candidates = vec![self.simplest(expression)];
        if self.passes.has(Pass::Expansion)
            && self.passes.has(Pass::Pythagoras)
            && let Some(polynomial) = self.monomials(expression)
        {
            let groups = self.groups(&polynomial);
            candidates.extend([Unary::Sin, Unary::Cos].map(|f| self.reduction(&groups, f)));
        }
        let cheapest = candidates.into_iter().min_by_key(|x| self.cost(&[*x]));
        cheapest.unwrap_or(expression)
    }

    /// The terms of a polynomial, those together that differ in squares of sines and cosines only.
    fn groups(&mut self, polynomial: &Polynomial) -> Vec<Polynomial> {
        let mut groups: BTreeMap<Expression, Polynomial> = BTreeMap::new();
        for (monomial, coefficient) in polynomial {
            let mut odd = self.powers(*monomial);
            for (base, exponent) in &mut odd {
                if self.circular(*base).is_some()
                    && let Some((_, rest)) = halves(exponent)
                {
                    *exponent = Rational::integer(rest);
                }
            }
            let odd = self.product(odd);
            let group = groups.entry(odd).or_default();
            group.insert(*monomial, coefficient.clone());
        }
        groups.into_values().collect()
    }

    /// The sum of all groups without squares of `function`, except for groups in which that would turn a sum into
    /// a difference.
    fn reduction(&mut self, groups: &[Polynomial], function: Unary) -> Expression {
        let mut terms = Vec::new();
        for group in groups {
            let replaced = self.replaced(group, function);
            let taken = if has_one_sign(group) && !has_one_sign(&replaced) {
                group.clone()
            } else {
                replaced
            };
            terms.extend(taken);
        }
        self.sum(terms)
    }

    /// A polynomial without squares of `function`.
    fn replaced(&mut self, polynomial: &Polynomial, function: Unary) -> Polynomial {
        let mut replaced = Polynomial::new();
        for (monomial, coefficient) in polynomial {
            for (term, number) in self.without_squares(*monomial, function) {
                let sum = replaced.entry(term).or_insert(Rational::ZERO);
                *sum = &*sum + &(&number * coefficient);
            }
        }
        replaced.retain(|_, coefficient| !coefficient.is_zero());
        replaced
    }

    /// A monomial with f²ᵏ = (1 − g²)ᵏ expanded, where f is a sine and g the cosine of the same
    /// angle, or the other way round.
    fn without_squares(
        &mut self,
        monomial: Expression,
        function: Unary,
    ) -> Vec<(Expression, Rational)> {
        let mut terms = vec![(self.one(), Rational::ONE)];
        for (base, exponent) in self.powers(monomial) {
            let powers = self.power_without_squares(base, &exponent, function);
            if terms.len() * powers.len() > MAX_REDUCED_TERMS {
                return vec![(monomial, Rational::ONE)];
            }
            let mut products = Vec::with_capacity(terms.len() * powers.len());
            for (x, c) in &terms {
                for (y, d) in &powers {
                    products.push((self.multiply(*x, *y), c * d));
                }
            }
            terms = products;
        }
        terms
    }

    /// Σ binom(k, j) (−1)ʲ g²ʲ fʳ for a power f²ᵏ⁺ʳ, and any other power as it is.
    fn power_without_squares(
        &mut self,
        base: Expression,
        exponent: &Rational,
        function: Unary,
    ) -> Vec<(Expression, Rational)> {
        let angle = self.circular(base).filter(|(f, _)| *f == function);
        let (Some((_, angle)), Some((squares, rest))) = (angle, halves(exponent)) else {
            return vec![(self.power(base, exponent), Rational::ONE)];
        };
        let other = match function {
            Unary::Sin => self.unary(Unary::Cos, angle),
            _ => self.unary(Unary::Sin, angle),
        };
        let mut terms = Vec::new();
        let mut binomial = 1;
        for j in 0..=squares {
            let powers = [(other, 2 * j), (base, rest)];
            let powers = powers.map(|(x, k)| (x, Rational::integer(k)));
            terms.push((self.product(powers), Rational::integer(binomial)));
            binomial = -binomial * (squares - j) / (j + 1);
        }
        terms
    }

    /// A monomial as a product of powers.
    fn powers(&self, monomial: Expression) -> Vec<(Expression, Rational)> {
        match self.node(monomial) {
            Node::Product(factors) => factors.to_vec(),
            _ => vec![(monomial, Rational::ONE)],
        }
    }

    /// The function and the angle of a sine or cosine.
    fn circular(&self, expression: Expression) -> Option<(Unary, Expression)> {
        match self.node(expression) {
            Node::Unary(function @ (Unary::Sin | Unary::Cos), angle) => Some((*function, *angle)),
            _ => None,
        }
    }
}

/// The number of squares in a power with this exponent, and the remaining exponent, unless there are none or many.
fn halves(exponent: &Rational) -> Option<(i64, i64)> {
    let exponent = exponent.to_integer()?;
    let is_replaced = (2..=HIGHEST_REDUCED_POWER).contains(&exponent);
    is_replaced.then_some((exponent / 2, exponent % 2))
}

/// Whether all coefficients are positive, or all negative.
fn has_one_sign(polynomial: &Polynomial) -> bool {
    let mut signs = polynomial.values().map(Rational::is_negative);
    let first = signs.next();
    signs.all(|sign| Some(sign) == first)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{Draft, Quantity};

    /// Sine and cosine of the coordinates.
    fn circular(draft: &Draft, coordinate: u32) -> [Quantity<'_>; 2] {
        let angle = draft.q(coordinate);
        [angle.sin(), angle.cos()]
    }

    /// What the reduction and what the rules of sums make of it.
    fn both_ways(draft: &Draft, x: Quantity<'_>) -> [Expression; 2] {
        let graph = &mut draft.graph();
        [graph.reduced(x.into()), graph.simplest(x.into())]
    }

    #[test]
    fn powers_are_replaced_up_to_the_eighth() {
        for k in [2, 3, 4, 5] {
            // Σ binom(k, j) sin²ʲ cos²⁽ᵏ⁻ʲ⁾ = 1.
            let draft = Draft::new(1);
            let [sine, cosine] = circular(&draft, 0);
            let mut terms = Vec::new();
            let mut binomial = 1;
            for j in 0..=k {
                terms.push(binomial * (sine.powi(2 * j) * cosine.powi(2 * (k - j))));
                binomial = binomial * (k - j) / (j + 1);
            }
            let [reduced, simplest] = both_ways(&draft, draft.sum(terms));
            let one = draft.one();
            assert_eq!(reduced == one, 2 * k <= HIGHEST_REDUCED_POWER, "{k}");
            // The rules of sums see two terms at a time, of which none can go alone.
            assert_ne!(simplest, one);
        }
    }

    #[test]
    fn sines_and_cosines_are_replaced_and_odd_powers_keep_one() {
        // f (1 − f²)³ expanded is f g⁶, for f the sine and for f the cosine.
        for [f, g] in [[0, 1], [1, 0]] {
            let draft = Draft::new(1);
            let both = circular(&draft, 0);
            let (f, g) = (both[f], both[g]);
            let binomials = [(0, 1), (1, -3), (2, 3), (3, -1)];
            let alternating = draft.sum(binomials.map(|(j, n)| n * f.powi(2 * j + 1)));
            let [reduced, simplest] = both_ways(&draft, alternating);
            let expected = f * g.powi(6);
            assert_eq!(reduced, expected);
            assert_ne!(simplest, expected);
        }
    }

    #[test]
    fn no_sum_becomes_a_difference() {
        // sin²a + cos²a sin²b costs more than 1 − cos²a cos²b, which cancels.
        let draft = Draft::new(2);
        let [[sa, ca], [sb, cb]] = [0, 1].map(|i| circular(&draft, i));
        let [sa, ca, sb, cb] = [sa, ca, sb, cb].map(Quantity::squared);
        let (sum, product) = (sa + ca * sb, ca * cb);
        let cost = |x: Quantity<'_>| draft.graph().cost(&[x.into()]);
        assert!(cost(1 - product) < cost(sum));
        let [reduced, simplest] = both_ways(&draft, sum);
        assert_eq!(reduced, simplest);
        // What has both signs already may become any of them.
        let x = draft.p(0);
        let mixed = draft.sum([3 * (x * sum), 3 * (x * product), -x]);
        assert_eq!(both_ways(&draft, mixed)[0], 2 * x);
    }
}
