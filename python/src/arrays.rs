//! Arrays of numpy.

use numpy::{PyArrayDyn, PyArrayMethods as _, PyReadonlyArrayDyn};
use pyo3::exceptions::PyException;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::IntoPyDict as _;

use crate::errors::value_error;

/// The numbers of an array, row by row, and its shape.
pub(crate) struct Numbers {
    pub(crate) numbers: Vec<f64>,
    pub(crate) shape: Vec<usize>,
}

impl Numbers {
    /// Reads anything that numpy makes an array of floats from.
    ///
    /// # Errors
    ///
    /// `ValueError` with the name of the argument: it is no array of numbers, or a number is NaN.
    pub(crate) fn read(name: &str, value: &Bound<'_, PyAny>) -> PyResult<Self> {
        let py = value.py();
        let numpy = py.import("numpy")?;
        let refused =
            |what: &str| value_error(format!("{name} is not an array of numbers: {what}"));
        if value.is_none() {
            return Err(refused("it is None"));
        }
        let array = numpy.getattr("asarray")?.call1((value,)).map_err(|error| {
            if !error.is_instance_of::<PyException>(py) {
                return error;
            }
            let refused = refused(&error.value(py).to_string());
            refused.set_cause(py, Some(error));
            refused
        })?;
        let dtype = array.getattr("dtype")?;
        let kind: String = dtype.getattr("kind")?.extract()?;
        if !["f", "i", "u", "b"].contains(&kind.as_str()) {
            return Err(refused(&format!("its elements are {dtype}")));
        }
        let is_masked = numpy.getattr("ma")?.getattr("is_masked")?.call1((value,))?;
        if is_masked.is_truthy()? {
            return Err(refused("some elements are masked"));
        }
        let settings = [("dtype", "float64"), ("order", "C")].into_py_dict(py)?;
        let array = numpy.getattr("array")?.call((array,), Some(&settings))?;
        let array: PyReadonlyArrayDyn<'_, f64> = array.extract()?;
        let array = array.as_array();
        let read = Self {
            numbers: array.iter().copied().collect(),
            shape: array.shape().to_vec(),
        };
        if read.numbers.iter().any(|number| number.is_nan()) {
            return Err(value_error(format!("{name} contains NaN")));
        }
        Ok(read)
    }

    /// The numbers of an array that must have a shape.
    pub(crate) fn of_shape(self, name: &str, expected: &[usize]) -> PyResult<Vec<f64>> {
        if self.shape == expected {
            return Ok(self.numbers);
        }
        Err(value_error(format!(
            "{name} has the shape {}, but {} is needed",
            shape(&self.shape),
            shape(expected)
        )))
    }
}

/// Reads the inputs that a function returned: a number for one input, or an array.
pub(crate) fn inputs(value: &Bound<'_, PyAny>, count: usize) -> PyResult<Vec<f64>> {
    let read = Numbers::read("the value of the feedback", value)?;
    if count == 1 && read.shape.is_empty() {
        return Ok(read.numbers);
    }
    read.of_shape("the value of the feedback", &[count])
}

/// An array that is made once, and that nothing is written to.
pub(crate) fn kept<'py>(
    py: Python<'py>,
    place: &PyOnceLock<Py<PyAny>>,
    make: impl FnOnce() -> PyResult<Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let array = place.get_or_try_init(py, || {
        let array = make()?;
        let settings = [("write", false)].into_py_dict(py)?;
        array.call_method("setflags", (), Some(&settings))?;
        Ok::<_, PyErr>(array.unbind())
    })?;
    Ok(array.bind(py).clone())
}

/// An array of a shape.
pub(crate) fn array<'py>(
    py: Python<'py>,
    numbers: Vec<f64>,
    shape: &[usize],
) -> PyResult<Bound<'py, PyAny>> {
    let array = numpy::PyArray1::from_vec(py, numbers);
    let array: Bound<'py, PyArrayDyn<f64>> = array.reshape(shape.to_vec())?;
    Ok(array.into_any())
}

/// A shape as Python writes it.
pub(crate) fn shape(lengths: &[usize]) -> String {
    match lengths {
        [one] => format!("({one},)"),
        several => {
            let several: Vec<_> = several.iter().map(ToString::to_string).collect();
            format!("({})", several.join(", "))
        }
    }
}
