//! Write the energies of a mechanical system on a struct of its parameters; get its equations of
//! motion as specialized Rust, derived at compile time, and step them.
#![cfg_attr(not(feature = "std"), no_std)]

#[cfg(feature = "alloc")]
extern crate alloc;

mod scalar;
mod state;
mod system;
mod lagrangian;
mod linearization;
mod inputs;
mod outputs;
mod operations;
mod factorization;
mod vector_space;
mod phase;
mod sample;
mod dynamics;
mod singularity;
mod equations_of_motion;
mod integrator;
mod compensated;
mod runge_kutta;
mod dormand_prince;
mod driver;
mod run;
mod condition;
mod observer;
#[cfg(feature = "alloc")]
mod trajectory;
mod error;
pub mod prelude;

#[doc(hidden)]
#[path = "private.rs"]
pub mod __private;

pub use condition::{AtZero, Condition, When};
pub use dormand_prince::{Dop853, Dop853Stepper};
pub use driver::{Driver, Ending, Reason, Unconditional, Unobserved};
pub use dynamics::{Component, Dynamics};
pub use equations_of_motion::EquationsOfMotion;
pub use error::IntegrationError;
pub use factorization::Factorization;
pub use inputs::{ControlledBy, Inputs, WithInputs};
pub use integrator::{Integrator, Statistics, Stepper};
pub use lagrangian::{Energies, Lagrangian};
pub use lagrangian_derive::Lagrangian;
pub use linearization::Linearization;
pub use observer::{Observer, Occasion, Progress};
pub use operations::{OperationCount, Operations};
pub use outputs::Outputs;
pub use phase::Phase;
pub use runge_kutta::{ButcherTableau, CLASSICAL_FOURTH_ORDER, RungeKutta, RungeKuttaStepper};
pub use sample::Sample;
pub use scalar::Scalar;
pub use singularity::Singularity;
pub use state::State;
pub use system::System;
#[cfg(feature = "alloc")]
pub use trajectory::{Interrupted, Trajectory};
pub use vector_space::VectorSpace;
