//! Models under the solvers of other crates. Without their features what is compiled are the tests of the systems alone.
#![allow(clippy::float_cmp)] // What is computed in the same way is equal.
#![cfg_attr(
    not(all(
        feature = "diffsol",
        feature = "differential-equations",
        feature = "ode-solvers"
    )),
    allow(dead_code)
)]

mod closeness;
#[cfg(feature = "differential-equations")]
mod differential_equations;
#[cfg(feature = "diffsol")]
mod diffsol;
mod errors;
mod jacobians;
mod models;
#[cfg(feature = "ode-solvers")]
mod ode_solvers;
mod states;
