//! From the graph to straight-line code: a DAG of operations, passes over it, a schedule, its verification.

pub(crate) mod straight_line;
pub(crate) mod operation_count;
pub(crate) mod removable_singularities;
pub(crate) mod angle_slopes;
pub(crate) mod dag;
pub(crate) mod passes;
pub(crate) mod schedule;
pub(crate) mod liveness;
pub(crate) mod numbering;
pub(crate) mod staging;
pub(crate) mod arrival;
pub(crate) mod reassociation;
pub(crate) mod register_order;
pub(crate) mod interpret;
pub(crate) mod taylor;
