//! Products and quotients laid out.

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
        factors: &[(Expression, Rational)],
    ) {
        let (mut above, mut below) = (self.part(factors, false), self.part(factors, true));
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
    fn part(&self, factors: &[(Expression, Rational)], below: bool) -> Vec<Power> {
        let mut part: Vec<_> = factors
            .iter()
            .filter(|(_, exponent)| exponent.is_negative() == below)
            .map(|(base, exponent)| Power {
                base: *base,
                exponent: exponent.abs(),
                before_bar: false,
            })
            .collect();
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
                line.push(Piece::Expression(factor.base));
            }
            _ => self.juxtapose(line, number, factors),
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
