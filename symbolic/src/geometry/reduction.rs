//! Polynomials in sines and cosines, reduced by sin² + cos² = 1 over all their terms.
//!
//! The rules of sums see two terms at a time. Here an expression is multiplied out, and for each angle
//! the squares of its sine are replaced by those of its cosine, or the other way round: what vanishes
//! then vanishes term by term. Terms that differ in squares only are looked at together. Where all of
//! them have one sign, a result with both signs is not taken, so that no sum becomes a difference.
//! Of all results the cheapest is taken, which may be the expression as it was.

use std::collections::{BTreeMap, BTreeSet};

use crate::algebra::expansion::Polynomial;
use crate::{Expression, Graph, Node, Pass, Rational, Unary};

/// For more angles than this not all combinations of sine and cosine are tried.
const MOST_ANGLES: usize = 4;
/// Higher powers of sines and cosines stay as they are.
const HIGHEST_POWER: i64 = 8;

/// The functions of each angle whose squares are replaced.
type Choice = BTreeMap<Expression, Unary>;

impl Graph {
    /// The cheapest of what `simplest` finds and of the reductions of the same expression.
    pub(crate) fn reduced(&mut self, expression: Expression) -> Expression {
        let mut candidates = vec![self.simplest(expression)];
        if self.passes.has(Pass::Expansion)
            && self.passes.has(Pass::Pythagoras)
            && let Some(polynomial) = self.monomials(expression)
        {
            let groups = self.groups(&polynomial);
            for choice in choices(&self.squared_angles(&polynomial)) {
                let reduction = self.reduction(&groups, &choice);
                candidates.extend([reduction, self.factored(reduction)]);
            }
        }
        let cheapest = candidates.into_iter().min_by_key(|x| self.cost(&[*x]));
        cheapest.unwrap_or(expression)
    }

    /// The angles of which a square of sine or cosine occurs.
    fn squared_angles(&self, polynomial: &Polynomial) -> BTreeSet<Expression> {
        let mut angles = BTreeSet::new();
        for monomial in polynomial.keys() {
            for (base, exponent) in self.powers(*monomial) {
                if let Some((_, angle)) = self.circular(base)
                    && halves(&exponent).is_some()
                {
                    angles.insert(angle);
                }
            }
        }
        angles
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

    /// The sum of all groups, each reduced unless that makes a difference of a sum.
    fn reduction(&mut self, groups: &[Polynomial], choice: &Choice) -> Expression {
        let mut terms = Vec::new();
        for group in groups {
            let replaced = self.replaced(group, choice);
            let taken = if has_one_sign(group) && !has_one_sign(&replaced) {
                group.clone()
            } else {
                replaced
            };
            terms.extend(taken);
        }
        self.sum(terms)
    }

    /// A polynomial without squares of the chosen functions.
    fn replaced(&mut self, polynomial: &Polynomial, choice: &Choice) -> Polynomial {
        let mut replaced = polynomial.clone();
        for (angle, function) in choice {
            let mut next = Polynomial::new();
            for (monomial, coefficient) in replaced {
                for (term, number) in self.without_squares(monomial, *function, *angle) {
                    let sum = next.entry(term).or_insert(Rational::ZERO);
                    *sum = &*sum + &(&number * &coefficient);
                }
            }
            next.retain(|_, coefficient| !coefficient.is_zero());
            replaced = next;
        }
        replaced
    }

    /// A monomial with f²ᵏ = (1 − g²)ᵏ multiplied out, where f is a sine and g the cosine or the other
    /// way round.
    fn without_squares(
        &mut self,
        monomial: Expression,
        function: Unary,
        angle: Expression,
    ) -> Vec<(Expression, Rational)> {
        let mut powers = self.powers(monomial);
        let replaced = (function, angle);
        let position = powers
            .iter()
            .position(|(base, _)| self.circular(*base) == Some(replaced));
        let found = position.and_then(|position| Some((position, halves(&powers[position].1)?)));
        let Some((position, (squares, rest))) = found else {
            return vec![(monomial, Rational::ONE)];
        };
        powers[position].1 = Rational::integer(rest);
        let rest = self.product(powers);
        let other = match function {
            Unary::Sin => Unary::Cos,
            _ => Unary::Sin,
        };
        let other = self.unary(other, angle);
        let mut terms = Vec::new();
        let mut binomial = 1;
        for k in 0..=squares {
            let power = self.power(other, &Rational::integer(2 * k));
            terms.push((self.multiply(rest, power), Rational::integer(binomial)));
            binomial = -binomial * (squares - k) / (k + 1);
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

    /// The angle of a sine or cosine.
    fn circular(&self, expression: Expression) -> Option<(Unary, Expression)> {
        match self.node(expression) {
            Node::Unary(function @ (Unary::Sin | Unary::Cos), angle) => Some((*function, *angle)),
            _ => None,
        }
    }
}

/// How many squares are in a power with this exponent, and what is left, unless there are none or many.
fn halves(exponent: &Rational) -> Option<(i64, i64)> {
    let exponent = exponent.to_integer()?;
    (2..=HIGHEST_POWER)
        .contains(&exponent)
        .then_some((exponent / 2, exponent % 2))
}

/// Whether all coefficients are positive, or all negative.
fn has_one_sign(polynomial: &Polynomial) -> bool {
    let mut signs = polynomial.values().map(Rational::is_negative);
    let first = signs.next();
    signs.all(|sign| Some(sign) == first)
}

/// Sine or cosine for each angle, in all combinations if there are few angles, else the same for all.
fn choices(angles: &BTreeSet<Expression>) -> Vec<Choice> {
    let functions = [Unary::Sin, Unary::Cos];
    if angles.is_empty() {
        return Vec::new();
    }
    if angles.len() > MOST_ANGLES {
        let same = |function| angles.iter().map(|angle| (*angle, function)).collect();
        return functions.map(same).into();
    }
    let combination = |number: usize| {
        let angles = angles.iter().enumerate();
        let choice = angles.map(|(bit, angle)| (*angle, functions[number >> bit & 1]));
        choice.collect()
    };
    (0..1 << angles.len()).map(combination).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draft::Draft;

    /// Sine and cosine of the coordinates.
    fn circular(draft: &mut Draft, coordinate: u32) -> [Expression; 2] {
        let angle = draft.q(coordinate);
        [draft.sin(angle), draft.cos(angle)]
    }

    #[test]
    fn powers_are_replaced_up_to_the_eighth() {
        for k in [2, 3, 4, 5] {
            // Σ binom(k, j) sin²ʲ cos²⁽ᵏ⁻ʲ⁾ = 1.
            let mut draft = Draft::new(1);
            let [sine, cosine] = circular(&mut draft, 0);
            let mut terms = Vec::new();
            let mut binomial = 1;
            for j in 0..=k {
                let powers = [(sine, 2 * j), (cosine, 2 * (k - j))];
                let powers = powers.map(|(x, n)| (x, Rational::integer(n)));
                terms.push((draft.graph.product(powers), Rational::integer(binomial)));
                binomial = binomial * (k - j) / (j + 1);
            }
            let whole = draft.graph.sum(terms);
            let is_one = draft.graph.reduced(whole) == draft.graph.one();
            assert_eq!(is_one, 2 * k <= HIGHEST_POWER, "{k}");
            // The rules of sums see two terms at a time, of which none can go alone.
            assert_ne!(draft.graph.simplest(whole), draft.graph.one());
        }
    }

    #[test]
    fn no_sum_becomes_a_difference() {
        // sin²a + cos²a sin²b costs more than 1 − cos²a cos²b, which cancels.
        let mut draft = Draft::new(2);
        let [[sa, ca], [sb, cb]] = [0, 1].map(|i| circular(&mut draft, i));
        let [sa, ca, sb, cb] = [sa, ca, sb, cb].map(|x| draft.square(x));
        let second = draft.times(&[ca, sb]);
        let sum = draft.plus(&[sa, second]);
        let (one, product) = (draft.graph.one(), draft.times(&[ca, cb]));
        let difference = draft.graph.subtract(one, product);
        assert!(draft.graph.cost(&[difference]) < draft.graph.cost(&[sum]));
        let reduced = draft.graph.reduced(sum);
        assert_eq!(reduced, draft.graph.simplest(sum));
        // What has both signs already may become any of them.
        let x = draft.parameter(0);
        let [scaled, shifted] = [sum, product].map(|y| draft.times(&[x, y]));
        let mixed = draft.graph.sum([
            (scaled, Rational::integer(3)),
            (shifted, Rational::integer(3)),
            (x, Rational::MINUS_ONE),
        ]);
        let twice = draft.graph.scale(x, &Rational::integer(2));
        assert_eq!(draft.graph.reduced(mixed), twice);
    }

    #[test]
    fn of_many_angles_all_squares_are_replaced_alike() {
        // Π (sin² + cos²) over five angles.
        let mut draft = Draft::new(5);
        let mut product = vec![draft.graph.one()];
        for i in 0..5 {
            let squares = circular(&mut draft, i).map(|x| draft.square(x));
            let pairs = product
                .iter()
                .flat_map(|x| squares.map(|square| (*x, square)));
            let pairs: Vec<_> = pairs.collect();
            product = pairs.iter().map(|(x, y)| draft.times(&[*x, *y])).collect();
        }
        let whole = draft.plus(&product);
        assert_eq!(draft.graph.reduced(whole), draft.graph.one());
    }
}
