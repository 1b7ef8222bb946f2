//! Exceptions.

use pyo3::create_exception;
use pyo3::exceptions::{PyArithmeticError, PyValueError};
use pyo3::prelude::*;

create_exception!(
    lagrangian,
    IntegrationError,
    PyArithmeticError,
    "A motion that could not be integrated to its end. `motion` is the motion up to the error."
);

/// A `ValueError` with a message.
pub(crate) fn value_error(message: impl Into<String>) -> PyErr {
    PyValueError::new_err(message.into())
}
