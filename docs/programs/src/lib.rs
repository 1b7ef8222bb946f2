//! What the programs of the guide share: where a figure is written to, and how it is drawn.

mod figure;

pub use figure::{Curve, Figure};
