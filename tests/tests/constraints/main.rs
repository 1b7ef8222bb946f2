//! Models with constraints.

mod closed_forms;
mod consistency;
mod junctions;
mod mechanisms;
mod pendulum;
mod reactions;
mod redundant;
mod references;
mod same_bits;
