//! The normal form of sums, Σ cᵢ·xᵢ.

use crate::algebra::split::Split;
use crate::limits::MAX_MERGED_SUM_LENGTH;
use crate::{Expression, Graph, Node, Rational};

impl Graph {
    /// Σ cᵢ·xᵢ of pairs (xᵢ, cᵢ).
    pub fn sum(&mut self, terms: impl IntoIterator<Item = (Expression, Rational)>) -> Expression {
        let mut merged = Vec::new();
        for (expression, coefficient) in terms {
            self.merge_term(&mut merged, expression, coefficient);
        }
        combine(&mut merged);
        self.apply_pythagoras(&mut merged);
        self.intern_sum(merged)
    }

    /// Adds c·x to `terms`, with the terms of x in its place if x is a short sum.
    pub(crate) fn merge_term(
        &self,
        terms: &mut Vec<(Expression, Rational)>,
        expression: Expression,
        coefficient: Rational,
    ) {
        if coefficient.is_zero() {
            return;
        }
        match self.node(expression) {
            Node::Constant(value) if !(value.is_long() || coefficient.is_long()) => {
                terms.push((self.one(), &coefficient * value));
            }
            Node::Sum(inner) if merges(inner) && !coefficient.is_long() => {
                terms.extend(inner.iter().map(|(x, c)| (*x, &coefficient * c)));
            }
            _ => terms.push((expression, coefficient)),
        }
    }

    fn intern_sum(&mut self, terms: Vec<(Expression, Rational)>) -> Expression {
        match terms.as_slice() {
            [] => self.zero(),
            [(x, c)] if *x == self.one() => self.constant(c),
            [(x, c)] if c.is_one() => *x,
            _ => self.intern(Node::Sum(terms.into())),
        }
    }

    /// A sum as its content times its primitive part (Knuth, The Art of Computer Programming, volume 2, 3rd edition
    /// 1997, section 4.6.1), with the common powers of its terms taken out.
    ///
    /// The primitive part has integer coefficients without a common divisor if one of them is then ±1, else its
    /// first coefficient is 1. Of a sum and its opposite, the one that was interned first is the primitive part
    /// of both, so that a defined quantity is found again as it was written. Sums that are multiples of each
    /// other have the same primitive part.
    ///
    /// None where the content is 1 and there is no common power.
    pub(crate) fn split(&mut self, sum: Expression) -> Option<Split> {
        if let Some(place) = self.splits.place(sum) {
            return self.splits.at(place);
        }
        let split = self.find_split(sum);
        // A sum occurs in many products, and its split stays the same.
        self.splits.keep(sum, split.as_ref());
        split
    }

    fn find_split(&mut self, sum: Expression) -> Option<Split> {
        let common = self.common_factors(sum);
        let divided = self.divide_terms(sum, &common);
        let (number, rest) = match self.node(divided) {
            Node::Constant(value) => (value.clone(), self.one()),
            Node::Sum(terms) => match self.primitive(terms, divided) {
                Some((number, terms)) => (number, self.intern_sum(terms)),
                None => (Rational::ONE, divided),
            },
            _ => (Rational::ONE, divided),
        };
        (rest != sum).then_some(Split {
            number,
            common,
            rest,
        })
    }

    /// The powers that divide every term of a sum of several.
    fn common_factors(&self, expression: Expression) -> Vec<(Expression, Rational)> {
        let Node::Sum(terms) = self.node(expression) else {
            return Vec::new();
        };
        let [(first, _), others @ ..] = &**terms else {
            return Vec::new();
        };
        if others.is_empty() || *first == self.one() {
            return Vec::new();
        }
        let mut common = self.factors(*first);
        for (term, _) in others {
            common.retain_mut(|(base, exponent)| {
                let other = self.exponent_in(*term, *base);
                let shared = other.filter(|k| k.is_negative() == exponent.is_negative());
                if let Some(k) = shared.filter(|k| k.abs() < exponent.abs()) {
                    *exponent = k.clone();
                }
                shared.is_some()
            });
            if common.is_empty() {
                break;
            }
        }
        common
    }

    /// An expression as a product of powers.
    pub(crate) fn factors(&self, expression: Expression) -> Vec<(Expression, Rational)> {
        match self.node(expression) {
            Node::Product(factors) => factors.to_vec(),
            _ => vec![(expression, Rational::ONE)],
        }
    }

    /// The exponent of `base` in a product of powers.
    fn exponent_in(&self, product: Expression, base: Expression) -> Option<&Rational> {
        static ONE: Rational = Rational::ONE;
        match self.node(product) {
            Node::Product(factors) => {
                let position = factors
                    .binary_search_by_key(&base, |(base, _)| *base)
                    .ok()?;
                Some(&factors[position].1)
            }
            _ => (product == base).then_some(&ONE),
        }
    }

    /// The sum of the terms of a sum, each divided by the same powers.
    fn divide_terms(&mut self, sum: Expression, divisor: &[(Expression, Rational)]) -> Expression {
        let terms = match self.node(sum) {
            Node::Sum(terms) if !divisor.is_empty() => terms.clone(),
            _ => return sum,
        };
        let inverse: Vec<_> = divisor.iter().map(|(x, k)| (*x, -k)).collect();
        let quotients: Vec<_> = terms
            .iter()
            .map(|(term, c)| {
                let quotient = self.multiply_factors(self.factors(*term), inverse.clone());
                (quotient, c.clone())
            })
            .collect();
        self.sum(quotients)
    }

    /// The content of a sum, and the terms of its primitive part; none where that is the sum itself.
    fn primitive(
        &self,
        terms: &[(Expression, Rational)],
        sum: Expression,
    ) -> Option<(Rational, Vec<(Expression, Rational)>)> {
        let content = self.content(terms);
        if content.is_one() {
            // The sum is here itself; mostly its opposite is not.
            let opposite = self.position_of_opposite(terms).filter(|_| terms.len() > 1);
            opposite.filter(|there| *there < sum.index())?;
            let opposite = terms.iter().map(|(x, c)| (*x, -c));
            return Some((Rational::MINUS_ONE, opposite.collect()));
        }
        let divided = |content: &Rational| -> Vec<(Expression, Rational)> {
            let inverse = content.reciprocal().unwrap_or(Rational::ONE);
            terms.iter().map(|(x, c)| (*x, c * &inverse)).collect()
        };
        let rest = divided(&content);
        let opposite = self.position_of_opposite(&rest);
        let opposite = opposite.filter(|there| {
            let here = self.position(&Node::Sum(rest.as_slice().into()));
            terms.len() > 1 && here.is_none_or(|here| *there < here)
        });
        if opposite.is_some() {
            let opposite = -&content;
            let other = divided(&opposite);
            return Some((opposite, other));
        }
        Some((content, rest))
    }

    /// The content, with the sign of the leading coefficient.
    fn content(&self, terms: &[(Expression, Rational)]) -> Rational {
        let leading = self.leading(terms);
        let mut divisor = leading.abs();
        for (_, coefficient) in terms {
            // Once 1 divides integers only, the divisor of what follows is found cheaply.
            if !(divisor.is_one() && coefficient.is_integer()) {
                divisor = divisor.common_divisor(coefficient);
            }
        }
        let primitive = terms.iter().any(|(_, c)| c.abs() == divisor);
        match (primitive, leading.is_negative()) {
            (false, _) => leading.clone(),
            (true, true) => -&divisor,
            (true, false) => divisor,
        }
    }

    /// The coefficient that gives a sum its sign: that of its first term that is not a number.
    fn leading<'a>(&self, terms: &'a [(Expression, Rational)]) -> &'a Rational {
        let position = usize::from(terms.len() > 1 && terms[0].0 == self.one());
        &terms[position].1
    }

    /// Whether `expression` is written with a minus sign in front.
    #[must_use]
    pub fn has_minus(&self, expression: Expression) -> bool {
        match self.node(expression) {
            Node::Constant(value) => value.is_negative(),
            // A sum that is not merged is no opposite: both signs of it would have a minus in front.
            Node::Sum(terms) => merges(terms) && self.leading(terms).is_negative(),
            _ => false,
        }
    }
}

/// Whether a sum is merged into one that contains it.
fn merges(terms: &[(Expression, Rational)]) -> bool {
    terms.len() <= MAX_MERGED_SUM_LENGTH && !terms.iter().any(|(_, c)| c.is_long())
}

/// Whether pairs (xᵢ, nᵢ) are sorted, each x once.
pub(crate) fn ascends(pairs: &[(Expression, Rational)]) -> bool {
    let mut position = 1;
    while position < pairs.len() {
        if pairs[position - 1].0 >= pairs[position].0 {
            return false;
        }
        position += 1;
    }
    true
}

/// Sorts pairs (xᵢ, nᵢ), adds the numbers of equal x, and drops those that vanish.
pub(crate) fn combine(pairs: &mut Vec<(Expression, Rational)>) {
    if ascends(pairs) && !pairs.iter().any(|(_, number)| number.is_zero()) {
        return;
    }
    pairs.sort_by_key(|(expression, _)| *expression);
    pairs.dedup_by(|later, earlier| {
        let equal = later.0 == earlier.0;
        if equal {
            earlier.1 = &earlier.1 + &later.1;
        }
        equal
    });
    pairs.retain(|(_, number)| !number.is_zero());
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Symbol;

    fn parameters<const N: usize>(graph: &mut Graph) -> [Expression; N] {
        let letters: Vec<_> = (0..).map(Symbol::Parameter).take(N).collect();
        core::array::from_fn(|i| graph.symbol(letters[i]))
    }

    fn sum(graph: &mut Graph, terms: &[(Expression, Rational)]) -> Expression {
        graph.sum(terms.iter().cloned())
    }

    fn ratio(numerator: i64, denominator: i64) -> Rational {
        Rational::new(numerator, denominator).unwrap()
    }

    #[test]
    fn a_sum_is_divided_by_what_its_terms_share() {
        let mut graph = Graph::new();
        let [x, y, z] = parameters(&mut graph);
        // 4 x² y − 6 x y z: the rest has no coefficient ±1 if 2 is taken out, so its first one becomes 1.
        let two = Rational::integer(2);
        let first = graph.product([(x, two), (y, Rational::ONE)]);
        let second = graph.product([x, y, z].map(|x| (x, Rational::ONE)));
        let terms = [
            (first, Rational::integer(4)),
            (second, Rational::integer(-6)),
        ];
        let written = sum(&mut graph, &terms);
        let split = graph.split(written).unwrap();
        assert_eq!(split.number, Rational::integer(4));
        assert_eq!(split.common, [(x, Rational::ONE), (y, Rational::ONE)]);
        assert_eq!(
            split.rest,
            sum(&mut graph, &[(x, Rational::ONE), (z, ratio(-3, 2))])
        );
        // 2 x/3 + 4 y/3 = ⅔ (x + 2 y).
        let written = sum(&mut graph, &[(x, ratio(2, 3)), (y, ratio(4, 3))]);
        let split = graph.split(written).unwrap();
        assert_eq!((split.number, split.common), (ratio(2, 3), Vec::new()));
    }

    #[test]
    fn the_smaller_power_is_common_and_signs_of_exponents_agree() {
        let mut graph = Graph::new();
        let [x, y] = parameters(&mut graph);
        let power = |graph: &mut Graph, k: i64| graph.power(x, &Rational::integer(k));
        // x³ + x² y shares x²; x⁻³ + x⁻² y shares x⁻²; x² y + x⁻¹ shares nothing.
        for (first, second, common) in [(3, 2, Some(2)), (-3, -2, Some(-2)), (2, -1, None)] {
            let (first, second) = (power(&mut graph, first), power(&mut graph, second));
            let scaled = graph.multiply(second, y);
            let written = graph.add(first, scaled);
            let split = graph.split(written).map(|split| split.common);
            assert_eq!(split, common.map(|k| vec![(x, Rational::integer(k))]));
        }
    }

    #[test]
    fn of_a_sum_and_its_opposite_the_first_is_the_rest_of_both() {
        let mut graph = Graph::new();
        let [x, y] = parameters(&mut graph);
        let opposite = graph.subtract(y, x);
        let written = graph.subtract(x, y);
        assert_eq!(graph.split(opposite).map(|split| split.rest), None);
        let split = graph.split(written).unwrap();
        assert_eq!((split.number, split.rest), (Rational::MINUS_ONE, opposite));
    }

    #[test]
    fn what_shares_nothing_is_not_split() {
        let mut graph = Graph::new();
        let [x, y] = parameters(&mut graph);
        let plain = graph.add(x, y);
        let shifted = graph.add_constant(x, &Rational::integer(2));
        let product = graph.multiply(x, y);
        for expression in [x, plain, shifted, product] {
            assert!(graph.split(expression).is_none());
        }
    }
}
