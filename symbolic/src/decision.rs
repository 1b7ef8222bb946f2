//! Exact decisions about identities, by random evaluation in modular arithmetic.

pub(crate) mod residue;
pub(crate) mod point;
pub(crate) mod evaluation;
pub(crate) mod identity_test;
