//! Identification of parameters from measured motions, by least squares.
//!
//! For a model with the clause `regressor`, each instant at which the motion and the forces were measured gives linear
//! equations Y π = τ − r for its base parameters π ([`Regressor`](crate::quantities::Regressor)). [`Identification`]
//! accumulates them without storing them, and [`Identified`] contains the estimate with its covariance.

mod singular_values;
mod error;
mod identified;
mod least_squares;

pub use error::IdentificationError;
pub use identified::Identified;
pub use least_squares::Identification;
