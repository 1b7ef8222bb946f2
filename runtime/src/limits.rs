//! The limits and tuning constants of the crate, with the reason for each.
//!
//! Not included are the coefficients of a method, which are next to it (`integrate/dormand_prince/coefficients.rs`),
//! and the ranges of the elementary functions (`scalar/sine_cosine.rs`, `scalar/double_double/constants.rs`), which
//! follow from the number format.

/// The number of steps, including rejected ones, after which an integration gives up by default: more than a motion
/// needs, but an end to a run whose steps have become tiny.
pub(crate) const MAX_STEPS: u64 = 100_000_000;

/// The smallest default of the singularity tolerance, in machine epsilons: the relative pivots of regular models are
/// small, too, and must not be mistaken for a singularity.
pub(crate) const MIN_SINGULARITY_TOLERANCE: f64 = 4096.0;

/// The singularity tolerance of methods with fixed steps, which have no tolerance of their own. By judgement: the
/// accuracy expected of the classical method.
pub(crate) const FIXED_STEP_SINGULARITY_TOLERANCE: f64 = 1e-6;

/// An inertia that is this small relative to its value elsewhere has nearly vanished. By judgement, between the ratios
/// near 1 of regular models and the rounding errors of M⁻¹.
pub(crate) const VANISHING_INERTIA: f64 = 1e-6;

/// The offsets, in each of the coordinates on which an inertia depends, at which the reference inertia is evaluated:
/// three offsets without a common period, so that not all of them meet the next zero of a sine.
pub(crate) const REFERENCE_OFFSETS: [f64; 3] = [-1.0, 0.5, 1.0];

/// The sweeps in which a matrix is equilibrated before it is factored with pivoting, each of which takes the root of what is left.
/// By judgement: of units apart by 10¹² a factor of 1.5 remains.
pub(crate) const EQUILIBRATION_SWEEPS: usize = 6;

/// The smallest ratio of a pivot of a saddle point problem to its diagonal entry, below which it is factored with pivoting. By
/// judgement: L D Lᵀ without pivoting loses at most as many digits as this has zeros.
pub(crate) const MIN_STABLE_PIVOT: f64 = 1e-2;

/// The sine of the angle between the gradient of a constraint and the span of other gradients below which the constraint
/// depends on the others at a consistent state. By judgement: it is far above rounding errors, and a mechanism that passes a singular configuration is
/// as near to it for no longer than this part of a radian.
pub(crate) const MIN_INDEPENDENT_SINE: f64 = 1e-10;

/// The part of the length of the longest column from which a preferred column is chosen as a dependent one before it: the threshold of
/// I. S. Duff, A. M. Erisman & J. K. Reid, *Direct Methods for Sparse Matrices*, 2nd edition (2017), 5.2.
pub(crate) const PREFERRED_LENGTH: f64 = 0.1;

/// The number of right-hand sides that are solved together: a vector register of 256 bits holds this number of `f64`.
pub(crate) const RIGHT_HAND_SIDES_AT_ONCE: usize = 4;

/// The number of rows that are eliminated together, of the same size.
pub(crate) const ROWS_AT_ONCE: usize = 4;

/// The number of constraints in the report of a mechanism that is not closed.
pub(crate) const REPORTED_CONSTRAINTS: usize = 6;

/// The number of coordinates in the report of a singularity, so that errors stay `Copy` and small.
pub(crate) const REPORTED_COORDINATES: usize = 6;

/// The limit of sweeps of Jacobi rotations, which ends the iteration for numbers that are not finite. About ten suffice
/// otherwise, since convergence is quadratic.
pub(crate) const JACOBI_SWEEPS: usize = 60;

/// The condition number of a scaled regressor above which a combination of parameters counts as not excited: half of
/// the digits of `f64` are lost.
pub(crate) const MAX_CONDITION_NUMBER: f64 = 1e8;

/// The limit of Newton steps for the velocities that belong to momenta. Two suffice if L is quadratic in the
/// velocities, about five for relativistic velocities.
pub(crate) const LEGENDRE_ITERATIONS: usize = 50;

/// A change of the velocities below this number of their rounding errors counts as rounding.
pub(crate) const LEGENDRE_ROUNDING: f64 = 8.0;

/// Newton's method for velocities gives up if a step with this damping factor brings no improvement.
pub(crate) const MIN_NEWTON_STEP: f64 = 1e-9;

/// The allowed error of the momentum of a velocity that is held because M is infinite there, in machine epsilons of the
/// largest momentum: a few rounding errors of its terms.
pub(crate) const HELD_MOMENTUM: f64 = 64.0;

/// The number of sweeps over all velocities, each followed by Newton's method, after which the search for velocities
/// gives up. One is enough if one velocity has a singular momentum, a few more if several are coupled.
pub(crate) const LEGENDRE_SWEEPS: usize = 16;

/// The number of bisections of the exponent of a velocity. Eleven reduce the 2044 exponents of `f64` to one, the others
/// determine three digits, from which Newton's method converges.
pub(crate) const LEGENDRE_BISECTIONS: usize = 22;

/// Numbers whose magnitude is in this range are printed without an exponent.
pub(crate) const PRINTED_WITHOUT_EXPONENT: core::ops::Range<f64> = 1e-4..1e7;

/// An angle up to this size is not reduced by whole periods: its rounding error is at most twice the rounding error of
/// π.
pub(crate) const SMALL_ANGLE: f64 = 8.0;

/// A time in comparison with which every motion is fast; in comparison with its reciprocal, every motion is slow.
pub(crate) const MAX_TIME_SCALE: f64 = 1e100;

/// A motion with a longer time scale is at rest.
pub(crate) const USABLE_TIME_SCALE: f64 = 1e50;

pub(crate) mod projection;

pub(crate) mod assembly;

pub(crate) mod events;

/// Singular configurations of constraints that steps of explicit Runge–Kutta methods pass.
pub(crate) mod passing {
    /// A stage is close to a singular configuration if the sine between gradients of constraints is below this number, about ε^¼
    /// (its square is the smallest relative pivot of G M⁻¹ Gᵀ), or below this part of the largest sine in the step.
    pub(crate) const CLOSE: f64 = 3e-4;
    pub(crate) const CLOSE_PART: f64 = 0.08;

    /// The sine below which rounding makes corrections onto the constraints larger than the tolerance.
    pub(crate) const SMALL_SINE: f64 = 0.25;

    /// The sine below which an end of a step that cannot be projected is reported as a singular configuration.
    pub(crate) const NEARLY_SINGULAR: f64 = 0.1;

    /// The factor between the lengths of steps that are tried, and their number.
    pub(crate) const CHANGE: f64 = 1.15;
    pub(crate) const MAX_ATTEMPTS: u32 = 10;
}

/// Fixed steps.
pub(crate) mod fixed_steps {
    /// An interval that is a multiple of the step up to this relative rounding error takes no additional step.
    pub(crate) const ROUNDING: f64 = 1e-9;
}

/// Step size control of DOP853. The values and names of the parameters are taken from the code DOP853 by Hairer and
/// Wanner, unless stated otherwise; see `integrate/dormand_prince/step_control.rs`.
pub(crate) mod dormand_prince {
    /// The default of the relative and absolute tolerance: a method of order 8 is made for tight tolerances.
    pub(crate) const TOLERANCE: f64 = 1e-10;

    /// The smallest tolerance near a singular configuration of constraints that is passed: rounding errors of accelerations grow
    /// as the inverse square of the distance.
    pub(crate) const PASSING_TOLERANCE: f64 = 1e-10;

    /// The multiple of the spacing ε |t| of times below which no step is tried by default.
    pub(crate) const MIN_STEP: f64 = 10.0;

    /// A step that reaches the target when it is lengthened by this factor is made to land on it, so that no tiny step
    /// is left.
    pub(crate) const LANDING: f64 = 1.01;

    /// The factor by which the new step is shorter than the step that would just meet the tolerance (SAFE).
    pub(crate) const SAFETY: f64 = 0.9;

    /// Errors over the tolerance outside of this range are beyond the bounds of growth.
    pub(crate) const MIN_ERROR: f64 = 1e-10;
    pub(crate) const MAX_ERROR: f64 = 1e10;

    /// The largest factor by which a step is shorter than the previous one (1/FAC1).
    pub(crate) const MAX_SHRINKAGE: f64 = 1.0 / 0.333;

    /// The largest factor by which a step is longer than the previous one (FAC2).
    pub(crate) const MAX_GROWTH: f64 = 6.0;

    /// The smallest time scale that is accepted before the first step, relative to the remaining time. The time scale
    /// is shorter if both a coordinate and its absolute tolerance are nearly zero.
    pub(crate) const MIN_TIME_SCALE: f64 = 1e-9;

    /// The weight of the third-order error estimate in (10.17) of section II.10.
    pub(crate) const THIRD_ORDER_WEIGHT: f64 = 0.01;

    /// The number of consecutive attempts with steps below ε times the remaining interval after which the integration
    /// gives up: it would take 10¹⁵ more steps. This parameter is not from DOP853; near t = 0 no step is too short to
    /// advance the time.
    pub(crate) const MAX_STALLED_ATTEMPTS: u32 = 10_000;

    /// The change of the state in the explicit Euler step that probes the second derivative, relative to the state.
    pub(crate) const PROBE: f64 = 0.01;

    /// Below this norm of the state or of its derivative the probe cannot be scaled.
    pub(crate) const NEGLIGIBLE: f64 = 1e-5;

    /// The probe if it cannot be scaled, and the smallest first step if nothing changes.
    pub(crate) const SMALL_STEP: f64 = 1e-6;

    /// Derivatives of this norm count as zero.
    pub(crate) const ZERO_DERIVATIVE: f64 = 1e-15;

    /// The first step relative to the probe if derivatives are zero.
    pub(crate) const SHORTENED_PROBE: f64 = 1e-3;

    /// The first step is at most this many times the probe.
    pub(crate) const MAX_PROBES: f64 = 100.0;
}

/// The Taylor series method.
pub(crate) mod taylor;

/// Checks of derivatives that were written by hand.
#[cfg(feature = "derivative-checks")]
pub(crate) mod derivative_checks {
    /// The number of points of a region at which derivatives are compared: a wrong branch that covers 2 % of the region
    /// is hit about five times.
    pub(crate) const POINTS: u32 = 256;

    /// A numerical derivative with a larger relative error confirms nothing.
    pub(crate) const MAX_RELATIVE_ERROR: f64 = 1e-2;

    /// A declared derivative is wrong if it differs from the numerical one by more than this many error estimates.
    pub(crate) const ERROR_ESTIMATES: f64 = 4.0;

    /// The number of fixed-point iterations for the generalized golden ratio, each of which divides the error by 3 or
    /// more.
    pub(crate) const RATIO_ITERATIONS: usize = 32;

    /// The number of step lengths of the difference quotients, from the longest to about 10⁻⁸ of it, where rounding
    /// dominates.
    pub(crate) const STEPS: usize = 40;

    /// The ratio of each step length to the previous one: irrational, so that no period hides between them.
    pub(crate) const STEP_RATIO: f64 = 0.618_033_988_749_894_9;

    /// The number of columns of the extrapolation tableau: the quotient itself, and three powers of the squared step
    /// removed.
    pub(crate) const COLUMNS: usize = 4;

    /// The number of shorter steps that must have been tried before a derivative is trusted.
    pub(crate) const SHORTER_STEPS: usize = 8;

    /// The largest factor by which the tableau amplifies rounding errors: Π (1 + ρ²ⁱ)/(1 − ρ²ⁱ) over i = 1, 2, 3 is 3.4
    /// for the ratio ρ of steps.
    pub(crate) const ROUNDING_AMPLIFICATION: f64 = 4.0;

    /// Jumps smaller than this, relative to the values, are noise and not steps of the function.
    pub(crate) const MIN_JUMP: f64 = 1e-5;

    /// The number of arguments in a report, so that errors stay `Copy` and small.
    pub(crate) const REPORTED_ARGUMENTS: usize = 4;
}

/// Elliptic functions and integrals.
pub(crate) mod elliptic {
    /// The limit of duplications of the arguments of an integral. Each divides their distance from the mean, which is
    /// at most a few means, by four. `f64` takes about ten, double-doubles about twenty.
    pub(crate) const DUPLICATIONS: usize = 64;

    /// If the last argument of `R_J` is larger than the others by this factor, it is exchanged: each duplication would
    /// only divide it by four.
    pub(crate) const LARGE_LAST: f64 = 1024.0;

    /// Integrals of the third kind with a characteristic below this are converted to a positive one, since terms of
    /// both signs would cancel.
    pub(crate) const NEGATIVE_CHARACTERISTIC: f64 = -1.0;

    /// The limit of arithmetic-geometric means. Convergence is quadratic: a ratio of 10⁻¹⁵⁰ takes about nine means to
    /// become of order 1, and six more for all digits of a double-double.
    pub(crate) const MEANS: usize = 24;
}

/// Rotations.
pub(crate) mod rotations {
    /// The columns of a rotation matrix are orthonormal up to this many machine epsilons: products of many rotations
    /// have smaller rounding errors.
    pub(crate) const NOT_ORTHONORMAL: f64 = 4096.0;

    /// A sine or cosine of half the second Euler angle that is at most this many machine epsilons is rounding, and so
    /// is the difference or the sum of the other angles.
    pub(crate) const UNDETERMINED: f64 = 4.0;

    /// The sine of a second Euler angle θ below this many machine epsilons of 1 + |θ| is rounding.
    pub(crate) const AT_POLE: f64 = 1.0;
}

/// Rigid bodies.
pub(crate) mod rigid_bodies {
    /// Entries of an inertia tensor that should be equal may differ by this many machine epsilons of the largest one:
    /// products of several matrices have smaller rounding errors.
    pub(crate) const ASYMMETRY: f64 = 4096.0;

    /// Principal moments that differ by less than this many machine epsilons of the largest one are equal: rounding of
    /// a rotated tensor separates equal moments by about ten.
    pub(crate) const EQUAL_MOMENTS: f64 = 64.0;

    /// The limit of sweeps of Jacobi's method. Convergence is quadratic: `f64` takes about five, double-doubles six,
    /// and derivative parts two more.
    pub(crate) const JACOBI_SWEEPS: usize = 32;

    /// Entries below this, in a matrix of order 1, change nothing; the squares of larger entries do not underflow.
    pub(crate) const NEGLIGIBLE_ENTRY: f64 = 1e-140;

    /// The number of machine epsilons of the largest moment by which a principal moment may be negative, or exceed the
    /// sum of the others: a plate satisfies the triangle inequality with equality.
    pub(crate) const UNPHYSICAL_ROUNDING: f64 = 64.0;

    /// A principal moment of at most this many machine epsilons of the largest one is zero.
    pub(crate) const NO_INERTIA: f64 = 64.0;

    /// The limit up to which the moments of a body may be unphysical if its numbers were printed, relative to the
    /// largest moment: with six digits each is rounded by up to 5·10⁻⁶ of itself, and three moments add up to about
    /// twice the largest.
    pub(crate) const UNPHYSICAL_DIGITS: f64 = 1e-5;

    /// A mesh whose volume is less than this many machine epsilons of the total volume of the tetrahedra of which it is
    /// the sum is flat: each of them is rounded by a few.
    #[cfg(feature = "alloc")]
    pub(crate) const FLAT_MESH: f64 = 1024.0;

    /// Triangles whose distance is less than this fraction of their size coincide: they are parts of a mesh that touch
    /// each other, with rounded coordinates.
    #[cfg(feature = "alloc")]
    pub(crate) const COINCIDENT: f64 = 1e-9;

    /// Winding numbers are integers up to this, unless the point is on an edge: sums of solid angles have much smaller
    /// rounding errors.
    #[cfg(feature = "alloc")]
    pub(crate) const UNCERTAIN_WINDING: f64 = 0.05;

    /// The number of largest triangles of a part of a mesh at which winding numbers are evaluated, until they are
    /// integers.
    #[cfg(feature = "alloc")]
    pub(crate) const SAMPLED_TRIANGLES: usize = 64;

    /// The smallest 1 ∓ cos θ of a nutation in closed form: at an inclination of about 10⁻¹² rad the rounding of the
    /// initial state decides on which side the axis passes the vertical.
    pub(crate) const VERTICAL: f64 = 1e-24;

    /// The limit of bisections of an interval that ends at 0: the number of exponents of `f64` below 1, plus its bits.
    pub(crate) const MAX_BISECTIONS: usize = 1024 + 64;

    /// The number of Newton steps for the root of a cubic: from the first digit on four give all digits, and six are
    /// enough for a small root without any correct digit.
    pub(crate) const POLISHING_STEPS: usize = 6;
}

/// Equilibria, their stability, and linear control.
pub(crate) mod analysis;
