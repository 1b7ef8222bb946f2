//! The integration of motions, as Python asks for it.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::array;
use crate::ensemble::Ensemble;
use crate::errors::{IntegrationError, value_error};
use crate::members::Members;
use crate::model::{Any, Maybe, Model};
use crate::motion::Motion;
use crate::motions::Motions;
use crate::request::{Law, Request, signals};
use crate::settings;

#[pymethods]
impl Model {
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
    ///     If given, the feedback is called once per period, and its inputs are held.
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
        let motion = Motion::of(self.dimension(), description.events, integrated);
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
            cancelled: AtomicBool::new(false),
        };
        let found = interruptibly(py, &ensemble.cancelled, || {
            self.evaluator.ensemble(&ensemble)
        })?;
        let found = found.ok_or_else(|| settings::impossible(description))?;
        let members = found.map_err(value_error)?;
        Ok(Motions::of(
            self.dimension(),
            description.events,
            ensemble.samples,
            &members,
        ))
    }
}

/// Computes on another thread, and asks Python for signals meanwhile: an interrupt from the keyboard cancels the computation.
fn interruptibly<T: Send>(
    py: Python<'_>,
    cancelled: &AtomicBool,
    compute: impl FnOnce() -> T + Send,
) -> PyResult<T> {
    py.detach(|| {
        std::thread::scope(|scope| {
            let computation = scope.spawn(compute);
            let mut interrupted = Ok(());
            while !computation.is_finished() {
                std::thread::park_timeout(BETWEEN_SIGNALS);
                if interrupted.is_ok() {
                    interrupted = Python::attach(signals);
                    cancelled.store(interrupted.is_err(), Ordering::Relaxed);
                }
            }
            let found = computation.join().map_err(|_| {
                PyRuntimeError::new_err("a thread of the ensemble ended unexpectedly")
            });
            interrupted.and(found)
        })
    })
}

/// After this time, Python is asked for signals.
const BETWEEN_SIGNALS: Duration = Duration::from_millis(2);

/// The exception for an error, with the motion up to it.
fn integration_error(py: Python<'_>, message: &str, motion: Motion) -> PyResult<PyErr> {
    let exception = IntegrationError::new_err(message.to_owned());
    exception
        .value(py)
        .setattr("motion", Py::new(py, motion)?)?;
    Ok(exception)
}
