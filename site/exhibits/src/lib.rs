//! The ready models as exhibits: one description of each, shared by the gallery and the page in the browser.
//!
//! A description consists of a name, sliders for parameters and starts, a law of control where one makes sense, curves, and a
//! drawing. The drawing places the bodies of the model with their masses and inertias, so that a test can compute the energies
//! of what is drawn and compare them with those of the model.

mod about;
mod camera;
mod description;
mod exhibit;
mod models;
mod motion;
pub mod palette;
mod picture;
mod pieces;
pub mod scene;
mod trail;
mod values;

pub use about::{About, Curve, Group, Quantity};
pub use camera::Camera;
pub use description::description;
pub use exhibit::{Evaluation, Exhibit, Motion, Refusal};
pub use models::exhibits;
pub use picture::{Kind, Picture, Piece};
pub use trail::Trails;
pub use values::Values;
