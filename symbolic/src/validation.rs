//! Translation validation: each derivation checks its own result (Pnueli, Siegel and Singerman, Translation
//! Validation, 1998).
//!
//! Comes in: a model as declared, and the programs that are about to be emitted for it. Goes out: which of
//! them do not compute what Lagrange's equations say. The programs are interpreted in binary64 at random
//! real points, on every branch that these meet. What they are compared with takes another road:
//! automatic differentiation in numbers of the energies as they were first built, without a derivative,
//! a solution or a pass of the algebra; the normal form of the energies is trusted. Elementary functions are
//! those of the crate `libm`, so that the answer is the same on every host.

mod agreement;
mod changes;
mod comparison;
mod hyper_dual;
mod lagrange;
mod number;
mod perturbation;
mod programs;
pub(crate) mod sample;
mod square_matrix;
mod tape;

pub use agreement::Validator;
pub use programs::{AccelerationProgram, LinearizationProgram, Method, Programs};
