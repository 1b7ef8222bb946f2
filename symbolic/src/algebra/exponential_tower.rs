//! Products with exponentials of exponentials, such as eᵘ·exp(−eᵘ), the derivative of −exp(−eᵘ): ∞·0 where u is large, though the
//! product is small. It is exp(u − eᵘ), whose exponent has a value, and so have its derivatives: a factor that grows like a power of eᵘ
//! joins the exponent by its logarithm, and what is left of it is bounded.

use crate::algebra::growth::Scaled;
use crate::{Expression, Graph, Node, Rational, Unary};

/// Π xᵢ^kᵢ, as pairs (xᵢ, kᵢ).
type Factors = Vec<(Expression, Rational)>;

impl Graph {
    /// Whether an exponent has a term with an exponential that grows where e^(k u) does.
    pub(super) fn is_tower(&self, exponent: Expression, (u, k): &(Expression, Rational)) -> bool {
        self.has_growing_term(exponent, &|v, power| {
            let ratio = self.ratio(v, *u);
            ratio.is_some_and(|ratio| !(&(&ratio * power) * k).is_negative())
        })
    }

    /// Whether an exponent has a term with a power of an exponential that is accepted.
    fn has_growing_term(
        &self,
        exponent: Expression,
        accepts: &dyn Fn(Expression, &Rational) -> bool,
    ) -> bool {
        let one = [(exponent, Rational::ONE)];
        let terms = match self.node(exponent) {
            Node::Sum(terms) => &**terms,
            _ => &one,
        };
        terms.iter().any(|(x, _)| {
            let mut factors = self.factors(*x).into_iter();
            factors.any(|(base, power)| self.exponent(base).is_some_and(|v| accepts(v, &power)))
        })
    }

    /// Moves what the first sum of exponentials among the factors grows like into the exponent of a factor beside it that is an
    /// exponential of the same exponential.
    pub(super) fn in_tower(&mut self, factors: &mut Factors) -> Option<Factors> {
        let towers = |graph: &Self, (x, _): &(Expression, Rational)| match graph.node(*x) {
            Node::Unary(Unary::Exp, w) => graph.has_growing_term(*w, &|_, _| true).then_some(*w),
            _ => None,
        };
        if !factors.iter().any(|factor| towers(self, factor).is_some()) {
            return None;
        }
        for position in 0..factors.len() {
            let (sum, power) = factors[position].clone();
            if !power.is_integer() || power.is_negative() {
                continue;
            }
            let Some(Scaled {
                scale,
                power: of_scale,
                rest,
            }) = self.scaled(sum)
            else {
                continue;
            };
            let argument = (scale.argument(), Rational::ONE);
            for other in (0..factors.len()).filter(|other| *other != position) {
                let Some(w) = towers(self, &factors[other]) else {
                    continue;
                };
                if !self.is_tower(w, &argument) {
                    continue;
                }
                let logarithm = self.growing_logarithm(scale);
                let exponent = self.sum([
                    (w, factors[other].1.clone()),
                    (logarithm, &power * &of_scale),
                ]);
                factors.remove(position.max(other));
                factors.remove(position.min(other));
                let exponential = self.unary(Unary::Exp, exponent);
                return Some(vec![(exponential, Rational::ONE), (rest, power)]);
            }
        }
        None
    }
}
