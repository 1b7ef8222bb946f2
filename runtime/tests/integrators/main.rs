//! Integrators, and the problems that they solve: methods, orders, tolerances, inputs, ensembles.

#[path = "../common/mod.rs"]
mod common;
#[path = "../common/settings.rs"]
mod settings;
#[path = "../common/constrained.rs"]
mod constrained;

mod beyond_many_turns;
mod branches;
mod corrected_ends;
mod counted_calls;
mod driven;
mod ensemble;
mod ensemble_errors;
mod errors;
mod jumps;
mod lanes;
mod long_run;
mod members;
mod members_under_laws;
mod methods;
mod order;
mod precision;
mod problem;
mod problem_settings;
mod projected_systems;
mod projection;
mod projection_errors;
mod recurrences;
mod running;
mod samples_of_parts;
mod saltation;
mod sampled;
mod series_by_hand;
mod sliding;
mod taylor;
mod tolerances;
mod trajectories;
mod units;
mod within_steps;
