//! The pieces of which a line is put together: texts, and formulas that are still to be written.

use std::borrow::Cow;

use crate::print::printed::Printed;

/// A piece of what is written.
#[derive(Debug)]
pub(crate) enum Piece {
    Text(Cow<'static, str>),
    /// A bracket that opens,
    Open(Cow<'static, str>),
    /// one that closes and opens,
    Middle(&'static str),
    /// and one that closes.
    Close(Cow<'static, str>),
    /// A formula.
    Formula(Printed),
    /// A term of a sum, whether it has a minus sign, and whether it is the first one.
    Term(bool, Printed, bool),
    /// A factor before the bar of a quotient, where a function's argument needs parentheses.
    BeforeBar(Printed),
}

impl Piece {
    /// What is written of it, unless it is to be expanded.
    pub(crate) fn text(&self) -> Option<&str> {
        match self {
            Self::Text(text) | Self::Open(text) | Self::Close(text) => Some(text),
            Self::Middle(text) => Some(text),
            Self::Formula(_) | Self::BeforeBar(_) | Self::Term(..) => None,
        }
    }
}
