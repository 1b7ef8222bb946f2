//! The parameters of a model, from the keywords of its constructor.

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::description::Description;
use crate::fields;

/// The numbers of all fields. Inputs that are not given are 0.
pub(crate) fn numbers(
    description: &Description,
    parameters: Option<&Bound<'_, PyDict>>,
) -> PyResult<Vec<f64>> {
    let name = description.name;
    let mut numbers = vec![f64::NAN; description.numbers()];
    let mut given = Vec::new();
    for (key, value) in parameters.into_iter().flatten() {
        let key: String = key.extract()?;
        let Some((field, first)) = description.field(&key) else {
            return Err(PyTypeError::new_err(format!(
                "{name} has no parameter {key}: its parameters are {}",
                description.parameters()
            )));
        };
        let values = fields::read(field, &value)?;
        if let Some(place) = numbers.get_mut(first..first + values.len()) {
            place.copy_from_slice(&values);
        }
        given.push(field.name);
    }
    for field in description
        .fields
        .iter()
        .filter(|field| !given.contains(&field.name))
    {
        let place = description.field(field.name).map_or(0, |(_, first)| first);
        match numbers.get_mut(place..place + field.count()) {
            Some(place) if field.is_input => place.fill(0.0),
            _ => {
                let documentation = field.documentation.lines().next().unwrap_or_default();
                let separator = if documentation.is_empty() { "" } else { ": " };
                return Err(PyTypeError::new_err(format!(
                    "{name} needs the parameter {}{separator}{documentation}",
                    field.name
                )));
            }
        }
    }
    Ok(numbers)
}
