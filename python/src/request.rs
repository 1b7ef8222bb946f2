//! What is asked of an integration, and what it finds.

use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};

use lagrangian::nalgebra::SVector;
use lagrangian::problem::{End, Keep, Observer, Reactions, Watched};
use lagrangian::{At, Dynamics, Integrator, ObservationKind, Phase, Problem, Progress};
use pyo3::prelude::*;

use crate::instant::Instant;
use crate::integrated::{Integrated, Reached};
use crate::method::Settings;
use crate::numbers::vector;
use crate::watch::Watch;

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
        if self.is_broken_off() {
            return SVector::repeat(f64::NAN);
        }
        let found = Python::attach(|py| {
            let coordinates = numpy::PyArray1::from_slice(py, state.q.as_slice());
            let velocities = numpy::PyArray1::from_slice(py, state.v.as_slice());
            let returned = function
                .bind(py)
                .call1((state.t, coordinates, velocities))?;
            crate::arrays::inputs(&returned, U)
        });
        match found {
            Ok(inputs) => vector(&inputs),
            Err(exception) => {
                self.keep(exception);
                SVector::repeat(f64::NAN)
            }
        }
    }

    /// Whether an exception was raised: the function is not called again.
    fn is_broken_off(&self) -> bool {
        let kept = self
            .exception
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        kept.is_some()
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
                if self.is_broken_off() {
                    return ControlFlow::Break(());
                }
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
pub(crate) fn signals(py: Python<'_>) -> PyResult<()> {
    py.check_signals()
}

/// After so many steps, Python is asked for signals.
const STEPS_BETWEEN_SIGNALS: u32 = 1024;
