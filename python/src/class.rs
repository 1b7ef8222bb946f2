//! The classes of a module.

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple, PyType};

use crate::description::Description;
use crate::errors::IntegrationError;
use crate::model::Model;
use crate::motion::{Event, Motion, Point};
use crate::motions::Motions;
use crate::registry;

/// Adds what all modules have.
///
/// # Errors
///
/// If Python does not allow it.
pub fn add_shared(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Model>()?;
    module.add_class::<Motion>()?;
    module.add_class::<Motions>()?;
    module.add_class::<Event>()?;
    module.add_class::<Point>()?;
    module.add(
        "IntegrationError",
        module.py().get_type::<IntegrationError>(),
    )
}

/// Adds the class of a model.
///
/// # Errors
///
/// If Python does not allow it.
pub fn add(module: &Bound<'_, PyModule>, description: &Description) -> PyResult<()> {
    let py = module.py();
    let description: &'static Description = Box::leak(Box::new(*description));
    let index = registry::register(description);
    let attributes = PyDict::new(py);
    attributes.set_item("__doc__", description.docstring())?;
    attributes.set_item("__module__", module.name()?)?;
    attributes.set_item("__signature__", signature(py, description)?)?;
    attributes.set_item("COORDINATES", PyTuple::new(py, description.coordinates)?)?;
    attributes.set_item("INPUTS", PyTuple::new(py, description.inputs)?)?;
    attributes.set_item("EVENTS", PyTuple::new(py, description.events)?)?;
    attributes.set_item("CONSTRAINTS", PyTuple::new(py, description.constraints)?)?;
    let outputs = description.outputs.iter().map(|output| output.name);
    attributes.set_item("OUTPUTS", PyTuple::new(py, outputs.collect::<Vec<_>>())?)?;
    let parameters = description.fields.iter().map(|field| field.name);
    attributes.set_item(
        "PARAMETERS",
        PyTuple::new(py, parameters.collect::<Vec<_>>())?,
    )?;
    attributes.set_item("EQUATIONS", description.equations)?;
    attributes.set_item("LATEX", description.latex)?;
    attributes.set_item(registry::INDEX, index)?;
    let bases = (py.get_type::<Model>(),);
    let class = py
        .get_type::<PyType>()
        .call1((description.name, bases, attributes))?;
    module.add(description.name, class)
}

/// The signature that `help` shows: all fields by keyword, inputs with 0.
fn signature<'py>(py: Python<'py>, description: &Description) -> PyResult<Bound<'py, PyAny>> {
    let inspect = py.import("inspect")?;
    let parameter = inspect.getattr("Parameter")?;
    let by_keyword = parameter.getattr("KEYWORD_ONLY")?;
    let mut parameters = Vec::new();
    for field in description.fields {
        let settings = PyDict::new(py);
        if field.is_input {
            settings.set_item("default", 0.0)?;
        }
        parameters.push(parameter.call((field.name, &by_keyword), Some(&settings))?);
    }
    inspect.getattr("Signature")?.call1((parameters,))
}
