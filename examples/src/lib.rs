//! What the figures of the examples are drawn with.

mod axis;
mod panel;
mod svg;

pub use axis::Axis;
pub use panel::{Panel, extent};
pub use svg::{Anchor, Point, Svg};
