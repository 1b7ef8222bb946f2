//! Models with constraints.

mod closed_forms;
mod consistency;
mod freedom;
mod pendulum;
mod reactions;
mod redundant;
mod references;
mod singular;
