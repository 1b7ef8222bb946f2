//! Derived models evaluated on scalars other than `f64`, with parameters of the same scalar.

mod models;
mod single_precision;
mod lanes;
mod members_in_lanes;
mod double_double;
mod sensitivities;
mod dual_expressions;
mod dual_numbers;
mod linearization_near_the_poles;
mod parameter_sensitivities;
