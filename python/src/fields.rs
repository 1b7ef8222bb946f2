//! The values of fields, from Python and back.

use lagrangian::quantities::{FieldDescription, FieldElement};
use pyo3::prelude::*;
use pyo3::types::{PyList, PyTuple};

use crate::arrays::{Numbers, array};
use crate::errors::value_error;

/// The numbers of a field from its value.
///
/// # Errors
///
/// `ValueError` with the name of the field.
pub(crate) fn read(field: &FieldDescription, value: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
    if field.element == FieldElement::Number {
        return Numbers::read(field.name, value)?.of_shape(field.name, field.lengths);
    }
    let mut numbers = Vec::new();
    read_bodies(field, field.lengths, value, &mut numbers)?;
    Ok(numbers)
}

fn read_bodies(
    field: &FieldDescription,
    lengths: &[usize],
    value: &Bound<'_, PyAny>,
    numbers: &mut Vec<f64>,
) -> PyResult<()> {
    let name = field.name;
    if let [length, inner @ ..] = lengths {
        let members: Vec<Bound<'_, PyAny>> = value
            .extract()
            .ok()
            .filter(|members: &Vec<_>| members.len() == *length)
            .ok_or_else(|| value_error(format!("{name} is a list of {length} bodies")))?;
        return members
            .iter()
            .try_for_each(|member| read_bodies(field, inner, member, numbers));
    }
    let shapes = parts(field.element);
    let written = match field.element {
        FieldElement::RigidBody => "(mass, centre of gravity, inertia tensor about it)",
        FieldElement::PrincipalBody => "(mass, principal moments)",
        _ => "(mass, height, transverse moment, axial moment)",
    };
    let given: Vec<Bound<'_, PyAny>> = value
        .extract()
        .ok()
        .filter(|given: &Vec<_>| given.len() == shapes.len())
        .ok_or_else(|| value_error(format!("{name} is a body: write {written}")))?;
    for (part, shape) in given.iter().zip(shapes) {
        numbers.extend(Numbers::read(name, part)?.of_shape(name, shape)?);
    }
    Ok(())
}

/// The shapes of the parts of a body.
fn parts(element: FieldElement) -> &'static [&'static [usize]] {
    match element {
        FieldElement::RigidBody => &[&[], &[3], &[3, 3]],
        FieldElement::PrincipalBody => &[&[], &[3]],
        FieldElement::SymmetricBody => &[&[], &[], &[], &[]],
        _ => &[&[]],
    }
}

/// The value of a field from its numbers: a number, an array, or a body as a tuple.
pub(crate) fn value<'py>(
    py: Python<'py>,
    field: &FieldDescription,
    numbers: &[f64],
) -> PyResult<Bound<'py, PyAny>> {
    if field.element == FieldElement::Number {
        return number_or_array(py, numbers, field.lengths);
    }
    bodies(py, field.element, field.lengths, numbers)
}

fn bodies<'py>(
    py: Python<'py>,
    element: FieldElement,
    lengths: &[usize],
    numbers: &[f64],
) -> PyResult<Bound<'py, PyAny>> {
    if let [length, inner @ ..] = lengths {
        let members = numbers.chunks(numbers.len() / (*length).max(1));
        let members: PyResult<Vec<_>> = members
            .map(|member| bodies(py, element, inner, member))
            .collect();
        return Ok(PyList::new(py, members?)?.into_any());
    }
    let mut rest = numbers;
    let mut found = Vec::new();
    for shape in parts(element) {
        let (part, behind) = rest.split_at(shape.iter().product::<usize>().min(rest.len()));
        found.push(number_or_array(py, part, shape)?);
        rest = behind;
    }
    Ok(PyTuple::new(py, found)?.into_any())
}

/// A float for one number without a shape, or else an array.
pub(crate) fn number_or_array<'py>(
    py: Python<'py>,
    numbers: &[f64],
    shape: &[usize],
) -> PyResult<Bound<'py, PyAny>> {
    match (shape, numbers) {
        ([], [number]) => Ok(number.into_pyobject(py)?.into_any()),
        _ => array(py, numbers.to_vec(), shape),
    }
}
