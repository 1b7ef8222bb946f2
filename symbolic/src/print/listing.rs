//! The equations of a model, one below the other: definitions, energies, momenta, Lagrange's equations, and the form
//! in which they are solved.
//!
//! What would be too long to read is left out, with a sentence that says how long it is. Definitions stand before
//! what is made of them, and only those that the equations mention.

pub(crate) mod section;
pub(crate) mod sections;
pub(crate) mod as_declared;
pub(crate) mod composer;
pub(crate) mod page_letters;
pub(crate) mod row_breaks;
pub(crate) mod constraints;
pub(crate) mod coordinates;
pub(crate) mod energy;
pub(crate) mod sampling;
pub(crate) mod families;
pub(crate) mod printed_model;
pub(crate) mod index_families;
pub(crate) mod index_letters;
pub(crate) mod index_pattern;
pub(crate) mod pair_sums;
pub(crate) mod pattern_text;
pub(crate) mod vector_text;
pub(crate) mod recursion_text;
pub(crate) mod recursion;
pub(crate) mod solved;

use crate::Expression;
use crate::print::listing::as_declared::AsDeclared;
use crate::print::names::Names;

/// The names of a model, in the order of the declaration.
#[derive(Clone, Debug, Default)]
pub struct Declared {
    /// The names of symbols; its definitions are not used.
    pub names: Names,
    /// The definitions.
    pub definitions: Vec<(String, Expression)>,
    /// The functions of events.
    pub events: Vec<(String, Expression)>,
    /// The energies and the definitions as they were declared.
    pub as_declared: AsDeclared,
    /// How many operations the accelerations take.
    pub operations: usize,
}

/// The equations of a model in print.
#[derive(Clone, Debug)]
pub struct Listing {
    /// Lines of Unicode.
    pub unicode: String,
    /// Displays of LaTeX, which `amsmath` typesets.
    pub latex: String,
}
