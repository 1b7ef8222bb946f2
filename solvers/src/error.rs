//! Errors of systems.

use core::fmt;

use lagrangian::{ComponentName, IntegrationError};

/// Why there is no such system, or no such state of it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SystemError {
    /// The time of the initial state is not finite.
    NonFiniteTime {
        /// That time.
        time: f64,
    },
    /// A component of a state is not finite: of the initial one, or of what a solver has found.
    NonFiniteState {
        /// The time of the state.
        time: f64,
        /// The first such component.
        component: ComponentName,
        /// Its value.
        value: f64,
    },
    /// The derivative of the initial state is not finite, as where the mass matrix is singular.
    NonFiniteDerivative {
        /// The time of the state.
        time: f64,
        /// The first such component.
        component: ComponentName,
        /// Its derivative.
        value: f64,
    },
    /// The dynamics update their state at given times, as under a sampled controller. Other solvers do not stop there.
    Updates {
        /// The time of the first update.
        time: f64,
    },
    /// A parameter of the dynamics has no meaning ([`Dynamics::check`](lagrangian::Dynamics::check)).
    InvalidParameter {
        /// What it is.
        error: IntegrationError,
    },
    /// A slice does not have as many numbers as it must.
    WrongSize {
        /// How many it must have.
        expected: usize,
        /// How many it has.
        found: usize,
    },
}

impl fmt::Display for SystemError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NonFiniteTime { time } => {
                write!(f, "the initial time must be finite, not {time}")
            }
            Self::NonFiniteState {
                time,
                component,
                value,
            } => write!(f, "{component} is {value} at t = {time}"),
            Self::NonFiniteDerivative {
                time,
                component,
                value,
            } => write!(f, "the derivative of {component} is {value} at t = {time}"),
            Self::Updates { time } => write!(
                f,
                "the dynamics update their state at t = {time}, as under a sampled controller: integrate them with \
                 `lagrangian::Problem`, whose steps end there"
            ),
            Self::InvalidParameter { error } => error.fmt(f),
            Self::WrongSize { expected, found } => {
                write!(f, "{expected} numbers are expected, not {found}")
            }
        }
    }
}

impl core::error::Error for SystemError {}
