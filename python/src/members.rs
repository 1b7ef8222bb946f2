//! The members of an ensemble, from Python.

use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::{Numbers, shape};
use crate::description::Description;
use crate::errors::value_error;
use crate::fields;
use crate::integrated::Reached;
use crate::settings::finite;

/// The numbers of the fields and the initial state of each member.
pub(crate) struct Members {
    pub(crate) models: Vec<Vec<f64>>,
    pub(crate) starts: Vec<Reached>,
}

impl Members {
    pub(crate) fn read(
        description: &Description,
        numbers: &[f64],
        [q, v]: [&Bound<'_, PyAny>; 2],
        t: f64,
        parameters: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let t = finite("t", t)?;
        let (q, v) = (
            Rows::read(description, "q", q)?,
            Rows::read(description, "v", v)?,
        );
        let mut counts = vec![("q", q.count), ("v", v.count)];
        let mut changes = Vec::new();
        for (name, value) in parameters.into_iter().flatten() {
            let name: String = name.extract()?;
            let Some((field, first)) = description.field(&name) else {
                return Err(value_error(format!(
                    "parameters: {} has no parameter {name}; its parameters are {}",
                    description.name,
                    description.parameters()
                )));
            };
            let values = value.try_iter().map_err(|_| {
                value_error(format!(
                    "parameters: {name} is an array with a value for each member"
                ))
            })?;
            let values: Vec<Bound<'_, PyAny>> = values.collect::<PyResult<_>>()?;
            let values = values.iter().map(|value| fields::read(field, value));
            let values = values.collect::<PyResult<Vec<_>>>()?;
            counts.push((field.name, Some(values.len())));
            changes.push((first, values));
        }
        let counted = counts
            .iter()
            .filter_map(|(name, count)| Some((*name, (*count)?)));
        let counted: Vec<(&str, usize)> = counted.collect();
        let count = match counted.as_slice() {
            [] => {
                return Err(value_error(
                    "an ensemble has more than one member: q, v or parameters have an index of the member first",
                ));
            }
            [(first, count), others @ ..] => {
                if let Some((other, length)) = others.iter().find(|(_, length)| length != count) {
                    return Err(value_error(format!(
                        "{first} has {count} members, but {other} has {length}"
                    )));
                }
                *count
            }
        };
        if count == 0 {
            return Err(value_error("there are no members"));
        }
        let mut models = vec![numbers.to_vec(); count];
        for (first, values) in &changes {
            for (model, value) in models.iter_mut().zip(values) {
                if let Some(place) = model.get_mut(*first..first + value.len()) {
                    place.copy_from_slice(value);
                }
            }
        }
        let start = |member| Reached {
            t,
            q: q.row(member),
            v: v.row(member),
        };
        Ok(Self {
            models,
            starts: (0..count).map(start).collect(),
        })
    }
}

/// A row for each member, or one for all.
struct Rows {
    numbers: Vec<f64>,
    n: usize,
    count: Option<usize>,
}

impl Rows {
    fn read(description: &Description, name: &str, value: &Bound<'_, PyAny>) -> PyResult<Self> {
        let n = description.coordinates.len();
        let read = Numbers::read(name, value)?;
        let count = match *read.shape.as_slice() {
            [length] if length == n => None,
            [count, length] if length == n => Some(count),
            _ => {
                return Err(value_error(format!(
                    "{name} has the shape {}, but ({n},) or (members, {n}) is needed",
                    shape(&read.shape)
                )));
            }
        };
        Ok(Self {
            numbers: read.numbers,
            n,
            count,
        })
    }

    fn row(&self, member: usize) -> Vec<f64> {
        let first = self.count.map_or(0, |_| member * self.n);
        self.numbers
            .iter()
            .skip(first)
            .take(self.n)
            .copied()
            .collect()
    }
}
