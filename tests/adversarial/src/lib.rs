//! Generated models, and what they evaluate to against references.
//!
//! The references are computed without this project's code; see `generator/`.

mod at;
mod comparison;
mod conditioning;
mod evaluation;
pub mod external;
mod motions;
mod regulators;
pub mod splits;

pub use at::{At, Values};
pub use comparison::{Comparison, compare, compare_each};
pub use conditioning::Conditioning;
pub use evaluation::{
    Entries, Evaluate, Found, constrained, driven, energies, energy_rate, motion, reduced, rows,
};
pub use motions::{ends, lanes, reduced_ends};
pub use regulators::compare_regulators;

/// The models, written by the build script.
#[rustfmt::skip]
#[allow(missing_docs, unreachable_pub, unused, deprecated, clippy::all, clippy::pedantic)]
mod models {
    use crate::Evaluate;

    include!(concat!(env!("OUT_DIR"), "/models.rs"));
}

pub use models::MODELS;
