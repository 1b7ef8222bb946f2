//! Emitted code as a guest in the user's crate: its names, its lints, its form.
#![deny(future_incompatible)] // Some lints of this group are those of whole crates.

mod c_source;
pub mod golden;
pub mod lints;
pub mod long_methods;
mod members_in_lanes;
pub mod root;
pub mod type_parameters;
mod without_annotations;
pub mod names;
