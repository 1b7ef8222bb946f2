//! External functions, which a declaration uses and Rust code computes.

use crate::scalar::Scalar;

/// The names of a function and of its arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FunctionSignature {
    /// The name of the function.
    pub name: &'static str,
    /// The names of its arguments, in order.
    pub arguments: &'static [&'static str],
}

/// A model whose declaration has `function(name(argument, …) = …)`.
///
/// `#[derive(Lagrangian)]` implements this trait. The feature `derivative-checks` adds a check of the declared
/// derivatives against the functions, `CheckDerivatives`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no external functions",
    note = "write the clause `function(f(x) = …, derivative(x) = …)` in its declaration"
)]
pub trait ExternalFunctions {
    /// The scalar on which the functions are evaluated.
    type Scalar: Scalar;

    /// The functions, in the order of declaration.
    const FUNCTIONS: &'static [FunctionSignature];

    /// Returns the value of the function at a position; NaN unless there is one with this number of arguments.
    fn function(&self, function: usize, arguments: &[Self::Scalar]) -> Self::Scalar;

    /// Returns the declared derivative of a function by one of its arguments, given by their positions; `None` if it is
    /// not declared.
    fn derivative(
        &self,
        function: usize,
        argument: usize,
        arguments: &[Self::Scalar],
    ) -> Option<Self::Scalar>;
}
