//! The base class of all models.

use std::hash::{DefaultHasher, Hash as _, Hasher as _};

use pyo3::exceptions::{PyAttributeError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple, PyType};

use crate::description::Description;
use crate::errors::value_error;
use crate::evaluator::Evaluator;
use crate::fields;
use crate::parameters;
use crate::registry;

/// A mechanical system at its parameters. Each model of the module is a class of its own, whose help lists its parameters;
/// objects do not change.
///
/// States are arrays: coordinates q and velocities v of shape (n,) for one state, or (k, n) for many, at a time t or at
/// times of shape (k,). Results have the index of the state first.
#[pyclass(subclass, frozen, module = "lagrangian", name = "Model")]
pub struct Model {
    pub(crate) description: &'static Description,
    pub(crate) numbers: Vec<f64>,
    pub(crate) evaluator: Box<dyn Evaluator>,
}

/// An argument.
pub(crate) type Any<'a, 'py> = &'a Bound<'py, PyAny>;

/// An argument that may be left out.
pub(crate) type Maybe<'a, 'py> = Option<&'a Bound<'py, PyAny>>;

impl Model {
    fn build(description: &'static Description, numbers: Vec<f64>) -> PyResult<Self> {
        let evaluator = (description.build)(&numbers);
        let evaluator = evaluator.map_err(|error| value_error(format!("{error:?}")))?;
        Ok(Self {
            description,
            numbers,
            evaluator,
        })
    }

    pub(crate) fn dimension(&self) -> usize {
        self.description.coordinates.len()
    }

    /// The parameters by their names.
    fn values<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let values = PyDict::new(py);
        let mut rest = self.numbers.as_slice();
        for field in self.description.fields {
            let (numbers, behind) = rest.split_at(field.count().min(rest.len()));
            values.set_item(field.name, fields::value(py, field, numbers)?)?;
            rest = behind;
        }
        Ok(values)
    }
}

#[pymethods]
impl Model {
    #[new]
    #[classmethod]
    #[pyo3(signature = (*args, **parameters))]
    fn new(
        cls: &Bound<'_, PyType>,
        args: &Bound<'_, PyTuple>,
        parameters: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let description = registry::description(cls).ok_or_else(|| {
            PyTypeError::new_err(
                "Model is the base class of the models of this module: create one of them",
            )
        })?;
        if !args.is_empty() {
            return Err(PyTypeError::new_err(format!(
                "{} takes its parameters by keyword: {}",
                description.name,
                description.parameters()
            )));
        }
        Self::build(description, parameters::numbers(description, parameters)?)
    }

    /// The parameters and the inputs, by their names.
    #[getter]
    fn parameters<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.values(py)
    }

    /// Returns a model with some parameters changed.
    #[pyo3(signature = (**changes))]
    fn replace<'py>(
        slf: &Bound<'py, Self>,
        changes: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let parameters = slf.get().values(slf.py())?;
        if let Some(changes) = changes {
            parameters.update(changes.as_mapping())?;
        }
        slf.get_type().call((), Some(&parameters))
    }

    /// A parameter by its name, for the properties of the classes.
    fn _parameter<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        let (field, first) = self.description.field(name).ok_or_else(|| {
            PyAttributeError::new_err(format!("{} has no {name}", self.description.name))
        })?;
        let numbers = self.numbers.get(first..first + field.count());
        fields::value(py, field, numbers.unwrap_or_default())
    }

    fn __eq__(slf: &Bound<'_, Self>, other: &Bound<'_, PyAny>) -> bool {
        let other = other.cast::<Self>().ok();
        other.is_some_and(|other| {
            slf.get_type().is(other.get_type()) && slf.get().numbers == other.get().numbers
        })
    }

    fn __hash__(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        self.description.name.hash(&mut hasher);
        for number in &self.numbers {
            // 0 and -0 are equal.
            (number + 0.0).to_bits().hash(&mut hasher);
        }
        hasher.finish()
    }

    fn __getnewargs_ex__<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Bound<'py, PyTuple>, Bound<'py, PyDict>)> {
        Ok((PyTuple::empty(py), self.values(py)?))
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let mut values = Vec::new();
        for (name, value) in &self.values(py)? {
            values.push(format!("{}={}", name.str()?, value.repr()?));
        }
        Ok(format!("{}({})", self.description.name, values.join(", ")))
    }
}
