//! What a program that uses the crate names: `use lagrangian::prelude::*;`.
//!
//! It brings the derive macro, the traits of models, and the methods of integration.

pub use crate::{
    ControlledBy, Dop853, Driver, Dynamics, Ending, Energies, Inputs, IntegrationError, Integrator,
    Lagrangian, Linearization, Observer, Occasion, Outputs, Phase, Progress, Reason, RungeKutta,
    Sample, Scalar, State, Statistics, Stepper, System, VectorSpace, WithInputs,
};
#[cfg(feature = "alloc")]
pub use crate::{Interrupted, Trajectory};
