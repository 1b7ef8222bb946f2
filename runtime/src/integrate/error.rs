//! The errors of an integration.

use core::fmt;

use super::dynamics::ComponentName;
use super::singularity::Singularity;
use crate::error_debug::debug_by_message;
use crate::number_format::Readable;

/// Why an integration could not start or could not continue.
///
/// Errors are values; an integrator never panics. The solution before the error is in [`Partial`](crate::Partial).
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum IntegrationError {
    /// The state is not finite.
    NonFiniteState {
        /// The time of the state.
        time: f64,
        /// Its first component that is not finite.
        component: ComponentName,
        /// The value of that component.
        value: f64,
    },
    /// The state is finite but its derivative is not.
    NonFiniteDerivative {
        /// The time of the state.
        time: f64,
        /// The first component whose derivative is not finite.
        component: ComponentName,
        /// The derivative of that component.
        value: f64,
    },
    /// An initial, final or sample time is not finite, or differs between lanes.
    NonFiniteTime {
        /// That time.
        time: f64,
    },
    /// The mass matrix is singular, or so ill-conditioned that the error of the accelerations exceeds the singularity
    /// tolerance.
    SingularConfiguration {
        /// The time of the configuration.
        time: f64,
        /// The relative error in the accelerations, estimated as the machine epsilon over the
        /// smallest relative pivot.
        estimated_error: f64,
        /// The coordinates that make it so.
        singularity: Singularity,
    },
    /// The tolerance requires a step that is too small to advance the time.
    StepTooSmall {
        /// The time reached.
        time: f64,
        /// The size of the next step.
        step: f64,
        /// The component with the largest error relative to the tolerance; none for fixed steps.
        component: Option<ComponentName>,
        /// Whether the absolute tolerance is zero, so that a component near zero may have no error.
        relative_only: bool,
    },
    /// A step of the smallest size that is allowed does not meet the tolerance.
    SmallestStep {
        /// The time reached.
        time: f64,
        /// That size, which [`Dop853::min_step`](crate::Dop853::min_step) sets.
        step: f64,
        /// The component with the largest error relative to the tolerance.
        component: ComponentName,
    },
    /// The state and its derivative are finite, but not the Taylor series of the motion.
    NoTaylorSeries {
        /// The time of the state.
        time: f64,
        /// The first component whose series is not finite.
        component: ComponentName,
    },
    /// A coordinate moves too fast for any step, because its inertia has nearly vanished: the coordinates are
    /// singular nearby.
    VanishingInertia {
        /// The time reached.
        time: f64,
        /// The size of the next step.
        step: f64,
        /// The coordinates that make it so; its relative pivot is the inertia relative to that elsewhere.
        singularity: Singularity,
    },
    /// A motion cannot leave a discontinuity surface of its equations: on both sides of it they lead back to it, as dry friction
    /// does at rest. There is then no motion on either side, but a sliding mode (A. F. Filippov, *Differential Equations with
    /// Discontinuous Righthand Sides* (1988), § 4), which the method does not follow. So is a motion whose passages through
    /// such a surface accumulate.
    SlidingMode {
        /// The time from which on it stays there.
        time: f64,
        /// The switching function that is zero there, such as ẋ for `signum(dot(x))`.
        function: &'static str,
    },
    /// So many steps were taken before the end that the integration gave up. With a limit that
    /// is set by [`Problem::max_steps`](crate::Problem::max_steps) it stops without an error instead, by
    /// [`StopReason::StepLimit`](crate::StopReason::StepLimit).
    TooManySteps {
        /// The time reached.
        time: f64,
        /// The limit.
        limit: u64,
    },
    /// A time at which a solution is asked is not between its ends.
    OutsideSolution {
        /// That time.
        time: f64,
        /// The time at which the solution, or the last step, begins.
        start: f64,
        /// The time at which it ends.
        end: f64,
    },
    /// A sample is asked for outside of the integration.
    OutsideSpan {
        /// Its time.
        time: f64,
        /// The time at which the integration begins.
        start: f64,
        /// The time at which it ends.
        end: f64,
    },
    /// An interval between samples is not a positive finite number.
    InvalidSampleInterval {
        /// That interval.
        interval: f64,
    },
    /// The update of a state does not come later each time: the period of a sampled controller is not a positive finite number.
    InvalidUpdate {
        /// The time of the update.
        time: f64,
        /// The time of the next one.
        next: f64,
    },
    /// The dynamics of an ensemble update their states.
    UpdatesInLanes,
    /// A step size is not a positive finite number.
    InvalidStep {
        /// That step size.
        step: f64,
    },
    /// The smallest step size is larger than the largest.
    InvalidStepRange {
        /// The smallest step size.
        min: f64,
        /// The largest step size.
        max: f64,
    },
    /// A tolerance is negative or not finite, or both are zero.
    InvalidTolerance {
        /// The relative tolerance.
        relative: f64,
        /// The absolute tolerance.
        absolute: f64,
    },
    /// The error that is allowed in a component is negative or not a number, since its
    /// [size](crate::SetTypicalSizes::with_sizes) is.
    InvalidSize {
        /// The component.
        component: ComponentName,
        /// What is allowed at an absolute tolerance of 1.
        size: f64,
    },
    /// The singularity tolerance is not a positive number.
    InvalidSingularityTolerance {
        /// That tolerance.
        tolerance: f64,
    },
    /// An event is watched for that the model does not declare.
    NoSuchEvent {
        /// The index that was given.
        index: usize,
        /// The names of the events of the model.
        events: &'static [&'static str],
    },
    /// The sample times are not ordered in the direction of integration.
    UnorderedTimes {
        /// The index of the first time that is out of order.
        index: usize,
        /// That time.
        time: f64,
        /// The time before it.
        previous: f64,
    },
}

impl fmt::Display for IntegrationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NonFiniteState {
                time,
                component,
                value,
            } => write!(f, "{component} is {value} at t = {}", Readable(time)),
            Self::NonFiniteDerivative {
                time,
                component,
                value,
            } => write!(
                f,
                "the derivative of {component} is {value} at t = {}",
                Readable(time)
            ),
            Self::NonFiniteTime { time } => {
                write!(
                    f,
                    "a time to integrate from or to must be finite, and the same in all lanes, not {time}"
                )
            }
            Self::SingularConfiguration {
                time,
                estimated_error,
                singularity,
            } => write_singular(f, (time, estimated_error), &singularity),
            Self::StepTooSmall {
                time,
                step,
                component,
                relative_only,
            } => write_too_small(f, (time, step), component, relative_only),
            Self::SmallestStep {
                time,
                step,
                component,
            } => write!(
                f,
                "at t = {} a step of {step:e}, which `min_step` does not let be shortened, does not meet the tolerance: the error of \
                 {component} is too large; allow shorter steps, or larger errors",
                Readable(time)
            ),
            Self::NoTaylorSeries { time, component } => write_no_series(f, time, component),
            Self::VanishingInertia {
                time,
                step,
                singularity,
            } => write_vanishing(f, (time, step), &singularity),
            Self::SlidingMode { time, function } => write_sliding(f, time, function),
            Self::TooManySteps { time, limit } => {
                write!(
                    f,
                    "the limit of {limit} steps is reached at t = {}: raise it, or look for discontinuous \
                     forces, such as dry friction, which need fixed steps or a smooth approximation",
                    Readable(time)
                )
            }
            Self::OutsideSolution { time, start, end } => write!(
                f,
                "the solution is known from t = {} to {}, not at {}",
                Readable(start),
                Readable(end),
                Readable(time)
            ),
            Self::InvalidStep { .. }
            | Self::InvalidStepRange { .. }
            | Self::InvalidTolerance { .. }
            | Self::InvalidSize { .. }
            | Self::InvalidSingularityTolerance { .. }
            | Self::NoSuchEvent { .. }
            | Self::UnorderedTimes { .. }
            | Self::OutsideSpan { .. }
            | Self::InvalidSampleInterval { .. }
            | Self::InvalidUpdate { .. }
            | Self::UpdatesInLanes => self.write_invalid_setting(f),
        }
    }
}

impl IntegrationError {
    /// The message of a setting that is invalid.
    fn write_invalid_setting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::InvalidStep { step } => {
                write!(
                    f,
                    "a step size must be positive and finite, not {}",
                    Readable(step)
                )
            }
            Self::InvalidStepRange { min, max } => write!(
                f,
                "the smallest step size, {}, must not be larger than the largest, {}",
                Readable(min),
                Readable(max)
            ),
            Self::InvalidTolerance { relative, absolute } => write!(
                f,
                "tolerances must be finite, not negative and not both zero, not {} (relative) and {} \
                 (absolute)",
                Readable(relative),
                Readable(absolute)
            ),
            Self::InvalidSize { component, size } => write!(
                f,
                "the size of {component} must be a positive number, not {}: its absolute tolerance is that many times the \
                 method's",
                Readable(size)
            ),
            Self::InvalidSingularityTolerance { tolerance } => {
                write!(
                    f,
                    "the singularity tolerance must be positive, not {tolerance}"
                )
            }
            Self::NoSuchEvent { index, events } => write!(
                f,
                "the model has no event {index}: its events are {events:?}, which the constants of the model name"
            ),
            Self::UnorderedTimes {
                index,
                time,
                previous,
            } => write!(
                f,
                "sample times must advance from the initial time towards the last: {time} at index \
                 {index} comes after {previous}"
            ),
            Self::OutsideSpan { time, start, end } => write!(
                f,
                "a sample is asked for at t = {}, outside of the integration from t = {} to {}",
                Readable(time),
                Readable(start),
                Readable(end)
            ),
            Self::InvalidSampleInterval { interval } => write!(
                f,
                "the interval between samples is {}: it must be positive, finite, and above the resolution of the times",
                Readable(interval)
            ),
            Self::InvalidUpdate { time, next } => write!(
                f,
                "the update of the state at t = {} is followed by one at t = {}: the period of a sampled controller is a positive finite \
                 number",
                Readable(time),
                Readable(next)
            ),
            Self::UpdatesInLanes => f.write_str(
                "states that are updated at given times, as under a sampled controller, are integrated one by one, not in lanes",
            ),
            _ => Ok(()),
        }
    }
}

/// The message of a singular configuration.
fn write_singular(
    f: &mut fmt::Formatter<'_>,
    (time, estimated_error): (f64, f64),
    singularity: &Singularity,
) -> fmt::Result {
    write!(f, "at t = {} {singularity}", Readable(time))?;
    if singularity.has_estimate() {
        write!(
            f,
            "; the estimated relative error of the accelerations is {estimated_error:.1e}"
        )?;
    }
    Ok(())
}

/// The message of a step size that is too small, with the remedy.
fn write_too_small(
    f: &mut fmt::Formatter<'_>,
    (time, step): (f64, f64),
    component: Option<ComponentName>,
    relative_only: bool,
) -> fmt::Result {
    let time = Readable(time);
    write!(f, "the step {step:e} is too small at t = {time}")?;
    match component {
        Some(component) => write!(f, ": {component} does not meet the tolerance there")?,
        None => f.write_str(" to advance the time: set a longer one")?,
    }
    if relative_only {
        f.write_str("; set an absolute tolerance, unless it is far from zero")?;
    }
    Ok(())
}

/// The message of a motion without a Taylor series.
fn write_no_series(f: &mut fmt::Formatter<'_>, time: f64, component: ComponentName) -> fmt::Result {
    let time = Readable(time);
    write!(
        f,
        "at t = {time} {component} has no Taylor series: a higher derivative is not finite; integrate by `Dop853`"
    )
}

/// The message of a sliding mode, with the remedy.
fn write_sliding(f: &mut fmt::Formatter<'_>, time: f64, function: &str) -> fmt::Result {
    let time = Readable(time);
    write!(
        f,
        "from t = {time} on the motion cannot leave {function} = 0, where the equations are discontinuous: on both sides they lead \
         back to it (a sliding mode, such as sticking by dry friction), and that is no motion on either side. Make them \
         continuous, as by tanh(u/w) in place of signum(u), with a small w, or declare an event there, stop at it, and go on \
         with the equations that hold on the surface"
    )
}

/// The message of a vanishing inertia, with its place.
fn write_vanishing(
    f: &mut fmt::Formatter<'_>,
    (time, step): (f64, f64),
    singularity: &Singularity,
) -> fmt::Result {
    let (time, coordinate) = (Readable(time), singularity.coordinate());
    write!(
        f,
        "the step {step:e} is too small at t = {time}: {coordinate} moves too fast, since its inertia \
         has nearly vanished"
    )?;
    singularity.write_coordinates(f)?;
    f.write_str("; use coordinates that are regular there, for Euler angles another sequence")
}

debug_by_message!(IntegrationError);

impl core::error::Error for IntegrationError {}
