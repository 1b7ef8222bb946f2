//! The prelude of `lagrangian`, without the derive macro.

pub use crate::rigid_body::{PrincipalBody, RigidBody, SymmetricBody};
pub use crate::{
    Advance, At, ConstantsOfMotion, Dop853, Dynamics, ExternalFunctions, GeneralizedCoordinates,
    IntegrationError, Integrator, Interpolant, Lagrangian, Linearization, ObservationKind,
    Occurrence, Phase, Progress, RouthReduction, Routhian, RungeKutta, Scalar, SetTypicalSizes,
    State, Statistics, Stepper, StopReason, Taylor, VectorSpace, WithInputs,
};
// Imported without names: through these traits, the compiler says which clause is missing.
#[doc(hidden)]
pub use crate::model::undeclared::{
    OfC as _, OfConstantsOfMotion as _, OfEvents as _, OfInputs as _, OfReducedModels as _,
    OfRegressor as _, OfSensitivities as _,
};
pub use nalgebra::{Matrix2, Matrix3, SMatrix, SVector, Vector2, Vector3};

#[cfg(feature = "derivative-checks")]
pub use crate::CheckDerivatives;
#[cfg(feature = "alloc")]
pub use crate::problem::{Dense, Every, StepEnds};
pub use crate::{Ensemble, Problem, Solution};
