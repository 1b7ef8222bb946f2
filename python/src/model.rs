//! The base class of all models.

use std::sync::Mutex;

use pyo3::exceptions::{PyAttributeError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple, PyType};

use crate::arrays::{Numbers, array};
use crate::class;
use crate::description::Description;
use crate::ensemble::Ensemble;
use crate::errors::{IntegrationError, value_error};
use crate::evaluator::{Evaluator, Quantity};
use crate::fields;
use crate::members::Members;
use crate::motion::Motion;
use crate::motions::Motions;
use crate::parameters;
use crate::request::{Law, Request};
use crate::settings;
use crate::states::States;

/// A mechanical system at its parameters. Each model of the module is a class of its own, whose help lists its parameters; objects
/// do not change.
///
/// States are arrays: coordinates q and velocities v of shape (n,) for one state, or (k, n) for many, at a time t or at times of
/// shape (k,). Results have the index of the state first.
#[pyclass(subclass, frozen, module = "lagrangian", name = "Model")]
pub struct Model {
    pub(crate) description: &'static Description,
    pub(crate) numbers: Vec<f64>,
    pub(crate) evaluator: Box<dyn Evaluator>,
}

/// An argument.
pub(crate) type Any<'a, 'py> = &'a Bound<'py, PyAny>;

/// An argument that may be left out.
pub(crate) type Maybe<'a, 'py> = Option<&'a Bound<'py, PyAny>>;

impl Model {
    fn build(description: &'static Description, numbers: Vec<f64>) -> PyResult<Self> {
        let evaluator = (description.build)(&numbers);
        let evaluator = evaluator.map_err(|error| value_error(format!("{error:?}")))?;
        Ok(Self {
            description,
            numbers,
            evaluator,
        })
    }

    pub(crate) fn dimension(&self) -> usize {
        self.description.coordinates.len()
    }

    /// The parameters by their names.
    fn values<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let values = PyDict::new(py);
        let mut rest = self.numbers.as_slice();
        for field in self.description.fields {
            let (numbers, behind) = rest.split_at(field.count().min(rest.len()));
            values.set_item(field.name, fields::value(py, field, numbers)?)?;
            rest = behind;
        }
        Ok(values)
    }
}

#[pymethods]
impl Model {
    #[new]
    #[classmethod]
    #[pyo3(signature = (**parameters))]
    fn new(cls: &Bound<'_, PyType>, parameters: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        let description = class::description(cls).ok_or_else(|| {
            PyTypeError::new_err(
                "Model is the base class of the models of this module: create one of them",
            )
        })?;
        Self::build(description, parameters::numbers(description, parameters)?)
    }

    /// The parameters and the inputs, by their names.
    #[getter]
    fn parameters<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.values(py)
    }

    /// Returns a model with some parameters changed.
    #[pyo3(signature = (**changes))]
    fn replace<'py>(
        slf: &Bound<'py, Self>,
        changes: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let parameters = slf.get().values(slf.py())?;
        if let Some(changes) = changes {
            parameters.update(changes.as_mapping())?;
        }
        slf.get_type().call((), Some(&parameters))
    }

    fn __getattr__<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        match self.description.field(name) {
            Some((field, first)) => {
                let numbers = self.numbers.get(first..first + field.count());
                fields::value(py, field, numbers.unwrap_or_default())
            }
            None => Err(PyAttributeError::new_err(format!(
                "{} has no attribute {name}",
                self.description.name
            ))),
        }
    }

    fn __getnewargs_ex__<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Bound<'py, PyTuple>, Bound<'py, PyDict>)> {
        Ok((PyTuple::empty(py), self.values(py)?))
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let mut values = Vec::new();
        for (name, value) in &self.values(py)? {
            values.push(format!("{}={}", name.str()?, value.repr()?));
        }
        Ok(format!("{}({})", self.description.name, values.join(", ")))
    }

    /// The accelerations, of shape (n,).
    #[pyo3(signature = (q, v, t=None, *, u=None))]
    fn accelerations<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.quantity((Quantity::Accelerations, &[self.dimension()]), [q, v], t, u)
    }

    /// The mass matrix, of shape (n, n).
    #[pyo3(signature = (q, v, t=None))]
    fn mass_matrix<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.quantity(
            (Quantity::MassMatrix, &[self.dimension(); 2]),
            [q, v],
            t,
            None,
        )
    }

    /// The forcing f in M q̈ = f, of shape (n,).
    #[pyo3(signature = (q, v, t=None, *, u=None))]
    fn forcing<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.quantity((Quantity::Forcing, &[self.dimension()]), [q, v], t, u)
    }

    /// The generalized forces of forces and dissipation, of shape (n,).
    #[pyo3(signature = (q, v, t=None, *, u=None))]
    fn generalized_forces<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.quantity(
            (Quantity::GeneralizedForces, &[self.dimension()]),
            [q, v],
            t,
            u,
        )
    }

    /// The generalized momenta, of shape (n,).
    #[pyo3(signature = (q, v, t=None))]
    fn momenta<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.quantity((Quantity::Momenta, &[self.dimension()]), [q, v], t, None)
    }

    /// The energy function Σ p q̇ − L.
    #[pyo3(signature = (q, v, t=None, *, u=None))]
    fn energy<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.quantity((Quantity::Energy, &[]), [q, v], t, u)
    }

    /// The kinetic energy.
    #[pyo3(signature = (q, v, t=None, *, u=None))]
    fn kinetic_energy<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.quantity((Quantity::KineticEnergy, &[]), [q, v], t, u)
    }

    /// The potential energy.
    #[pyo3(signature = (q, v, t=None, *, u=None))]
    fn potential_energy<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.quantity((Quantity::PotentialEnergy, &[]), [q, v], t, u)
    }

    /// The generalized forces M q̈ − f that accelerations `a` of the shape of q need in addition, of shape (n,).
    #[pyo3(signature = (q, v, a, t=None, *, u=None))]
    fn inverse_dynamics<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        a: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let states = States::read(self.description, [q, v], t, u)?;
        let (n, all) = (self.dimension(), states.shape(&[self.dimension()]));
        let accelerations = Numbers::read("a", a)?.of_shape("a", &all)?;
        let of_one = |index: usize| {
            accelerations
                .iter()
                .skip(index * n)
                .take(n)
                .copied()
                .collect()
        };
        let forces = self.evaluate(Quantity::InverseDynamics, &states, of_one)?;
        array(q.py(), forces.unwrap_or_default(), &all)
    }

    /// The outputs by their names, each with its shape.
    #[pyo3(signature = (q, v, t=None, *, u=None))]
    fn outputs<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let outputs = self.description.outputs.iter();
        let parts: Vec<_> = outputs
            .map(|output| (output.name, output.lengths))
            .collect();
        self.named(Quantity::Outputs, &parts, [q, v], t, u)
    }

    /// The values of the event functions by the names of the events.
    #[pyo3(signature = (q, v, t=None, *, u=None))]
    fn event_functions<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let parts: Vec<_> = self
            .description
            .events
            .iter()
            .map(|name| (*name, &[][..]))
            .collect();
        self.named(Quantity::EventFunctions, &parts, [q, v], t, u)
    }

    /// The multipliers of the constraints, of shape (constraints,).
    #[pyo3(signature = (q, v, t=None, *, u=None))]
    fn multipliers<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let count = self.description.constraints.len();
        self.quantity((Quantity::Multipliers, &[count]), [q, v], t, u)
    }

    /// The matrices A, of shape (2n, 2n), and B, of shape (2n, inputs), of ẋ = A x + B u for deviations x = (q, v) and u. Without
    /// inputs B has no columns.
    #[pyo3(signature = (q, v, t=None, *, u=None))]
    fn linearize<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<[Bound<'py, PyAny>; 2]> {
        let (rows, inputs) = (2 * self.dimension(), self.description.inputs.len());
        let a = self.quantity((Quantity::StateMatrix, &[rows, rows]), [q, v], t, u)?;
        if inputs == 0 {
            let states = States::read(self.description, [q, v], t, u)?;
            return Ok([a, array(q.py(), Vec::new(), &states.shape(&[rows, 0]))?]);
        }
        Ok([
            a,
            self.quantity((Quantity::InputMatrix, &[rows, inputs]), [q, v], t, u)?,
        ])
    }

    /// The coordinates and velocities nearest to a guess that satisfy the constraints.
    #[pyo3(signature = (q, v, t=0.0))]
    fn assemble<'py>(
        &self,
        py: Python<'py>,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        t: f64,
    ) -> PyResult<[Bound<'py, PyAny>; 2]> {
        let start = settings::start(self.description, q, v, t)?;
        let assembled = self.evaluator.assemble(start.instant());
        let assembled = assembled
            .ok_or_else(|| value_error(format!("{} has no constraints", self.description.name)))?;
        let [q, v] = assembled.map_err(value_error)?;
        let n = self.dimension();
        Ok([array(py, q, &[n])?, array(py, v, &[n])?])
    }

    /// Integrates a motion until a time.
    ///
    /// Parameters
    /// ----------
    /// q, v : arrays of shape (n,)
    ///     Coordinates and velocities at the time `t`.
    /// until : float
    ///     The final time, which may be before `t`.
    /// samples : int or array of times
    ///     A number of equally spaced times with both ends, or the times; by default both ends.
    /// method : `"taylor"`, `"dop853"` or `"runge_kutta"`
    ///     By default Taylor series if the model has them, else `"dop853"`.
    /// tolerance : float
    ///     Relative and absolute tolerance.
    /// step : float
    ///     The step of `"runge_kutta"`, or the largest step.
    /// record, stop : name, list of names, or dict of names and directions
    ///     Events that are recorded, and events at which the motion ends; the directions are "rising", "falling" and "either".
    /// feedback : function of t, q, v
    ///     Returns the inputs.
    /// period : float
    ///     With it the feedback is called once per period, and its inputs are held.
    ///
    /// Raises `IntegrationError`, whose `motion` is the motion up to the error.
    #[pyo3(signature = (q, v, until, *, t=0.0, samples=None, method=None, tolerance=None, step=None, record=None, stop=None,
        feedback=None, period=None))]
    #[allow(clippy::too_many_arguments)] // By keyword.
    fn integrate(
        &self,
        py: Python<'_>,
        q: Any<'_, '_>,
        v: Any<'_, '_>,
        until: f64,
        t: f64,
        samples: Maybe<'_, '_>,
        method: Option<&str>,
        tolerance: Option<f64>,
        step: Option<f64>,
        record: Maybe<'_, '_>,
        stop: Maybe<'_, '_>,
        feedback: Maybe<'_, '_>,
        period: Option<f64>,
    ) -> PyResult<Motion> {
        let description = self.description;
        let start = settings::start(description, q, v, t)?;
        let law = settings::law(description, feedback, period)?;
        let request = Request {
            until: settings::finite("until", until)?,
            samples: settings::samples(samples, t, until)?,
            settings: settings::method(description, method, &law, tolerance, step)?,
            watch: settings::watch(description, record, stop)?,
            law,
            start,
            exception: Mutex::new(None),
        };
        let found = py.detach(|| self.evaluator.integrate(&request));
        let mut integrated = found.ok_or_else(|| settings::impossible(description))?;
        if let Some(exception) = request.into_exception() {
            return Err(exception);
        }
        let error = integrated.error.take();
        let motion = Motion::new(self.dimension(), description.events, integrated);
        match error {
            None => Ok(motion),
            Some(error) => Err(integration_error(py, &error.to_string(), motion)?),
        }
    }

    /// Integrates many motions on all cores, by Taylor series in SIMD lanes on each.
    ///
    /// Parameters
    /// ----------
    /// q, v : arrays of shape (members, n), or (n,) for all members
    /// parameters : dict of names and arrays
    ///     Parameters that differ, with the index of the member first.
    /// threads : int
    ///     By default one for each core. The results do not depend on it.
    ///
    /// The other parameters are as for `integrate`. A member that fails does not raise an exception: `errors` has its message.
    #[pyo3(signature = (q, v, until, *, t=0.0, parameters=None, samples=None, method=None, tolerance=None, step=None, record=None,
        stop=None, threads=0))]
    #[allow(clippy::too_many_arguments)] // By keyword.
    fn ensemble(
        &self,
        py: Python<'_>,
        q: Any<'_, '_>,
        v: Any<'_, '_>,
        until: f64,
        t: f64,
        parameters: Option<&Bound<'_, PyDict>>,
        samples: Maybe<'_, '_>,
        method: Option<&str>,
        tolerance: Option<f64>,
        step: Option<f64>,
        record: Maybe<'_, '_>,
        stop: Maybe<'_, '_>,
        threads: usize,
    ) -> PyResult<Motions> {
        let description = self.description;
        let members = Members::read(description, &self.numbers, [q, v], t, parameters)?;
        let ensemble = Ensemble {
            models: members.models,
            starts: members.starts,
            until: settings::finite("until", until)?,
            samples: settings::samples(samples, t, until)?,
            settings: settings::method(description, method, &Law::Held, tolerance, step)?,
            watch: settings::watch(description, record, stop)?,
            threads,
        };
        let found = py.detach(|| self.evaluator.ensemble(&ensemble));
        let found = found.ok_or_else(|| settings::impossible(description))?;
        Ok(Motions {
            dimension: self.dimension(),
            events: description.events,
            times: ensemble.samples,
            members: found.map_err(value_error)?,
        })
    }
}

/// The exception for an error, with the motion up to it.
fn integration_error(py: Python<'_>, message: &str, motion: Motion) -> PyResult<PyErr> {
    let exception = IntegrationError::new_err(message.to_owned());
    exception
        .value(py)
        .setattr("motion", Py::new(py, motion)?)?;
    Ok(exception)
}
