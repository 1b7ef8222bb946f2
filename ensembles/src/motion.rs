//! The results of single members.

use std::error;
use std::fmt;
use std::ops::Deref;

use lagrangian::{IntegrationError, Partial, Solution};

use crate::column::Column;

/// The motion of a member. It dereferences to its [`Solution`], and thus to its last state: `motion.t`, `motion.q[0]`,
/// `motion.events()`.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion<T, X, K = ()> {
    /// The index of the member.
    pub index: usize,
    /// The point of the member: in what it differs from the others.
    pub point: T,
    /// The motion.
    pub solution: Solution<f64, X, K>,
}

impl<T, X, K> Deref for Motion<T, X, K> {
    type Target = Solution<f64, X, K>;

    fn deref(&self) -> &Self::Target {
        &self.solution
    }
}

/// A member whose integration failed: its index, its point, the error, and the motion up to it.
#[derive(Clone, PartialEq)]
pub struct Failure<T, X, K = ()> {
    /// The index of the member.
    pub index: usize,
    /// The point of the member.
    pub point: T,
    /// The error, and the motion up to it.
    pub partial: Partial<Solution<f64, X, K>>,
    /// The parameters of the point, if they have names.
    pub(crate) parameters: Vec<(Column, f64)>,
}

impl<T, X, K> Failure<T, X, K> {
    /// Returns the error.
    #[must_use]
    pub fn error(&self) -> IntegrationError {
        self.partial.error()
    }
}

/// The index, the parameters if they have names, and the error.
impl<T, X, K> fmt::Display for Failure<T, X, K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "member {}", self.index)?;
        let mut opening = " (";
        for (column, value) in &self.parameters {
            write!(f, "{opening}{} = {value}", column.name)?;
            if !column.unit.is_empty() {
                write!(f, " {}", column.unit)?;
            }
            opening = ", ";
        }
        let closing = if self.parameters.is_empty() { "" } else { ")" };
        write!(f, "{closing}: {}", self.partial)
    }
}

impl<T, X, K> fmt::Debug for Failure<T, X, K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl<T, X, K> error::Error for Failure<T, X, K> {}
