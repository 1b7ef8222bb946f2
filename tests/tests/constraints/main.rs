//! Models with constraints.

mod consistency;
mod pendulum;
mod reactions;
mod redundant;
mod references;
