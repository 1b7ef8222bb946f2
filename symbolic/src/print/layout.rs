//! Expressions laid out as pieces of text, from left to right.
//!
//! What is still to be printed lies on a stack, so that depth costs no recursion: an expression is
//! taken off and its own pieces are put in its place. Each piece knows what it may contain without
//! parentheses.

use std::borrow::Cow;

use crate::print::names::Letters;
use crate::print::notation::Notation;
use crate::print::numeral::Numeral;
use crate::print::order::term_place;
use crate::{Binary, Expression, Graph, Node, Rational, Unary};

/// A part of a formula.
#[derive(Debug)]
pub(crate) enum Piece<'a> {
    Text(Cow<'static, str>),
    /// A bracket that opens,
    Open(&'static str),
    /// one that closes and opens,
    Middle(&'static str),
    /// and one that closes.
    Close(&'static str),
    /// An expression where no parentheses are needed: by name if it has one,
    Expression(Expression),
    /// or written out.
    Body(Expression),
    /// A multiple of a sum, term by term.
    Multiple(&'a [(Expression, Rational)], Rational),
    /// A multiple c·x in a sum, and whether it is the first.
    Term(Expression, Rational, bool),
    /// A power x^k with k > 0 in a product.
    Power(Power),
}

/// A power x^k with k > 0 in a product.
#[derive(Clone, Debug)]
pub(crate) struct Power {
    pub(crate) base: Expression,
    pub(crate) exponent: Rational,
    /// The number by which the terms of a sum are multiplied; else 1.
    pub(crate) scale: Rational,
    /// Whether a quotient's bar follows, so that a function's argument needs parentheses.
    pub(crate) before_bar: bool,
}

impl Piece<'_> {
    pub(crate) fn text(&self) -> Option<&str> {
        match self {
            Self::Text(text) => Some(text),
            Self::Open(text) | Self::Middle(text) | Self::Close(text) => Some(text),
            Self::Expression(_)
            | Self::Body(_)
            | Self::Multiple(..)
            | Self::Term(..)
            | Self::Power(_) => None,
        }
    }

    pub(crate) fn owned(text: String) -> Self {
        Self::Text(Cow::Owned(text))
    }
}

/// The precedence of an expression in print.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) enum Precedence {
    /// A sum, or anything with a minus sign in front.
    Sum,
    /// A product or quotient.
    Product,
    /// A power, a root or a function of something.
    Power,
    /// A letter, or something within its own brackets.
    Atom,
}

/// A formula of which the rest is still to be printed.
pub(crate) struct Layout<'a> {
    pub(crate) graph: &'a Graph,
    pub(crate) letters: Cow<'a, Letters>,
    pub(crate) notation: Notation,
    stack: Vec<Piece<'a>>,
}

impl<'a> Layout<'a> {
    pub(crate) fn new(
        graph: &'a Graph,
        letters: Cow<'a, Letters>,
        notation: Notation,
        root: Expression,
    ) -> Self {
        Self {
            graph,
            letters,
            notation,
            stack: vec![Piece::Body(root)],
        }
    }

    /// Takes off what is to be printed next.
    pub(crate) fn next(&mut self) -> Option<Piece<'a>> {
        self.stack.pop()
    }

    /// Puts the pieces of `piece` in its place.
    pub(crate) fn expand(&mut self, piece: Piece<'a>) {
        let mut line = Vec::new();
        match piece {
            Piece::Expression(expression) => self.expression(&mut line, expression),
            Piece::Body(expression) => self.body(&mut line, expression),
            Piece::Multiple(terms, scale) => self.sum(&mut line, terms, &scale, true),
            Piece::Term(x, coefficient, first) => self.term(&mut line, x, &coefficient, first),
            Piece::Power(factor) => self.factor(&mut line, &factor),
            Piece::Text(_) | Piece::Open(_) | Piece::Middle(_) | Piece::Close(_) => {
                line.push(piece);
            }
        }
        self.stack.extend(line.into_iter().rev());
    }

    fn expression(&self, line: &mut Vec<Piece<'a>>, expression: Expression) {
        match self.letters.definition(expression) {
            Some(name) => line.push(Piece::owned(self.letters.print(name, 0, self.notation))),
            None => self.body(line, expression),
        }
    }

    fn body(&self, line: &mut Vec<Piece<'a>>, expression: Expression) {
        match self.graph.node(expression) {
            Node::Constant(value) => {
                if value.is_negative() {
                    line.push(Piece::Text(self.notation.minus().into()));
                }
                line.push(Piece::owned(Numeral::of(value).print(self.notation)));
            }
            Node::Pi => line.push(Piece::Text(self.notation.pi().into())),
            Node::Symbol(symbol) => {
                let (spelling, dots) = self.letters.symbol(*symbol);
                line.push(Piece::owned(self.letters.print(
                    &spelling,
                    dots,
                    self.notation,
                )));
            }
            Node::Sum(terms) => self.sum(line, terms, &Rational::ONE, true),
            // By its factors, even if it has a name itself.
            Node::Product(factors) => {
                let (coefficient, factors) = self.with_positive_sums(&Rational::ONE, factors);
                self.sign(line, &coefficient, true);
                self.product(line, &coefficient.abs(), factors);
            }
            Node::Unary(function, x) => self.call(line, *function, *x, &Rational::ONE, false),
            Node::Binary(function, x, y) => self.binary(line, *function, *x, *y),
            Node::Application(function, arguments) => self.application(line, *function, arguments),
            Node::Opaque(x) => self.enclosed(line, true, *x),
        }
    }

    /// Σ cᵢ·xᵢ, beginning with a term without a minus sign if there is one.
    fn sum(
        &self,
        line: &mut Vec<Piece<'a>>,
        terms: &'a [(Expression, Rational)],
        scale: &Rational,
        first: bool,
    ) {
        let mut ordered: Vec<_> = terms.iter().collect();
        ordered.sort_by_cached_key(|(x, _)| term_place(self.graph, *x));
        let positive = |x, c: &Rational| !self.powers_of_term(x, &(c * scale)).0.is_negative();
        if let Some(position) = ordered.iter().position(|(x, c)| positive(*x, c)) {
            ordered[..=position].rotate_right(1);
        }
        for (position, (x, c)) in ordered.into_iter().enumerate() {
            line.push(Piece::Term(*x, c * scale, first && position == 0));
        }
    }

    /// A multiple c·x as a number and powers.
    fn powers_of_term(&self, x: Expression, coefficient: &Rational) -> (Rational, Vec<Power>) {
        match self.graph.node(x) {
            Node::Product(factors) if self.letters.definition(x).is_none() => {
                self.with_positive_sums(coefficient, factors)
            }
            _ => self.with_positive_sums(coefficient, &[(x, Rational::ONE)]),
        }
    }

    fn term(&self, line: &mut Vec<Piece<'a>>, x: Expression, coefficient: &Rational, first: bool) {
        let named = self.letters.definition(x).is_some();
        if let Node::Sum(terms) = self.graph.node(x)
            && coefficient.is_one()
            && !named
        {
            // A long sum that is a term of another one continues it.
            return self.sum(line, terms, &Rational::ONE, first);
        }
        let (coefficient, factors) = self.powers_of_term(x, coefficient);
        self.sign(line, &coefficient, first);
        let size = coefficient.abs();
        if x == self.graph.one() {
            line.push(Piece::owned(Numeral::of(&size).print(self.notation)));
        } else {
            self.product(line, &size, factors);
        }
    }

    /// What stands before a term.
    fn sign(&self, line: &mut Vec<Piece<'a>>, coefficient: &Rational, first: bool) {
        match (first, coefficient.is_negative()) {
            (true, false) => {}
            (true, true) => line.push(Piece::Text(self.notation.minus().into())),
            (false, negative) => {
                line.push(Piece::Text(self.notation.between_terms(negative).into()));
            }
        }
    }

    /// x, within parentheses unless it binds at least as tightly as `precedence`.
    pub(crate) fn at_least(
        &self,
        line: &mut Vec<Piece<'a>>,
        precedence: Precedence,
        x: Expression,
    ) {
        self.enclosed(line, self.precedence(x) < precedence, x);
    }

    pub(crate) fn enclosed(&self, line: &mut Vec<Piece<'a>>, parentheses: bool, x: Expression) {
        let (open, close) = self.notation.parentheses();
        line.extend(parentheses.then_some(Piece::Open(open)));
        line.push(Piece::Expression(x));
        line.extend(parentheses.then_some(Piece::Close(close)));
    }

    fn precedence(&self, expression: Expression) -> Precedence {
        if self.letters.definition(expression).is_some() {
            return Precedence::Atom;
        }
        match self.graph.node(expression) {
            Node::Constant(value) if value.is_negative() => Precedence::Sum,
            Node::Constant(value) if Numeral::of(value).is_plain() => Precedence::Atom,
            Node::Constant(_) => Precedence::Product,
            Node::Pi
            | Node::Symbol(_)
            | Node::Opaque(_)
            | Node::Unary(Unary::Exp | Unary::Abs | Unary::Signum, _)
            | Node::Binary(Binary::Atan2 | Binary::Min | Binary::Max | Binary::Scale, ..)
            | Node::Application(..) => Precedence::Atom,
            Node::Sum(terms) => match &**terms {
                [(_, c)] if !c.is_negative() => Precedence::Product,
                _ => Precedence::Sum,
            },
            Node::Product(factors) => match &**factors {
                [(_, k)] if !k.is_negative() => Precedence::Power,
                _ => Precedence::Product,
            },
            Node::Unary(..) | Node::Binary(Binary::Power, ..) => Precedence::Power,
        }
    }

    /// Whether `expression` is printed as one letter, which a function takes without parentheses.
    pub(crate) fn is_letter(&self, expression: Expression) -> bool {
        match (
            self.letters.definition(expression),
            self.graph.node(expression),
        ) {
            (Some(name), _) => !name.is_word(),
            (_, Node::Symbol(symbol)) => !self.letters.symbol(*symbol).0.is_word(),
            (_, Node::Pi) => true,
            _ => false,
        }
    }

    pub(crate) fn is_plain_number(&self, expression: Expression) -> bool {
        self.graph
            .as_constant(expression)
            .is_some_and(|value| !value.is_negative() && Numeral::of(value).is_plain())
    }
}
