//! States as arguments: one, or many as arrays.

use pyo3::prelude::*;

use crate::arrays::{Numbers, shape};
use crate::description::Description;
use crate::errors::value_error;
use crate::instant::Instant;

/// One state, or many, at times, under inputs.
pub(crate) struct States {
    /// How many there are; `None` for a single one without an index.
    pub(crate) count: Option<usize>,
    n: usize,
    t: Vec<f64>,
    q: Vec<f64>,
    v: Vec<f64>,
    /// The inputs of each, where they are given.
    inputs: Option<Batch>,
}

/// Rows of numbers, or one for all.
struct Batch {
    rows: Vec<f64>,
    length: usize,
    is_one: bool,
}

impl States {
    /// Reads the arguments: q and v of shape (n,) or (k, n), t a number or of shape (k,), u of shape (inputs,) or (k, inputs).
    pub(crate) fn read(
        description: &Description,
        [q, v]: [&Bound<'_, PyAny>; 2],
        t: Option<&Bound<'_, PyAny>>,
        u: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let n = description.coordinates.len();
        let (q, v) = (Numbers::read("q", q)?, Numbers::read("v", v)?);
        let count = match *q.shape.as_slice() {
            [length] if length == n => None,
            [count, length] if length == n => Some(count),
            _ => {
                return Err(value_error(format!(
                    "q has the shape {}, but {} has the coordinates {}: an array of the shape ({n},) or (states, {n}) is needed",
                    shape(&q.shape),
                    description.name,
                    Description::listed(description.coordinates),
                )));
            }
        };
        let v = v.of_shape("v", &q.shape)?;
        let t = match t.map(|t| Numbers::read("t", t)).transpose()? {
            None => vec![0.0; count.unwrap_or(1)],
            Some(t) if t.shape.is_empty() => vec![t.numbers.iter().sum(); count.unwrap_or(1)],
            Some(t) => t.of_shape("t", count.as_slice())?,
        };
        let inputs = u.map(|u| Batch::read(description, u, count)).transpose()?;
        Ok(Self {
            count,
            n,
            t,
            q: q.numbers,
            v,
            inputs,
        })
    }

    /// How many states there are.
    pub(crate) fn len(&self) -> usize {
        self.t.len()
    }

    pub(crate) fn instant(&self, index: usize) -> Instant<'_> {
        let part = |numbers: &'_ [f64]| index * self.n..((index + 1) * self.n).min(numbers.len());
        Instant {
            t: self.t.get(index).copied().unwrap_or(f64::NAN),
            q: self.q.get(part(&self.q)).unwrap_or_default(),
            v: self.v.get(part(&self.v)).unwrap_or_default(),
        }
    }

    /// The inputs of a state, if some are given.
    pub(crate) fn inputs(&self, index: usize) -> Option<&[f64]> {
        self.inputs.as_ref().map(|inputs| inputs.row(index))
    }

    /// The shape of a result with this shape for each state.
    pub(crate) fn shape(&self, of_one: &[usize]) -> Vec<usize> {
        self.count
            .into_iter()
            .chain(of_one.iter().copied())
            .collect()
    }
}

impl Batch {
    fn read(
        description: &Description,
        u: &Bound<'_, PyAny>,
        count: Option<usize>,
    ) -> PyResult<Self> {
        let inputs = description.inputs;
        let length = inputs.len();
        if length == 0 {
            return Err(value_error(format!("{} has no inputs", description.name)));
        }
        let u = Numbers::read("u", u)?;
        let is_one = match *u.shape.as_slice() {
            [] => length == 1,
            [given] => given == length,
            _ => false,
        };
        let is_many = |count: usize| u.shape == [count, length];
        if !is_one && !count.is_some_and(is_many) {
            return Err(value_error(format!(
                "u has the shape {}, but {} has the inputs {}: an array of the shape ({length},){} is needed",
                shape(&u.shape),
                description.name,
                Description::listed(inputs),
                count.map_or(String::new(), |count| format!(" or ({count}, {length})")),
            )));
        }
        Ok(Self {
            rows: u.numbers,
            length,
            is_one,
        })
    }

    fn row(&self, index: usize) -> &[f64] {
        let first = if self.is_one { 0 } else { index * self.length };
        self.rows
            .get(first..first + self.length)
            .unwrap_or_default()
    }
}
