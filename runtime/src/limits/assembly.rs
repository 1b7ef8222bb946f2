//! The search for consistent states.

/// The steps of Newton's method, which from a good guess takes five.
pub(crate) const MAX_ITERATIONS: usize = 100;

/// The smallest part of a step that is tried.
pub(crate) const LEAST_DAMPING: f64 = 1e-6;

/// The part of a damped step by which the next step has to be shorter (P. Deuflhard, *Newton Methods for Nonlinear
/// Problems* (2004), 3.3).
pub(crate) const SUFFICIENT_DECREASE: f64 = 0.25;

/// What counts as zero, and how often velocities are corrected, is as in the projection of steps.
pub(crate) use super::projection::{VELOCITY_SWEEPS, max_residual};
