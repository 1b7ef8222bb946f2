//! What the examples share: figures, and equations on a terminal.

mod axis;
mod equations;
mod panel;
mod svg;

pub use axis::Axis;
pub use equations::wrapped;
pub use panel::{Panel, extent};
pub use svg::{Anchor, Point, Svg};
