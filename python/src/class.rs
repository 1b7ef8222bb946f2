//! The classes of a module.

use lagrangian::quantities::FieldDescription;
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
    let (py, name) = (module.py(), module.name()?);
    let shared = [
        py.get_type::<Model>(),
        py.get_type::<Motion>(),
        py.get_type::<Motions>(),
        py.get_type::<Event>(),
        py.get_type::<Point>(),
        py.get_type::<IntegrationError>(),
    ];
    for class in shared {
        // Where `pickle` looks for it.
        class.setattr("__module__", &name)?;
        module.add(class.name()?, class)?;
    }
    Ok(())
}

/// Adds the class of a model.
///
/// # Errors
///
/// If Python does not allow it.
pub fn add(module: &Bound<'_, PyModule>, description: &Description) -> PyResult<()> {
    let py = module.py();
    let description: &'static Description = Box::leak(Box::new(Description {
        fields: named_for_python(py, description.fields)?,
        ..*description
    }));
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
    let property = py.import("builtins")?.getattr("property")?;
    let method = py.import("operator")?.getattr("methodcaller")?;
    for field in description.fields {
        let get = method.call1(("_parameter", field.name))?;
        let read_only = property.call1((get, py.None(), py.None(), field.documentation))?;
        attributes.set_item(field.name, read_only)?;
    }
    // Objects do not change: they have no attributes of their own.
    attributes.set_item("__slots__", PyTuple::empty(py))?;
    attributes.set_item("EQUATIONS", description.equations)?;
    attributes.set_item("LATEX", description.latex)?;
    attributes.set_item(registry::INDEX, index)?;
    let bases = (py.get_type::<Model>(),);
    let class = py
        .get_type::<PyType>()
        .call1((description.name, bases, attributes))?;
    module.add(description.name, class)
}

/// The fields with names that Python knows: in its normal form of identifiers, and with an underscore behind keywords and the names of
/// methods.
fn named_for_python(
    py: Python<'_>,
    fields: &[FieldDescription],
) -> PyResult<&'static [FieldDescription]> {
    let normalize = py.import("unicodedata")?.getattr("normalize")?;
    let is_keyword = py.import("keyword")?.getattr("iskeyword")?;
    let model = py.get_type::<Model>();
    let mut named = Vec::new();
    for field in fields {
        let mut name: String = normalize.call1(("NFKC", field.name))?.extract()?;
        if is_keyword.call1((&name,))?.is_truthy()? || model.hasattr(&name)? {
            name.push('_');
        }
        named.push(FieldDescription {
            name: name.leak(),
            ..*field
        });
    }
    Ok(named.leak())
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
