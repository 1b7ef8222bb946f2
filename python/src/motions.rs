//! Many motions, as Python sees them.

use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::array;
use crate::ensemble::EnsembleMotions;
use crate::integrated::Reached;
use crate::motion::Event;

/// The motions of an ensemble as arrays whose first index is the member. Samples behind the end of a member are NaN.
#[pyclass(frozen, module = "lagrangian")]
#[derive(Debug)]
pub struct Motions {
    pub(crate) dimension: usize,
    pub(crate) events: &'static [&'static str],
    pub(crate) times: Vec<f64>,
    pub(crate) members: EnsembleMotions,
}

impl Motions {
    fn samples<'py>(
        &self,
        py: Python<'py>,
        of: impl Fn(&Reached) -> &Vec<f64>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (members, times, n) = (self.members.len(), self.times.len(), self.dimension);
        let mut numbers = Vec::with_capacity(members * times * n);
        for (member, behind) in self.members.iter().zip(1..) {
            numbers.extend(
                member
                    .samples
                    .iter()
                    .flat_map(|sample| of(sample).iter().copied()),
            );
            numbers.resize(behind * times * n, f64::NAN);
        }
        array(py, numbers, &[members, times, n])
    }

    fn ends<'py>(
        &self,
        py: Python<'py>,
        of: impl Fn(&Reached) -> &Vec<f64>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let numbers = self
            .members
            .iter()
            .flat_map(|member| of(&member.end).iter().copied());
        array(py, numbers.collect(), &[self.members.len(), self.dimension])
    }
}

#[pymethods]
impl Motions {
    /// The times of the samples, of shape (samples,).
    #[getter]
    fn t<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        array(py, self.times.clone(), &[self.times.len()])
    }

    /// The coordinates at the samples, of shape (members, samples, n).
    #[getter]
    fn q<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.samples(py, |sample| &sample.q)
    }

    /// The velocities at the samples, of shape (members, samples, n).
    #[getter]
    fn v<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.samples(py, |sample| &sample.v)
    }

    /// The last times, of shape (members,).
    #[getter]
    fn end_t<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let times = self.members.iter().map(|member| member.end.t);
        array(py, times.collect(), &[self.members.len()])
    }

    /// The last coordinates, of shape (members, n).
    #[getter]
    fn end_q<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.ends(py, |end| &end.q)
    }

    /// The last velocities, of shape (members, n).
    #[getter]
    fn end_v<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.ends(py, |end| &end.v)
    }

    /// For each member, the list of its events.
    #[getter]
    fn events(&self) -> Vec<Vec<Event>> {
        let members = self.members.iter();
        members
            .map(|member| Event::all(self.events, &member.events))
            .collect()
    }

    /// The messages of the members that failed, by their indices.
    #[getter]
    fn errors<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let errors = PyDict::new(py);
        for (index, member) in self.members.iter().enumerate() {
            if let Some(message) = &member.error {
                errors.set_item(index, message)?;
            }
        }
        Ok(errors)
    }

    fn __len__(&self) -> usize {
        self.members.len()
    }

    fn __repr__(&self) -> String {
        format!(
            "Motions({} members, {} samples)",
            self.members.len(),
            self.times.len()
        )
    }
}
