//! Exact algebra on a shared graph: numbers, normal forms, functions, derivatives, costs.

pub(crate) mod hashing;
pub(crate) mod rational;
pub(crate) mod symbol;
pub(crate) mod contents;
pub(crate) mod enclosure;
pub(crate) mod interner;
pub(crate) mod graph;
pub(crate) mod sum;
pub(crate) mod pythagoras;
pub(crate) mod product;
pub(crate) mod angle_differences;
pub(crate) mod hyperbolic;
pub(crate) mod call;
pub(crate) mod circular;
pub(crate) mod function;
pub(crate) mod external_function;
pub(crate) mod dependence;
pub(crate) mod derivative;
pub(crate) mod time_derivative;
pub(crate) mod velocity_degree;
pub(crate) mod substitution;
pub(crate) mod evaluation;
pub(crate) mod cost;
pub(crate) mod expansion;
pub(crate) mod trigonometric_reduction;
pub(crate) mod half_angles;
