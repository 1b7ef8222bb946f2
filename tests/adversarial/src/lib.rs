//! Generated models, and what they evaluate to against references.
//!
//! The references are computed without this project's code; see `generator/`.

mod at;
mod comparison;
mod evaluation;
pub mod external;

pub use at::{At, Values};
pub use comparison::{Comparison, compare};
pub use evaluation::{Evaluate, Found, driven, energies, motion, reduced, rows};

/// The models, written by the build script.
#[rustfmt::skip]
#[allow(missing_docs, unreachable_pub, unused, clippy::all, clippy::pedantic)]
mod models {
    use crate::Evaluate;

    include!(concat!(env!("OUT_DIR"), "/models.rs"));
}

pub use models::MODELS;
