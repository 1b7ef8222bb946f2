//! The search for consistent states.

/// The steps of Newton's method, which from a good guess takes five.
pub(crate) const MAX_ITERATIONS: usize = 100;

/// The smallest part of a step that is tried.
pub(crate) const LEAST_DAMPING: f64 = 1e-6;

/// The part of a damped step by which the next step has to be shorter (P. Deuflhard, *Newton Methods for Nonlinear
/// Problems* (2004), 3.3).
pub(crate) const SUFFICIENT_DECREASE: f64 = 0.25;

/// The corrections of the velocities, in which constraints are linear: the second takes rounding errors away.
pub(crate) const VELOCITY_SWEEPS: usize = 2;

/// The residual of a constraint that counts as zero, in terms of its gradient times the state, and for a state near zero
/// its square.
pub(crate) use super::projection::max_residual;
