//! Exact decisions about identities, in modular arithmetic.

pub(crate) mod residue;
pub(crate) mod point;
