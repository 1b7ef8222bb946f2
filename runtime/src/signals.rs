//! Inputs that are functions of time, with their Taylor series, for [`Problem::driven_by`](crate::Problem::driven_by).

pub use crate::model::{Constant, Polynomial, Signal, Signals, Sinusoid, Sum};
