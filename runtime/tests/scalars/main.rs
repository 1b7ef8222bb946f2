//! Scalars, functions of them, and linear algebra over them.

#[path = "../common/mod.rs"]
mod common;

mod double_double;
mod dual_functions;
mod dual_lanes;
mod dual_numbers;
mod elliptic;
mod extreme_angles;
mod extreme_elliptic_integrals;
mod factorization;
mod indefinite;
mod logistic;
mod provided;
