//! The Pythagorean identity sin² + cos² = 1 and its consequences, in sums.
//!
//! Three directed rules, with c ≥ d > 0 or both negative:
//!
//! - `c·r·sin²x + c·r·cos²x → c·r`
//! - `c·r − d·r·sin²x → (c−d)·r + d·r·cos²x`
//! - `c·r − d·r·cos²x → (c−d)·r + d·r·sin²x`
//!
//! The first leaves one term where there were two, and so do the others for c = d. These make terms of
//! one sign of a difference, which is exact where the difference cancels. No rule goes the other way:
//! sin²x never becomes 1 − cos²x.

use crate::algebra::sum::combine;
use crate::{Expression, Graph, Node, Pass, Rational, Unary};

type Terms = Vec<(Expression, Rational)>;

impl Graph {
    /// Applies the rewrite rules to terms in normal form until none of them fires.
    pub(crate) fn apply_pythagoras(&mut self, terms: &mut Terms) {
        if !self.passes.has(Pass::Pythagoras) {
            return;
        }
        while terms.len() > 1 && (0..terms.len()).any(|position| self.merge_square(terms, position))
        {
            combine(terms);
        }
    }

    /// Merges the term at `position` with another one, if a rule fits.
    fn merge_square(&mut self, terms: &mut Terms, position: usize) -> bool {
        let Node::Product(factors) = self.node(terms[position].0) else {
            return false;
        };
        if !factors.iter().any(|(base, k)| self.is_square(*base, k)) {
            return false;
        }
        let factors = factors.clone();
        let (term, coefficient) = terms[position].clone();
        for (index, (base, exponent)) in factors.iter().enumerate() {
            let Some(complement) = self.complement(*base, exponent) else {
                continue;
            };
            let mut rest = factors.to_vec();
            rest[index].1 = exponent - &Rational::integer(2);
            let rest = self.product(rest);
            let square = self.square(complement);
            let partner = self.multiply(rest, square);
            let larger = find(terms, rest).filter(|larger| exceeds(larger, &coefficient));
            let (replaced, result) = if find(terms, partner) == Some(&coefficient) {
                (partner, vec![(rest, coefficient.clone())])
            } else if let Some(larger) = larger {
                (
                    rest,
                    vec![(partner, -&coefficient), (rest, larger + &coefficient)],
                )
            } else {
                continue;
            };
            terms.retain(|(x, _)| *x != term && *x != replaced);
            // What is left may be a number or a sum of its own.
            for (x, c) in result {
                self.merge_term(terms, x, c);
            }
            return true;
        }
        false
    }

    /// Whether a power is that of a sine or of a cosine which stands at least squared.
    fn is_square(&self, base: Expression, exponent: &Rational) -> bool {
        matches!(self.node(base), Node::Unary(Unary::Sin | Unary::Cos, _))
            && exponent.to_integer().is_some_and(|k| k >= 2)
    }

    /// The cosine to a sine and the sine to a cosine, where it stands at least squared.
    fn complement(&mut self, base: Expression, exponent: &Rational) -> Option<Expression> {
        if !self.is_square(base, exponent) {
            return None;
        }
        match *self.node(base) {
            Node::Unary(Unary::Sin, x) => Some(self.unary(Unary::Cos, x)),
            Node::Unary(Unary::Cos, x) => Some(self.unary(Unary::Sin, x)),
            _ => None,
        }
    }
}

/// Whether `larger` has the opposite sign of `smaller` and at least its magnitude.
fn exceeds(larger: &Rational, smaller: &Rational) -> bool {
    larger.is_negative() != smaller.is_negative() && larger.abs() >= smaller.abs()
}

/// The coefficient of a term.
fn find(terms: &[(Expression, Rational)], term: Expression) -> Option<&Rational> {
    terms
        .iter()
        .find(|(x, _)| *x == term)
        .map(|(_, coefficient)| coefficient)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Symbol;

    /// The coordinates x and y, the parameter r, and squares of sine and cosine of x.
    fn symbols(graph: &mut Graph) -> [Expression; 5] {
        let x = graph.symbol(Symbol::Coordinate(0));
        let y = graph.symbol(Symbol::Coordinate(1));
        let r = graph.symbol(Symbol::Parameter(0));
        let [sine, cosine] = [Unary::Sin, Unary::Cos].map(|function| {
            let value = graph.unary(function, x);
            graph.square(value)
        });
        [x, y, r, sine, cosine]
    }

    #[test]
    fn squares_of_one_angle_merge() {
        let mut graph = Graph::new();
        let [_, y, r, sine, cosine] = symbols(&mut graph);
        let three = Rational::integer(3);
        let [a, b] = [sine, cosine].map(|square| graph.multiply(r, square));
        let merged = graph.sum([(a, three.clone()), (y, Rational::ONE), (b, three.clone())]);
        let expected = graph.sum([(r, three), (y, Rational::ONE)]);
        assert_eq!(merged, expected);
    }

    #[test]
    fn differences_become_squares() {
        let mut graph = Graph::new();
        let [_, _, r, sine, cosine] = symbols(&mut graph);
        let one = graph.one();
        assert_eq!(graph.subtract(one, sine), cosine);
        assert_eq!(graph.subtract(one, cosine), sine);
        let part = graph.multiply(r, sine);
        let difference = graph.subtract(part, r);
        let square = graph.multiply(r, cosine);
        assert_eq!(difference, graph.negate(square));
    }

    #[test]
    fn differences_of_multiples_become_terms_of_one_sign() {
        let mut graph = Graph::new();
        let [_, _, r, sine, cosine] = symbols(&mut graph);
        let one = graph.one();
        let combine = |graph: &mut Graph, terms: [(Expression, i64); 2]| {
            graph.sum(terms.map(|(x, c)| (x, Rational::integer(c))))
        };
        // 2 − cos² = 1 + sin², as in the determinant of a double pendulum.
        let difference = combine(&mut graph, [(one, 2), (cosine, -1)]);
        assert_eq!(difference, combine(&mut graph, [(one, 1), (sine, 1)]));
        // −5 r + 2 r sin² = −3 r − 2 r cos².
        let [across, along] = [sine, cosine].map(|square| graph.multiply(r, square));
        let difference = combine(&mut graph, [(r, -5), (across, 2)]);
        assert_eq!(difference, combine(&mut graph, [(r, -3), (along, -2)]));
        // 1 − 2 cos² would be a difference on either side.
        let difference = combine(&mut graph, [(one, 1), (cosine, -2)]);
        let Node::Sum(terms) = graph.node(difference) else {
            panic!("{:?} is no sum", graph.node(difference));
        };
        assert!(terms.iter().any(|(x, _)| *x == cosine));
    }

    #[test]
    fn higher_powers_and_longer_sums_merge_in_turn() {
        // sin⁴ + 2 sin² cos² + cos⁴ is not touched, but sin⁴ + sin² cos² is sin².
        let mut graph = Graph::new();
        let [_, _, _, sine, cosine] = symbols(&mut graph);
        let fourth = graph.square(sine);
        let mixed = graph.multiply(sine, cosine);
        assert_eq!(graph.add(fourth, mixed), sine);
        let last = graph.add(fourth, mixed);
        assert_eq!(graph.add(last, cosine), graph.one());
    }

    #[test]
    fn nothing_else_merges() {
        let mut graph = Graph::new();
        let [_, y, r, sine, cosine] = symbols(&mut graph);
        let other = graph.unary(Unary::Cos, y);
        let other = graph.square(other);
        let double = graph.scale(cosine, &Rational::integer(2));
        let scaled = graph.multiply(r, cosine);
        let one = graph.one();
        // Other angles, other coefficients, other factors, and sums that would become differences.
        for (x, y) in [
            (sine, other),
            (sine, double),
            (sine, scaled),
            (one, sine),
            (sine, r),
        ] {
            let sum = graph.add(x, y);
            assert!(matches!(graph.node(sum), Node::Sum(terms) if terms.len() == 2));
        }
        let difference = graph.subtract(sine, cosine);
        assert!(matches!(graph.node(difference), Node::Sum(terms) if terms.len() == 2));
    }
}
