//! What the programs of the guide share: where a figure is written to, and how it is drawn.

mod figure;

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
