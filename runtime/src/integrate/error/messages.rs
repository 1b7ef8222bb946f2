//! The messages of integration errors.

use core::fmt;

use super::IntegrationError;
use crate::error_messages::error_messages;
use crate::integrate::singularity::SingularCoordinates;
use crate::number_format::Readable;

error_messages! { IntegrationError:
    Self::NonFiniteState { time, component, value } =>
        "{component} is {value} at t = {}",
        Readable(time);
    Self::NonFiniteDerivative { time, component, value } =>
        "the derivative of {component} is {value} at t = {}",
        Readable(time);
    Self::NonFiniteTime { time } =>
        "a time to integrate from or to must be finite, and the same in all lanes, not {time}";
    Self::SingularConfiguration { time, estimated_error, singularity } =>
        "at t = {} {singularity}{}",
        Readable(time), Estimate(singularity.has_estimate().then_some(estimated_error));
    Self::StepTooSmall { time, step, component: Some(component), relative_only } =>
        "the step {step:e} is too small at t = {}: {component} does not meet the tolerance there{}",
        Readable(time), advice(relative_only);
    Self::StepTooSmall { time, step, component: None, relative_only } =>
        "the step {step:e} is too small at t = {} to advance the time: set a longer one{}",
        Readable(time), advice(relative_only);
    Self::SmallestStep { time, step, component } =>
        "at t = {} a step of {step:e}, which `min_step` does not let be shortened, does not meet the tolerance: the error of \
         {component} is too large; allow shorter steps, or larger errors",
        Readable(time);
    Self::NoTaylorSeries { time, component } =>
        "at t = {} {component} has no Taylor series: a higher derivative is not finite; integrate by `Dop853`",
        Readable(time);
    Self::VanishingInertia { time, step, singularity } =>
        "the step {step:e} is too small at t = {}: {} moves too fast, since its inertia has nearly vanished{}; \
         use coordinates that are regular there, for Euler angles another sequence",
        Readable(time), singularity.coordinate(), SingularCoordinates(&singularity);
    Self::SlidingMode { time, function } =>
        "from t = {} on the motion cannot leave {function} = 0, where the equations are discontinuous: on both sides they lead \
         back to it (a sliding mode, such as sticking by dry friction), and that is no motion on either side. Make them \
         continuous, as by tanh(u/w) in place of signum(u), with a small w, or declare an event there, stop at it, and go on \
         with the equations that hold on the surface",
        Readable(time);
    Self::ProjectionFailed { time, constraint, residual } =>
        "at t = {} no state that meets the constraints is found nearby: {constraint} is violated by {}; begin at a state \
         that meets them, or keep away from where they contradict each other",
        Readable(time), Readable(residual);
    Self::Inconsistent { time, constraint, residual } =>
        "at t = {} the state does not meet the constraint {constraint}, whose residual is {}: \
         `model.assemble(state).solve()?.state` is a state that meets all constraints",
        Readable(time), Readable(residual);
    Self::OffManifold { time, component, correction, limit } =>
        "at t = {} the state does not meet the constraints: the projection onto them would change {component} by {}, which \
         is more than {}, ten times the error that is allowed; begin at, or change to, a state that meets them, with velocities \
         that do, too, and let the derivative keep them",
        Readable(time), Readable(correction), Readable(limit);
    Self::TooManySteps { time, limit } =>
        "the limit of {limit} steps is reached at t = {}: raise it, or look for discontinuous \
         forces, such as dry friction, which need fixed steps or a smooth approximation",
        Readable(time);
    Self::OutsideSolution { time, start, end } =>
        "the solution is known from t = {} to {}, not at {}",
        Readable(start), Readable(end), Readable(time);
    Self::OutsideSpan { time, start, end } =>
        "a sample is asked for at t = {}, outside of the integration from t = {} to {}",
        Readable(time), Readable(start), Readable(end);
    Self::UnorderedTimes { index, time, previous } =>
        "sample times must advance from the initial time towards the last: {time} at index \
         {index} comes after {previous}";
    Self::InvalidSampleInterval { interval } =>
        "the interval between samples is {}: it must be positive, finite, and above the resolution of the times",
        Readable(interval);
    Self::InvalidPeriod { period } =>
        "the period of a sampled controller is {}: it must be positive and finite",
        Readable(period);
    Self::InvalidTimeConstant { input, time_constant } =>
        "the time constant with which input {input} lags is {}: it must be positive and finite; an actuator without a lag has none",
        Readable(time_constant);
    Self::InvalidCompliance { constraint, compliance } =>
        "the compliance of the constraint {constraint} is {}: it must be positive and finite; a part that does not yield has a \
         small one",
        Readable(compliance);
    Self::InvalidUpdate { time, next } =>
        "the update of the state at t = {} is followed by one at t = {}: the period of a sampled controller has to be above the \
         resolution of the times",
        Readable(time), Readable(next);
    Self::InvalidStep { step } =>
        "a step size must be positive and finite, not {}",
        Readable(step);
    Self::InvalidStepRange { min, max } =>
        "the smallest step size, {}, must not be larger than the largest, {}",
        Readable(min), Readable(max);
    Self::InvalidTolerance { relative, absolute } =>
        "tolerances must be finite, not negative and not both zero, not {} (relative) and {} \
         (absolute)",
        Readable(relative), Readable(absolute);
    Self::InvalidSize { component, size } =>
        "the size of {component} must be a positive number, not {}: its absolute tolerance is that many times the \
         method's",
        Readable(size);
    Self::InvalidSingularityTolerance { tolerance } =>
        "the singularity tolerance must be positive, not {tolerance}";
    Self::NoSuchEvent { index, events } =>
        "the model has no event {index}: its events are {events:?}, which the constants of the model name";
}

/// The error of the accelerations at a singular configuration, if it is estimated.
struct Estimate(Option<f64>);

impl fmt::Display for Estimate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.map_or(Ok(()), |error| {
            write!(
                f,
                "; the estimated relative error of the accelerations is {error:.1e}"
            )
        })
    }
}

/// What helps against short steps if the tolerance is relative only.
const fn advice(relative_only: bool) -> &'static str {
    if relative_only {
        "; set an absolute tolerance, unless it is far from zero"
    } else {
        ""
    }
}
