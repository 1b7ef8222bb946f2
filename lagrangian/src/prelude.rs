//! The names that most programs use: `use lagrangian::prelude::*;`.
//!
//! It contains the derive macro, the traits of models, the integrators, and the vectors and matrices of their
//! signatures.

#[doc(no_inline)]
pub use crate::nalgebra::{Matrix2, Matrix3, SMatrix, SVector, Vector2, Vector3};
#[doc(no_inline)]
pub use crate::rigid_body::{PrincipalBody, RigidBody, SymmetricBody};
#[doc(no_inline)]
pub use crate::{
    Advance, At, ConstantsOfMotion, Dop853, Dynamics, Ensemble, ExternalFunctions,
    GeneralizedCoordinates, IntegrationError, Integrator, Interpolant, Lagrangian, Linearization,
    ObservationKind, Occurrence, Phase, Problem, Progress, RouthReduction, Routhian, RungeKutta,
    Scalar, SetTypicalSizes, Solution, State, Statistics, Stepper, StopReason, Taylor, VectorSpace,
    WithInputs,
};
// Imported without names: through these traits, the compiler says which clause is missing.
#[doc(hidden)]
pub use lagrangian_runtime::__private::undeclared::{
    OfC as _, OfConstantsOfMotion as _, OfEvents as _, OfInputs as _, OfReducedModels as _,
    OfRegressor as _, OfSensitivities as _,
};

#[cfg(feature = "derivative-checks")]
#[doc(no_inline)]
pub use crate::CheckDerivatives;
#[cfg(feature = "alloc")]
#[doc(no_inline)]
pub use crate::problem::{Dense, Every, StepEnds};
