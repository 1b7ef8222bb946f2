//! The numerics of `lagrangian`: models, integrators and analysis, without the derive macro.
//!
//! Programs depend on [`lagrangian`](https://docs.rs/lagrangian), which re-exports this crate and the derive macro. The runtime and
//! the macro do not depend on each other, so that cargo compiles them in parallel.
#![cfg_attr(not(feature = "std"), no_std)]

#[cfg(feature = "alloc")]
extern crate alloc;

mod limits;
#[cfg(feature = "serde")]
mod array_as_tuple;
mod number_format;
mod error_debug;
mod error_messages;
mod scalar;
mod linalg;
mod integrate;
mod model;
#[cfg(feature = "derivative-checks")]
mod check;
pub mod elliptic;
pub mod rotation;
pub mod rigid_body;
pub mod analysis;
pub mod identification;
pub mod problem;
pub mod assembly;
pub mod laws;
pub mod signals;
pub mod quantities;

#[doc(hidden)]
pub use model::emitted as __private;

#[cfg(feature = "derivative-checks")]
pub use check::{ArgumentValues, CheckDerivatives, DerivativeError, check_derivatives};
pub use integrate::{
    Advance, At, BranchVisitor, ButcherTableau, CLASSICAL_FOURTH_ORDER, Checkpoint, ComponentName,
    DeclaredEvent, DenseOutput, Dop853, Dop853Interpolant, Dop853Stepper, Dynamics, EventDynamics,
    EventValues, IntegrationError, Integrator, Interpolant, MetConditions, ObservationKind,
    Occurrence, Progress, Resume, RungeKutta, RungeKuttaMemory, RungeKuttaStepper, Series,
    SeriesMemory, SetTypicalSizes, SingleNumber, Singularity, Statistics, StepPolynomial, Stepper,
    StopReason, SwitchingFunction, Taylor, TaylorCoefficients, TaylorInterpolant, TaylorStepper,
    TypicalSizes, WithSizes,
};
pub use integrate::{Ensemble, InLanes, TaylorLanes, recurrences};
pub use integrate::{Partial, Problem, Solution};
pub use linalg::{ErrorTolerance, Factorization, IntoVector, LaneStates, VectorSpace};
pub use model::{ByParameters, StateTransition};
pub use model::{CanonicalEquations, CanonicalPhase, EnergyResidual, NoVelocities};
pub use model::{
    ConstantsOfMotion, ConstantsWatch, EquationsOfMotion, ExternalFunctions, FunctionSignature,
    GeneralizedCoordinates, Lagrangian, LargestChange, Linearization, OperationCount, Operations,
    Phase, Reconstruction, RouthReduction, Routhian, State, WithInputs,
};
pub use scalar::{DoubleDouble, Dual, Lanes, Scalar};
