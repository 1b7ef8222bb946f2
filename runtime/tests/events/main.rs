//! Events: where functions cross zero, and what reactions to that make of a motion.

#[path = "../common/mod.rs"]
mod common;
#[path = "../common/constrained.rs"]
mod constrained;
mod directions;
mod event_models;
mod random_numbers;
mod two_lists;
mod two_runs;

mod consecutive_runs;
mod contacts;
mod crossings;
mod event_derivatives;
mod events;
mod hostile_events;
mod hostile_motions;
mod in_lanes;
mod loose_tolerances;
mod projected_steps;
mod reactions;
mod rounding;
mod series_of_events;
mod several_in_a_step;
mod short_runs;

mod stopping_reactions;
mod functions_of_roundings;
mod settings_compose;
mod switch_derivatives;
mod touches;
