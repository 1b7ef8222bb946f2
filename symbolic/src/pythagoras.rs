//! sin² + cos² = 1 and its consequences, in sums.
//!
//! Three directed rules, each of which leaves one term where there were two:
//!
//!     c·r·sin²x + c·r·cos²x  →  c·r
//!     c·r − c·r·sin²x        →  c·r·cos²x
//!     c·r − c·r·cos²x        →  c·r·sin²x
//!
//! The last two make a product of a difference, which is exact where the difference cancels. No rule
//! goes the other way: sin²x never becomes 1 − cos²x.

use crate::sum::combine;
use crate::{Expression, Graph, Node, Rational, Unary};

type Terms = Vec<(Expression, Rational)>;

impl Graph {
    /// Applies the rules to terms in normal form until none of them fires.
    pub(crate) fn apply_pythagoras(&mut self, terms: &mut Terms) {
        while terms.len() > 1 && (0..terms.len()).any(|position| self.merge_square(terms, position))
        {
            combine(terms);
        }
    }

    /// Merges the term at `position` with another one, if a rule fits.
    fn merge_square(&mut self, terms: &mut Terms, position: usize) -> bool {
        let (term, coefficient) = terms[position].clone();
        let Node::Product(factors) = self.node(term) else {
            return false;
        };
        let factors = factors.clone();
        for (index, (base, exponent)) in factors.iter().enumerate() {
            let Some(complement) = self.complement(*base, exponent) else {
                continue;
            };
            let mut rest = factors.to_vec();
            rest[index].1 = exponent - &Rational::integer(2);
            let rest = self.product(rest);
            let square = self.square(complement);
            let partner = self.multiply(rest, square);
            let (replaced, result) = if find(terms, partner) == Some(&coefficient) {
                (partner, (rest, coefficient.clone()))
            } else if find(terms, rest) == Some(&-&coefficient) {
                (rest, (partner, -&coefficient))
            } else {
                continue;
            };
            terms.retain(|(x, _)| *x != term && *x != replaced);
            // What is left may be a number or a sum of its own.
            self.merge_term(terms, result.0, result.1);
            return true;
        }
        false
    }

    /// The cosine to a sine and the sine to a cosine, where it stands at least squared.
    fn complement(&mut self, base: Expression, exponent: &Rational) -> Option<Expression> {
        let Node::Unary(function, x) = *self.node(base) else {
            return None;
        };
        exponent.to_integer().filter(|k| *k >= 2)?;
        match function {
            Unary::Sin => Some(self.unary(Unary::Cos, x)),
            Unary::Cos => Some(self.unary(Unary::Sin, x)),
            _ => None,
        }
    }
}

/// The coefficient of a term.
fn find(terms: &[(Expression, Rational)], term: Expression) -> Option<&Rational> {
    terms
        .iter()
        .find(|(x, _)| *x == term)
        .map(|(_, coefficient)| coefficient)
}
