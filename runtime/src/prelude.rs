//! The names that most programs use: `use lagrangian::prelude::*;`.
//!
//! The derive macro, the traits of models, the integrators, and the vectors and matrices of their signatures.

pub use crate::rigid_body::{PrincipalBody, RigidBody, SymmetricBody};
pub use crate::{
    Advance, At, AugmentedPhase, ConstantsOfMotion, ControlledBy, Crossing, Dop853, Driver,
    Dynamics, Energies, Event, Events, EventsWith, ExternalFunctions, GeneralizedCoordinates,
    Inputs, IntegrationError, IntegrationMethod, Integrator, Interpolant, Lagrangian,
    Linearization, ObservationKind, Observer, Occurrence, Outcome, Outputs, OutputsWith, Phase,
    Plant, Progress, Reaction, RouthReduction, Routhian, RungeKutta, RunningIntegration, Scalar,
    SetTypicalSizes, State, Statistics, Step, Stepper, StopReason, Taylor, VectorSpace,
    WithController, WithInputs,
};
pub use crate::{
    EnergyBalance, EnergyBalanceWith, Hamiltonian, HamiltonianWith, Regressor, RegressorWith,
    Sensitivities, SensitivitiesWith,
};
// Without names: through them the compiler says which clause is missing.
#[doc(hidden)]
pub use crate::model::undeclared::{
    OfConstantsOfMotion as _, OfEnergies as _, OfEnergyBalance as _, OfEvents as _,
    OfHamiltonian as _, OfInputs as _, OfOutputs as _, OfReducedModels as _, OfRegressor as _,
    OfSensitivities as _,
};
pub use nalgebra::{Matrix2, Matrix3, SMatrix, SVector, Vector2, Vector3};

#[cfg(feature = "derivative-checks")]
pub use crate::CheckDerivatives;
#[cfg(feature = "alloc")]
pub use crate::problem::{Dense, Every, StepEnds};
#[cfg(feature = "alloc")]
pub use crate::{DenseSolution, PartialSolution, PartialTrajectory, Trajectory};
pub use crate::{Problem, Solution};
