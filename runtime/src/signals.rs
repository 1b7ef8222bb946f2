//! Inputs that are functions of time, with their Taylor series: what [`Problem::driven_by`](crate::Problem::driven_by) takes.

pub use crate::model::{Constant, Polynomial, Signal, Signals, Sinusoid, Sum};
