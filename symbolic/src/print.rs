//! Formulas as in a book, in Unicode and in LaTeX.

pub(crate) mod names;
pub(crate) mod index;
pub(crate) mod spelling;
pub(crate) mod notation;
pub(crate) mod numeral;
pub(crate) mod order;
pub(crate) mod quotient;
pub(crate) mod printed;
pub(crate) mod layout;
pub(crate) mod piece;
pub(crate) mod line;
pub(crate) mod writer;
pub(crate) mod formula;
pub(crate) mod arrangement;
pub(crate) mod single_quotient;
pub(crate) mod size;
pub(crate) mod folding;
pub(crate) mod listing;
