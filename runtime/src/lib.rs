//! Write the energies of a mechanical system on a struct of its parameters; get its equations of
//! motion as specialized Rust, derived at compile time, and step them.
#![cfg_attr(not(feature = "std"), no_std)]

mod scalar;
mod state;
mod system;
mod lagrangian;
mod linearization;
mod inputs;
mod outputs;
mod operations;
mod factorization;

#[doc(hidden)]
#[path = "private.rs"]
pub mod __private;

pub use factorization::Factorization;
pub use inputs::{ControlledBy, Inputs, WithInputs};
pub use lagrangian::{Energies, Lagrangian};
pub use lagrangian_derive::Lagrangian;
pub use linearization::Linearization;
pub use operations::{OperationCount, Operations};
pub use outputs::Outputs;
pub use scalar::Scalar;
pub use state::State;
pub use system::System;
