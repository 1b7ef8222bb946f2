//! From the graph to straight-line code: a DAG of operations, passes over it, a schedule, its verification.

pub(crate) mod straight_line;
pub(crate) mod cost;
pub(crate) mod removable;
pub(crate) mod dag;
pub(crate) mod collecting;
pub(crate) mod factoring;
pub(crate) mod sharing;
pub(crate) mod staging;
pub(crate) mod schedule;
pub(crate) mod interpret;
pub(crate) mod verify;
