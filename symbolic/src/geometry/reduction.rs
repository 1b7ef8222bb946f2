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
                    && exponent >= Rational::integer(2)
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
                    && let Some(k) = exponent.to_integer().filter(|k| *k >= 2)
                {
                    *exponent = Rational::integer(k % 2);
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

    /// A polynomial without squares of the chosen functions: f²ᵏ = (1 − g²)ᵏ.
    fn replaced(&mut self, polynomial: &Polynomial, choice: &Choice) -> Polynomial {
        let mut waiting: Vec<(Expression, Rational)> = polynomial.clone().into_iter().collect();
        let mut replaced = Polynomial::new();
        while let Some((monomial, coefficient)) = waiting.pop() {
            if let Some([one, square]) = self.without_a_square(monomial, choice) {
                waiting.push((square, -&coefficient));
                waiting.push((one, coefficient));
            } else {
                let sum = replaced.entry(monomial).or_insert(Rational::ZERO);
                *sum = &*sum + &coefficient;
            }
        }
        replaced.retain(|_, coefficient| !coefficient.is_zero());
        replaced
    }

    /// The monomials r and r·g² of which r·f² is the difference, where f is chosen to be replaced.
    fn without_a_square(
        &mut self,
        monomial: Expression,
        choice: &Choice,
    ) -> Option<[Expression; 2]> {
        let mut powers = self.powers(monomial);
        let two = Rational::integer(2);
        let (position, angle) = powers
            .iter()
            .enumerate()
            .find_map(|(position, (base, k))| {
                let (function, angle) = self.circular(*base)?;
                let is_square =
                    choice.get(&angle) == Some(&function) && k.is_integer() && *k >= two;
                is_square.then_some((position, angle))
            })?;
        powers[position].1 = &powers[position].1 - &two;
        let rest = self.product(powers);
        let other = match choice.get(&angle)? {
            Unary::Sin => Unary::Cos,
            _ => Unary::Sin,
        };
        let other = self.unary(other, angle);
        let square = self.square(other);
        Some([rest, self.multiply(rest, square)])
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
