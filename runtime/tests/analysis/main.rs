//! What is asked of a model besides its motion: equilibria, stability, linear models, control, derivatives.

#[path = "../common/mod.rs"]
mod common;

mod constrained;
mod control;
mod controllers;
mod decided_stability;
#[cfg(feature = "derivative-checks")]
mod derivative_check;
mod equilibria;
mod hostile_stability;
mod laws;
mod legendre;
mod linearization;
mod regulators;
mod small_oscillations;
mod state_transition;
mod steady_motions;
mod stiff_state_space;
mod three_bodies;
mod undecided_stability;
