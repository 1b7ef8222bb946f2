//! The passes over the DAG, in the order in which they are applied.

pub(crate) mod collecting;
pub(crate) mod factoring;
pub(crate) mod invariants;
pub(crate) mod sharing;
