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

/// A row whose leverage differs from 1 by less is no combination of others: with rows of length 1, the others have coefficients below
/// 3·10⁻⁵ in each combination that vanishes.
pub(crate) const NEGLIGIBLE_LEVERAGE: f64 = 1e-9;
