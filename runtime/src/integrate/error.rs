//! The errors of an integration.

mod messages;

use super::component_name::ComponentName;
use super::singularity::Singularity;
use crate::scalar::Scalar;

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
        /// The time.
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
        /// The coordinates that cause it.
        singularity: Singularity,
    },
    /// The tolerance requires a step that is too small to advance the time.
    StepTooSmall {
        /// The time reached.
        time: f64,
        /// The size of the next step.
        step: f64,
        /// The component with the largest error relative to the tolerance; `None` for fixed steps.
        component: Option<ComponentName>,
        /// Whether the absolute tolerance is zero, so that a component near zero may have no error.
        relative_only: bool,
    },
    /// A step of the smallest size that is allowed does not meet the tolerance.
    SmallestStep {
        /// The time reached.
        time: f64,
        /// The step size, which [`Dop853::min_step`](crate::Dop853::min_step) sets.
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
        /// The coordinates that cause it; the relative pivot is the inertia relative to its size elsewhere.
        singularity: Singularity,
    },
    /// A motion cannot leave a discontinuity surface of its equations, because on both sides they lead back to it, like
    /// dry friction at rest. The solution is then a sliding mode (A. F. Filippov, *Differential Equations with
    /// Discontinuous Righthand Sides* (1988), § 4), which the method does not follow. This is also the error of a
    /// motion that crosses such a surface at accumulating times.
    SlidingMode {
        /// The time from which on the motion stays there.
        time: f64,
        /// The switching function that is zero there, such as ẋ for `signum(dot(x))`.
        function: &'static str,
    },
    /// The projection of a state onto the manifold on which the equations hold has failed
    /// ([`Dynamics::project`](crate::Dynamics::project)): no state nearby satisfies the constraints, or none of them is
    /// nearest.
    ProjectionFailed {
        /// The time of the state.
        time: f64,
        /// The [name](crate::Dynamics::constraint_name) of the first constraint that is violated.
        constraint: &'static str,
        /// Its residual.
        residual: f64,
    },
    /// The start of a motion of a model, or a state that a reaction has left, does not meet the constraints.
    Inconsistent {
        /// The time of the state.
        time: f64,
        /// The constraint that is violated most.
        constraint: &'static str,
        /// Its residual g, or the residual of its velocity ġ if the coordinates meet it.
        residual: f64,
    },
    /// A state is farther from the manifold on which the equations hold than the error of a step and rounding explain.
    /// It is the start, a state left by a reaction, or the end of a step with a derivative that does not preserve the
    /// constraints.
    OffManifold {
        /// The time of the state.
        time: f64,
        /// The first component that the projection moves too far.
        component: ComponentName,
        /// The size of the change that the projection would make to it, less what rounding errors explain.
        correction: f64,
        /// The largest change allowed: ten times the allowed error, plus an allowance for rounding.
        limit: f64,
    },
    /// The integration took the default maximum of steps without reaching its end. If the limit is set by
    /// [`Problem::max_steps`](crate::Problem::max_steps), the integration stops without an error instead, with
    /// [`StopReason::StepLimit`](crate::StopReason::StepLimit).
    TooManySteps {
        /// The time reached.
        time: f64,
        /// The limit.
        limit: u64,
    },
    /// The time at which a solution is evaluated is not between its ends.
    OutsideSolution {
        /// The time.
        time: f64,
        /// The start of the solution, or of the last step.
        start: f64,
        /// The time at which it ends.
        end: f64,
    },
    /// A sample is requested outside of the time span of the integration.
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
        /// The interval.
        interval: f64,
    },
    /// The period of a sampled controller is not a positive finite number.
    InvalidPeriod {
        /// The period.
        period: f64,
    },
    /// The time constant of an actuator's lag is not a positive finite number.
    InvalidTimeConstant {
        /// The index of the input.
        input: usize,
        /// The time constant.
        time_constant: f64,
    },
    /// The compliance of a constraint is not a positive finite number.
    InvalidCompliance {
        /// The name of the constraint.
        constraint: &'static str,
        /// The compliance.
        compliance: f64,
    },
    /// The next update of a state is not later than the present one, for example because a period is shorter than the
    /// resolution of times.
    InvalidUpdate {
        /// The time of the update.
        time: f64,
        /// The time of the next one.
        next: f64,
    },
    /// A step size is not a positive finite number.
    InvalidStep {
        /// The step size.
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
    /// The allowed error of a component is negative or not a number, because its
    /// [size](crate::SetTypicalSizes::with_sizes) is.
    InvalidSize {
        /// The component.
        component: ComponentName,
        /// The error allowed at an absolute tolerance of 1.
        size: f64,
    },
    /// The singularity tolerance is not a positive number.
    InvalidSingularityTolerance {
        /// The tolerance.
        tolerance: f64,
    },
    /// An event is watched that the model does not declare.
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
        /// The time.
        time: f64,
        /// The time before it.
        previous: f64,
    },
}

impl IntegrationError {
    /// Returns the error for a singularity.
    #[cold]
    pub(crate) fn singular<S: Scalar>(time: f64, singularity: Singularity) -> Self {
        Self::SingularConfiguration {
            time,
            estimated_error: S::machine_epsilon() / singularity.relative_pivot(),
            singularity,
        }
    }
}
