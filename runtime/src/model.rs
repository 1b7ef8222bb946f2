//! Mechanical systems: the traits that the derive macro implements, and what a model offers to integrators and
//! controllers.

mod generalized_coordinates;
mod state;
mod system;
mod law;
mod controlled_problem;
mod phase;
mod named_singularity;
mod poles;
mod linearization;
mod state_transition;
mod operations;
mod by_columns;
mod quantities;
mod state_jacobian;
mod constraints;
mod directional_derivatives;
mod saddle_point;
mod degrees_of_freedom;
mod assembly;
mod impacts;
mod assembly_error;
mod lagrangian;
mod model_reference;
mod legendre;
mod constants_of_motion;
mod motion_series;
mod events;
mod event_dynamics;
mod in_lanes;
mod whole_periods;
mod singular_configuration;
mod equations_of_motion;
mod members_in_lanes;
mod inputs;
mod with_inputs;
mod outputs;
mod regressor;
mod sensitivities;
mod energy_balance;
mod energy_residual;
mod canonical_phase;
mod canonical_equations;
mod hamiltonian;
mod external_functions;
mod reflect;
mod routhian;
mod reconstruction;
mod signals;
mod arrays;
pub mod undeclared;
#[doc(hidden)]
pub mod emitted;

pub use assembly::{Assembled, Assembly};
pub use assembly_error::{AssemblyError, OpenConstraints};
pub use canonical_equations::CanonicalEquations;
pub use canonical_phase::CanonicalPhase;
pub use constants_of_motion::{ConstantsOfMotion, ConstantsWatch, LargestChange};
pub use constraints::Constraints;
pub use degrees_of_freedom::DegreesOfFreedom;
pub use directional_derivatives::{DirectionalDerivatives, MotionDerivatives};
pub use energy_balance::EnergyBalance;
pub use energy_residual::EnergyResidual;
pub use equations_of_motion::EquationsOfMotion;
pub use events::Events;
pub use external_functions::{ExternalFunctions, FunctionSignature};
pub use generalized_coordinates::GeneralizedCoordinates;
pub use hamiltonian::{Hamiltonian, NoVelocities};
pub use impacts::Impacts;
pub use inputs::Inputs;
pub use lagrangian::Lagrangian;
pub use law::{
    Driven, DynamicFeedback, Feedback, Held, Lagged, Law, LawSeries, LawStates, LawsInLanes,
    Sampled, SampledFeedback, StatesInLanes,
};
pub use linearization::Linearization;
pub use members_in_lanes::MembersInLanes;
pub use motion_series::MotionSeries;
pub use operations::{OperationCount, Operations};
pub use outputs::Outputs;
pub use phase::Phase;
pub use quantities::{Energies, Quantities};
pub use reconstruction::Reconstruction;
pub use reflect::{
    FieldDescription, FieldElement, FieldReader, FieldValue, InvalidNumbers, Reflect,
};
pub use regressor::Regressor;
pub use routhian::{RouthReduction, Routhian, RouthianSeries};
pub use sensitivities::{MultiplierSensitivities, Sensitivities};
pub use signals::{Constant, Polynomial, Signal, Signals, Sinusoid, Sum};
pub use state::State;
pub use state_jacobian::StateJacobian;
pub use state_transition::{ByParameters, StateTransition};
pub use with_inputs::WithInputs;
