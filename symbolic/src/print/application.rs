//! Powers, roots and functions laid out.

use crate::print::layout::{Layout, Piece, Power, Precedence};
use crate::print::notation::Notation;
use crate::print::numeral::Numeral;
use crate::{Binary, Expression, ExternalFunction, Node, Rational, Unary};

impl<'a> Layout<'a> {
    pub(crate) fn factor(&self, line: &mut Vec<Piece<'a>>, factor: &Power) {
        let (base, exponent) = (factor.base, &factor.exponent);
        if *exponent == Rational::HALF {
            return self.root(line, base);
        }
        if let (None, Node::Unary(function, x)) =
            (self.letters.definition(base), self.graph.node(base))
            && exponent.is_integer()
            // The exponent of ln cosh x would be that of cosh x.
            && (exponent.is_one() || *function != Unary::LogCosh)
        {
            return self.call(line, *function, *x, exponent, factor.before_bar);
        }
        if !factor.scale.is_one() {
            let (open, close) = self.notation.parentheses();
            line.extend([Piece::Open(open), self.base(factor), Piece::Close(close)]);
            return;
        }
        if exponent.is_one() {
            return self.at_least(line, Precedence::Power, base);
        }
        self.at_least(line, Precedence::Atom, base);
        line.push(Piece::owned(self.exponent(exponent)));
    }

    /// The exponent k > 0 behind a base.
    fn exponent(&self, exponent: &Rational) -> String {
        if exponent.is_one() {
            return String::new();
        }
        if exponent.is_integer() {
            return self.notation.exponent(&exponent.to_string());
        }
        match (self.notation, Numeral::of(exponent)) {
            (Notation::Unicode, Numeral::Fraction(above, below)) => format!("^({above}/{below})"),
            (Notation::Unicode, numeral @ Numeral::Scientific(..)) => {
                format!("^({})", numeral.print(self.notation))
            }
            (Notation::Unicode, Numeral::Decimal(digits)) => format!("^{digits}"),
            (Notation::Latex, Numeral::Fraction(above, below)) => format!("^{{{above}/{below}}}"),
            (Notation::Latex, numeral) => format!("^{{{}}}", numeral.print(self.notation)),
        }
    }

    fn root(&self, line: &mut Vec<Piece<'a>>, x: Expression) {
        if self.notation == Notation::Latex {
            line.extend([
                Piece::Open("\\sqrt{"),
                Piece::Expression(x),
                Piece::Close("}"),
            ]);
        } else {
            line.push(Piece::Text("√".into()));
            let letter = self.is_letter(x) || self.is_plain_number(x);
            self.enclosed(line, !letter, x);
        }
    }

    /// f(x)^k for k ≥ 1, as f^k x where that is the custom.
    pub(crate) fn call(
        &self,
        line: &mut Vec<Piece<'a>>,
        function: Unary,
        x: Expression,
        exponent: &Rational,
        before_bar: bool,
    ) {
        let raised = self.exponent(exponent);
        let name = self.notation.function(function);
        match function {
            Unary::Abs
                if self.notation == Notation::Latex
                    || !self.graph.contents(x).has_absolute_value() =>
            {
                let (open, close) = self.notation.bars();
                line.extend([Piece::Open(open), Piece::Expression(x), Piece::Close(close)]);
                line.push(Piece::owned(raised));
            }
            Unary::Abs | Unary::Exp | Unary::Signum => {
                line.push(Piece::Text(name.into()));
                self.enclosed(line, true, x);
                line.push(Piece::owned(raised));
            }
            _ => {
                line.push(Piece::owned(format!("{name}{raised}")));
                let bare = self.is_letter(x) && !before_bar;
                if bare && (self.notation == Notation::Latex || exponent.is_one()) {
                    line.push(Piece::Text(" ".into()));
                }
                self.enclosed(line, !bare, x);
            }
        }
    }

    pub(crate) fn binary(
        &self,
        line: &mut Vec<Piece<'a>>,
        function: Binary,
        x: Expression,
        y: Expression,
    ) {
        let name = match (self.notation, function) {
            (_, Binary::Power) => return self.real_power(line, x, y),
            (Notation::Unicode, function) | (_, function @ Binary::Scale) => function.name(),
            (Notation::Latex, Binary::Atan2) => "\\operatorname{atan2}",
            (Notation::Latex, Binary::Min) => "\\min",
            (Notation::Latex, Binary::Max) => "\\max",
        };
        line.push(Piece::Text(name.into()));
        self.arguments(line, &[x, y]);
    }

    /// An external function, called by its declared name.
    pub(crate) fn application(
        &self,
        line: &mut Vec<Piece<'a>>,
        function: ExternalFunction,
        arguments: &[Expression],
    ) {
        let name = self.graph.function_name(function);
        line.push(Piece::owned(self.notation.operator(name)));
        self.arguments(line, arguments);
    }

    /// (x, y, …).
    fn arguments(&self, line: &mut Vec<Piece<'a>>, arguments: &[Expression]) {
        let (open, close) = self.notation.parentheses();
        line.push(Piece::Open(open));
        for (position, argument) in arguments.iter().enumerate() {
            if position > 0 {
                line.push(Piece::Text(", ".into()));
            }
            line.push(Piece::Expression(*argument));
        }
        line.push(Piece::Close(close));
    }

    fn real_power(&self, line: &mut Vec<Piece<'a>>, x: Expression, y: Expression) {
        self.at_least(line, Precedence::Atom, x);
        if self.notation == Notation::Latex {
            line.extend([Piece::Open("^{"), Piece::Expression(y), Piece::Close("}")]);
        } else {
            line.push(Piece::Text("^".into()));
            self.at_least(line, Precedence::Atom, y);
        }
    }
}
