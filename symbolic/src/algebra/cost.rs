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
        self.cost_up_to(roots, usize::MAX)
    }

    /// Whether some roots cost less than others. Of the others it is not asked how much more they cost: they may be many
    /// times as long.
    #[must_use]
    pub fn costs_less(&self, roots: &[Expression], others: &[Expression]) -> bool {
        let cost = self.cost(roots);
        cost < self.cost_up_to(others, cost)
    }

    /// The cost of the roots, or some number above `bound` where it is above that.
    fn cost_up_to(&self, roots: &[Expression], bound: usize) -> usize {
        let mut angles: BTreeSet<Expression> = BTreeSet::new();
        let mut cost = 0;
        self.visit_descendants(roots, |_, node| {
            cost += match node {
                Node::Constant(_) | Node::Pi | Node::Symbol(_) | Node::Opaque(_) => 0,
                Node::Unary(Unary::Sin | Unary::Cos, angle) => {
                    COST_OF_SINE_AND_COSINE * usize::from(angles.insert(*angle))
                }
                Node::Sum(terms) => self.cost_of_sum(terms),
                Node::Product(factors) => cost_of_product(factors),
                Node::Unary(function, _) => function.cost(),
                Node::Binary(function, ..) => function.cost(),
                Node::Application(..) => COST_OF_FUNCTION,
            };
            cost <= bound
        });
        cost
    }

    /// Additions, and one multiplication for each magnitude of a coefficient.
    fn cost_of_sum(&self, terms: &[(Expression, Rational)]) -> usize {
        let (mut magnitudes, mut all_negative): (Vec<Rational>, bool) = (Vec::new(), true);
        for (x, c) in terms {
            all_negative &= c.is_negative();
            if c.is_one() || *x == self.one() {
                continue;
            }
            let magnitude = c.abs();
            if !magnitude.is_one() && !magnitudes.contains(&magnitude) {
                magnitudes.push(magnitude);
            }
        }
        terms.len() - 1 + magnitudes.len() + usize::from(all_negative)
    }
}

/// Multiplications, roots, and one division if there is a denominator.
fn cost_of_product(factors: &[(Expression, Rational)]) -> usize {
    let (mut above, mut below, mut more) = (0, 0, 0);
    for (_, exponent) in factors {
        if exponent.is_one() {
            above += 1;
            continue;
        }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Symbol;

    #[test]
    fn a_comparison_that_stops_early_is_one_of_costs() {
        let mut graph = Graph::new();
        let mut roots = vec![graph.symbol(Symbol::Time)];
        for i in 0..12 {
            let x = graph.symbol(Symbol::Coordinate(i % 3));
            let last = roots[roots.len() - 1];
            let next = match i % 4 {
                0 => graph.multiply(last, x),
                1 => graph.unary(Unary::Sin, last),
                2 => graph.divide(last, x),
                _ => graph.sum([(last, Rational::integer(3)), (x, Rational::MINUS_ONE)]),
            };
            roots.push(next);
        }
        for first in 0..roots.len() {
            for second in 0..roots.len() {
                let [one, other] = [&roots[first..], &roots[second..=second]];
                assert_eq!(
                    graph.costs_less(one, other),
                    graph.cost(one) < graph.cost(other)
                );
                assert_eq!(
                    graph.costs_less(other, one),
                    graph.cost(other) < graph.cost(one)
                );
            }
        }
    }
}
