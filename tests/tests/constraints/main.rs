//! Models with constraints.

mod closed_forms;
mod consistency;
mod pendulum;
mod reactions;
mod redundant;
mod references;
mod singular;
