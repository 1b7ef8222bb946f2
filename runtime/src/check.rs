//! Checks of handwritten derivatives, for tests. Requires the feature `derivative-checks`.

mod derivative_check;
mod derivative_error;
mod numerical_derivative;

pub use derivative_check::{CheckDerivatives, check_derivatives};
pub use derivative_error::{ArgumentValues, DerivativeError};
