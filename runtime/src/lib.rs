//! Write the energies of a mechanical system on a struct of its parameters; get its equations of
//! motion as specialized Rust, derived at compile time, and step them.
//!
//! ```
//! use lagrangian::prelude::*;
//!
//! #[derive(Lagrangian)]
//! #[lagrangian(
//!     coordinates(theta),
//!     define(x = l * sin(theta), y = -l * cos(theta)),
//!     kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
//!     potential = m * g * y,
//! )]
//! struct Pendulum { m: f64, g: f64, l: f64 }
//!
//! let pendulum = Pendulum { m: 1.0, g: 9.81, l: 1.0 };
//! let start = State::new(0.0, [0.5], [0.0]);
//! let end = Dop853::new()
//!     .relative_tolerance(1e-10)
//!     .absolute_tolerance(1e-12)
//!     .integrate_to(&pendulum.dynamics(), start, 10.0)?
//!     .state();
//! assert!((pendulum.energy(&end) - pendulum.energy(&start)).abs() < 1e-8);
//! # Ok::<(), IntegrationError>(())
//! ```
//!
//! - [`Lagrangian`](derive@Lagrangian) describes the declaration.
//! - [`trait@Lagrangian`] is what a model can do: mass matrix, forcing, accelerations, momenta, energy,
//!   inverse dynamics, derivatives. [`Inputs`], [`Outputs`], [`Energies`] and [`ExternalFunctions`] stand
//!   beside it. A [`Plant`] is controlled by a law, with or without states of its own.
//! - [`Dynamics`] is what an [`Integrator`] steps; [`trait@Lagrangian`] enters by its `dynamics`.
//! - [`Scalar`] is what all of it is generic over: `f64`, `f32`, [`Lanes`], [`DoubleDouble`], and dual
//!   numbers with the feature `num-dual`.
//!
//! Without the default feature `std` the crate is `no_std`, and without `alloc` it does not allocate.
#![cfg_attr(not(feature = "std"), no_std)]

#[cfg(feature = "alloc")]
extern crate alloc;

mod scalar;
mod lanes;
mod sine_cosine;
mod into_vector;
mod state;
mod generalized_coordinates;
mod lagrangian;
mod linearization;
mod inputs;
mod plant;
mod outputs;
mod functions;
mod slope;
mod derivative_check;
mod derivative_error;
mod operations;
mod factorization;
mod lanewise;
mod pivoting;
mod vector_space;
mod phase;
mod sample;
mod dynamics;
mod singularity;
mod equations_of_motion;
mod augmented_phase;
mod controlled_by;
mod with_controller;
mod integrator;
mod compensated;
mod runge_kutta;
mod dormand_prince;
mod driver;
mod run;
mod stop_condition;
mod observer;
#[cfg(feature = "alloc")]
mod trajectory;
mod error;
#[cfg(test)]
mod order_conditions;
pub mod prelude;

#[doc(hidden)]
#[path = "private.rs"]
pub mod __private;

pub use augmented_phase::AugmentedPhase;
pub use controlled_by::ControlledBy;
pub use derivative_check::check_derivatives;
pub use derivative_error::{ArgumentValues, DerivativeError};
pub use dormand_prince::{Dop853, Dop853Stepper};
pub use driver::{Driver, Outcome, StopReason};
pub use dynamics::{ComponentName, Dynamics};
pub use equations_of_motion::EquationsOfMotion;
pub use error::IntegrationError;
pub use factorization::Factorization;
pub use functions::{ExternalFunctions, FunctionSignature};
pub use generalized_coordinates::GeneralizedCoordinates;
pub use inputs::{Inputs, WithInputs};
pub use integrator::{Integrator, Statistics, Stepper};
pub use into_vector::IntoVector;
pub use lagrangian::{Energies, Lagrangian};
#[doc = include_str!("declaration.md")]
pub use lagrangian_derive::Lagrangian;
pub use linearization::Linearization;
pub use nalgebra;
pub use num_traits;
pub use observer::{ObservationKind, Observer, Progress, Unobserved};
pub use operations::{OperationCount, Operations};
pub use outputs::{Outputs, OutputsWith};
pub use phase::Phase;
pub use plant::Plant;
pub use runge_kutta::{ButcherTableau, CLASSICAL_FOURTH_ORDER, RungeKutta, RungeKuttaStepper};
pub use sample::{InitialValue, Sample};
pub use scalar::{DoubleDouble, Lanes, Scalar};
pub use singularity::Singularity;
pub use state::State;
pub use stop_condition::{
    Crossing, MetConditions, Predicate, StopCondition, Unconditional, ZeroCrossing,
};
#[cfg(feature = "alloc")]
pub use trajectory::{PartialTrajectory, Trajectory};
pub use vector_space::VectorSpace;
pub use with_controller::WithController;
