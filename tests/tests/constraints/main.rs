//! Models with constraints.

mod consistency;
mod pendulum;
mod redundant;
