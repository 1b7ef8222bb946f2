//! A constraint as it is declared.

use crate::Expression;

/// A relation that holds in every motion: an expression that is zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Constraint {
    /// g(q, t) = 0.
    Holonomic(Expression),
    /// A(q, t) q̇ + a(q, t) = 0.
    Nonholonomic(Expression),
}

impl Constraint {
    /// The expression that is zero.
    #[must_use]
    pub const fn expression(self) -> Expression {
        match self {
            Self::Holonomic(expression) | Self::Nonholonomic(expression) => expression,
        }
    }

    /// A constraint of this kind, with another expression.
    pub(crate) const fn with_expression(self, expression: Expression) -> Self {
        match self {
            Self::Holonomic(_) => Self::Holonomic(expression),
            Self::Nonholonomic(_) => Self::Nonholonomic(expression),
        }
    }

    /// Whether it is declared as a relation of coordinates.
    #[must_use]
    pub const fn is_holonomic(self) -> bool {
        matches!(self, Self::Holonomic(_))
    }
}
