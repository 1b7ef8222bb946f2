//! What the programs of the guide share: where a figure is written to, and how it is drawn.

mod figure;
pub mod furuta;

pub use figure::{Curve, Figure};

/// The blocks of the cookbook, which are tests.
#[cfg(doctest)]
mod cookbook {
    #[doc = include_str!("../../cookbook/control.md")]
    mod control {}
    #[doc = include_str!("../../cookbook/contact.md")]
    mod contact {}
    #[doc = include_str!("../../cookbook/modelling.md")]
    mod modelling {}
    #[doc = include_str!("../../cookbook/solvers.md")]
    mod solvers {}
    #[doc = include_str!("../../cookbook/data.md")]
    mod data {}
}
