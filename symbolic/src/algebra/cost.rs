//! The cost model, by which one form is preferred to another.
//!
//! In units of an addition of binary64 on a current x86-64 core, where additions, subtractions and
//! multiplications take one each. A division stalls the divider for about five of them, a square root
//! for about seven, a sine and cosine of one angle take about twelve. The figures are reciprocal
//! throughputs; what they decide has been measured.

use std::collections::BTreeSet;

use crate::limits::{
    COST_OF_DIVISION, COST_OF_FUNCTION, COST_OF_SINE_AND_COSINE, COST_OF_SQUARE_ROOT,
};
use crate::{Expression, Graph, Node, Rational, Unary};

impl Graph {
    /// The cost of the roots, each shared subexpression once; scheduling finds more to share.
    #[must_use]
    pub fn cost(&self, roots: &[Expression]) -> usize {
        let descendants = self.descendants(roots);
        let angles: BTreeSet<Expression> = descendants
            .iter()
            .filter_map(|expression| match self.node(*expression) {
                Node::Unary(Unary::Sin | Unary::Cos, angle) => Some(*angle),
                _ => None,
            })
            .collect();
        let others = descendants
            .iter()
            .map(|expression| match self.node(*expression) {
                Node::Constant(_)
                | Node::Pi
                | Node::Symbol(_)
                | Node::Opaque(_)
                | Node::Unary(Unary::Sin | Unary::Cos, _) => 0,
                Node::Sum(terms) => self.cost_of_sum(terms),
                Node::Product(factors) => cost_of_product(factors),
                Node::Unary(function, _) => function.cost(),
                Node::Binary(function, ..) => function.cost(),
                Node::Application(..) => COST_OF_FUNCTION,
            });
        COST_OF_SINE_AND_COSINE * angles.len() + others.sum::<usize>()
    }

    /// Additions, and one multiplication for each magnitude of a coefficient.
    fn cost_of_sum(&self, terms: &[(Expression, Rational)]) -> usize {
        let scaled = terms.iter().filter(|(x, _)| *x != self.one());
        let magnitudes: BTreeSet<Rational> = scaled
            .map(|(_, c)| c.abs())
            .filter(|c| !c.is_one())
            .collect();
        let negations = usize::from(terms.iter().all(|(_, c)| c.is_negative()));
        terms.len() - 1 + magnitudes.len() + negations
    }
}

/// Multiplications, roots, and one division if there is a denominator.
fn cost_of_product(factors: &[(Expression, Rational)]) -> usize {
    let (mut above, mut below, mut more) = (0, 0, 0);
    for (_, exponent) in factors {
        let (numerator, denominator) = exponent.abs().to_fraction().unwrap_or((1, 1));
        let integer = usize::try_from(numerator / denominator).unwrap_or(0);
        let multiplications = match integer {
            0 => 0,
            k => k.ilog2() as usize + k.count_ones() as usize - 1,
        };
        more += multiplications;
        let parts = usize::from(integer > 0) + usize::from(denominator > 1);
        if denominator > 1 {
            more += COST_OF_SQUARE_ROOT;
        }
        *(if exponent.is_negative() {
            &mut below
        } else {
            &mut above
        }) += parts;
    }
    let multiplications = above.max(1) - 1 + below.max(1) - 1;
    more + multiplications + if below > 0 { COST_OF_DIVISION } else { 0 }
}
