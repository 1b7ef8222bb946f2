//! Systems of linear equations in expressions: determinants, elimination and factorizations.

pub(crate) mod rows;
pub(crate) mod components;
pub(crate) mod determinant;
pub(crate) mod block_triangular;
pub(crate) mod symmetric_elimination;
pub(crate) mod elimination_order;
pub(crate) mod ldlt;
