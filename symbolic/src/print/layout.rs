//! Expressions laid out as formulas.
//!
//! What is deep is laid out level by level: an operand that is neither a letter nor a number is
//! [unfolded](Part::Unfolded) later.

use crate::limits::{MAX_PRINTED_DEPTH, MAX_UNFOLDED_LINE_LENGTH};
use crate::print::names::Letters;
use crate::print::notation::Notation;
use crate::print::order::term_place;
use crate::print::printed::{Part, Precedence, Printed};
use crate::print::quotient::Power;
use crate::{Binary, Expression, Graph, Node, Rational, Unary};

impl Graph {
    /// All of an expression that is written out, what it is made of by name; none where it is longer than a line may be.
    pub(crate) fn written_out(&self, x: Expression, letters: &Letters) -> Option<Printed> {
        let graph = self;
        Layout { graph, letters }.whole(x)
    }

    /// All of an expression, by name if it has one.
    pub(crate) fn printed(&self, x: Expression, letters: &Letters) -> Option<Printed> {
        let name = letters.definition(x).cloned();
        name.or_else(|| self.written_out(x, letters))
    }
}

/// Lays out expressions.
pub(crate) struct Layout<'a> {
    pub(crate) graph: &'a Graph,
    pub(crate) letters: &'a Letters,
}

impl Layout<'_> {
    fn whole(&self, x: Expression) -> Option<Printed> {
        let mut formula = self.body(x);
        // What is one sign, such as x², has three parts.
        let mut room = 2 * MAX_UNFOLDED_LINE_LENGTH;
        self.complete(&mut formula, &mut room, MAX_PRINTED_DEPTH)?;
        Some(formula)
    }

    fn complete(&self, formula: &mut Printed, room: &mut usize, depth: usize) -> Option<()> {
        *room = room.checked_sub(1)?;
        let depth = depth.checked_sub(1)?;
        if let Part::Unfolded(x, scale, _) = &formula.0 {
            *formula = self.multiple(*x, scale);
        }
        for part in formula.parts_mut() {
            self.complete(part, room, depth)?;
        }
        if let Part::Sum(terms) = &mut formula.0 {
            // A sum that is a term of another one continues it.
            let terms = core::mem::take(terms).into_iter();
            let terms = terms.flat_map(|(negative, term)| match term.0 {
                Part::Sum(terms) if !negative => terms,
                _ => vec![(negative, term)],
            });
            formula.0 = Part::Sum(terms.collect());
        }
        Some(())
    }

    /// A multiple of an expression that is written out.
    pub(crate) fn multiple(&self, x: Expression, scale: &Rational) -> Printed {
        match self.graph.node(x) {
            Node::Sum(terms) if !scale.is_one() => Printed::of_terms(self.terms(terms, scale)),
            _ => self.body(x),
        }
    }

    /// An expression by name if it has one.
    pub(crate) fn operand(&self, x: Expression) -> Printed {
        match (self.letters.definition(x), self.graph.node(x)) {
            (Some(name), _) => name.clone(),
            (None, Node::Constant(_) | Node::Pi | Node::Symbol(_)) => self.body(x),
            _ => self.unfolded(x, Rational::ONE),
        }
    }

    pub(crate) fn unfolded(&self, x: Expression, scale: Rational) -> Printed {
        Printed(Part::Unfolded(x, scale, self.precedence(x)))
    }

    /// An expression that is written out.
    pub(crate) fn body(&self, x: Expression) -> Printed {
        match self.graph.node(x) {
            Node::Constant(value) => Printed::number(value),
            Node::Pi => Printed::text(["π", "\\pi"]),
            Node::Symbol(symbol) => Printed(Part::Name(self.letters.symbol(*symbol))),
            Node::Sum(terms) => Printed::of_terms(self.terms(terms, &Rational::ONE)),
            // By its factors, even if it has a name itself.
            Node::Product(factors) => {
                let (coefficient, factors) = self.with_positive_sums(&Rational::ONE, factors);
                let product = self.product(&coefficient.abs(), factors);
                Printed::of_terms(vec![(coefficient.is_negative(), product)])
            }
            Node::Unary(function, x) => self.call(*function, *x),
            Node::Binary(Binary::Power, x, y) => {
                let sides = [*x, *y].map(|side| self.operand(side));
                Printed(Part::Power(Box::new(sides)))
            }
            Node::Binary(function, x, y) => {
                let name = match function {
                    Binary::Atan2 => ["atan2", "\\operatorname{atan2}"],
                    Binary::Min => ["min", "\\min"],
                    Binary::Max => ["max", "\\max"],
                    other => [other.name(); 2],
                };
                Printed::call(name, [*x, *y].map(|side| self.operand(side)).into())
            }
            // An external function is called by its declared name.
            Node::Application(function, arguments) => {
                let name = self.graph.function_name(*function);
                let name = [Notation::Unicode, Notation::Latex].map(|it| it.operator(name));
                let arguments = arguments.iter().map(|x| self.operand(*x));
                Printed::call(name.each_ref().map(|name| &**name), arguments.collect())
            }
            Node::Opaque(x) => Printed::list(vec![self.operand(*x)]),
        }
    }

    /// Σ cᵢ·xᵢ, beginning with a term without a minus sign if there is one.
    fn terms(&self, terms: &[(Expression, Rational)], scale: &Rational) -> Vec<(bool, Printed)> {
        let mut ordered: Vec<_> = terms.iter().collect();
        ordered.sort_by_cached_key(|(x, _)| term_place(self.graph, *x));
        let terms = ordered.into_iter().map(|(x, c)| {
            let c = c * scale;
            let (coefficient, powers) = self.powers_of_term(*x, &c);
            let (size, negative) = (coefficient.abs(), coefficient.is_negative());
            let is_sum = matches!(self.graph.node(*x), Node::Sum(_));
            let term = if is_sum && c.is_one() && self.letters.definition(*x).is_none() {
                // A long sum that is a term of another one continues it.
                (false, self.unfolded(*x, Rational::ONE))
            } else if *x == self.graph.one() {
                (negative, Printed::number(&size))
            } else {
                (negative, self.product(&size, powers))
            };
            (negative, term)
        });
        let mut terms: Vec<_> = terms.collect();
        if let Some(position) = terms.iter().position(|(negative, _)| !negative) {
            terms[..=position].rotate_right(1);
        }
        terms.into_iter().map(|(_, term)| term).collect()
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

    pub(crate) fn call(&self, function: Unary, x: Expression) -> Printed {
        let argument = self.operand(x);
        if function == Unary::Abs && !self.graph.contents(x).has_absolute_value() {
            return Printed::bars(argument);
        }
        Printed(Part::Function(function, Box::new(argument)))
    }

    /// How tightly what is neither a letter nor a number binds.
    fn precedence(&self, x: Expression) -> Precedence {
        match self.graph.node(x) {
            Node::Sum(terms) if terms.len() == 1 && !terms[0].1.is_negative() => {
                Precedence::Product
            }
            Node::Sum(_) => Precedence::Sum,
            Node::Product(factors) if factors.len() == 1 && !factors[0].1.is_negative() => {
                Precedence::Power
            }
            Node::Product(_) => Precedence::Product,
            Node::Unary(Unary::Exp | Unary::Abs | Unary::Signum, _) => Precedence::Atom,
            Node::Unary(..) | Node::Binary(Binary::Power, ..) => Precedence::Power,
            _ => Precedence::Atom,
        }
    }
}
