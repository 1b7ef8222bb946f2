//! What the programs of the guide share: where a figure is written to, and how it is drawn.

mod figure;
pub mod furuta;

pub use figure::{Curve, Figure};

/// The fragments of the chapters.
#[cfg(doctest)]
mod fragments {
    #[doc = include_str!("../../introduction.md")]
    mod introduction {}
    #[doc = include_str!("../../guide/declare.md")]
    mod declare {}
    #[doc = include_str!("../../guide/simulate.md")]
    mod simulate {}
    #[doc = include_str!("../../guide/watch.md")]
    mod watch {}
    #[doc = include_str!("../../guide/control.md")]
    mod control {}
    #[doc = include_str!("../../guide/constrain.md")]
    mod constrain {}
    #[doc = include_str!("../../guide/linearize.md")]
    mod linearize {}
    #[doc = include_str!("../../guide/identify.md")]
    mod identify {}
    #[doc = include_str!("../../guide/many.md")]
    mod many {}
}

/// The blocks of the cookbook, which are tests.
#[cfg(doctest)]
mod cookbook {
    #[doc = include_str!("../../cookbook/control.md")]
    mod control {}
    #[doc = include_str!("../../cookbook/contact.md")]
    mod contact {}
    #[doc = include_str!("../../cookbook/modelling.md")]
    mod modelling {}
    #[cfg(feature = "serde")]
    #[doc = include_str!("../../cookbook/solvers.md")]
    mod solvers {}
    #[doc = include_str!("../../cookbook/data.md")]
    mod data {}
}
