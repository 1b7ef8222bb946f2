//! Matrices of expressions: their elements, determinants and factorizations.

pub(crate) mod axis;
pub(crate) mod factor;
pub(crate) mod dense;
pub(crate) mod rows;
pub(crate) mod determinant;
pub(crate) mod block_triangular;
pub(crate) mod symmetric_elimination;
pub(crate) mod elimination_order;
pub(crate) mod ldlt;
