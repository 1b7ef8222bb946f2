//! Identification of parameters from measured motions, by least squares.
//!
//! A model with the clause `regressor` gives linear equations Y π = τ − r for its base parameters π at each instant at which
//! the motion and the forces were measured ([`Regressor`](crate::quantities::Regressor)). [`Identification`] gathers them without
//! storing them, and [`Identified`] has the estimate with its covariance.

mod singular_values;
mod error;
mod identified;
mod least_squares;

pub use error::IdentificationError;
pub use identified::Identified;
pub use least_squares::Identification;
