//! Ignorable coordinates: the constants of motion that they give, and the models that are left without them.

mod clauses;
mod constrained;
mod constants_of_motion;
mod digits;
mod equal_constants;
mod hostile_models;
mod models;
mod poles;
mod reduced_motion;
mod symmetric_top;
