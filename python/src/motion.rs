//! Motions, as Python sees them.

use pyo3::prelude::*;

use crate::arrays::array;
use crate::integrated::{Found, Integrated, Reached};

/// A time with coordinates and velocities.
#[pyclass(frozen, module = "lagrangian")]
#[derive(Clone, Debug)]
pub struct Point {
    reached: Reached,
}

#[pymethods]
impl Point {
    /// The time.
    #[getter]
    fn t(&self) -> f64 {
        self.reached.t
    }

    /// The coordinates, of shape (n,).
    #[getter]
    fn q<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        array(py, self.reached.q.clone(), &[self.reached.q.len()])
    }

    /// The velocities, of shape (n,).
    #[getter]
    fn v<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        array(py, self.reached.v.clone(), &[self.reached.v.len()])
    }

    fn __repr__(&self) -> String {
        let Reached { t, q, v } = &self.reached;
        format!("Point(t={t}, q={q:?}, v={v:?})")
    }
}

/// An event that occurred.
#[pyclass(frozen, module = "lagrangian")]
#[derive(Clone, Debug)]
pub struct Event {
    name: &'static str,
    rises: bool,
    at: Reached,
}

impl Event {
    /// The events that were found, by their names.
    pub(crate) fn all(names: &[&'static str], found: &[Found]) -> Vec<Self> {
        let events = found.iter().map(|found| Self {
            name: names.get(found.event).copied().unwrap_or_default(),
            rises: found.rises,
            at: found.at.clone(),
        });
        events.collect()
    }
}

#[pymethods]
impl Event {
    /// The name of the event in the declaration.
    #[getter]
    fn name(&self) -> &str {
        self.name
    }

    /// "rising" or "falling": how the event function crosses zero.
    #[getter]
    fn direction(&self) -> &str {
        if self.rises { "rising" } else { "falling" }
    }

    /// The time.
    #[getter]
    fn t(&self) -> f64 {
        self.at.t
    }

    /// The coordinates, of shape (n,).
    #[getter]
    fn q<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        array(py, self.at.q.clone(), &[self.at.q.len()])
    }

    /// The velocities, of shape (n,).
    #[getter]
    fn v<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        array(py, self.at.v.clone(), &[self.at.v.len()])
    }

    fn __repr__(&self) -> String {
        let (name, direction, t) = (self.name, self.direction(), self.at.t);
        format!("Event(name={name:?}, direction={direction:?}, t={t})")
    }
}

/// A motion: its samples, its events and its end.
#[pyclass(frozen, module = "lagrangian")]
#[derive(Debug)]
pub struct Motion {
    dimension: usize,
    events: &'static [&'static str],
    integrated: Integrated,
}

impl Motion {
    pub(crate) fn new(
        dimension: usize,
        events: &'static [&'static str],
        integrated: Integrated,
    ) -> Self {
        Self {
            dimension,
            events,
            integrated,
        }
    }

    fn matrix<'py>(
        &self,
        py: Python<'py>,
        of: impl Fn(&Reached) -> &Vec<f64>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let samples = &self.integrated.samples;
        let numbers = samples
            .iter()
            .flat_map(|sample| of(sample).iter().copied())
            .collect();
        array(py, numbers, &[samples.len(), self.dimension])
    }
}

#[pymethods]
impl Motion {
    /// The times of the samples, of shape (samples,).
    #[getter]
    fn t<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let times: Vec<_> = self
            .integrated
            .samples
            .iter()
            .map(|sample| sample.t)
            .collect();
        let count = times.len();
        array(py, times, &[count])
    }

    /// The coordinates at the samples, of shape (samples, n).
    #[getter]
    fn q<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.matrix(py, |sample| &sample.q)
    }

    /// The velocities at the samples, of shape (samples, n).
    #[getter]
    fn v<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.matrix(py, |sample| &sample.v)
    }

    /// The last state.
    #[getter]
    fn end(&self) -> Point {
        Point {
            reached: self.integrated.end.clone(),
        }
    }

    /// The events that were recorded or that stopped the motion, in the order of time.
    #[getter]
    fn events(&self) -> Vec<Event> {
        Event::all(self.events, &self.integrated.events)
    }

    /// Why the motion ends there: "completed", "event", "zeno" (events follow each other ever faster), or "error".
    #[getter]
    fn reason(&self) -> &str {
        match self.integrated.reason {
            lagrangian::StopReason::Completed => "completed",
            lagrangian::StopReason::Zeno => "zeno",
            lagrangian::StopReason::Error => "error",
            _ => "event",
        }
    }

    /// How many steps were taken.
    #[getter]
    fn steps(&self) -> u64 {
        self.integrated.steps
    }

    fn __repr__(&self) -> String {
        format!(
            "Motion({} samples, {} events, end at t={}, {})",
            self.integrated.samples.len(),
            self.integrated.events.len(),
            self.integrated.end.t,
            self.reason(),
        )
    }
}
