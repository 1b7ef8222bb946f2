//! Products and quotients laid out.

use std::cmp::Ordering;

use crate::limits::MAX_COMMON_DENOMINATOR;
use crate::print::layout::{Layout, Piece, Power};
use crate::print::notation::Notation;
use crate::print::numeral::Numeral;
use crate::print::order::{NAMED, factor_rank};
use crate::{Expression, Node, Rational};

impl<'a> Layout<'a> {
    /// c·Π xᵢ^kᵢ with c > 0, as a product or as a quotient of two.
    pub(crate) fn product(
        &self,
        line: &mut Vec<Piece<'a>>,
        coefficient: &Rational,
        factors: Vec<Power>,
    ) {
        let (above, below) = factors
            .into_iter()
            .partition(|factor| !factor.exponent.is_negative());
        let (mut above, mut below) = (self.part(above), self.part(below));
        let numeral = Numeral::of(coefficient);
        let (over, under) = match (numeral.coefficient(self.notation), numeral) {
            _ if coefficient.is_one() => (None, None),
            (Some(text), _) if below.is_empty() => (Some(text), None),
            (_, Numeral::Fraction(over, under)) => {
                (Some(over).filter(|one| one != "1"), Some(under))
            }
            (text, _) => (text, None),
        };
        if below.is_empty() && under.is_none() {
            return self.juxtapose(line, over, above);
        }
        if self.notation == Notation::Latex {
            line.push(Piece::Open("\\frac{"));
            self.side(line, over, above);
            line.push(Piece::Middle("}{"));
            self.side(line, under, below);
            line.push(Piece::Close("}"));
            return;
        }
        if let Some(last) = above.last_mut() {
            last.before_bar = true;
        }
        self.juxtapose(line, over, above);
        line.push(Piece::Text("/".into()));
        let single = below.len() + usize::from(under.is_some()) == 1;
        let (open, close) = self.notation.parentheses();
        line.extend((!single).then_some(Piece::Open(open)));
        if let (true, Some(factor)) = (single, below.first_mut()) {
            factor.before_bar = false;
        }
        self.juxtapose(line, under, below);
        line.extend((!single).then_some(Piece::Close(close)));
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

    /// One side of a fraction in LaTeX, where a single sum needs no parentheses.
    fn side(&self, line: &mut Vec<Piece<'a>>, number: Option<String>, factors: Vec<Power>) {
        match (&number, factors.as_slice()) {
            (None, [factor]) if factor.exponent.is_one() => {
                line.push(self.base(factor));
            }
            _ => self.juxtapose(line, number, factors),
        }
    }

    /// The base of a power where it needs no parentheses.
    pub(crate) fn base(&self, factor: &Power) -> Piece<'a> {
        match self.graph.node(factor.base) {
            Node::Sum(terms) if !factor.scale.is_one() => {
                Piece::Multiple(terms, factor.scale.clone())
            }
            _ => Piece::Expression(factor.base),
        }
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
            if let Some(terms) = self.terms(*base)
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
                before_bar: false,
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
    fn terms(&self, base: Expression) -> Option<&'a [(Expression, Rational)]> {
        match self.graph.node(base) {
            Node::Sum(terms) if terms.len() > 1 && self.letters.definition(base).is_none() => {
                Some(terms)
            }
            _ => None,
        }
    }

    /// A number and factors side by side.
    fn juxtapose(&self, line: &mut Vec<Piece<'a>>, number: Option<String>, factors: Vec<Power>) {
        let empty = number.is_none() && factors.is_empty();
        let mut left = number.is_some().then_some(Side::Number);
        line.extend(number.map(Piece::owned));
        if empty {
            line.push(Piece::Text("1".into()));
        }
        for factor in factors {
            let right = self.side_of(&factor);
            let separator = match (left, right) {
                (None, _) => "",
                (_, Side::Number) => self.notation.before_number(),
                (Some(Side::Word), _) | (Some(Side::Letter), Side::Word) => {
                    self.notation.between_words()
                }
                _ => " ",
            };
            line.push(Piece::Text(separator.into()));
            line.push(Piece::Power(factor));
            left = Some(right);
        }
    }

    /// What meets a factor's neighbours.
    fn side_of(&self, factor: &Power) -> Side {
        let word = |word| if word { Side::Word } else { Side::Letter };
        match (
            self.letters.definition(factor.base),
            self.graph.node(factor.base),
        ) {
            (Some(name), _) => word(name.is_word()),
            (_, Node::Symbol(symbol)) => word(self.letters.symbol(*symbol).0.is_word()),
            (_, Node::Constant(_)) if factor.exponent != Rational::HALF => Side::Number,
            _ => Side::Letter,
        }
    }
}

/// What a factor shows to its neighbours.
#[derive(Clone, Copy)]
enum Side {
    Number,
    Letter,
    Word,
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
