//! The analysis of models: equilibria and steady motions, small oscillations and stability, linear state-space models
//! and their control.
//!
//! - [`EquilibriumSearch`] finds equilibria, steady motions and the inputs that hold a configuration.
//! - [`SmallOscillations`] holds the linearized equations about an equilibrium or a steady motion: [`NormalModes`],
//!   [`DampedModes`], the [`Spectrum`] and the [`Stability`].
//! - [`StateSpace`] is a linear model with inputs and outputs, about any state: its poles, its [`Controllability`], its
//!   discretization and its linear-quadratic [`Regulator`].
//! - [`TangentSpace`] is the choice of independent coordinates and velocities of a constrained model, for its
//!   [`StateSpace`](StateSpace::reduced), and [`RequiredInputs`] are what its actuators do in a given motion.
//!
//! Nothing allocates. Eigenvalues of nonsymmetric matrices are computed in `f64`; everything else is generic over
//! scalars that are a single number.

mod jacobian_rows;
mod tangent_error;
mod balance;
mod force_balance;
mod equilibrium;
mod eigenvalues;
mod symmetric_eigenvalues;
mod spectrum;
mod oscillation_error;
mod components;
mod members;
mod time_dependence;
mod reduced_equations;
mod small_oscillations;
mod linear_errors;
mod normal_modes;
mod null_vector;
mod damped_modes;
mod eigenvalue_errors;
mod stability;
mod controllability;
mod matrix_exponential;
mod state_space;
mod linear_outputs;
mod tangent_choice;
mod tangent_space;
mod tangents;
mod steady_motion;
mod equilibrium_error;
mod equilibrium_problem;
mod constrained_balance;
mod newton;
mod levenberg_marquardt;
mod equilibrium_search;
mod reduced_state_space;
mod constrained_oscillations;
mod required_inputs;
mod required_inputs_error;
mod riccati;
mod matrix_sign;
mod lyapunov;
mod riccati_newton;
mod regulator;
mod regulator_error;

pub use balance::{Balance, FreeInputs, HeldInputs};
pub use constrained_balance::OnConstraints;
pub use controllability::{Controllability, UncontrollableMode};
pub use damped_modes::{DampedMode, DampedModes};
pub use equilibrium::{Equilibrium, SearchReport, Variable};
pub use equilibrium_error::EquilibriumError;
pub use equilibrium_search::EquilibriumSearch;
pub use normal_modes::NormalModes;
pub use oscillation_error::OscillationError;
pub use regulator::Regulator;
pub use regulator_error::RegulatorError;
pub use required_inputs::RequiredInputs;
pub use required_inputs_error::RequiredInputsError;
pub use small_oscillations::SmallOscillations;
pub use spectrum::Spectrum;
pub use stability::{LinearStability, SecondVariation, Stability, Verdict};
pub use state_space::{DiscreteStateSpace, StateSpace};
pub use tangent_error::{IndependentVariables, TangentError};
pub use tangent_space::{TangentBasis, TangentSpace};

/// Returns whether a number exceeds a limit; NaN counts as exceeding it.
fn exceeds(value: f64, limit: f64) -> bool {
    value.is_nan() || value > limit
}
