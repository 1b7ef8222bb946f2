//! Errors that carry the results up to them.

#[cfg(feature = "alloc")]
use alloc::boxed::Box;
use core::fmt;

use super::error::IntegrationError;

/// An error that stopped an integration, with the results up to then, such as a [`Solution`](crate::Solution). The
/// operator `?` converts it to the error alone.
#[derive(Clone, PartialEq)]
pub struct Partial<T> {
    // A single pointer if there is an allocator, so that a `Result` is not large because of its error.
    #[cfg(feature = "alloc")]
    parts: Box<(IntegrationError, T)>,
    #[cfg(not(feature = "alloc"))]
    parts: (IntegrationError, T),
}

impl<T> Partial<T> {
    pub(super) fn new(error: IntegrationError, value: T) -> Self {
        let parts = (error, value);
        Self {
            #[cfg(feature = "alloc")]
            parts: Box::new(parts),
            #[cfg(not(feature = "alloc"))]
            parts,
        }
    }

    /// Returns the error.
    #[must_use]
    pub fn error(&self) -> IntegrationError {
        self.parts.0
    }

    pub(super) fn value(&self) -> &T {
        &self.parts.1
    }

    pub(super) fn into_value(self) -> T {
        self.parts.1
    }
}

/// Shows the message without the results, which may be long.
impl<T> fmt::Debug for Partial<T>
where
    Self: fmt::Display,
{
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl<T> core::error::Error for Partial<T> where Self: fmt::Display {}

impl<T> From<Partial<T>> for IntegrationError {
    fn from(partial: Partial<T>) -> Self {
        partial.error()
    }
}
