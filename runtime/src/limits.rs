//! The limits and tuning constants of the crate, with the reason of each.
//!
//! Not here: the coefficients of a method, which are beside it (`integrate/dormand_prince/coefficients.rs`), and the
//! ranges of the elementary functions (`scalar/sine_cosine.rs`, `scalar/double_double/constants.rs`), which follow
//! from the format of the numbers.

/// Steps, rejected ones included, after which an integration gives up by default: more than a motion
/// needs, but an end to a run whose steps have become tiny.
pub(crate) const MAX_STEPS: u64 = 100_000_000;

/// The smallest default of the singularity tolerance, in machine epsilons:
/// the relative pivots of regular models are small, too, and are not to be taken for a singularity.
pub(crate) const MIN_SINGULARITY_TOLERANCE: f64 = 4096.0;

/// The singularity tolerance of methods with fixed steps, which have no tolerance of their own: by
/// judgement, what one expects of the classical method.
pub(crate) const FIXED_STEP_SINGULARITY_TOLERANCE: f64 = 1e-6;

/// An inertia that is this small in relation to what it is elsewhere has nearly vanished. By judgement,
/// between the ratios near 1 of regular models and the rounding errors of M⁻¹.
pub(crate) const VANISHING_INERTIA: f64 = 1e-6;

/// The offsets, in each of the coordinates on which an inertia depends, at which the reference inertia is evaluated.
/// Three offsets without a common period, so that not all of them meet the next zero of a sine.
pub(crate) const REFERENCE_OFFSETS: [f64; 3] = [-1.0, 0.5, 1.0];

/// Right-hand sides that are solved for together: as many `f64` as a vector register of 256 bits holds.
pub(crate) const RIGHT_HAND_SIDES_AT_ONCE: usize = 4;

/// Coordinates of a singularity that a report carries, so that errors stay `Copy` and small.
pub(crate) const REPORTED_COORDINATES: usize = 6;

/// Sweeps of Jacobi rotations, of which some ten suffice since convergence is quadratic: an end for numbers that are not
/// finite.
pub(crate) const JACOBI_SWEEPS: usize = 60;

/// The condition number of a scaled regressor above which a combination of parameters counts as not excited: half of the
/// digits of `f64` are lost.
pub(crate) const MAX_CONDITION_NUMBER: f64 = 1e8;

/// Steps of Newton's method for the velocities that belong to momenta: two where L is quadratic in the velocities, some
/// five for relativistic ones.
pub(crate) const LEGENDRE_ITERATIONS: usize = 50;

/// A change of the velocities below so many of their rounding errors is one.
pub(crate) const LEGENDRE_ROUNDING: f64 = 8.0;

/// Newton's method for velocities is given up where a step of this length, relative to a whole one, does not come nearer.
pub(crate) const MIN_NEWTON_STEP: f64 = 1e-9;

/// What may be missing of the momentum of a velocity that is held since M is infinite there, in machine epsilons of the largest momentum:
/// some rounding errors of its terms.
pub(crate) const HELD_MOMENTUM: f64 = 64.0;

/// Sweeps over all velocities, each followed by Newton's method, before the search for velocities is given up: one is enough
/// where one velocity has a singular momentum, some more where several are coupled.
pub(crate) const LEGENDRE_SWEEPS: usize = 16;

/// Bisections of the exponent of a velocity: of the 2044 exponents of `f64` eleven leave one, the others three of its digits,
/// from where Newton's method converges.
pub(crate) const LEGENDRE_BISECTIONS: usize = 22;

/// Numbers whose magnitude is in this range are printed without an exponent.
pub(crate) const PRINTED_WITHOUT_EXPONENT: core::ops::Range<f64> = 1e-4..1e7;

/// An angle up to this is not reduced by whole periods: its rounding error is that of π or twice as much.
pub(crate) const SMALL_ANGLE: f64 = 8.0;

/// A time in comparison with which every motion is fast, and whose inverse is one in comparison with which it is slow.
pub(crate) const MAX_TIME_SCALE: f64 = 1e100;

/// A motion with a longer time scale is at rest.
pub(crate) const USABLE_TIME_SCALE: f64 = 1e50;

/// The projection of states onto the manifold on which equations hold.
pub(crate) mod projection {
    /// How far a projection may move the end of a step, in errors that are allowed. By judgement: an estimate of the error may be too
    /// small by some.
    pub(crate) const MAX_CORRECTION: f64 = 10.0;

    /// How far a state is moved to see what rounding makes of its projection, in machine epsilons of its components and of their
    /// changes in the step.
    pub(crate) const MOVED_EPSILONS: f64 = 8.0;

    /// By how many of the changes under that movement a projection may move the end of a step. By judgement: the sums of a step have
    /// some ten terms.
    pub(crate) const CHANGES: f64 = 8.0;

    /// The relative and the absolute error of a state at which fixed steps begin.
    pub(crate) const FIXED_STEP_START: f64 = super::FIXED_STEP_SINGULARITY_TOLERANCE;
}

/// Location of events within a step.
pub(crate) mod events {
    /// The resolution of time, in machine epsilons of the time and of the
    /// step: the value that SUNDIALS uses for the same purpose.
    pub(crate) const TIME_RESOLUTION: f64 = 100.0;

    /// By what factor each time after the start is farther than the one before, while the function stays at zero.
    /// It trades evaluations, logarithmic in the step, for the shortest flight that is seen.
    pub(crate) const DEPARTURE_GROWTH: f64 = 4.0;

    /// Divisions of a bracket, of which there are at most one more than by bisection. Between its ends are fewer than 2⁶⁴
    /// numbers unless one of them is near zero.
    pub(crate) const DIVISIONS: usize = 66;

    /// The parts of a step at whose ends event functions are evaluated, for methods with dense output. By judgement; an
    /// adaptive step is a fraction of the fastest oscillation of the motion.
    pub(crate) const PARTS: u32 = 8;

    /// How far a state is moved to see the rounding errors of event functions, in machine epsilons.
    pub(crate) const MOVED_EPSILONS: f64 = 4.0;

    /// The parts of the last step over which a state is extrapolated to see in which direction an event function goes,
    /// each if the one before shows nothing but rounding errors.
    pub(crate) const EXTRAPOLATIONS: [f64; 3] = [1.0 / 1024.0, 1.0 / 32.0, 1.0];

    /// The parts of the last step at which event functions have their signs on both sides of the end of a run. The first is one at which
    /// the second derivative of a function makes no difference to its change, the others are for functions with large rounding errors.
    pub(crate) const SIDES: [f64; 3] = [1.0 / 134_217_728.0, 1.0 / 1_048_576.0, 1.0 / 1024.0];

    /// The parts of the time between two zeros at which a function is zero that is so all the time.
    pub(crate) const BETWEEN: [f64; 3] = [0.618, 0.271, 0.859];

    /// The least value of a parabola, as a part of those next to it, that is zero.
    pub(crate) const TOUCHING: f64 = 0.01;

    /// The iterations by which an event is located in the arithmetic of the scalar. The slope is one of differences, right
    /// to some 1e-4 at least, so that three are enough for each order of derivative parts.
    pub(crate) const DELAY_ITERATIONS: usize = 6;

    /// The change of an event function over its values on both sides of a zero, below which the zero is an extremum.
    pub(crate) const MIN_CHANGE: f64 = 1e-8;

    /// The rounding errors that an event function has to exceed after a reaction to count again.
    pub(crate) const COOLDOWN: f64 = 4.0;

    /// An event that occurs again within this many resolutions of time may be one of a series that accumulates.
    pub(crate) const SHORT_TIME: f64 = 1024.0;

    /// The same in lengths of the last step, for an event function that has not left its rounding errors in between.
    pub(crate) const SHORT_PART: f64 = 0.125;

    /// The most coefficients of a polynomial whose roots are isolated: those of order 64, beyond which no method goes.
    pub(crate) const MAX_COEFFICIENTS: usize = 65;

    /// Half of the order up to which the series of an event function is computed at first: the sums of order k have k products,
    /// so that all up to order 6 cost a twentieth of all up to order 28. By judgement.
    pub(crate) const LEADING_HALF_ORDER: usize = 3;

    /// What is left of an event function anywhere in a step, at least, over its value at the beginning, where the first few terms
    /// exclude a zero. It guards against what terms of higher order do within a step and not at its end. By judgement.
    pub(crate) const MIN_REMAINING_PART: f64 = 0.25;

    /// The errors of the coefficients of an event's polynomial, in machine epsilons: values below what they make are zero,
    /// and an extremum of that size is a double root.
    pub(crate) const UNCERTAINTY: f64 = 8.0;

    /// An interval of this length, in steps, is not divided further: roots in it are one.
    pub(crate) const MIN_WIDTH: f64 = 1e-12;

    /// The least part of a step over which the series of an event function is used: it does not converge there, as that of
    /// a square root at 0.
    pub(crate) const MIN_WINDOW: f64 = 1.0 / 1024.0;

    /// A value of an event function that differs from that of its polynomial by more than this part of the terms shows a
    /// corner. Larger than the rounding errors of `f32`.
    pub(crate) const NEAR: f64 = 1e-5;

    /// How many times the end of an interval is moved off a zero, in the search for one root.
    pub(crate) const DISPLACEMENTS: u32 = 3;

    /// The intervals that are looked at for one root, at most. A simple root takes some ten, a multiple one some hundred.
    pub(crate) const ISOLATION_STEPS: usize = 1024;

    /// How many occurrences of one event there may be in a row, each within a short time after the one before: a ball whose
    /// bounces become ever shorter is then at rest.
    pub(crate) const OCCURRENCES: f64 = 8.0;
}

/// Fixed steps.
pub(crate) mod fixed_steps {
    /// An interval that is a multiple of the step up to this relative rounding error takes no additional step.
    pub(crate) const ROUNDING: f64 = 1e-9;
}

/// Step size control of DOP853. Values and names of the parameters are those of the code DOP853 by Hairer and Wanner,
/// unless said otherwise; see `integrate/dormand_prince/step_control.rs`.
pub(crate) mod dormand_prince {
    /// Relative and absolute tolerance unless set: a method of order 8 is made for tight ones.
    pub(crate) const TOLERANCE: f64 = 1e-10;

    /// No step is tried below this multiple of the spacing ε |t| of times, unless set.
    pub(crate) const MIN_STEP: f64 = 10.0;

    /// A step that reaches the target when it is made this much longer is made to land on it, so that no tiny
    /// step is left.
    pub(crate) const LANDING: f64 = 1.01;

    /// The new step is the one that would just meet the tolerance times this (SAFE).
    pub(crate) const SAFETY: f64 = 0.9;

    /// Errors over the tolerance that are less, or greater, are beyond the bounds of growth.
    pub(crate) const MIN_ERROR: f64 = 1e-10;
    pub(crate) const MAX_ERROR: f64 = 1e10;

    /// A step is at most this much shorter than the one before (1/FAC1).
    pub(crate) const MAX_SHRINKAGE: f64 = 1.0 / 0.333;

    /// A step is at most this much longer than the one before (FAC2).
    pub(crate) const MAX_GROWTH: f64 = 6.0;

    /// The least time scale that is believed before the first step, in relation to the remaining time. It is shorter
    /// where a coordinate is nearly zero and its absolute tolerance, too.
    pub(crate) const MIN_TIME_SCALE: f64 = 1e-9;

    /// The weight of the third-order error estimate in (10.17) of section II.10.
    pub(crate) const THIRD_ORDER_WEIGHT: f64 = 0.01;

    /// Attempts in a row with steps below ε times the remaining interval, after which the integration gives up: it
    /// would take 10¹⁵ steps more. Our own; near t = 0 no step is too short to advance the time.
    pub(crate) const MAX_STALLED_ATTEMPTS: u32 = 10_000;

    /// The change of the state in the explicit Euler step that probes the second derivative, relative to the state.
    pub(crate) const PROBE: f64 = 0.01;

    /// Below this norm of the state or of its derivative the probe cannot be scaled.
    pub(crate) const NEGLIGIBLE: f64 = 1e-5;

    /// The probe where it cannot be scaled, and the least first step where nothing changes.
    pub(crate) const SMALL_STEP: f64 = 1e-6;

    /// Derivatives of this norm count as zero.
    pub(crate) const ZERO_DERIVATIVE: f64 = 1e-15;

    /// Where derivatives are zero, the first step in relation to the probe.
    pub(crate) const SHORTENED_PROBE: f64 = 1e-3;

    /// The first step is at most this many times the probe.
    pub(crate) const MAX_PROBES: f64 = 100.0;
}

/// The Taylor series method.
pub(crate) mod taylor;

/// Checks of derivatives that were written by hand.
#[cfg(feature = "derivative-checks")]
pub(crate) mod derivative_checks {
    /// Points of a region at which derivatives are compared: a wrong branch that covers 2 % of the region is hit
    /// about five times.
    pub(crate) const POINTS: u32 = 256;

    /// A numerical derivative whose relative error is larger confirms nothing.
    pub(crate) const MAX_RELATIVE_ERROR: f64 = 1e-2;

    /// A declared derivative is wrong if it is farther from the numerical one than this many error estimates.
    pub(crate) const ERROR_ESTIMATES: f64 = 4.0;

    /// Fixed-point iterations for the generalized golden ratio, each of which divides the error by 3 or more.
    pub(crate) const RATIO_ITERATIONS: usize = 32;

    /// Step lengths of the difference quotients, from the longest to about 10⁻⁸ of it, where rounding takes over.
    pub(crate) const STEPS: usize = 40;

    /// The ratio of each step length to the one before: irrational, so that no period hides between them.
    pub(crate) const STEP_RATIO: f64 = 0.618_033_988_749_894_9;

    /// Columns of the extrapolation tableau: the quotient itself, and three powers of the squared step removed.
    pub(crate) const COLUMNS: usize = 4;

    /// Shorter steps that must have been tried for a derivative to be trusted.
    pub(crate) const SHORTER_STEPS: usize = 8;

    /// By how much at most the tableau amplifies rounding errors: Π (1 + ρ²ⁱ)/(1 − ρ²ⁱ) over i = 1, 2, 3
    /// is 3.4 for the ratio ρ of steps.
    pub(crate) const ROUNDING_AMPLIFICATION: f64 = 4.0;

    /// Jumps that are smaller than this, relative to the values, are noise and no steps of the function.
    pub(crate) const MIN_JUMP: f64 = 1e-5;

    /// Arguments that a report carries, so that errors stay `Copy` and small.
    pub(crate) const REPORTED_ARGUMENTS: usize = 4;
}

/// Elliptic functions and integrals.
pub(crate) mod elliptic {
    /// Duplications of the arguments of an integral at most: each quarters their distance from the mean, which is at most
    /// some means. `f64` takes some ten, double-doubles some twenty.
    pub(crate) const DUPLICATIONS: usize = 64;

    /// Where the last argument of `R_J` is larger than the others by this factor, it is exchanged: each duplication would only
    /// quarter it.
    pub(crate) const LARGE_LAST: f64 = 1024.0;

    /// Characteristics of integrals of the third kind below this are exchanged for positive ones, since terms of both signs
    /// would cancel.
    pub(crate) const NEGATIVE_CHARACTERISTIC: f64 = -1.0;

    /// Arithmetic-geometric means at most. Convergence is quadratic: a ratio of 10⁻¹⁵⁰ takes some nine means to become of
    /// order 1, and six more for all digits of a double-double.
    pub(crate) const MEANS: usize = 24;
}

/// Rotations.
pub(crate) mod rotations {
    /// The columns of a rotation matrix are orthonormal up to this many machine epsilons: products of many rotations are
    /// rounded by less.
    pub(crate) const NOT_ORTHONORMAL: f64 = 4096.0;

    /// A sine or cosine of half the second Euler angle that is this many machine epsilons is rounding, and so is the
    /// difference or the sum of the other angles.
    pub(crate) const UNDETERMINED: f64 = 4.0;

    /// The sine of a second Euler angle θ that is less than this many machine epsilons of 1 + |θ| is rounding.
    pub(crate) const AT_POLE: f64 = 1.0;
}

/// Rigid bodies.
pub(crate) mod rigid_bodies {
    /// Entries of an inertia tensor that should be equal may differ by this many machine epsilons of the largest one:
    /// products of several matrices are rounded by less.
    pub(crate) const ASYMMETRY: f64 = 4096.0;

    /// Principal moments that differ by less than this many machine epsilons of the largest one are equal: rounding of a
    /// rotated tensor separates equal ones by some ten.
    pub(crate) const EQUAL_MOMENTS: f64 = 64.0;

    /// Sweeps of Jacobi's method at most. Convergence is quadratic: `f64` takes some five, double-doubles six, and
    /// derivative parts two more.
    pub(crate) const JACOBI_SWEEPS: usize = 32;

    /// Entries of a matrix of order 1 that change nothing, nor do their squares underflow above them.
    pub(crate) const NEGLIGIBLE_ENTRY: f64 = 1e-140;

    /// By how many machine epsilons of the largest moment a principal moment may be negative, or exceed the sum of the
    /// others: a plate meets the triangle inequality with equality.
    pub(crate) const UNPHYSICAL_ROUNDING: f64 = 64.0;

    /// A principal moment that is this many machine epsilons of the largest one is zero.
    pub(crate) const NO_INERTIA: f64 = 64.0;

    /// By how much the moments of a body may be unphysical if its numbers were printed, relative to the largest moment: with
    /// six digits each is rounded by up to 5·10⁻⁶ of itself, and three moments add up to about twice the largest.
    pub(crate) const UNPHYSICAL_DIGITS: f64 = 1e-5;

    /// A mesh whose volume is less than this many machine epsilons of that of the tetrahedra of which it is the sum is
    /// flat: each is rounded by some.
    #[cfg(feature = "alloc")]
    pub(crate) const FLAT_MESH: f64 = 1024.0;

    /// Triangles whose distance is less than this part of their size are at one place: parts of a mesh that touch each other,
    /// with coordinates that are rounded.
    #[cfg(feature = "alloc")]
    pub(crate) const COINCIDENT: f64 = 1e-9;

    /// Winding numbers are whole up to this, unless the point is on an edge: sums of solid angles are rounded by much less.
    #[cfg(feature = "alloc")]
    pub(crate) const UNCERTAIN_WINDING: f64 = 0.05;

    /// The largest triangles of a part of a mesh at which winding numbers are looked at, until they are whole.
    #[cfg(feature = "alloc")]
    pub(crate) const SAMPLED_TRIANGLES: usize = 64;

    /// The least 1 ∓ cos θ of a nutation in closed form: at an inclination of some 10⁻¹² rad the rounding of the initial state
    /// decides on which side the axis passes the vertical.
    pub(crate) const VERTICAL: f64 = 1e-24;

    /// Bisections of an interval that ends at 0 at most: as many as `f64` has exponents below 1, and bits.
    pub(crate) const MAX_BISECTIONS: usize = 1024 + 64;

    /// Steps of Newton's method for the root of a cubic: from the first digit on four give all, and six do from no digit of a small
    /// root.
    pub(crate) const POLISHING_STEPS: usize = 6;
}

/// Equilibria, their stability, and linear control.
pub(crate) mod analysis;
