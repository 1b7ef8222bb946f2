//! External functions, such as tables: known by their names and their declared derivatives alone.
//!
//! A function is declared first and its derivatives afterwards, as expressions in its
//! [arguments](crate::Symbol::Argument), so that functions can be each other's derivatives. The set of functions
//! is closed under differentiation: a derivative that is not declared is a further external function of the same
//! arguments; whether it is needed is seen in the programs that apply it.

use crate::Expression;

/// A handle to an external function of one [`Graph`](crate::Graph).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct ExternalFunction(pub(super) u32);

impl ExternalFunction {
    /// The position in the order of declaration.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// The declaration of an external function.
#[derive(Clone, Debug)]
pub(crate) struct ExternalDeclaration {
    pub(super) name: String,
    pub(super) arguments: Vec<String>,
    /// By argument, in the symbols of the arguments.
    pub(super) derivatives: Vec<Option<Expression>>,
    /// The function and the argument whose derivative this is, if it was not declared.
    pub(super) undeclared: Option<(ExternalFunction, usize)>,
}
