//! One level of a formula on a line: which signs stand between its parts, and which parts are in parentheses.

use std::borrow::Cow;

use crate::Unary;
use crate::print::index::Range;
use crate::print::notation::{ELLIPSIS, Notation};
use crate::print::numeral::Numeral;
use crate::print::piece::Piece::{self, BeforeBar, Close, Formula, Middle, Open, Term, Text};
use crate::print::printed::{DOT, Part, Precedence, Printed};

/// The pieces of one formula, while it is expanded.
pub(crate) struct Line {
    notation: Notation,
    pub(crate) pieces: Vec<Piece>,
}

impl Line {
    pub(crate) const fn new(notation: Notation) -> Self {
        Self {
            notation,
            pieces: Vec::new(),
        }
    }

    fn text(&mut self, text: impl Into<Cow<'static, str>>) {
        self.pieces.push(Text(text.into()));
    }

    /// The parts of a formula and the signs between them.
    pub(crate) fn formula(&mut self, Printed(part): Printed, before_bar: bool) {
        match part {
            Part::Text(signs) => {
                let text = self.notation.of(signs);
                self.text(text);
            }
            Part::Number(number) => self.text(number.print(self.notation)),
            Part::Name(name) => self.text(name.print(self.notation)),
            Part::Sum(terms) => self.terms(terms, true),
            Part::Product(factors) => self.product(factors, before_bar),
            Part::Quotient(sides) => self.quotient(*sides),
            Part::Power(sides) => self.power(*sides, before_bar),
            Part::Root(x) => self.root(*x),
            Part::Function(function, x) => self.function(function, "", *x, before_bar),
            Part::Enclosed(open, parts, close) => {
                let [open, close] = [open, close].map(|signs| self.notation.of(signs));
                self.pieces.push(Open(open.into()));
                for (position, part) in parts.into_iter().enumerate() {
                    if position > 0 {
                        self.text(", ");
                    }
                    self.pieces.push(Formula(part));
                }
                self.pieces.push(Close(close.into()));
            }
            Part::Before(signs, x) => {
                let signs = self.notation.of(signs);
                self.text(signs);
                self.at_least(Precedence::Atom, *x);
            }
            Part::Behind(x, signs) => {
                self.at_least(Precedence::Atom, *x);
                let signs = self.notation.of(signs);
                self.text(signs);
            }
            Part::VectorProduct(sides, sign) => {
                let [left, right] = *sides;
                let least = if sign == DOT {
                    Precedence::Power
                } else {
                    Precedence::Product
                };
                self.at_least(least, left);
                let sign = self.notation.of(sign);
                self.text(sign);
                self.at_least(least, right);
            }
            Part::SumOver(range, x) => {
                self.text(range.sum_sign(self.notation));
                self.at_least(Precedence::Product, *x);
            }
            Part::SumBelow(signs, x) => {
                let signs = self.notation.of(signs);
                self.text(signs);
                self.at_least(Precedence::Product, *x);
            }
            Part::Equation(sides) => {
                let [left, right] = *sides;
                self.pieces
                    .extend([Formula(left), Text(" = ".into()), Formula(right)]);
            }
            Part::ForAll(x, ranges) => {
                self.pieces.push(Formula(*x));
                let ranges: Vec<_> = ranges
                    .iter()
                    .map(|range: &Range| range.print(self.notation))
                    .collect();
                let space = match self.notation {
                    Notation::Unicode => "  ",
                    Notation::Latex => " \\quad ",
                };
                self.text(format!("{space}({})", ranges.join("; ")));
            }
            Part::Unfolded(..) => self.text(self.notation.of(ELLIPSIS)),
        }
    }

    /// x, within parentheses unless it binds at least as tightly as `precedence`.
    fn at_least(&mut self, precedence: Precedence, x: Printed) {
        self.enclosed(x.precedence() < precedence, x, false);
    }

    fn around(&mut self, open: [&'static str; 2], x: Printed, close: [&'static str; 2]) {
        let [open, close] = [open, close].map(|signs| self.notation.of(signs));
        self.pieces
            .extend([Open(open.into()), Formula(x), Close(close.into())]);
    }

    fn enclosed(&mut self, parentheses: bool, x: Printed, before_bar: bool) {
        if parentheses {
            let [open, close] = [["(", "\\left("], [")", "\\right)"]];
            self.around(open, x, close);
        } else if before_bar {
            self.pieces.push(BeforeBar(x));
        } else {
            self.pieces.push(Formula(x));
        }
    }

    fn terms(&mut self, terms: Vec<(bool, Printed)>, first: bool) {
        for (position, (negative, term)) in terms.into_iter().enumerate() {
            let first = first && position == 0;
            self.pieces.push(Term(negative, term, first));
        }
    }

    /// A sum that is a term of another one continues it.
    pub(crate) fn continued(&mut self, sum: Printed, first: bool) {
        match sum.0 {
            Part::Sum(terms) => self.terms(terms, first),
            _ => self.term(false, sum, first),
        }
    }

    /// A term of a sum, and the sign before it.
    pub(crate) fn term(&mut self, negative: bool, term: Printed, first: bool) {
        match (first, negative) {
            (true, false) => {}
            (true, true) => self.text(self.notation.of(["−", "-"])),
            (false, true) => self.text(self.notation.of([" − ", " - "])),
            (false, false) => self.text(" + "),
        }
        self.at_least(Precedence::VectorProduct, term);
    }

    /// Factors side by side.
    fn product(&mut self, mut factors: Vec<Printed>, before_bar: bool) {
        if let Part::Number(number) = &factors[0].0
            && let Some([over, under]) = number.spread(self.notation)
        {
            let [over, under] = [over, under].map(|number| Printed(Part::Number(number)));
            if over.is_one() {
                factors.remove(0);
            } else {
                factors[0] = over;
            }
            return self.quotient([Printed::of_factors(factors), under]);
        }
        let last = factors.len() - 1;
        let mut left = None;
        for (position, factor) in factors.into_iter().enumerate() {
            let right = side(&factor);
            self.text(match (left, right) {
                (None, _) => "",
                (_, Side::Number) => self.notation.of(["·", " \\cdot "]),
                (Some(Side::Word), _) | (Some(Side::Letter), Side::Word) => {
                    self.notation.of(["·", "\\,"])
                }
                _ => " ",
            });
            let is_last = position == last;
            let is_bare = match &factor.0 {
                Part::Number(_) => true,
                Part::Quotient(_) => self.notation == Notation::Latex || is_last,
                // What a sum over an index comprises ends with the product.
                Part::SumOver(..) | Part::SumBelow(..) => is_last,
                Part::VectorProduct(..) => {
                    last == 1 && is_last && matches!(left, Some(Side::Number))
                }
                _ => factor.precedence() >= Precedence::Power,
            };
            self.enclosed(!is_bare, factor, before_bar && is_last);
            left = Some(right);
        }
    }

    fn quotient(&mut self, [above, below]: [Printed; 2]) {
        if self.notation == Notation::Latex {
            self.pieces.extend([
                Open("\\frac{".into()),
                Formula(above),
                Middle("}{"),
                Formula(below),
                Close("}".into()),
            ]);
            return;
        }
        let parentheses = above.precedence() < Precedence::Product;
        self.enclosed(parentheses, above, true);
        self.text("/");
        self.at_least(Precedence::Power, below);
    }

    fn power(&mut self, [base, exponent]: [Printed; 2], before_bar: bool) {
        let raised = self.exponent(&exponent);
        match (base.0, raised) {
            // ln cosh² x would be the logarithm of a square.
            (Part::Function(function, x), Some(raised)) if function != Unary::LogCosh => {
                self.function(function, &raised, *x, before_bar);
            }
            (base, Some(raised)) => {
                self.at_least(Precedence::Atom, Printed(base));
                self.text(raised);
            }
            (base, None) => {
                self.at_least(Precedence::Atom, Printed(base));
                if self.notation == Notation::Latex {
                    self.around(["", "^{"], exponent, ["", "}"]);
                } else {
                    self.text("^");
                    self.at_least(Precedence::Atom, exponent);
                }
            }
        }
    }

    /// A number as an exponent.
    fn exponent(&self, exponent: &Printed) -> Option<String> {
        let Part::Number(number) = &exponent.0 else {
            return None;
        };
        Some(match (self.notation, number) {
            (notation, Numeral::Decimal(digits)) if !digits.contains('.') => {
                notation.exponent(digits)
            }
            (Notation::Unicode, Numeral::Decimal(digits)) => format!("^{digits}"),
            (Notation::Unicode, Numeral::Fraction(above, below)) => format!("^({above}/{below})"),
            (Notation::Unicode, number) => format!("^({})", number.print(self.notation)),
            (Notation::Latex, Numeral::Fraction(above, below)) => format!("^{{{above}/{below}}}"),
            (Notation::Latex, number) => format!("^{{{}}}", number.print(self.notation)),
        })
    }

    fn root(&mut self, x: Printed) {
        if self.notation == Notation::Latex {
            self.around(["", "\\sqrt{"], x, ["", "}"]);
        } else {
            self.text("√");
            let is_plain = matches!(&x.0, Part::Number(number) if number.is_plain());
            self.enclosed(!x.is_letter() && !is_plain, x, false);
        }
    }

    /// f(x)^k, as f^k x where that is the custom.
    fn function(&mut self, function: Unary, raised: &str, x: Printed, before_bar: bool) {
        let name = self.notation.function(function);
        match function {
            Unary::Abs if self.notation == Notation::Latex => {
                self.around(["|", "\\left|"], x, ["|", "\\right|"]);
                self.text(raised.to_owned());
            }
            Unary::Abs | Unary::Exp | Unary::Signum => {
                self.text(name);
                self.enclosed(true, x, false);
                self.text(raised.to_owned());
            }
            _ => {
                self.text(format!("{name}{raised}"));
                let bare = x.is_letter() && !before_bar;
                if bare && (self.notation == Notation::Latex || raised.is_empty()) {
                    self.text(" ");
                }
                self.enclosed(!bare, x, false);
            }
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

/// What meets a factor's neighbours.
fn side(factor: &Printed) -> Side {
    match &factor.0 {
        Part::Name(name) if name.is_word() => Side::Word,
        Part::Number(_) => Side::Number,
        Part::Power(sides) => side(&sides[0]),
        Part::Behind(x, _) => side(x),
        Part::Root(x) if matches!(x.0, Part::Name(_)) => side(x),
        _ => Side::Letter,
    }
}
