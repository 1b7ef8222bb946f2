//! Formulas as trees of what is written: from expressions, and from energies as they are declared.
//!
//! A tree says what is a term, a factor or an exponent; the [line](crate::print::line) decides on parentheses and dots.

use crate::print::index::{Index, Range};
use crate::print::numeral::Numeral;
use crate::print::spelling::Spelling;
use crate::{Expression, Rational, Unary};

/// Signs in Unicode and in LaTeX.
pub(crate) type Signs = [String; 2];

/// A formula, or a part of one.
#[derive(Clone, PartialEq, Debug)]
pub struct Printed(pub(crate) Part);

/// What a formula is.
#[derive(Clone, PartialEq, Debug)]
pub(crate) enum Part {
    Text(Signs),
    /// A number that is not negative.
    Number(Numeral),
    Name(Spelling),
    /// Terms, each with whether it has a minus sign.
    Sum(Vec<(bool, Printed)>),
    Product(Vec<Printed>),
    Quotient(Box<[Printed; 2]>),
    Power(Box<[Printed; 2]>),
    Root(Box<Printed>),
    Function(Unary, Box<Printed>),
    /// What stands between what opens and what closes, separated by commas.
    Enclosed(Signs, Vec<Printed>, Signs),
    /// Signs before or behind something.
    Before(Signs, Box<Printed>),
    Behind(Box<Printed>, Signs),
    /// A product of vectors, which has a sign of its own.
    VectorProduct(Box<[Printed; 2]>, [&'static str; 2]),
    /// The sum of a term over an index with a range,
    SumOver(Range, Box<Printed>),
    /// or over what is written below the sign.
    SumBelow(Signs, Box<Printed>),
    Equation(Box<[Printed; 2]>),
    /// For all of these values.
    ForAll(Box<Printed>, Vec<Range>),
    /// A multiple of an expression that is not laid out yet, and how tightly it binds.
    Unfolded(Expression, Rational, Precedence),
}

/// How tightly a formula binds.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) enum Precedence {
    /// A sum, or anything with a minus sign in front.
    Sum,
    /// A product of vectors: with a factor beside it, it would look like a product of three numbers.
    VectorProduct,
    /// A product or quotient, or a sum over an index.
    Product,
    /// A power, a root or a function of something.
    Power,
    /// A letter, or something within its own brackets.
    Atom,
}

/// The sign of an inner product.
pub(crate) const DOT: [&str; 2] = ["·", " \\cdot "];

impl Printed {
    /// Signs in Unicode and in LaTeX.
    #[must_use]
    pub fn text([unicode, latex]: [&str; 2]) -> Self {
        Self(Part::Text([unicode.to_owned(), latex.to_owned()]))
    }

    /// A number.
    #[must_use]
    pub fn number(value: &Rational) -> Self {
        let size = Self(Part::Number(Numeral::of(value)));
        if value.is_negative() {
            size.negated()
        } else {
            size
        }
    }

    /// The number 0.
    #[must_use]
    pub fn zero() -> Self {
        Self::number(&Rational::ZERO)
    }

    /// A name with indices behind it and dots above it.
    #[must_use]
    pub fn name(name: &str, is_parameter: bool, indices: Vec<Index>, dots: usize) -> Self {
        let spelling = if is_parameter {
            Spelling::of_parameter(name)
        } else {
            Spelling::of(name)
        };
        Self(Part::Name(spelling.with_dots(dots).with_indices(indices)))
    }

    /// A function of one number, if it has a name in books.
    #[must_use]
    pub fn function(name: &str) -> Option<impl FnOnce(Self) -> Self> {
        let mut known = Unary::ALL.into_iter();
        let function = known.find(|function| function.name() == name)?;
        Some(move |argument| match function {
            Unary::Abs => Self::bars(argument),
            _ => Self(Part::Function(function, Box::new(argument))),
        })
    }

    /// An absolute value.
    #[must_use]
    pub fn bars(x: Self) -> Self {
        Self::within([["|", "|"], ["\\left|", "\\right|"]], vec![x])
    }

    /// A function of several numbers, called by its name in Unicode and in LaTeX.
    #[must_use]
    pub fn call([unicode, latex]: [&str; 2], arguments: Vec<Self>) -> Self {
        let opening = [format!("{unicode}("), format!("{latex}\\left(")];
        let closing = [")", "\\right)"].map(String::from);
        Self(Part::Enclosed(opening, arguments, closing))
    }

    /// A list in parentheses.
    #[must_use]
    pub fn list(list: Vec<Self>) -> Self {
        Self::call(["", ""], list)
    }

    /// A list between what opens and what closes it, in Unicode and in LaTeX.
    #[must_use]
    pub fn within([unicode, latex]: [[&str; 2]; 2], list: Vec<Self>) -> Self {
        let [opening, closing] = [0, 1].map(|i| [unicode[i], latex[i]].map(String::from));
        Self(Part::Enclosed(opening, list, closing))
    }

    /// The square root.
    #[must_use]
    pub fn root(self) -> Self {
        Self(Part::Root(Box::new(self)))
    }

    /// A power; the one with exponent 1 is the base.
    #[must_use]
    pub fn power(self, exponent: Self) -> Self {
        if exponent.is_one() {
            return self;
        }
        Self(Part::Power(Box::new([self, exponent])))
    }

    /// With signs behind it, in Unicode and in LaTeX.
    #[must_use]
    pub fn followed_by(self, signs: [&str; 2]) -> Self {
        Self(Part::Behind(Box::new(self), signs.map(String::from)))
    }

    /// With signs before it, in Unicode and in LaTeX, such as the name of a function.
    #[must_use]
    pub fn after(self, signs: [&str; 2]) -> Self {
        Self(Part::Before(signs.map(String::from), Box::new(self)))
    }

    /// A component along an axis.
    #[must_use]
    pub fn component(self, axis: &str) -> Self {
        if let Part::Name(name) = self.0 {
            let index = Index::Word(axis.to_owned());
            return Self(Part::Name(name.with_indices([index])));
        }
        let axis = format!("_{axis}");
        self.followed_by([&axis, &axis])
    }

    /// A product of two vectors with a sign between them.
    #[must_use]
    pub fn vector_product(self, other: Self, sign: [&'static str; 2]) -> Self {
        Self(Part::VectorProduct(Box::new([self, other]), sign))
    }

    /// The inner product of two vectors.
    #[must_use]
    pub fn inner_product(self, other: Self) -> Self {
        self.vector_product(other, DOT)
    }

    /// The sum over what is written below its sign, in Unicode and in LaTeX.
    pub(crate) fn summed_over(self, [unicode, latex]: [&str; 2]) -> Self {
        let signs = [format!("Σ{unicode} "), format!("\\sum_{latex} ")];
        Self(Part::SumBelow(signs, Box::new(self)))
    }

    /// The sum over an index.
    #[must_use]
    pub fn summed(self, over: Range) -> Self {
        Self(Part::SumOver(over, Box::new(self)))
    }

    /// Both sides of an equation.
    pub(crate) fn equals(self, right: Self) -> Self {
        Self(Part::Equation(Box::new([self, right])))
    }

    /// For all values of indices.
    #[must_use]
    pub fn for_all(self, ranges: Vec<Range>) -> Self {
        if ranges.is_empty() {
            return self;
        }
        Self(Part::ForAll(Box::new(self), ranges))
    }

    /// Whether it is the number 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.is_number("0")
    }

    pub(crate) fn is_one(&self) -> bool {
        self.is_number("1")
    }

    fn is_number(&self, expected: &str) -> bool {
        matches!(&self.0, Part::Number(Numeral::Decimal(digits)) if digits == expected)
    }

    /// Terms in a row; of none, 0.
    #[must_use]
    pub fn sum(terms: impl IntoIterator<Item = Self>) -> Self {
        let terms = terms.into_iter().filter(|term| !term.is_zero());
        let sum = terms.reduce(|sum, term| sum.plus(term, false));
        sum.unwrap_or_else(Self::zero)
    }

    /// A term more, or one less. A sum continues the one before it.
    #[must_use]
    pub fn plus(self, term: Self, minus: bool) -> Self {
        let mut terms = self.into_terms();
        if minus {
            terms.push((true, term));
        } else {
            terms.extend(term.into_terms());
        }
        Self::of_terms(terms)
    }

    fn into_terms(self) -> Vec<(bool, Self)> {
        match self.0 {
            Part::Sum(terms) => terms,
            _ => vec![(false, self)],
        }
    }

    /// A sum of terms; a single one without a minus sign is none.
    pub(crate) fn of_terms(mut terms: Vec<(bool, Self)>) -> Self {
        match terms.as_slice() {
            [(false, _)] => terms.swap_remove(0).1,
            _ => Self(Part::Sum(terms)),
        }
    }

    /// With the opposite sign.
    #[must_use]
    pub fn negated(self) -> Self {
        Self(Part::Sum(vec![(true, self)]))
    }

    /// A function of what a minus sign stands before, with this sign before its value.
    fn below_sign(self, function: impl FnOnce(Self) -> Self) -> Self {
        match self.0 {
            Part::Sum(mut terms) if matches!(*terms, [(true, _)]) => {
                function(terms.swap_remove(0).1).negated()
            }
            _ => function(self),
        }
    }

    /// A product.
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        self.below_sign(|left| {
            let factors = [left, other].into_iter().flat_map(|side| match side.0 {
                Part::Product(factors) => factors,
                _ => vec![side],
            });
            Self::of_factors(factors.collect())
        })
    }

    /// A product of factors; a single one is none, and without factors it is 1.
    pub(crate) fn of_factors(mut factors: Vec<Self>) -> Self {
        match factors.as_slice() {
            [] => Self::number(&Rational::ONE),
            [_] => factors.swap_remove(0),
            _ => Self(Part::Product(factors)),
        }
    }

    /// A quotient.
    #[must_use]
    pub fn over(self, other: Self) -> Self {
        self.below_sign(|above| Self(Part::Quotient(Box::new([above, other]))))
    }

    pub(crate) fn precedence(&self) -> Precedence {
        match &self.0 {
            Part::Sum(_) | Part::Equation(_) | Part::ForAll(..) => Precedence::Sum,
            Part::VectorProduct(..) => Precedence::VectorProduct,
            Part::Number(number) if !number.is_plain() => Precedence::Product,
            Part::Product(_) | Part::Quotient(_) | Part::SumOver(..) | Part::SumBelow(..) => {
                Precedence::Product
            }
            Part::Text(_)
            | Part::Number(_)
            | Part::Name(_)
            | Part::Enclosed(..)
            | Part::Behind(..)
            | Part::Function(Unary::Exp | Unary::Abs | Unary::Signum, _) => Precedence::Atom,
            Part::Power(_) | Part::Root(_) | Part::Function(..) | Part::Before(..) => {
                Precedence::Power
            }
            Part::Unfolded(.., precedence) => *precedence,
        }
    }

    /// Whether it is one letter, which a function takes without parentheses.
    pub(crate) fn is_letter(&self) -> bool {
        match &self.0 {
            Part::Name(name) => !name.is_word(),
            Part::Text(_) => true,
            _ => false,
        }
    }

    /// The formulas of which it is made, from left to right.
    pub(crate) fn parts_mut(&mut self) -> Vec<&mut Self> {
        match &mut self.0 {
            Part::Text(_) | Part::Number(_) | Part::Name(_) | Part::Unfolded(..) => Vec::new(),
            Part::Sum(terms) => terms.iter_mut().map(|(_, term)| term).collect(),
            Part::Product(parts) | Part::Enclosed(_, parts, _) => parts.iter_mut().collect(),
            Part::Quotient(sides)
            | Part::Power(sides)
            | Part::VectorProduct(sides, _)
            | Part::Equation(sides) => sides.iter_mut().collect(),
            Part::Root(x)
            | Part::Function(_, x)
            | Part::Before(_, x)
            | Part::Behind(x, _)
            | Part::SumOver(_, x)
            | Part::SumBelow(_, x)
            | Part::ForAll(x, _) => vec![&mut **x],
        }
    }

    /// Visits the formula and all that it is made of, from left to right.
    pub(crate) fn visit(&mut self, visit: &mut impl FnMut(&mut Self)) {
        visit(self);
        for part in self.parts_mut() {
            part.visit(visit);
        }
    }

    /// Visits the indices of names and the bounds of sums, from left to right.
    pub(crate) fn visit_indices(&mut self, visit: &mut impl FnMut(&mut Index)) {
        self.visit(&mut |part| match &mut part.0 {
            Part::Name(name) => name.indices.iter_mut().for_each(&mut *visit),
            Part::SumOver(range, _) => [&mut range.first, &mut range.last]
                .into_iter()
                .for_each(&mut *visit),
            _ => {}
        });
    }
}
