//! Models with constraints.

mod pendulum;
