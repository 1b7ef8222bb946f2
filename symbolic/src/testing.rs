//! Models to test with, written as formulas.
//!
//! Unit tests see this library as it is compiled for them, which to the compiler is not the library that other
//! crates see. What unit tests share with the tests in `tests/` is therefore a module of the library, behind the
//! feature `testing`; what those tests share among themselves is the crate in `testing/`.
#![allow(missing_docs, clippy::must_use_candidate, clippy::missing_panics_doc)]

mod draft;
mod program_expressions;
mod quantity;
mod solutions;
pub mod systems;
mod verification;

pub use draft::Draft;
pub use quantity::{Quantity, vector};
pub use verification::Fault;
