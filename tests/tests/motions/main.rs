//! Motions of derived models: events, checkpoints, many turns, the Hamiltonian form, control.

#[cfg(feature = "all-cases")]
#[path = "../../../runtime/tests/common/settings.rs"]
mod settings;

mod checkpoint_events;
mod checkpoints;
mod events;
mod events_under_inputs;
mod full_revolutions;
mod hamiltonian;
mod linear_control;
mod many_turns;
#[cfg(feature = "all-cases")]
mod pairs_of_settings;
mod regularity;
mod regulators;
mod sampled_events;
mod simultaneous_events;
