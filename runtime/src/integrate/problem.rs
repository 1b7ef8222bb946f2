//! Initial value problems: the system, what is watched and kept during its integration, and the limits.
//!
//! Input: dynamics and an initial state, then settings in any order, then a method. Output: a solution, or an error
//! with the solution up to it. Without the feature `alloc` only the end is kept.

#![allow(clippy::type_complexity)] // The type of a problem contains its settings.

mod keep;
#[cfg(feature = "alloc")]
mod samples;
#[cfg(feature = "alloc")]
mod dense;
mod member;
mod run;
mod solution;
mod system;
mod watch;

#[cfg(feature = "alloc")]
pub use dense::Dense;
pub use keep::{End, Keep};
pub(crate) use member::Member;
pub use run::Run;
#[cfg(feature = "alloc")]
pub use samples::{Every, StepEnds};
use solution::Events;
pub(crate) use solution::Found;
pub use solution::Solution;
pub use system::System;
pub use watch::{DeclaredBy, When};

use core::marker::PhantomData;

use super::at::At;
use super::driver::{Course, Driver};
use super::dynamics::Dynamics;
use super::error::IntegrationError;
use super::event::Watched;
use super::integrator::Integrator;
use super::loop_state::Steps;
use super::observer::{EachStep, Flow, Observer, Progress};
use super::outcome::{Outcome, StopReason};
use super::partial::Partial;
use super::reactions::Reactions;
use super::stepper::Statistics;
use crate::limits::MAX_STEPS;
use crate::scalar::Scalar;
use keep::Saved;

/// An initial value problem: dynamics with an initial state, and the settings of their integration.
///
/// It is created from a model, or from any [`Dynamics`], and an initial state. The law of its inputs follows, if there
/// is one ([`feedback`](Self::feedback), [`driven_by`](Self::driven_by)). Then come settings in any order: events
/// ([`when`](Self::when), [`on`](Self::on)), conditions ([`stop_when`](Self::stop_when)), observers
/// ([`each_step`](Self::each_step)), what is kept ([`save`](Self::save)), limits. Settings accumulate; none replaces
/// another. Finally, [`solve`](Self::solve) integrates by a method.
///
/// ```
/// use lagrangian::prelude::*;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     taylor,
///     coordinates(height),
///     kinetic = 0.5 * m * dot(height).powi(2),
///     potential = m * g * height,
///     event(floor = height),
/// )]
/// struct Ball { m: f64, g: f64 }
///
/// let ball = Ball { m: 0.1, g: 10.0 };
/// let start = State::new(0.0, [5.0], [0.0]);
/// // It falls for 1 s, and for 1 s from bounce to bounce, ½ s, ¼ s, …
/// let motion = Problem::new(&ball, start)
///     .on(Ball::FLOOR).falling().then(|ball| ball.v[0] *= -0.5)
///     .when(|ball| ball.v[0]).falling().record()
///     .save(Every(0.1))
///     .solve(2.3, Taylor::new())?;
/// let times: Vec<f64> = motion.events().iter().map(|event| event.t).collect();
/// for (found, expected) in times.iter().zip([1.0, 1.5, 2.0, 2.25]) {
///     assert!((found - expected).abs() < 1e-14);
/// }
/// assert_eq!(motion.samples().len(), 24);
/// # Ok::<(), IntegrationError>(())
/// ```
#[must_use = "a problem is integrated by `solve`"]
#[derive(Clone, Debug)]
pub struct Problem<S, D, K = End, C = (), R = (), O = ()>
where
    S: Scalar,
    D: Dynamics<S>,
{
    dynamics: D,
    start: At<f64, D::State>,
    keep: K,
    watch: Watch<C, R, O>,
    limits: Limits,
    scalar: PhantomData<S>,
}

/// The conditions, events, reactions and observers of a problem.
#[derive(Clone, Debug)]
struct Watch<C, R, O> {
    /// Conditions and events; `count` is their number.
    conditions: C,
    count: usize,
    reactions: R,
    observer: O,
}

/// The end of an integration: what it has reached, its cost, and the error that stopped it.
type Ended<X> = (Outcome<X>, Statistics, Result<(), IntegrationError>);

/// The limits of an integration, if they are set.
#[derive(Clone, Copy, Debug, Default)]
struct Limits {
    max_steps: Option<u64>,
    singularity_tolerance: Option<f64>,
}

impl Limits {
    /// Returns a driver: a method with what is watched, and these limits.
    fn driver<I, C, O>(self, method: I, conditions: C, observer: O) -> Driver<I, C, O> {
        Driver {
            integrator: method,
            conditions,
            observer,
            singularity_tolerance: self.singularity_tolerance,
        }
    }

    /// Returns the course to an end within these limits.
    fn course(self, end: f64) -> Course {
        Course {
            end,
            max_steps: self.max_steps.unwrap_or(MAX_STEPS),
        }
    }

    /// Returns the result of an integration that has ended, possibly by an error or at the largest number of steps.
    fn found<S, D, T, K>(
        self,
        (mut outcome, statistics, result): Ended<D::State>,
        collection: K::Collection,
        events: Events<S, D::State>,
    ) -> Found<S, D::State, K::Kept>
    where
        S: Scalar,
        D: Dynamics<S>,
        K: Keep<S, D, T>,
    {
        let result = result.and(self.check(&mut outcome));
        let solution = Solution::new(K::finish(collection, &outcome), events, outcome, statistics);
        match result {
            Ok(()) => Ok(solution),
            Err(error) => Err(Partial::new(error, solution)),
        }
    }

    /// Returns an error at the largest number of steps, unless a limit is set.
    fn check<X>(self, outcome: &mut Outcome<X>) -> Result<(), IntegrationError> {
        if outcome.reason == StopReason::StepLimit && self.max_steps.is_none() {
            outcome.reason = StopReason::Error;
            Err(IntegrationError::TooManySteps {
                time: outcome.last.t,
                limit: MAX_STEPS,
            })
        } else {
            Ok(())
        }
    }
}

impl<S: Scalar, D: Dynamics<S>> Problem<S, D> {
    /// Creates the problem of a model, `Problem::new(&model, start)`, or of any [`Dynamics`], from an initial state.
    pub fn new<Y, Kind>(system: Y, start: At<S, D::State>) -> Self
    where
        Y: System<Kind, S, Dynamics = D, State = D::State>,
    {
        Self {
            dynamics: system.into_dynamics(),
            start: start.at_one_time(),
            keep: End,
            watch: Watch {
                conditions: (),
                count: 0,
                reactions: (),
                observer: (),
            },
            limits: Limits::default(),
            scalar: PhantomData,
        }
    }
}

/// Problems in which nothing is watched yet.
#[diagnostic::on_unimplemented(
    message = "the inputs are set before events, conditions and observers",
    note = "write `feedback`, `feedback_with_states`, `sampled_feedback`, `driven_by` or `under` directly behind `Problem::new`: a law may \
            add components to the state"
)]
pub trait NothingWatched {}

impl NothingWatched for ((), (), ()) {}

/// Problems that keep only their end so far.
#[diagnostic::on_unimplemented(
    message = "what is kept of the motion was said before: `{Self}`",
    note = "call `save` once; `Dense` keeps the whole motion, so that `solution.at(t)` has every sample"
)]
pub trait NothingSaved {}

impl NothingSaved for End {}

impl<S: Scalar, D: Dynamics<S>, K, C, R, O> Problem<S, D, K, C, R, O> {
    /// Replaces the dynamics, before anything is watched.
    pub(crate) fn with_dynamics<E: Dynamics<S>>(
        self,
        change: impl FnOnce(D, At<f64, D::State>) -> (E, At<f64, E::State>),
    ) -> Problem<S, E, K, C, R, O>
    where
        (C, R, O): NothingWatched,
    {
        let (dynamics, start) = change(self.dynamics, self.start);
        Problem {
            dynamics,
            start,
            keep: self.keep,
            watch: self.watch,
            limits: self.limits,
            scalar: PhantomData,
        }
    }
}

impl<S: Scalar, D: Dynamics<S>, K, C, R, O> Problem<S, D, K, C, R, O> {
    /// Limits the number of steps, including rejected ones; in a [`Run`], the number for each call. At the limit the
    /// integration ends with [`StopReason::StepLimit`](crate::StopReason::StepLimit). Without this setting, 10⁸ steps
    /// that do not reach the end are an error, [`TooManySteps`](crate::IntegrationError::TooManySteps).
    pub fn max_steps(mut self, steps: u64) -> Self {
        self.limits.max_steps = Some(steps);
        self
    }

    /// Sets the relative error of the accelerations at which the integration ends near a singularity of the mass
    /// matrix: the machine epsilon over the smallest relative pivot. Infinity turns the check off.
    ///
    /// The default is the relative tolerance of an adaptive method, or 10⁻⁶ for fixed steps, but at least 4096 machine
    /// epsilons, since the pivots of regular models are small, too.
    pub fn singularity_tolerance(mut self, tolerance: f64) -> Self {
        self.limits.singularity_tolerance = Some(tolerance);
        self
    }

    /// Calls `observer` at every sample, at every event and at the end of every step. It returns nothing, or
    /// `ControlFlow::Break(())` to end the integration. Several observers are called in the order in which they are
    /// set, even if an earlier one stops the integration.
    pub fn each_step<F, A>(self, observer: F) -> Problem<S, D, K, C, R, (O, EachStep<F>)>
    where
        F: FnMut(&Progress<'_, D::State>) -> A,
        A: Flow,
    {
        self.watching(|watch| Watch {
            conditions: watch.conditions,
            count: watch.count,
            reactions: watch.reactions,
            observer: (watch.observer, EachStep(observer)),
        })
    }

    /// Appends conditions and a reaction to the existing ones.
    fn with<E, A>(
        self,
        conditions: E,
        reaction: impl FnOnce(R, usize) -> A,
    ) -> Problem<S, D, K, (C, E), A, O>
    where
        E: Watched<S, D>,
    {
        self.watching(|watch| Watch {
            conditions: (watch.conditions, conditions),
            count: watch.count + E::COUNT,
            reactions: reaction(watch.reactions, watch.count),
            observer: watch.observer,
        })
    }

    /// Returns the dynamics: the equations of motion of a model under its law.
    pub fn dynamics(&self) -> &D {
        &self.dynamics
    }

    /// Returns the initial time and state.
    pub fn initial_state(&self) -> &At<f64, D::State> {
        &self.start
    }

    fn watching<C2, R2, O2>(
        self,
        change: impl FnOnce(Watch<C, R, O>) -> Watch<C2, R2, O2>,
    ) -> Problem<S, D, K, C2, R2, O2> {
        Problem {
            dynamics: self.dynamics,
            start: self.start,
            keep: self.keep,
            watch: change(self.watch),
            limits: self.limits,
            scalar: PhantomData,
        }
    }

    /// Integrates by a method until the time `end`, which may be before the start.
    ///
    /// The integration ends earlier if an event, a condition or an observer stops it, or if events follow each other
    /// ever faster, like the bounces of a ball that comes to rest: [`Solution::reason`](crate::Solution) tells which.
    ///
    /// # Errors
    ///
    /// Any [`IntegrationError`](crate::IntegrationError), with the solution up to it.
    pub fn solve<I>(
        self,
        end: f64,
        method: I,
    ) -> Result<Solution<S, D::State, K::Kept>, Partial<Solution<S, D::State, K::Kept>>>
    where
        I: Integrator<S, D>,
        C: Watched<S, D>,
        R: Reactions<S, D>,
        O: Observer<D::State>,
        K: Keep<S, D, I::Stepper>,
    {
        match self.into_member(end, method) {
            Ok(mut member) => {
                // With its own steps, a member continues until it has ended.
                let _ = member.go_on(Steps::Own);
                member.finish()
            }
            Err(found) => found,
        }
    }
}

impl<S: Scalar, D: Dynamics<S>, N, C, R, O> Problem<S, D, N, C, R, O> {
    /// Sets what is kept of the motion in addition to its end and its events: samples ([`Every`], a list of times,
    /// [`StepEnds`]), or the whole motion ([`Dense`]).
    pub fn save<K: Saved>(self, keep: K) -> Problem<S, D, K, C, R, O>
    where
        N: NothingSaved,
    {
        Problem {
            dynamics: self.dynamics,
            start: self.start,
            keep,
            watch: self.watch,
            limits: self.limits,
            scalar: PhantomData,
        }
    }
}
