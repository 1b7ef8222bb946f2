//! The driver of an integration: limits, stop conditions, samples.
//!
//! Input: a method, the dynamics, the initial value, sample times and the final time. Output: samples to an
//! observer, and the outcome. Nothing here allocates but [`Driver::sample`], which collects. Errors are values; the
//! sample times are visited in order, each once.

mod events;
mod run;

pub(crate) use run::check_times;

use super::at::InitialValue;
#[cfg(feature = "alloc")]
use super::collector::Samples;
use super::collector::Uncollected;
#[cfg(feature = "alloc")]
use super::dense_output::DenseOutput;
#[cfg(feature = "alloc")]
use super::dense_solution::{DenseSolution, Segments};
use super::dynamics::Dynamics;
use super::error::IntegrationError;
use super::integrator::Integrator;
use super::observer::{Observer, Observers, Unobserved};
use super::outcome::Outcome;
#[cfg(feature = "alloc")]
use super::reacting::{React, Unreacting};
use super::stop_condition::{Extensible, Predicate, StopCondition, Unconditional};
#[cfg(feature = "alloc")]
use super::trajectory::{PartialSolution, PartialTrajectory, Trajectory};
use crate::limits::MAX_STEPS;
use crate::scalar::Scalar;

/// A method of integration with limits, a stop condition and an observer.
///
/// ```
/// use core::ops::ControlFlow;
/// use lagrangian::prelude::*;
/// use lagrangian::nalgebra::SVector;
///
/// /// A stone: height and velocity.
/// struct Stone;
///
/// impl Dynamics for Stone {
///     type State = SVector<f64, 2>;
///
///     fn derivative(&self, _: f64, x: &Self::State) -> Self::State {
///         SVector::from([x[1], -10.0])
///     }
/// }
///
/// let mut fastest = 0.0_f64;
/// let outcome = Dop853::new()
///     .driver()
///     .max_steps(1000)
///     .stop_at_zero(|_, x: &SVector<f64, 2>| x[0])
///     .observe(|progress: &Progress<'_, SVector<f64, 2>>| {
///         fastest = fastest.max(progress.x[1].abs());
///         ControlFlow::Continue(())
///     })
///     .run_until(&Stone, (0.0, SVector::from([20.0, 0.0])), 10.0)?;
/// assert_eq!(outcome.reason, StopReason::Condition);
/// assert!((outcome.last.t - 2.0).abs() < 1e-9);
/// assert!((fastest - 20.0).abs() < 1e-9);
/// # Ok::<(), IntegrationError>(())
/// ```
///
/// # Events and reactions
///
/// An event has a function, whose zeros are located within a step, and the direction in which it crosses zero. A reaction
/// changes the state or the model there, and the integration goes on: a ball bounces where its height falls through zero.
///
/// ```
/// use lagrangian::prelude::*;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     coordinates(height),
///     kinetic = 0.5 * m * dot(height).powi(2),
///     potential = m * g * height,
/// )]
/// struct Ball { m: f64, g: f64 }
///
/// let ball = Ball { m: 0.1, g: 10.0 };
/// let start = State::new(0.0, [5.0], [0.0]);
/// let driver = Dop853::new()
///     .driver()
///     .events(Event::falling(), |_, x: &Phase<f64, 1>| x.q[Ball::HEIGHT]);
/// let bounce = |_, _, x: &mut Phase<f64, 1>, _: &mut _| {
///     x.v[Ball::HEIGHT] *= -0.5;
///     Reaction::Changed
/// };
/// let motion = driver.sample_reacting(&mut ball.dynamics(), start, &[2.995, 10.0], bounce)?;
/// // It falls for 1 s and flies for 1 s, ½ s, ¼ s, …: the ninth bounce is at t = 3 − 2⁻⁷.
/// assert_eq!(motion.events().iter().filter(|event| event.t < 2.995).count(), 9);
/// // Then it is at rest.
/// assert_eq!(motion.reason(), StopReason::Zeno);
/// assert!((motion.last().t - 3.0).abs() < 1e-8);
/// # Ok::<(), IntegrationError>(())
/// ```
///
/// The flights become ever shorter here (Zeno behaviour), which ends the integration. A reaction to an event that is to
/// hold the ball on the floor changes the model.
///
/// An integration consumes its driver; one with the same settings is a `clone()`.
#[derive(Clone, Debug)]
pub struct Driver<I, C = Unconditional, O = Unobserved> {
    pub(crate) integrator: I,
    max_steps: u64,
    singularity_tolerance: Option<f64>,
    condition: C,
    observer: O,
}

impl<I> Driver<I> {
    /// The driver of a method, without stop condition and observer, and with at most 10⁸ steps.
    #[must_use]
    pub fn new(integrator: I) -> Self {
        Self {
            integrator,
            max_steps: MAX_STEPS,
            singularity_tolerance: None,
            condition: Unconditional,
            observer: Unobserved,
        }
    }
}

impl<I, C, O> Driver<I, C, O> {
    pub(crate) fn of_parts(
        (integrator, condition, observer): (I, C, O),
        (max_steps, singularity_tolerance): (u64, Option<f64>),
    ) -> Self {
        Self {
            integrator,
            max_steps,
            singularity_tolerance,
            condition,
            observer,
        }
    }

    /// Limits the number of steps, rejected ones included, of one call. Then the integration stops by
    /// [`StopReason::StepLimit`](crate::StopReason::StepLimit), and can go on: from the last state, or, as if it had not stopped, as a
    /// [`RunningIntegration`](crate::RunningIntegration).
    #[must_use]
    pub fn max_steps(mut self, steps: u64) -> Self {
        self.max_steps = steps;
        self
    }

    pub(crate) fn condition_mut(&mut self) -> &mut C {
        &mut self.condition
    }

    /// The steps that are allowed at a time.
    pub(crate) fn steps_at_a_time(&self) -> u64 {
        self.max_steps
    }

    /// Sets the relative error of the accelerations at which the integration ends near a
    /// singularity of the mass matrix. The error is estimated as the machine epsilon over the smallest relative
    /// pivot. Infinity turns the check off.
    ///
    /// The default is the relative tolerance of an adaptive method and 10⁻⁶ for fixed steps, but not below 4096
    /// machine epsilons, since the pivots of regular models are small, too.
    #[must_use]
    pub fn singularity_tolerance(mut self, tolerance: f64) -> Self {
        self.singularity_tolerance = Some(tolerance);
        self
    }

    /// Stops after the first step at whose end `condition(t, x)` holds. A closure names the type of the state, which is
    /// that of the dynamics: `|t, x: &Phase<f64, N>|` of a mechanical system, `|t, x: &AugmentedPhase<f64, N, K>|`
    /// under a controller with states.
    ///
    /// Conditions and [events](Self::events) all count, in whatever order they are set. In that order they are numbered: a
    /// condition is one, and events as many as there are.
    #[must_use]
    pub fn stop_when<F>(self, condition: F) -> Driver<I, C::With<Predicate<F>>, O>
    where
        C: Extensible,
    {
        self.with_condition(Predicate(condition))
    }

    /// Adds conditions behind those that there are.
    fn with_condition<E>(self, conditions: E) -> Driver<I, C::With<E>, O>
    where
        C: Extensible,
    {
        Driver {
            integrator: self.integrator,
            max_steps: self.max_steps,
            singularity_tolerance: self.singularity_tolerance,
            condition: self.condition.with(conditions),
            observer: self.observer,
        }
    }

    /// Calls `observer` at every sample, at every event and at the end of every step; it may stop the integration. Of several
    /// observers each is called, in the order in which they are set, also where one before it stops.
    #[must_use]
    pub fn observe<E>(self, observer: E) -> Driver<I, C, Observers<O, E>> {
        Driver {
            integrator: self.integrator,
            max_steps: self.max_steps,
            singularity_tolerance: self.singularity_tolerance,
            condition: self.condition,
            observer: Observers(self.observer, observer),
        }
    }

    /// Integrates from `initial` until the time `end`, which may lie before it, or until a condition or the observer
    /// stops.
    ///
    /// # Errors
    ///
    /// Any of [`IntegrationError`].
    pub fn run_until<S: Scalar, D: Dynamics<S> + ?Sized>(
        self,
        dynamics: &D,
        initial: impl InitialValue<D::State>,
        end: f64,
    ) -> Result<Outcome<D::State>, IntegrationError>
    where
        I: Integrator<S, D>,
        C: StopCondition<S, D>,
        O: Observer<D::State>,
    {
        self.run_through(dynamics, initial, &[end])
    }

    /// Integrates through each of `times`, which advance in one direction from the initial time.
    /// The observer sees the samples; nothing is collected.
    ///
    /// # Errors
    ///
    /// Any of [`IntegrationError`].
    pub fn run_through<S: Scalar, D: Dynamics<S> + ?Sized>(
        mut self,
        dynamics: &D,
        initial: impl InitialValue<D::State>,
        times: &[f64],
    ) -> Result<Outcome<D::State>, IntegrationError>
    where
        I: Integrator<S, D>,
        C: StopCondition<S, D>,
        O: Observer<D::State>,
    {
        let initial = initial.into_initial();
        let (outcome, result) = self.run(dynamics, &initial, times, &mut Uncollected);
        result.map(|()| outcome)
    }

    /// The motion from `initial` at each of `times`, which advance in one direction. An empty list
    /// gives an empty trajectory.
    ///
    /// # Errors
    ///
    /// Any of [`IntegrationError`], with the samples up to then.
    #[cfg(feature = "alloc")]
    pub fn sample<S: Scalar, D: Dynamics<S> + ?Sized>(
        mut self,
        dynamics: &D,
        initial: impl InitialValue<D::State>,
        times: &[f64],
    ) -> Result<Trajectory<D::State, S>, PartialTrajectory<D::State, S>>
    where
        I: Integrator<S, D>,
        C: StopCondition<S, D>,
        O: Observer<D::State>,
    {
        self.collect(&mut Unreacting(dynamics), initial, times)
    }

    #[cfg(feature = "alloc")]
    fn collect<S: Scalar, D: Dynamics<S> + ?Sized>(
        &mut self,
        system: &mut impl React<S, D>,
        initial: impl InitialValue<D::State>,
        times: &[f64],
    ) -> Result<Trajectory<D::State, S>, PartialTrajectory<D::State, S>>
    where
        I: Integrator<S, D>,
        C: StopCondition<S, D>,
        O: Observer<D::State>,
    {
        let mut samples = Samples {
            samples: alloc::vec::Vec::with_capacity(times.len()),
            events: alloc::vec::Vec::new(),
        };
        let initial = initial.into_initial();
        let (outcome, result) = self.run_parts(system, &initial, times, &mut samples);
        let Samples { samples, events } = samples;
        let trajectory = Trajectory {
            samples,
            events,
            outcome,
        };
        match result {
            Ok(()) => Ok(trajectory),
            Err(error) => Err(PartialTrajectory::new(error, trajectory)),
        }
    }

    /// The motion from `initial` until the time `end`, or until a condition or the observer stops, as a solution that can
    /// be asked at any time.
    ///
    /// ```
    /// use lagrangian::prelude::*;
    /// # use lagrangian::nalgebra::SVector;
    /// # struct Oscillator;
    /// # impl Dynamics for Oscillator {
    /// #     type State = SVector<f64, 2>;
    /// #     fn derivative(&self, _: f64, x: &Self::State) -> Self::State {
    /// #         SVector::from([x[1], -x[0]])
    /// #     }
    /// # }
    /// // ẍ = −x.
    /// let start = (0.0, SVector::from([0.0, 1.0]));
    /// let solution = Dop853::new().driver().solve(&Oscillator, start, 10.0)?;
    /// for t in [0.0, 0.3, 7.77, 10.0] {
    ///     assert!((solution.at(t)?[0] - t.sin()).abs() < 1e-8);
    /// }
    /// assert!(solution.at(10.5).is_err());
    /// # Ok::<(), IntegrationError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// Any of [`IntegrationError`], with the solution up to then.
    #[cfg(feature = "alloc")]
    #[allow(clippy::type_complexity)] // The interpolant is that of the method's stepper.
    pub fn solve<S: Scalar, D: Dynamics<S> + ?Sized, T>(
        mut self,
        dynamics: &D,
        initial: impl InitialValue<D::State>,
        end: f64,
    ) -> Result<
        DenseSolution<D::State, T::Interpolant, S>,
        PartialSolution<D::State, T::Interpolant, S>,
    >
    where
        I: Integrator<S, D, Stepper = T>,
        T: DenseOutput<S, D>,
        C: StopCondition<S, D>,
        O: Observer<D::State>,
    {
        self.collect_steps(&mut Unreacting(dynamics), initial, end)
    }

    #[cfg(feature = "alloc")]
    #[allow(clippy::type_complexity)] // The interpolant is that of the method's stepper.
    fn collect_steps<S: Scalar, D: Dynamics<S> + ?Sized, T>(
        &mut self,
        system: &mut impl React<S, D>,
        initial: impl InitialValue<D::State>,
        end: f64,
    ) -> Result<
        DenseSolution<D::State, T::Interpolant, S>,
        PartialSolution<D::State, T::Interpolant, S>,
    >
    where
        I: Integrator<S, D, Stepper = T>,
        T: DenseOutput<S, D>,
        C: StopCondition<S, D>,
        O: Observer<D::State>,
    {
        let mut segments = Segments::new();
        let initial = initial.into_initial();
        let (outcome, result) = self.run_parts(system, &initial, &[end], &mut segments);
        let solution = DenseSolution::new(initial, segments, outcome);
        match result {
            Ok(()) => Ok(solution),
            Err(error) => Err(PartialSolution::new(error, solution)),
        }
    }
}
