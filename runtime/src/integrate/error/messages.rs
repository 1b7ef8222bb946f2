//! The messages of integration errors.

use core::fmt;

use super::IntegrationError;
use crate::integrate::component_name::ComponentName;
use crate::integrate::singularity::Singularity;
use crate::number_format::Readable;

impl IntegrationError {
    /// Writes the message about an invalid setting.
    pub(super) fn write_invalid_setting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
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
            _ => self.write_invalid_time(f),
        }
    }

    /// Writes the message about an invalid time or time interval.
    fn write_invalid_time(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
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
            Self::InvalidPeriod { period } => write!(
                f,
                "the period of a sampled controller is {}: it must be positive and finite",
                Readable(period)
            ),
            Self::InvalidTimeConstant {
                input,
                time_constant,
            } => write!(
                f,
                "the time constant with which input {input} lags is {}: it must be positive and finite; an actuator without a lag has none",
                Readable(time_constant)
            ),
            Self::InvalidCompliance {
                constraint,
                compliance,
            } => write!(
                f,
                "the compliance of the constraint {constraint} is {}: it must be positive and finite; a part that does not yield has a \
                 small one",
                Readable(compliance)
            ),
            Self::InvalidUpdate { time, next } => write!(
                f,
                "the update of the state at t = {} is followed by one at t = {}: the period of a sampled controller has to be above the \
                 resolution of the times",
                Readable(time),
                Readable(next)
            ),
            _ => Ok(()),
        }
    }
}

/// Writes the message about a singular configuration.
pub(super) fn write_singular(
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

/// Writes the message about a step size that is too small, with the remedy.
pub(super) fn write_too_small(
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

/// Writes the message about a motion without a Taylor series.
pub(super) fn write_no_series(
    f: &mut fmt::Formatter<'_>,
    time: f64,
    component: ComponentName,
) -> fmt::Result {
    let time = Readable(time);
    write!(
        f,
        "at t = {time} {component} has no Taylor series: a higher derivative is not finite; integrate by `Dop853`"
    )
}

/// Writes the message about a sliding mode, with the remedy.
pub(super) fn write_sliding(f: &mut fmt::Formatter<'_>, time: f64, function: &str) -> fmt::Result {
    let time = Readable(time);
    write!(
        f,
        "from t = {time} on the motion cannot leave {function} = 0, where the equations are discontinuous: on both sides they lead \
         back to it (a sliding mode, such as sticking by dry friction), and that is no motion on either side. Make them \
         continuous, as by tanh(u/w) in place of signum(u), with a small w, or declare an event there, stop at it, and go on \
         with the equations that hold on the surface"
    )
}

/// Writes the message about a vanishing inertia, with its place.
pub(super) fn write_vanishing(
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

/// Writes the message about a projection that has failed.
pub(super) fn write_failed_projection(
    f: &mut fmt::Formatter<'_>,
    time: f64,
    constraint: &str,
    residual: f64,
) -> fmt::Result {
    let (time, residual) = (Readable(time), Readable(residual));
    write!(
        f,
        "at t = {time} no state that meets the constraints is found nearby: {constraint} is violated by {residual}; begin at a state \
         that meets them, or keep away from where they contradict each other"
    )
}

/// Writes the message about a state that does not meet the constraints of a model, with the remedy.
pub(super) fn write_inconsistent(
    f: &mut fmt::Formatter<'_>,
    time: f64,
    constraint: &str,
    residual: f64,
) -> fmt::Result {
    let (time, residual) = (Readable(time), Readable(residual));
    write!(
        f,
        "at t = {time} the state does not meet the constraint {constraint}, whose residual is {residual}: \
         `model.assemble(state).solve()?.state` is a state that meets all constraints"
    )
}

/// Writes the message about a state that is off the manifold, with the remedy.
pub(super) fn write_off_manifold(
    f: &mut fmt::Formatter<'_>,
    time: f64,
    component: ComponentName,
    [correction, limit]: [f64; 2],
) -> fmt::Result {
    let (time, correction, limit) = (Readable(time), Readable(correction), Readable(limit));
    write!(
        f,
        "at t = {time} the state does not meet the constraints: the projection onto them would change {component} by {correction}, which \
         is more than {limit}, ten times the error that is allowed; begin at, or change to, a state that meets them, with velocities \
         that do, too, and let the derivative keep them"
    )
}
