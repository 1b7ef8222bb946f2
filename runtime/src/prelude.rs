//! What a program that uses the crate names: `use lagrangian::prelude::*;`.
//!
//! It brings the derive macro, the traits of models, the methods of integration, and the vectors and
//! matrices in which they speak.

pub use crate::{
    AugmentedPhase, ControlledBy, Crossing, Dop853, Driver, Dynamics, Energies, ExternalFunctions,
    GeneralizedCoordinates, Inputs, IntegrationError, Integrator, Lagrangian, Linearization,
    ObservationKind, Observer, Outcome, Outputs, OutputsWith, Phase, Plant, Progress, RungeKutta,
    Sample, Scalar, State, Statistics, Stepper, StopReason, VectorSpace, WithController,
    WithInputs,
};
pub use nalgebra::{Matrix2, Matrix3, SMatrix, SVector, Vector2, Vector3};

#[cfg(feature = "derivative-checks")]
pub use crate::CheckDerivatives;
#[cfg(feature = "alloc")]
pub use crate::{PartialTrajectory, Trajectory};
