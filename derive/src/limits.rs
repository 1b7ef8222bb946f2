//! The limits of this crate, each with the model that set it and what would move it.

use lagrangian_symbolic::Rational;

/// How many scopes may be nested with a `let` for each variable. rustc 1.95 without optimization overflows at
/// 2500; the derivatives of an arm of six joints in space have as many variables.
pub(crate) const MOST_SCOPES: usize = 1000;

/// How many variables are declared at once in a long method.
pub(crate) const DECLARED_AT_ONCE: usize = 200;

/// How deep expressions are nested in one statement.
pub(crate) const DEEPEST_NESTING: usize = 6;

/// The most numbers that a field may hold. Each is a symbol of the equations and has a name, used or not,
/// which takes a macro 45 microseconds and two kilobytes: at most half a second for a field.
pub(crate) const MOST_COMPONENTS: usize = 10_000;

/// How many coordinates may have one name.
pub(crate) const LARGEST_FAMILY: usize = 1000;

/// The most components that a vector or matrix may have.
pub(crate) const LARGEST_ARRAY: usize = 10_000;

/// The most rows of an identity matrix, and of the diagonal matrix of a vector.
pub(crate) const MOST_DIAGONAL_ROWS: usize = 100;

/// How often expressions may be repeated in one declaration, all together.
pub(crate) const MOST_REPETITIONS: usize = 100_000;

/// For more coordinates the relative pivots are those of a numerical factorization.
pub(crate) const MOST_PIVOTS: usize = 4;

/// Formulas longer than this are broken off; their text serves nobody.
pub(crate) const LONGEST_FORMULA: usize = 600;

/// How many names an error lists.
pub(crate) const MOST_NAMES: usize = 10;

/// Whether a number is neither beyond the largest nor lost below the smallest `f64`.
pub(crate) fn in_range(number: &Rational) -> bool {
    let rounded = number.to_f64();
    rounded.is_finite() && (rounded != 0.0 || number.is_zero())
}
