//! Systems: Lagrange's equations, their solution, and what is known of a system symbolically.

mod angular_velocities;
mod constraints;
mod dynamics;
mod equations;
mod pivots;
mod regressors;
mod routhian;
mod structure;
mod vectors_in_frames;
