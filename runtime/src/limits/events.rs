//! Location of events within a step.

/// The resolution of time, in machine epsilons of the time and of the step: the value that SUNDIALS uses for this
/// purpose.
pub(crate) const TIME_RESOLUTION: f64 = 100.0;

/// The growth factor of the distances from the start at which a function that stays at zero is evaluated. It is a
/// compromise between the number of evaluations, which is logarithmic in the step, and the shortest flight that is
/// noticed.
pub(crate) const DEPARTURE_GROWTH: f64 = 4.0;

/// The limit of divisions of a bracket. There is at most one more than with bisection, and there are fewer than 2⁶⁴
/// numbers between the ends unless one of them is near zero.
pub(crate) const DIVISIONS: usize = 66;

/// The number of parts of a step at whose ends event functions are evaluated, for methods with dense output. By
/// judgement: an adaptive step is a fraction of the fastest oscillation of the motion.
pub(crate) const PARTS: u32 = 8;

/// The distance by which a state is moved to find the rounding errors of event functions, in machine epsilons.
pub(crate) const MOVED_EPSILONS: f64 = 4.0;

/// The fractions of the last step over which a state is extrapolated to find the direction in which an event
/// function changes; each is used if the previous one shows only rounding errors.
pub(crate) const EXTRAPOLATIONS: [f64; 3] = [1.0 / 1024.0, 1.0 / 32.0, 1.0];

/// The fractions of the last step at which the signs of event functions are taken on both sides of the end of a
/// run. At the first, the second derivative of a function does not affect its change; the others are for functions
/// with large rounding errors.
pub(crate) const SIDES: [f64; 3] = [1.0 / 134_217_728.0, 1.0 / 1_048_576.0, 1.0 / 1024.0];

/// The fractions of the time between two zeros of a function at which it is evaluated to find whether it is zero
/// all the time.
pub(crate) const BETWEEN: [f64; 3] = [0.618, 0.271, 0.859];

/// A parabola touches zero if its minimum is at most this fraction of the larger value beside it.
pub(crate) const TOUCHING: f64 = 0.01;

/// The number of iterations by which an event is located in the arithmetic of the scalar. The slope is a finite
/// difference with a relative error of at most about 1e-4, so that three iterations are enough for each order of
/// derivative parts.
pub(crate) const DELAY_ITERATIONS: usize = 6;

/// The change of an event function, relative to its values on both sides of a zero, below which the zero is an
/// extremum.
pub(crate) const MIN_CHANGE: f64 = 1e-8;

/// The number of rounding errors that an event function has to exceed after a reaction to count again.
pub(crate) const COOLDOWN: f64 = 4.0;

/// An event that recurs within this many resolutions of time may belong to a series of accumulating events.
pub(crate) const SHORT_TIME: f64 = 1024.0;

/// The corresponding limit in lengths of the last step, for an event function that has not left its rounding errors
/// in between.
pub(crate) const SHORT_PART: f64 = 0.125;

/// The largest number of coefficients of a polynomial whose roots are isolated: order 64, which no method exceeds.
pub(crate) const MAX_COEFFICIENTS: usize = 65;

/// Half of the order up to which the series of an event function is computed first. The sums of order k have k
/// products, so that all orders up to 8 cost a tenth of all orders up to 28. Methods up to that order compute all terms at once. By
/// judgement.
pub(crate) const LEADING_HALF_ORDER: usize = 4;

/// The smallest value of an event function in a step, relative to its value at the beginning, for which the first
/// few terms exclude a zero. It guards against terms of higher order that have an effect within a step but not at
/// its end. By judgement.
pub(crate) const MIN_REMAINING_PART: f64 = 0.125;

/// The largest part of a step in which the sign of an event function may be uncertain behind a zero that is located by
/// Newton's method. The slope of the terms that the series omits is then small beside the slope of the function.
pub(crate) const MAX_ZERO_WIDTH: f64 = 1e-3;

/// The largest number of zeros of an event function in a step that are isolated in the arithmetic of `f64`. By judgement: a step
/// is shorter than half a period of the fastest oscillation of the motion, and products of its coordinates oscillate several times
/// as fast.
pub(crate) const MAX_ISOLATED_ZEROS: usize = 4;

/// Parts of a step up to this one are not halved further to isolate zeros in the arithmetic of `f64`. Zeros that are closer to each
/// other are searched for in double-doubles. By judgement.
pub(crate) const MIN_ISOLATING_PART: f64 = 1.0 / 16.0;

/// The number of steps of the simplified Newton method from the zero of a polynomial to the zero of its function, with the slope of
/// the polynomial. In most cases one is enough; where these are not, the zero is searched for.
pub(crate) const SIMPLIFIED_NEWTON_STEPS: u32 = 4;

/// The largest number of steps of Newton's method; bisection alone needs 53.
pub(crate) const MAX_NEWTON_STEPS: u32 = 64;

/// The step of Newton's method, as a part of a step of the integration, after which the zero is exact to rounding: √ε.
pub(crate) const LAST_NEWTON_STEP: f64 = 1.5e-8;

/// The number of rounding errors that the value of an event function at its zero may have; a larger value is searched for the
/// zero. By judgement.
pub(crate) const ROUNDINGS_AT_ZERO: f64 = 32.0;

/// The errors of the coefficients of an event's polynomial, in machine epsilons. Values below their effect are
/// zero, and an extremum of that size is a double root.
pub(crate) const UNCERTAINTY: f64 = 8.0;

/// An interval of this length, in steps, is not divided further: roots in it count as one.
pub(crate) const MIN_WIDTH: f64 = 1e-12;

/// The smallest fraction of a step over which the series of an event function is used. A series that needs a
/// shorter one does not converge there, like the series of a square root at 0.
pub(crate) const MIN_WINDOW: f64 = 1.0 / 1024.0;

/// If an event function differs from its polynomial by more than this fraction of the terms, there is a corner. The
/// value is larger than the rounding errors of `f32`.
pub(crate) const NEAR: f64 = 1e-5;

/// The number of times that the end of an interval is moved off a zero in the search for one root.
pub(crate) const DISPLACEMENTS: u32 = 3;

/// The limit of intervals that are inspected for one root. A simple root takes about ten, a multiple root about a
/// hundred.
pub(crate) const ISOLATION_STEPS: usize = 1024;

/// The number of consecutive occurrences of one event, each a short time after the previous one, after which they
/// accumulate: a ball whose bounces become ever shorter is then at rest.
pub(crate) const OCCURRENCES: f64 = 8.0;
