//! Motions, as Python sees them.

use lagrangian::StopReason;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;

use crate::arrays::{array, kept};
use crate::integrated::{Found, Integrated, Reached};

/// A time with coordinates and velocities.
#[pyclass(frozen, from_py_object, module = "lagrangian")]
#[derive(Clone, Debug)]
pub struct Point {
    reached: Reached,
}

impl Point {
    pub(crate) fn of(reached: &Reached) -> Self {
        Self {
            reached: reached.clone(),
        }
    }

    pub(crate) fn reached(&self) -> &Reached {
        &self.reached
    }
}

#[pymethods]
impl Point {
    #[new]
    fn new(t: f64, q: Vec<f64>, v: Vec<f64>) -> Self {
        Self {
            reached: Reached { t, q, v },
        }
    }

    fn __getnewargs__(&self) -> (f64, Vec<f64>, Vec<f64>) {
        let Reached { t, q, v } = self.reached.clone();
        (t, q, v)
    }

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
#[pyclass(frozen, from_py_object, module = "lagrangian")]
#[derive(Clone, Debug)]
pub struct Event {
    name: String,
    rises: bool,
    at: Reached,
}

impl Event {
    /// The events that were found, by their names.
    pub(crate) fn all(names: &[&'static str], found: &[Found]) -> Vec<Self> {
        let events = found.iter().map(|found| Self {
            name: names
                .get(found.event)
                .copied()
                .unwrap_or_default()
                .to_owned(),
            rises: found.rises,
            at: found.at.clone(),
        });
        events.collect()
    }
}

#[pymethods]
impl Event {
    #[new]
    fn new(name: String, rises: bool, t: f64, q: Vec<f64>, v: Vec<f64>) -> Self {
        let at = Reached { t, q, v };
        Self { name, rises, at }
    }

    fn __getnewargs__(&self) -> (String, bool, f64, Vec<f64>, Vec<f64>) {
        let Reached { t, q, v } = self.at.clone();
        (self.name.clone(), self.rises, t, q, v)
    }

    /// The name of the event in the declaration.
    #[getter]
    fn name(&self) -> &str {
        &self.name
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
        let (name, direction, t) = (&self.name, self.direction(), self.at.t);
        format!("Event(name={name:?}, direction={direction:?}, t={t})")
    }
}

/// A motion: its samples, its events and its end.
#[pyclass(frozen, module = "lagrangian")]
pub struct Motion {
    dimension: usize,
    samples: Vec<Reached>,
    events: Vec<Event>,
    end: Reached,
    reason: String,
    steps: u64,
    arrays: [PyOnceLock<Py<PyAny>>; 3],
}

/// The dimension, the numbers of the samples one after another, the events, the end, the reason and the steps.
type Parts = (usize, Vec<f64>, Vec<Event>, Point, String, u64);

impl Motion {
    pub(crate) fn of(dimension: usize, names: &[&'static str], integrated: Integrated) -> Self {
        let reason = match integrated.reason {
            StopReason::Completed => "completed",
            StopReason::Error => "error",
            _ => "event",
        };
        Self {
            dimension,
            events: Event::all(names, &integrated.events),
            samples: integrated.samples,
            end: integrated.end,
            reason: reason.to_owned(),
            steps: integrated.steps,
            arrays: [const { PyOnceLock::new() }; 3],
        }
    }

    fn matrix<'py>(
        &self,
        py: Python<'py>,
        place: &PyOnceLock<Py<PyAny>>,
        of: impl Fn(&Reached) -> &Vec<f64>,
    ) -> PyResult<Bound<'py, PyAny>> {
        kept(py, place, || {
            let numbers = self
                .samples
                .iter()
                .flat_map(|sample| of(sample).iter().copied());
            array(py, numbers.collect(), &[self.samples.len(), self.dimension])
        })
    }
}

#[pymethods]
impl Motion {
    #[new]
    #[allow(clippy::needless_pass_by_value)] // Python has no slices.
    fn new(
        dimension: usize,
        samples: Vec<f64>,
        events: Vec<Event>,
        end: Point,
        reason: String,
        steps: u64,
    ) -> Self {
        let samples = samples.chunks(2 * dimension + 1).map(|sample| {
            let (t, state) = sample.split_first().unwrap_or((&f64::NAN, &[]));
            let (q, v) = state.split_at(dimension.min(state.len()));
            Reached {
                t: *t,
                q: q.to_vec(),
                v: v.to_vec(),
            }
        });
        Self {
            dimension,
            samples: samples.collect(),
            events,
            end: end.reached,
            reason,
            steps,
            arrays: [const { PyOnceLock::new() }; 3],
        }
    }

    fn __getnewargs__(&self) -> Parts {
        let numbers = self.samples.iter().flat_map(|Reached { t, q, v }| {
            std::iter::once(*t)
                .chain(q.iter().copied())
                .chain(v.iter().copied())
        });
        (
            self.dimension,
            numbers.collect(),
            self.events.clone(),
            self.end(),
            self.reason.clone(),
            self.steps,
        )
    }

    /// The times of the samples, of shape (samples,).
    #[getter]
    fn t<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        kept(py, &self.arrays[0], || {
            let times = self.samples.iter().map(|sample| sample.t);
            array(py, times.collect(), &[self.samples.len()])
        })
    }

    /// The coordinates at the samples, of shape (samples, n).
    #[getter]
    fn q<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.matrix(py, &self.arrays[1], |sample| &sample.q)
    }

    /// The velocities at the samples, of shape (samples, n).
    #[getter]
    fn v<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.matrix(py, &self.arrays[2], |sample| &sample.v)
    }

    /// The last state.
    #[getter]
    fn end(&self) -> Point {
        Point::of(&self.end)
    }

    /// The events that were recorded or that stopped the motion, in the order of time.
    #[getter]
    fn events(&self) -> Vec<Event> {
        self.events.clone()
    }

    /// Why the motion ends there: "completed", "event", or "error" in the motion of an exception.
    #[getter]
    fn reason(&self) -> &str {
        &self.reason
    }

    /// How many steps were taken.
    #[getter]
    fn steps(&self) -> u64 {
        self.steps
    }

    fn __repr__(&self) -> String {
        format!(
            "Motion({} samples, {} events, end at t={}, {})",
            self.samples.len(),
            self.events.len(),
            self.end.t,
            self.reason,
        )
    }
}
