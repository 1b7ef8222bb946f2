//! The sixteen programs by drivers.

pub(crate) mod bounce;
pub(crate) mod cancellation;
pub(crate) mod checkpoint;
pub(crate) mod dense;
pub(crate) mod ensemble;
pub(crate) mod events;
pub(crate) mod game_loop;
pub(crate) mod linear_quadratic_regulator;
pub(crate) mod other_method;
pub(crate) mod parameter_change;
pub(crate) mod proportional_derivative;
pub(crate) mod sampled_controller;
pub(crate) mod samples;
pub(crate) mod signal;
pub(crate) mod top;
