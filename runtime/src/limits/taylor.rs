//! The limits of the Taylor series method.

/// An error of a velocity counts by the displacement that it causes in this many time scales of the motion, a little
/// more than a period: at the tolerance of rounding it grows over many. With a single time scale, as in `Dop853`, steps
/// are longer by 4 %, and the error of the double pendulum at t = 1000 is 5 times as large.
pub(crate) const VELOCITY_TIMES: f64 = 8.0;

/// The unit of time of the first series, as a fraction of the time in which the state changes by its size.
pub(crate) const FIRST_UNIT: f64 = 0.125;

/// The factor by which the unit of time changes if coefficients overflow. It is squared each time, so that a few
/// changes pass through all exponents.
pub(crate) const UNIT_CHANGE: f64 = 1.0 / 1_048_576.0;

/// The number of changes of the unit after which the motion counts as having no Taylor series.
pub(crate) const UNIT_CHANGES: usize = 6;

/// A step that is this many times as long as the last one that did not end early is long, and so is the first step: the
/// polynomial is then checked within the step, too. With 4, steps pass over changes of the force tanh(100 sin 3t).
pub(crate) const LONG_STEP: f64 = 2.0;

/// If less than this fraction of the time between two checks within a rejected step remains to its end, the motion has
/// arrived there.
pub(crate) const MIN_AHEAD: f64 = 1.0 / 1024.0;

/// A term of half the order is negligible below this many tolerances. In a step whose length the tolerance has chosen,
/// the term is about the square root of the inverse tolerance, in tolerances.
pub(crate) const NEGLIGIBLE_TERM: f64 = 1024.0;

/// The number of times within a step that are checked if it is long or otherwise uncertain. A force that acts for a sixteenth of
/// such a step is noticed.
pub(crate) const INNER_CHECKS: u32 = 16;

/// The number of passages to other branches of the equations that are checked in a step; a step with more of them is
/// shortened.
pub(crate) const MAX_CROSSINGS: usize = 16;

/// A switching function has one sign in a step if its value at the beginning exceeds the sum of its other terms by this
/// factor.
pub(crate) const ONE_SIGN: f64 = 1.0 + 1e-12;

/// The largest of the last two terms of a switching function's series, over the sum of all terms, up to which sign
/// changes are searched; the limit is larger if the terms of the motion are. The effect of a contact of this depth is
/// of the order of its power 3/2. The time of a change is then refined by values of the function itself.
pub(crate) const CONVERGED: f64 = 1e-10;

/// The limit of halvings by which a step is shortened at once if the series of a switching function does not converge.
pub(crate) const MAX_HALVINGS: u32 = 16;

/// Values of a switching function up to this many rounding errors of the sum of its terms have no sign.
pub(crate) const SIGN_UNCERTAINTY: f64 = 32.0;

/// The fraction of a step within which two sign changes cancel: the effect of what happens between them is below all
/// errors.
pub(crate) const MIN_PART: f64 = 1.0 / 1_073_741_824.0;

/// The limit of parts of a step that are inspected. A sign change takes about ten if others are near.
pub(crate) const ISOLATION_STEPS: u32 = 1024;

/// Times that differ by this many rounding errors are not distinguished in the search for sign changes.
pub(crate) const RESOLUTION: f64 = 64.0;

/// The distance before a sign change at which the polynomial of a step is compared with the equations, as a fraction of
/// the step.
pub(crate) const BEFORE: f64 = 1.0 / 65_536.0;

/// The first time after a discontinuity surface at which a step may end, in rounding errors of the time.
pub(crate) const FIRST_PUSH: f64 = 16.0;

/// The factor by which this time grows if the sign of the switching function is not certain there.
pub(crate) const PUSH_GROWTH: f64 = 4.0;

/// The longest time after a discontinuity surface, in lengths of the step.
pub(crate) const MAX_PUSH: f64 = 1.0 / 256.0;

/// The number of Newton steps by which the time of a crossing is refined. Each adds ten digits, or one order of
/// derivative parts.
pub(crate) const ROOT_ITERATIONS: u32 = 4;

/// The limit of series that are computed at one time after a discontinuity surface; two are enough as a rule.
pub(crate) const SETTLING: u32 = 8;

/// The smallest number of these series on scalars with derivative parts: each makes one more order of derivatives
/// correct.
pub(crate) const SETTLING_OF_DERIVATIVES: u32 = 3;

/// A step to a discontinuity surface is short if it takes at most this many rounding errors of the time.
pub(crate) const SHORT_PASSAGE: f64 = 1024.0;

/// The number of consecutive short steps after which passages accumulate. This many surfaces may be crossed at once.
pub(crate) const MAX_SHORT_PASSAGES: u32 = 64;

/// The smallest default of the singularity tolerance, equal to the tolerance of `Dop853`.
pub(crate) const SINGULARITY_TOLERANCE: f64 = super::dormand_prince::TOLERANCE;

/// The distance by which the state is moved to find the condition of the derivative, in machine epsilons.
pub(crate) const MOVED_EPSILONS: f64 = 4.0;

/// The number of the changes found in this way by which the derivative may differ from the derivative of the
/// polynomial.
pub(crate) const CHANGES: f64 = 8.0;

/// The number of tolerances, divided by the step, for each order, by which the derivative at the end of a step may
/// differ from the derivative of the polynomial: omitted terms have this size.
pub(crate) const RESIDUAL_PER_ORDER: f64 = 4.0;

/// The number of rounding errors of the state and of its change by which it may differ in addition. By judgement: the
/// rounding error of a derivative is amplified by its condition.
pub(crate) const RESIDUAL_ROUNDING: f64 = 4096.0;

/// The number of these rounding errors that are allowed after a sign change of a switching function.
pub(crate) const CROSSING_ROUNDING: f64 = 64.0;

/// The least tolerance, in machine epsilons, at which the ends of steps are corrected by the derivatives there. By judgement: at smaller
/// ones rounding errors count, and the series about the end, which the next step needs, contains the derivative.
pub(crate) const MIN_CORRECTED: f64 = 1024.0;

/// The factor by which a step is shortened if its derivative differs by more.
pub(crate) const SHORTENING: f64 = 2.0;

/// Singular configurations of constraints that a step passes.
pub(crate) mod passing {
    /// The intervals into which the reach of a step is divided in the search for a singular configuration.
    pub(crate) const INTERVALS: u32 = 6;

    /// The number of times that a minimum of the sine is refined, and the factor by which its bracket shrinks.
    pub(crate) const REFINEMENTS: u32 = 2;
    pub(crate) const BRACKET: f64 = 0.125;

    /// The sine between gradients of constraints below which a configuration counts as singular.
    pub(crate) const SINGULAR_SINE: f64 = 0.01;

    /// The rounding error of the coefficient of order k, in machine epsilons times distance⁻ᵏ, at most. A step as long as such
    /// an error allows, or as this part of the distance, is lengthened to pass. Measured: with 10⁹ and 0.6, motions at a
    /// tolerance of 10⁻¹¹ have twice the error.
    pub(crate) const MAX_GROWTH: f64 = 1e8;
    pub(crate) const MIN_PART: f64 = 0.85;

    /// The least length of a step that passes, as a multiple of the distance: rounding errors of the last terms of order 28
    /// are multiplied by 50 there.
    pub(crate) const BEHIND: f64 = 1.15;

    /// A step that is longer by more than this factor is shortened to that length first, if its polynomial does not describe
    /// the motion.
    pub(crate) const FARTHER: f64 = 1.01;

    /// The sine at the end of a step, as a part of the sine at its beginning, below which the step ends too near to a singular
    /// configuration. Behind a configuration that is passed, the sine is about 0.15 of the one at the beginning. Of 60,000 motions
    /// of linkages through several configurations each, more than twenty ended at one without this limit, and none with it.
    pub(crate) const MIN_SINE_PART: f64 = 0.05;

    /// The part of the distance after which a step ends if the polynomial does not describe the motion beyond it, and the part of a
    /// step that is tried next if it ends at a configuration that was not found.
    pub(crate) const SHORT: f64 = 0.5;
}

/// The smallest step, as for DOP853 by default.
pub(crate) const MIN_STEP: f64 = super::dormand_prince::MIN_STEP;

/// The limit of the bytes on the stack if the terms are stored for each pair of factors; a chain of 30 links needs this
/// many. Above it, each factor is stored once.
pub(crate) const MAX_PAIRED_CONVOLUTIONS: usize = 1 << 19;

/// The limit of pairs of factors whose sums are straight-line code instead of a loop. With more of them the code is no faster, and
/// takes three times as long to compile.
pub(crate) const MAX_UNROLLED_CONVOLUTIONS: usize = 24;

/// Half of the order from which on convolutions of few pairs keep sums of several orders. By judgement: four at a time.
pub(crate) const MIN_CONVOLUTIONS: usize = 4;

/// The factor by which a step is lengthened to land on the target, as for DOP853.
pub(crate) const LANDING: f64 = super::dormand_prince::LANDING;
