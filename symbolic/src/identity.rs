//! Exact decisions about identities, by random evaluation in modular arithmetic, and random points for all tests.

pub(crate) mod residue;
pub(crate) mod modular_matrix;
pub(crate) mod row_echelon;
pub(crate) mod rational_reconstruction;
pub(crate) mod homomorphic_image;
pub(crate) mod modular_point;
pub(crate) mod incremental_evaluation;
pub(crate) mod gradient;
pub(crate) mod tested_value;
pub(crate) mod identity_testing;
pub(crate) mod independence;
pub(crate) mod real_point;
pub(crate) mod claims;
