//! Mechanical systems: what the derive macro implements, and what a model offers to an integrator and to a
//! controller.

mod generalized_coordinates;
mod state;
mod vector_pair;
mod phase;
mod named_singularity;
mod poles;
mod linearization;
#[cfg(feature = "num-dual")]
mod state_transition;
mod operations;
mod by_columns;
mod lagrangian;
mod constants_of_motion;
mod motion_series;
mod events;
mod ensemble;
mod whole_periods;
mod singular_configuration;
mod common_dynamics;
mod equations_of_motion;
mod owned_equations;
mod inputs;
mod outputs;
mod regressor;
mod sensitivities;
mod energy_balance;
mod energy_residual;
mod canonical_phase;
mod canonical_equations;
mod hamiltonian;
mod external_functions;
mod augmented_phase;
mod reconstructed_phase;
mod routhian;
mod reconstruction;
mod controlled_by;
mod signals;
mod driven_by;
mod with_controller;
mod plant;
mod arrays;
#[doc(hidden)]
pub mod emitted;

pub use augmented_phase::AugmentedPhase;
pub use canonical_equations::CanonicalEquations;
pub use canonical_phase::CanonicalPhase;
pub use constants_of_motion::{ConstantsOfMotion, ConstantsWatch, LargestChange};
pub use controlled_by::ControlledBy;
pub use driven_by::DrivenBy;
pub use energy_balance::{EnergyBalance, EnergyBalanceWith};
pub use energy_residual::EnergyResidual;
pub use equations_of_motion::EquationsOfMotion;
pub use events::{Events, EventsWith};
pub use external_functions::{ExternalFunctions, FunctionSignature};
pub use generalized_coordinates::GeneralizedCoordinates;
pub use hamiltonian::{Hamiltonian, HamiltonianWith, NoVelocities};
pub use inputs::{Inputs, WithInputs};
pub use lagrangian::{Energies, Lagrangian};
pub use linearization::Linearization;
pub use motion_series::{MotionSeries, MotionSeriesWith};
pub use operations::{OperationCount, Operations};
pub use outputs::{Outputs, OutputsWith};
pub use owned_equations::OwnedEquations;
pub use phase::Phase;
pub use plant::Plant;
pub use reconstructed_phase::ReconstructedPhase;
pub use reconstruction::Reconstruction;
pub use regressor::{Regressor, RegressorWith};
pub use routhian::{RouthReduction, Routhian, RouthianSeries};
pub use sensitivities::{Sensitivities, SensitivitiesWith};
pub use signals::{Constant, Polynomial, Signal, Signals, Sinusoid, Sum};
pub use state::State;
#[cfg(feature = "num-dual")]
pub use state_transition::{ByParameters, StateTransition};
pub use with_controller::WithController;
