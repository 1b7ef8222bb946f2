//! From energies to equations of motion, and what is known of them before any number is.

pub(crate) mod model;
pub(crate) mod equations;
pub(crate) mod structure;
pub(crate) mod elimination;
