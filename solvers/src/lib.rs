#![cfg_attr(
    all(feature = "diffsol", feature = "differential-equations", feature = "ode-solvers"),
    doc = include_str!("../README.md")
)]
#![cfg_attr(
    not(all(
        feature = "diffsol",
        feature = "differential-equations",
        feature = "ode-solvers"
    )),
    doc = "Models of [`lagrangian`] under the solvers of other crates, each behind a feature: [`OdeSystem`]."
)]
#![no_std]

extern crate alloc;

mod error;
mod on_duals;
mod jacobian;
mod source;
mod ode_system;
#[cfg(feature = "ode-solvers")]
mod ode_solvers;
#[cfg(feature = "differential-equations")]
mod differential_equations;
#[cfg(feature = "diffsol")]
mod diffsol;

pub use error::SystemError;
pub use jacobian::{DualJacobian, Jacobian, ModelJacobian, NoJacobian};
pub use ode_system::OdeSystem;
pub use on_duals::OnDuals;
pub use source::{ByDynamics, ByModel, Source};
