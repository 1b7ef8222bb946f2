//! Products and quotients laid out.

use std::cmp::Ordering;

use crate::limits::MAX_COMMON_DENOMINATOR;
use crate::print::layout::Layout;
use crate::print::numeral::Numeral;
use crate::print::order::{NAMED, factor_rank};
use crate::print::printed::{Part, Printed};
use crate::{Expression, Node, Rational, Unary};

/// A power x^k in a product.
#[derive(Clone, Debug)]
pub(crate) struct Power {
    base: Expression,
    exponent: Rational,
    /// The number by which the terms of a sum are multiplied; else 1.
    scale: Rational,
}

impl<'a> Layout<'a> {
    /// c·Π xᵢ^kᵢ with c > 0, as a product or as a quotient of two.
    pub(crate) fn product(&self, coefficient: &Rational, factors: Vec<Power>) -> Printed {
        let (above, below): (Vec<_>, Vec<_>) = factors
            .into_iter()
            .partition(|factor| !factor.exponent.is_negative());
        let (over, under) = match Numeral::of(coefficient) {
            _ if coefficient.is_one() => (None, None),
            Numeral::Fraction(over, under) if !below.is_empty() => {
                let over = Some(over).filter(|over| over != "1");
                (over.map(Numeral::Decimal), Some(Numeral::Decimal(under)))
            }
            number => (Some(number), None),
        };
        let side = |number: Option<Numeral>, powers| {
            let number = number.map(|number| Printed(Part::Number(number)));
            let factors = self
                .part(powers)
                .into_iter()
                .map(|power| self.factor(&power));
            Printed::of_factors(number.into_iter().chain(factors).collect())
        };
        if below.is_empty() {
            return side(over, above);
        }
        Printed(Part::Quotient(Box::new([
            side(over, above),
            side(under, below),
        ])))
    }

    /// The factors above or below the bar, in order.
    fn part(&self, mut part: Vec<Power>) -> Vec<Power> {
        for factor in &mut part {
            factor.exponent = factor.exponent.abs();
        }
        part.sort_by_cached_key(|factor| {
            let rank = if self.letters.definition(factor.base).is_some() {
                (NAMED, 0, 0, 0)
            } else {
                factor_rank(self.graph, factor.base, &factor.exponent)
            };
            (rank, factor.base)
        });
        part
    }

    /// A power with a positive exponent.
    fn factor(&self, factor: &Power) -> Printed {
        let (base, exponent) = (factor.base, &factor.exponent);
        if *exponent == Rational::HALF {
            return self.operand(base).root();
        }
        let base = match (self.letters.definition(base), self.graph.node(base)) {
            // ln cosh² x would be the logarithm of a square.
            (None, Node::Unary(function, x))
                if exponent.is_one() || exponent.is_integer() && *function != Unary::LogCosh =>
            {
                self.call(*function, *x)
            }
            _ if factor.scale.is_one() => self.operand(base),
            _ => self.unfolded(base, factor.scale.clone()),
        };
        base.power(Printed::number(exponent))
    }

    /// c·Π xᵢ^kᵢ as a number and powers of which the sums have integer coefficients, and at least as many terms with a
    /// plus sign as with a minus sign; the number has a minus sign only where no sum can take it.
    pub(crate) fn with_positive_sums(
        &self,
        coefficient: &Rational,
        factors: &[(Expression, Rational)],
    ) -> (Rational, Vec<Power>) {
        let mut coefficient = coefficient.clone();
        let mut powers = Vec::with_capacity(factors.len());
        let mut undecided = None;
        for (base, exponent) in factors {
            let mut scale = Rational::ONE;
            if let Some(terms) = self.terms_of(*base)
                && exponent.is_one()
            {
                scale = common_denominator(terms);
                let negative = terms.iter().filter(|(_, c)| c.is_negative()).count();
                match (2 * negative).cmp(&terms.len()) {
                    Ordering::Less => {}
                    Ordering::Equal => undecided = Some(powers.len()),
                    Ordering::Greater => scale = -&scale,
                }
                coefficient = &coefficient * &scale.reciprocal().unwrap_or(Rational::ONE);
            }
            powers.push(Power {
                base: *base,
                exponent: exponent.clone(),
                scale,
            });
        }
        if let Some(position) = undecided
            && coefficient.is_negative()
        {
            powers[position].scale = -&powers[position].scale;
            coefficient = -&coefficient;
        }
        (coefficient, powers)
    }

    /// The terms of a sum that is written out.
    fn terms_of(&self, base: Expression) -> Option<&'a [(Expression, Rational)]> {
        match self.graph.node(base) {
            Node::Sum(terms) if terms.len() > 1 && self.letters.definition(base).is_none() => {
                Some(terms)
            }
            _ => None,
        }
    }
}

/// The least number by which the coefficients of a sum become integers; 1 if they would be long.
fn common_denominator(terms: &[(Expression, Rational)]) -> Rational {
    let mut least = 1_i64;
    for (_, c) in terms {
        let Some((_, below)) = c.to_fraction() else {
            return Rational::ONE;
        };
        if below > MAX_COMMON_DENOMINATOR {
            return Rational::ONE;
        }
        least = least / greatest_common_divisor(least, below) * below;
        if least > MAX_COMMON_DENOMINATOR {
            return Rational::ONE;
        }
    }
    Rational::integer(least)
}

const fn greatest_common_divisor(mut a: i64, mut b: i64) -> i64 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}
