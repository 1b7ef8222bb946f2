//! Translation validation: each derivation checks its own result (Pnueli, Siegel and Singerman, Translation
//! Validation, 1998).
//!
//! Input: a model as declared, and the programs that are about to be emitted for it. Output: which of them disagree
//! with Lagrange's equations. The programs are interpreted in binary64 at random real points, on every branch that
//! these meet. The reference is independent: automatic differentiation of the energies as they were first built,
//! without a symbolic derivative, a solver or a pass; the normal form of the energies is trusted. Elementary
//! functions are those of the crate `libm`, so that the answer is the same on every host.

mod validator;
mod derivative_check;
mod comparison;
mod constraint_check;
mod hyper_dual;
mod jet;
mod lagrange;
mod method;
mod mixed_derivatives;
mod number;
mod perturbation;
mod requested_check;
mod recurrence_tape;
mod reduction_check;
mod reference;
mod series_check;
mod value_series_check;
mod square_matrix;
mod sum_with_size;
mod tape;
mod tapes;

pub use method::Method;
pub use reduction_check::ReductionCheck;
pub use series_check::SeriesCheck;
pub use tape::Tape;
pub use tapes::{ConstraintTapes, SolutionTape, Tapes};
pub use validator::Validator;
pub use value_series_check::ValueSeriesCheck;
