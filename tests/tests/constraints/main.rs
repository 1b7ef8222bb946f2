//! Models with constraints.

mod pendulum;
mod redundant;
