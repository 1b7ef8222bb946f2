//! Many motions, as Python sees them.

use std::collections::BTreeMap;

use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;

use crate::arrays::{array, kept};
use crate::ensemble::MemberMotion;
use crate::integrated::Reached;
use crate::motion::{Event, Point};

/// The motions of an ensemble as arrays whose first index is the member. Samples after the end of a member are NaN.
#[pyclass(frozen, module = "lagrangian")]
pub struct Motions {
    dimension: usize,
    times: Vec<f64>,
    samples: [Vec<f64>; 2],
    ends: Vec<Point>,
    events: Vec<Vec<Event>>,
    errors: BTreeMap<usize, String>,
    arrays: [PyOnceLock<Py<PyAny>>; 6],
}

/// The dimension, the times, the coordinates and velocities of all samples, the ends, the events and the errors.
type Parts = (
    usize,
    Vec<f64>,
    [Vec<f64>; 2],
    Vec<Point>,
    Vec<Vec<Event>>,
    BTreeMap<usize, String>,
);

impl Motions {
    pub(crate) fn of(
        dimension: usize,
        names: &[&'static str],
        times: Vec<f64>,
        members: &[MemberMotion],
    ) -> Self {
        let all = |of: fn(&Reached) -> &Vec<f64>| {
            let length = times.len() * dimension;
            let mut numbers = Vec::with_capacity(members.len() * length);
            for (member, count) in members.iter().zip(1..) {
                numbers.extend(
                    member
                        .samples
                        .iter()
                        .flat_map(|sample| of(sample).iter().copied()),
                );
                numbers.resize(count * length, f64::NAN);
            }
            numbers
        };
        let samples = [all(|sample| &sample.q), all(|sample| &sample.v)];
        let errors = members.iter().enumerate();
        let errors = errors.filter_map(|(index, member)| Some((index, member.error.clone()?)));
        Self::new(
            dimension,
            times,
            samples,
            members
                .iter()
                .map(|member| Point::of(&member.end))
                .collect(),
            members
                .iter()
                .map(|member| Event::all(names, &member.events))
                .collect(),
            errors.collect(),
        )
    }

    fn samples<'py>(&self, py: Python<'py>, which: usize) -> PyResult<Bound<'py, PyAny>> {
        let shape = [self.ends.len(), self.times.len(), self.dimension];
        kept(py, &self.arrays[which], || {
            array(py, self.samples[which].clone(), &shape)
        })
    }
}

#[pymethods]
impl Motions {
    #[new]
    fn new(
        dimension: usize,
        times: Vec<f64>,
        samples: [Vec<f64>; 2],
        ends: Vec<Point>,
        events: Vec<Vec<Event>>,
        errors: BTreeMap<usize, String>,
    ) -> Self {
        Self {
            dimension,
            times,
            samples,
            ends,
            events,
            errors,
            arrays: [const { PyOnceLock::new() }; 6],
        }
    }

    fn __getnewargs__(&self) -> Parts {
        (
            self.dimension,
            self.times.clone(),
            self.samples.clone(),
            self.ends.clone(),
            self.events.clone(),
            self.errors.clone(),
        )
    }

    /// The times of the samples, of shape (samples,).
    #[getter]
    fn t<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        kept(py, &self.arrays[2], || {
            array(py, self.times.clone(), &[self.times.len()])
        })
    }

    /// The coordinates at the samples, of shape (members, samples, n).
    #[getter]
    fn q<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.samples(py, 0)
    }

    /// The velocities at the samples, of shape (members, samples, n).
    #[getter]
    fn v<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.samples(py, 1)
    }

    /// The last times, of shape (members,).
    #[getter]
    fn end_t<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        kept(py, &self.arrays[3], || {
            let times = self.ends.iter().map(|end| end.reached().t);
            array(py, times.collect(), &[self.ends.len()])
        })
    }

    /// The last coordinates, of shape (members, n).
    #[getter]
    fn end_q<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        kept(py, &self.arrays[4], || {
            let numbers = self
                .ends
                .iter()
                .flat_map(|end| end.reached().q.iter().copied());
            array(py, numbers.collect(), &[self.ends.len(), self.dimension])
        })
    }

    /// The last velocities, of shape (members, n).
    #[getter]
    fn end_v<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        kept(py, &self.arrays[5], || {
            let numbers = self
                .ends
                .iter()
                .flat_map(|end| end.reached().v.iter().copied());
            array(py, numbers.collect(), &[self.ends.len(), self.dimension])
        })
    }

    /// For each member, the list of its events.
    #[getter]
    fn events(&self) -> Vec<Vec<Event>> {
        self.events.clone()
    }

    /// The messages of the members that failed, by their indices.
    #[getter]
    fn errors(&self) -> BTreeMap<usize, String> {
        self.errors.clone()
    }

    fn __len__(&self) -> usize {
        self.ends.len()
    }

    fn __repr__(&self) -> String {
        format!(
            "Motions({} members, {} samples)",
            self.ends.len(),
            self.times.len()
        )
    }
}
