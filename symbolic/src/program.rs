//! From the graph to straight-line code: planned, regrouped, scheduled, verified.

pub(crate) mod straight_line;
pub(crate) mod cost;
pub(crate) mod removable;
pub(crate) mod plan;
pub(crate) mod collecting;
pub(crate) mod factoring;
pub(crate) mod sharing;
pub(crate) mod preparation;
pub(crate) mod schedule;
pub(crate) mod interpretation;
pub(crate) mod verify;
