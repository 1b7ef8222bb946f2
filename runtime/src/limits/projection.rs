//! The projection of states onto the manifold on which equations hold.

/// The iterations of Newton's method for the coordinates with the factors of the first: of a relative error e in a
/// state they leave e⁴, and of its derivatives e³.
pub(crate) const POSITION_SWEEPS: usize = 3;

/// The iterations for the velocities, in which constraints are linear, with the factors at the unprojected
/// coordinates: of a relative error e of the velocities they leave e³. Two would leave more than the residual that is
/// allowed, where a motion turns after a step with the tolerance 1e-5.
pub(crate) const VELOCITY_SWEEPS: usize = 3;

/// The part of each coordinate by which a state is moved to find how many constraints are independent nearby, and the
/// projections that bring it back onto the constraints.
pub(crate) const NEARBY: f64 = 1e-3;
pub(crate) const TO_NEARBY: usize = 3;

/// The residual of a constraint that a projection may leave, in terms of its gradient times the state: the square root
/// of the machine epsilon, far above rounding errors and far below what a projection that does not converge leaves.
pub(crate) fn max_residual<S: crate::Scalar>() -> f64 {
    libm::sqrt(S::machine_epsilon())
}

/// The residual that rounding may leave in a constraint, in machine epsilons of its terms at some state. By judgement: a few for
/// each rotation in a chain.
pub(crate) const ROUNDED_EPSILONS: f64 = 64.0;

/// The largest move of the end of a step by a projection, in allowed errors. By judgement: an estimate of the error
/// may be too small by some factor.
pub(crate) const MAX_CORRECTION: f64 = 10.0;

/// The distance by which a state is moved to find the effect of rounding on its projection, in machine epsilons of
/// its components and of their changes in the step.
pub(crate) const MOVED_EPSILONS: f64 = 8.0;

/// The number of the changes found in this way by which a projection may move the end of a step. By judgement: the
/// sums of a step have about ten terms.
pub(crate) const CHANGES: f64 = 8.0;

/// The relative and the absolute error that are allowed in the initial state of fixed steps.
pub(crate) const FIXED_STEP_START: f64 = super::FIXED_STEP_SINGULARITY_TOLERANCE;
