//! The limits of the Taylor series method.

/// An error of a velocity counts by the displacement that it causes in so many of the times in which a motion goes on, a
/// little more than a period: at the tolerance of rounding it grows over many. Counted once, as by `Dop853`, steps are longer by
/// 4 %, and the error of the double pendulum at t = 1000 is 5 times as large.
pub(crate) const VELOCITY_TIMES: f64 = 8.0;

/// The unit of time of the first series, in times in which the state changes by its size.
pub(crate) const FIRST_UNIT: f64 = 0.125;

/// The factor by which the unit of time changes where coefficients overflow; its square the next time, and so on,
/// so that a few changes pass through all exponents.
pub(crate) const UNIT_CHANGE: f64 = 1.0 / 1_048_576.0;

/// Changes of the unit until the motion counts as without a Taylor series.
pub(crate) const UNIT_CHANGES: usize = 6;

/// A step that is this many times the last one is long, as is the first: the polynomial is then checked at times
/// within the step, too.
pub(crate) const LONG_STEP: f64 = 4.0;

/// A term of half the order that is this many tolerances is negligible: in a step whose length the tolerance has
/// chosen, it is about the square root of their inverse.
pub(crate) const NEGLIGIBLE_TERM: f64 = 1024.0;

/// The number of times within a long step. A force that acts for a sixteenth of a long step is noticed.
pub(crate) const INNER_CHECKS: u32 = 16;

/// Passages to other branches of the equations that are checked in a step; a step with more of them is shortened.
pub(crate) const MAX_CROSSINGS: usize = 16;

/// A switching function whose value at the beginning of a step exceeds its other terms by this factor has one sign.
pub(crate) const ONE_SIGN: f64 = 1.0 + 1e-12;

/// The last two terms of a switching function's series, over the sum of all, up to which changes of its sign are looked for;
/// more where those of the motion are larger. What a contact of this depth does is of the order of the power 3/2 of it. The
/// time of a change is then refined by values of the function itself.
pub(crate) const CONVERGED: f64 = 1e-10;

/// By how many halvings a step is shortened at once where the series of a switching function does not converge.
pub(crate) const MAX_HALVINGS: u32 = 16;

/// Values of a switching function that are this many rounding errors of the sum of its terms have no sign.
pub(crate) const SIGN_UNCERTAINTY: f64 = 32.0;

/// Parts of a step, in its length, within which two changes of sign are none: what happens between them is below all errors.
pub(crate) const MIN_PART: f64 = 1.0 / 1_073_741_824.0;

/// Parts that are looked at in one step, at most. A change of sign takes some ten where others are near.
pub(crate) const ISOLATION_STEPS: u32 = 1024;

/// Times that differ by this many rounding errors are not distinguished in the search for changes of sign.
pub(crate) const RESOLUTION: f64 = 64.0;

/// How far before a change of sign the polynomial of a step is compared with the equations, in parts of the step.
pub(crate) const BEFORE: f64 = 1.0 / 65_536.0;

/// The first time behind a discontinuity surface at which a step may end, in rounding errors of the time.
pub(crate) const FIRST_PUSH: f64 = 16.0;

/// By how much that time is farther away each time if the sign of the switching function is not certain there.
pub(crate) const PUSH_GROWTH: f64 = 4.0;

/// The longest time behind a discontinuity surface, in lengths of the step.
pub(crate) const MAX_PUSH: f64 = 1.0 / 256.0;

/// Newton steps by which the time of a crossing is refined. Each adds ten digits, or one order of derivative parts.
pub(crate) const ROOT_ITERATIONS: u32 = 4;

/// Series that are computed behind a discontinuity surface at one time at most; two are enough as a rule.
pub(crate) const SETTLING: u32 = 8;

/// And at least on scalars with derivative parts: each makes one more order of them right.
pub(crate) const SETTLING_OF_DERIVATIVES: u32 = 3;

/// A step to a discontinuity surface is short if it takes this many rounding errors of the time.
pub(crate) const SHORT_PASSAGE: f64 = 1024.0;

/// After so many short steps in a row passages accumulate. There may be as many surfaces that are crossed at once.
pub(crate) const MAX_SHORT_PASSAGES: u32 = 64;

/// The least default of the singularity tolerance, that of the other methods.
pub(crate) const SINGULARITY_TOLERANCE: f64 = super::dormand_prince::TOLERANCE;

/// How far the state is moved where the condition of the derivative is looked at, in machine epsilons.
pub(crate) const MOVED_EPSILONS: f64 = 4.0;

/// By how many changes under that movement the derivative may differ from that of the polynomial.
pub(crate) const CHANGES: f64 = 8.0;

/// The derivative at the end of a step may differ from that of the polynomial by this many tolerances over the step,
/// for each order: terms that are left out are of that size.
pub(crate) const RESIDUAL_PER_ORDER: f64 = 4.0;

/// And by this many rounding errors of the state and of its change. By judgement: the rounding error of a derivative
/// is amplified by its condition.
pub(crate) const RESIDUAL_ROUNDING: f64 = 4096.0;

/// What is allowed of them behind a change of sign of a switching function.
pub(crate) const CROSSING_ROUNDING: f64 = 64.0;

/// A step whose derivative differs by more is divided by this.
pub(crate) const SHORTENING: f64 = 2.0;

/// As for DOP853, unless set there.
pub(crate) const MIN_STEP: f64 = super::dormand_prince::MIN_STEP;

/// The bytes that the terms of pairs of factors may take on the stack when they are stored for each pair; a chain of
/// 30 links needs as many. Beyond, each factor is stored once.
pub(crate) const MAX_PAIRED_CONVOLUTIONS: usize = 1 << 19;

/// Half of the order from which on convolutions of few pairs keep sums of several orders. By judgement: four at a time.
pub(crate) const MIN_CONVOLUTIONS: usize = 4;

/// As for DOP853.
pub(crate) const LANDING: f64 = super::dormand_prince::LANDING;
