//! Products, powers and logarithms of exponential functions, so that none overflows where its value does not.
//!
//! 1 + eᵘ is too large for a number where its reciprocal and its logarithm are not, and the derivatives of these are
//! ∞/∞ there. With σ(u) = 1/(1 + e⁻ᵘ) a sum with an exponential term is r + c·eᵘ = (1 + eᵘ)·(r·σ(−u) + c·σ(u)), where
//! the last factor is between r and c; its power or logarithm is put together from those of the factors. What stays is
//! bounded:
//!
//! - (1 + eᵘ)⁻¹ = σ(−u), and eᵘ·σ(−u) = σ(u);
//! - ln(1 + eᵘ) is a function of its own, whose derivative is σ(u);
//! - another exponential joins: eᵛ·σ(w) = exp(v − ln(1 + e⁻ʷ)).
//!
//! As with the logarithm of a sum of exponentials from the largest of them (Blanchard, Higham and Higham, Accurately
//! computing the log-sum-exp and softmax functions, 2021), but without a comparison, so that derivatives of all orders
//! and Taylor series are of the same form. All of this holds for every real u.

use std::collections::BTreeMap;

use crate::algebra::growth::{Growing, Scaled};
use crate::{Expression, Graph, Node, Rational, Unary};

/// Π xᵢ^kᵢ, as pairs (xᵢ, kᵢ).
type Factors = Vec<(Expression, Rational)>;

impl Graph {
    /// σ(−u) = 1 − σ(u).
    pub(crate) fn logistic_complement(&mut self, u: Expression) -> Expression {
        let opposite = self.negate(u);
        self.unary(Unary::Logistic, opposite)
    }

    /// Whether `x` is eᵘ with an exponent that changes.
    pub(super) fn exponent(&self, x: Expression) -> Option<Expression> {
        match self.node(x) {
            Node::Unary(Unary::Exp, u) if self.contents(*u).varies() => Some(*u),
            _ => None,
        }
    }

    /// x/y, where it is a number.
    pub(super) fn ratio(&self, x: Expression, y: Expression) -> Option<Rational> {
        if x == y {
            return Some(Rational::ONE);
        }
        let one = [(x, Rational::ONE)];
        let terms_of_x = match self.node(x) {
            Node::Sum(terms) => &**terms,
            _ => &one,
        };
        let one = [(y, Rational::ONE)];
        let terms_of_y = match self.node(y) {
            Node::Sum(terms) => &**terms,
            _ => &one,
        };
        let (first, other) = (terms_of_x.first()?, terms_of_y.first()?);
        if terms_of_x.len() != terms_of_y.len() || first.1.is_long() || other.1.is_long() {
            return None;
        }
        let ratio = &first.1 * &other.1.reciprocal()?;
        let mut pairs = terms_of_x.iter().zip(terms_of_y);
        let same = pairs.all(|((x, c), (y, d))| x == y && *c == d * &ratio);
        same.then_some(ratio)
    }

    /// Rewrites the first exponential beside a logistic function or a hyperbolic cosine among sorted factors, if there is
    /// one: what it becomes is to be multiplied by the factors that are left.
    pub(crate) fn take_exponential(&mut self, factors: &mut Factors) -> Factors {
        if self.leaves_exponentials || factors.len() < 2 {
            return Vec::new();
        }
        if !(self.has_exponential || self.has_hyperbolic) {
            return Vec::new();
        }
        for position in 0..factors.len() {
            let Some(exponent) = self.exponent(factors[position].0) else {
                continue;
            };
            let exponent = (exponent, factors[position].1.clone());
            if !exponent.1.is_negative() && self.is_never_positive(exponent.0) {
                continue;
            }
            for other in (0..factors.len()).filter(|other| *other != position) {
                if let Some(joined) = self.joined(&exponent, &factors[other]) {
                    factors.remove(position.max(other));
                    factors.remove(position.min(other));
                    return joined;
                }
            }
        }
        let taken = self.divided(factors);
        let taken = taken.or_else(|| self.in_tower(factors));
        taken.unwrap_or_default()
    }

    /// Rewrites the first power of a sum of exponentials that is divided by what it grows like, if there is one.
    fn divided(&mut self, factors: &mut Factors) -> Option<Factors> {
        let bounded =
            |x: Expression| matches!(self.node(x), Node::Unary(Unary::Logistic | Unary::Sech, _));
        if !factors.iter().any(|(x, k)| bounded(*x) && !k.is_negative()) {
            return None;
        }
        for position in 0..factors.len() {
            let (sum, power) = factors[position].clone();
            if !power.is_integer() || power.is_negative() {
                continue;
            }
            let Some(scaled) = self.scaled(sum) else {
                continue;
            };
            let Scaled { scale, rest, .. } = scaled;
            let (base, less) = self.growing_power(scale, &-&(&power * &scaled.power));
            let mut others = factors.iter();
            if others.any(|(other, k)| *other == base && *k >= less) {
                factors.remove(position);
                return Some(vec![(base, -&less), (rest, power)]);
            }
        }
        None
    }

    /// eᵘ to a power times another power, as factors that overflow where their product does.
    fn joined(
        &mut self,
        (u, power): &(Expression, Rational),
        (base, exponent): &(Expression, Rational),
    ) -> Option<Factors> {
        match *self.node(*base) {
            Node::Unary(Unary::Logistic, w) => {
                let ratio = self.ratio(*u, w);
                if let Some(ref ratio) = ratio
                    && let Some(factors) =
                        self.exchanged_with_logistic(w, &(ratio * power), exponent)
                {
                    return Some(factors);
                }
                let grows = ratio.is_some_and(|ratio| ratio.is_negative() == power.is_negative());
                let shared = !exponent.is_negative() && !grows && self.may_share_a_symbol(*u, w);
                shared.then(|| {
                    let opposite = self.negate(w);
                    let logarithm = self.unary(Unary::Softplus, opposite);
                    let terms = [(*u, power.clone()), (logarithm, -exponent)];
                    let sum = self.sum(terms);
                    vec![(self.unary(Unary::Exp, sum), Rational::ONE)]
                })
            }
            Node::Unary(Unary::Sech, w) if !exponent.is_negative() => {
                // sech w = 2 √(σ(2w) σ(−2w)).
                let ratio = self.ratio(*u, w)?;
                let m = &ratio * power;
                let k = exponent.clone();
                if m.abs() > k {
                    return None;
                }
                let twice = self.scale(w, &Rational::integer(2));
                let [above, below] = [&k + &m, &k - &m].map(|x| &x * &Rational::HALF);
                if !above.is_integer() {
                    let logarithm = self.growing_logarithm(Growing::Cosine(w));
                    let sum = self.sum([(*u, power.clone()), (logarithm, -&k)]);
                    return Some(vec![(self.unary(Unary::Exp, sum), Rational::ONE)]);
                }
                let logistic = self.unary(Unary::Logistic, twice);
                let complement = self.logistic_complement(twice);
                let two = self.integer(2);
                Some(vec![(logistic, above), (complement, below), (two, k)])
            }
            Node::Unary(Unary::Exp, w)
                if self.is_with_softplus(*u)
                    || self.is_with_softplus(w)
                    || self.is_tower(w, &(*u, power.clone())) =>
            {
                let sum = self.sum([(*u, power.clone()), (w, exponent.clone())]);
                Some(vec![(self.unary(Unary::Exp, sum), Rational::ONE)])
            }
            _ => None,
        }
    }

    /// e^(m·w)·σ(w)ⁿ, where eʷ = σ(w)/σ(−w).
    fn exchanged_with_logistic(
        &mut self,
        w: Expression,
        m: &Rational,
        n: &Rational,
    ) -> Option<Factors> {
        if m.is_negative() == n.is_negative() {
            return None;
        }
        let (less, more) = (m.abs(), n.abs());
        let moved = if less < more { less } else { more };
        // The root of what has become too small for a number would be 0.
        if !moved.is_integer() {
            return None;
        }
        let moved = if m.is_negative() { -&moved } else { moved };
        let logistic = self.unary(Unary::Logistic, w);
        let complement = self.logistic_complement(w);
        let rest = self.scale(w, &(m - &moved));
        let rest = self.unary(Unary::Exp, rest);
        Some(vec![
            (logistic, n + &moved),
            (complement, -&moved),
            (rest, Rational::ONE),
        ])
    }

    /// Whether a sum has a term ln(1 + eᵘ) or ln cosh u.
    fn is_with_softplus(&self, sum: Expression) -> bool {
        let is_one = |x: Expression| {
            matches!(
                self.node(x),
                Node::Unary(Unary::Softplus | Unary::LogCosh, _)
            )
        };
        match self.node(sum) {
            Node::Sum(terms) => terms.iter().any(|(x, _)| is_one(*x)),
            _ => is_one(sum),
        }
    }

    /// exp(−n·ln(1 + eᵘ)) = σ(−u)ⁿ.
    pub(crate) fn exponential_of_softplus(&mut self, x: Expression) -> Option<Expression> {
        let Node::Sum(terms) = self.node(x) else {
            return None;
        };
        if self.leaves_exponentials {
            return None;
        }
        let [(y, number)] = &**terms else {
            return None;
        };
        let (Node::Unary(Unary::Softplus, u), true) = (self.node(*y), number.is_negative()) else {
            return None;
        };
        let (u, exponent) = (*u, -number);
        if !exponent.is_integer() {
            return None;
        }
        let complement = self.logistic_complement(u);
        Some(self.power(complement, &exponent))
    }

    /// The roots with exponentials and logarithms in place of the functions that stand for sums of them, in a graph that
    /// [leaves](Graph::leaves_exponentials) them so.
    pub(crate) fn by_exponentials(&mut self, roots: &[Expression]) -> Vec<Expression> {
        let mut values = BTreeMap::new();
        for part in self.descendants(roots) {
            let Node::Unary(
                function @ (Unary::Logistic | Unary::Softplus | Unary::Sech | Unary::LogCosh),
                u,
            ) = *self.node(part)
            else {
                continue;
            };
            let u = self.replace(&[u], &values)[0];
            if matches!(function, Unary::Sech | Unary::LogCosh) {
                let cosine = self.unary(Unary::Cosh, u);
                let value = match function {
                    Unary::Sech => self.power(cosine, &Rational::MINUS_ONE),
                    _ => self.unary(Unary::Ln, cosine),
                };
                values.insert(part, value);
                continue;
            }
            let exponent = match function {
                Unary::Logistic => self.negate(u),
                _ => u,
            };
            let exponential = self.unary(Unary::Exp, exponent);
            let sum = self.add_constant(exponential, &Rational::ONE);
            let value = match function {
                Unary::Logistic => self.power(sum, &Rational::MINUS_ONE),
                _ => self.unary(Unary::Ln, sum),
            };
            values.insert(part, value);
        }
        self.replace(roots, &values)
    }
}
