//! What is asked of an integration, and what it finds.

use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};

use lagrangian::nalgebra::SVector;
use lagrangian::problem::{End, Keep, Observer, Reactions, Watched};
use lagrangian::{
    At, Dop853, Dynamics, Integrator, ObservationKind, Phase, Problem, Progress, RungeKutta, Taylor,
};
use pyo3::prelude::*;

use crate::evaluator::Instant;
use crate::integrated::{Integrated, Reached};

/// The method of an integration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Taylor series.
    Taylor,
    /// Dormand–Prince 8(5,3).
    Dop853,
    /// The classical method of fixed step.
    RungeKutta,
}

/// The settings of a method.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// The method.
    pub method: Method,
    /// The relative tolerance, if it is set.
    pub tolerance: Option<f64>,
    /// The step of a method of fixed step, or the largest one.
    pub step: Option<f64>,
}

/// How the inputs are set.
#[derive(Debug)]
pub enum Law {
    /// They keep the values of their fields.
    Held,
    /// A function of time, coordinates and velocities.
    Feedback(Py<PyAny>),
    /// A function that is called once per period; its result is held.
    Sampled(Py<PyAny>, f64),
}

/// Which events are recorded, and which stop the motion: for each event where it rises, then for each where it falls.
#[derive(Clone, Debug, Default)]
pub struct Watch {
    /// Whether the event is kept.
    pub recorded: Vec<bool>,
    /// Whether the motion ends there.
    pub stops: Vec<bool>,
}

impl Watch {
    /// Whether an event is kept.
    #[must_use]
    pub fn records(&self, event: usize) -> bool {
        self.recorded.get(event).copied().unwrap_or(false)
    }

    /// Whether the motion ends at an event.
    #[must_use]
    pub fn stops_at(&self, event: usize) -> bool {
        self.stops.get(event).copied().unwrap_or(false)
    }
}

impl Settings {
    /// The Taylor method.
    #[must_use]
    pub fn taylor(&self) -> Taylor {
        let mut method = Taylor::new();
        if let Some(tolerance) = self.tolerance {
            method = method
                .relative_tolerance(tolerance)
                .absolute_tolerance(tolerance);
        }
        if let Some(step) = self.step {
            method = method.max_step(step);
        }
        method
    }

    /// The method of Dormand and Prince.
    #[must_use]
    pub fn dop853(&self) -> Dop853 {
        let mut method = Dop853::new();
        if let Some(tolerance) = self.tolerance {
            method = method
                .relative_tolerance(tolerance)
                .absolute_tolerance(tolerance);
        }
        if let Some(step) = self.step {
            method = method.max_step(step);
        }
        method
    }

    /// The classical Runge–Kutta method; without a step its step is NaN, which is an error.
    #[must_use]
    pub fn runge_kutta(&self) -> RungeKutta<4> {
        RungeKutta::classical(self.step.unwrap_or(f64::NAN))
    }
}

/// What is asked of an integration.
#[derive(Debug)]
pub struct Request {
    /// The initial time and state.
    pub start: Reached,
    /// The final time.
    pub until: f64,
    /// The times of samples.
    pub samples: Vec<f64>,
    /// The method.
    pub settings: Settings,
    /// What is done at events.
    pub watch: Watch,
    /// How the inputs are set.
    pub law: Law,
    /// The first exception that a function of Python raised, or a signal.
    pub exception: Mutex<Option<PyErr>>,
}

impl Request {
    /// The initial time and state.
    pub fn start(&self) -> Instant<'_> {
        self.start.instant()
    }

    /// The exception that a function of Python raised.
    pub(crate) fn into_exception(self) -> Option<PyErr> {
        self.exception
            .into_inner()
            .unwrap_or_else(PoisonError::into_inner)
    }

    /// The inputs that a function of Python returns; NaN if it raises an exception, which is kept.
    pub fn inputs<const N: usize, const U: usize>(
        &self,
        function: &Py<PyAny>,
        state: &At<f64, Phase<f64, N>>,
    ) -> SVector<f64, U> {
        let found = Python::attach(|py| {
            let coordinates = numpy::PyArray1::from_slice(py, state.q.as_slice());
            let velocities = numpy::PyArray1::from_slice(py, state.v.as_slice());
            let returned = function
                .bind(py)
                .call1((state.t, coordinates, velocities))?;
            crate::arrays::inputs(&returned, U)
        });
        match found {
            Ok(inputs) => crate::evaluator::vector(&inputs),
            Err(exception) => {
                self.keep(exception);
                SVector::repeat(f64::NAN)
            }
        }
    }

    fn keep(&self, exception: PyErr) {
        let mut kept = self
            .exception
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        kept.get_or_insert(exception);
    }

    /// Whether the motion ends where it is observed: at an event that stops it, or where a signal interrupts it.
    fn flow<X>(&self, progress: &Progress<'_, X>, steps: &mut u32) -> ControlFlow<()> {
        match progress.kind {
            ObservationKind::Event(event) if self.watch.stops_at(event) => {
                return ControlFlow::Break(());
            }
            ObservationKind::Step => {
                *steps += 1;
                if steps.is_multiple_of(STEPS_BETWEEN_SIGNALS)
                    && let Err(exception) = Python::attach(signals)
                {
                    self.keep(exception);
                    return ControlFlow::Break(());
                }
            }
            _ => {}
        }
        ControlFlow::Continue(())
    }

    /// Integrates a problem by a method.
    pub fn solve<D, C, R, O, I, Z, const N: usize>(
        &self,
        problem: Problem<f64, D, End, C, R, O>,
        method: I,
    ) -> Integrated
    where
        D: Dynamics<f64, State = Phase<f64, N, Z>>,
        Z: Clone,
        I: Integrator<f64, D>,
        C: Watched<f64, D>,
        R: Reactions<f64, D>,
        O: Observer<D::State>,
        Vec<f64>: Keep<f64, D, I::Stepper, Kept = Vec<At<f64, D::State>>>,
    {
        let mut steps = 0;
        let solved = problem
            .save(self.samples.clone())
            .each_step(|progress: &Progress<'_, D::State>| self.flow(progress, &mut steps))
            .solve(self.until, method);
        match solved {
            Ok(solution) => Integrated::of(&solution, &self.watch, None),
            Err(partial) => {
                let error = partial.error();
                Integrated::of(partial.solution(), &self.watch, Some(error))
            }
        }
    }
}

/// The exception of a signal, such as an interrupt from the keyboard.
fn signals(py: Python<'_>) -> PyResult<()> {
    py.check_signals()
}

/// After so many steps, Python is asked for signals.
const STEPS_BETWEEN_SIGNALS: u32 = 1024;
