//! Expressions with operators.

use core::fmt;
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::Draft;
use crate::{Binary, Expression, ExternalFunction, Graph, Matrix, Rational, Unary};

/// An expression in the graph of a [`Draft`].
#[derive(Clone, Copy)]
#[must_use]
pub struct Quantity<'d> {
    pub(super) draft: &'d Draft,
    pub(super) expression: Expression,
}

impl Quantity<'_> {
    /// The handle in the graph.
    pub fn expression(self) -> Expression {
        self.expression
    }

    pub fn sin(self) -> Self {
        self.unary(Unary::Sin)
    }

    pub fn cos(self) -> Self {
        self.unary(Unary::Cos)
    }

    pub fn abs(self) -> Self {
        self.unary(Unary::Abs)
    }

    pub fn signum(self) -> Self {
        self.unary(Unary::Signum)
    }

    pub fn sqrt(self) -> Self {
        self.make(Graph::square_root)
    }

    pub fn squared(self) -> Self {
        self.powi(2)
    }

    pub fn powi(self, exponent: i64) -> Self {
        self.make(|graph, x| graph.power(x, &Rational::integer(exponent)))
    }

    /// The power of an exact exponent, as numerator and denominator.
    pub fn powr(self, numerator: i64, denominator: i64) -> Self {
        let exponent = Rational::new(numerator, denominator).expect("a denominator but zero");
        self.make(|graph, x| graph.power(x, &exponent))
    }

    /// The power of any exponent.
    pub fn pow(self, exponent: Self) -> Self {
        self.with(exponent, |graph, x, y| graph.binary(Binary::Power, x, y))
    }

    pub fn exp(self) -> Self {
        self.unary(Unary::Exp)
    }

    pub fn ln(self) -> Self {
        self.unary(Unary::Ln)
    }

    pub fn recip(self) -> Self {
        self.powi(-1)
    }

    pub fn min(self, other: Self) -> Self {
        self.with(other, |graph, x, y| graph.binary(Binary::Min, x, y))
    }

    pub fn max(self, other: Self) -> Self {
        self.with(other, |graph, x, y| graph.binary(Binary::Max, x, y))
    }

    /// An external function of this.
    pub fn through(self, function: ExternalFunction) -> Self {
        self.make(|graph, x| graph.apply(function, &[x]))
    }

    /// The time derivative.
    pub fn dot(self) -> Self {
        let coordinates = self.draft.coordinates();
        self.make(|graph, x| graph.time_derivatives(&[x], coordinates)[0])
    }

    fn unary(self, function: Unary) -> Self {
        self.make(|graph, x| graph.unary(function, x))
    }

    fn scaled(self, factor: &Rational) -> Self {
        self.make(|graph, x| graph.scale(x, factor))
    }

    fn make(self, make: impl FnOnce(&mut Graph, Expression) -> Expression) -> Self {
        self.draft.make(|graph| make(graph, self.expression))
    }

    fn with(
        self,
        other: Self,
        make: impl FnOnce(&mut Graph, Expression, Expression) -> Expression,
    ) -> Self {
        debug_assert!(core::ptr::eq(self.draft, other.draft), "of two drafts");
        self.make(|graph, x| make(graph, x, other.expression))
    }
}

impl Add for Quantity<'_> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.with(other, Graph::add)
    }
}

impl Sub for Quantity<'_> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self.with(other, Graph::subtract)
    }
}

impl Mul for Quantity<'_> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        self.with(other, Graph::multiply)
    }
}

impl Div for Quantity<'_> {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        self.with(other, Graph::divide)
    }
}

impl Neg for Quantity<'_> {
    type Output = Self;

    fn neg(self) -> Self {
        self.make(Graph::negate)
    }
}

impl Add<i64> for Quantity<'_> {
    type Output = Self;

    fn add(self, number: i64) -> Self {
        self.make(|graph, x| graph.add_constant(x, &Rational::integer(number)))
    }
}

impl Sub<i64> for Quantity<'_> {
    type Output = Self;

    fn sub(self, number: i64) -> Self {
        self + -number
    }
}

impl<'d> Sub<Quantity<'d>> for i64 {
    type Output = Quantity<'d>;

    fn sub(self, other: Quantity<'d>) -> Quantity<'d> {
        other.draft.number(self) - other
    }
}

impl<'d> Mul<Quantity<'d>> for i64 {
    type Output = Quantity<'d>;

    fn mul(self, other: Quantity<'d>) -> Quantity<'d> {
        other.scaled(&Rational::integer(self))
    }
}

/// Panics if the divisor is zero.
impl Div<i64> for Quantity<'_> {
    type Output = Self;

    fn div(self, divisor: i64) -> Self {
        self.scaled(&Rational::new(1, divisor).expect("a divisor but zero"))
    }
}

/// The column vector of these components.
pub fn vector<const N: usize>(components: [Quantity<'_>; N]) -> Matrix {
    Matrix::vector(components.map(Quantity::expression).to_vec())
}

impl From<Quantity<'_>> for Expression {
    fn from(quantity: Quantity<'_>) -> Self {
        quantity.expression
    }
}

/// Expressions of one graph are equal if they are one node.
impl PartialEq for Quantity<'_> {
    fn eq(&self, other: &Self) -> bool {
        self.expression == other.expression
    }
}

impl PartialEq<Quantity<'_>> for Expression {
    fn eq(&self, other: &Quantity<'_>) -> bool {
        *self == other.expression
    }
}

impl fmt::Debug for Quantity<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.expression.fmt(formatter)
    }
}
