//! Initial value problems: what is integrated, what is watched and kept on the way, and what limits it.
//!
//! Input: dynamics and an initial state, then settings in any order, then a method. Output: a solution, or an error with the
//! solution up to there. Without the feature `alloc` only the end is kept.

#![allow(clippy::type_complexity)] // The settings of a problem are in its type.

mod keep;
mod member;
mod part;
mod reaction;
mod run;
mod sample_times;
mod solution;
mod system;
mod watch;

#[cfg(feature = "alloc")]
pub use keep::{Dense, Every, StepEnds};
pub use keep::{End, Keep};
pub(crate) use member::Member;
pub use run::Run;
pub(crate) use sample_times::SampleTimes;
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
use crate::limits::MAX_STEPS;
use crate::scalar::Scalar;
use keep::Saved;
pub use reaction::Reactions;

/// An initial value problem: dynamics with an initial state, and what is asked of their integration.
///
/// It is made from a model, or from any [`Dynamics`], and the state at which it begins. The law of its inputs follows, if there is one
/// ([`feedback`](Self::feedback), [`driven_by`](Self::driven_by)). Then come settings in any order:
/// events ([`when`](Self::when), [`on`](Self::on)), conditions ([`stop_when`](Self::stop_when)), observers
/// ([`each_step`](Self::each_step)), what is kept ([`save`](Self::save)), limits. Each counts, none takes the place of another.
/// [`solve`](Self::solve) integrates by a method.
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

/// What is watched.
#[derive(Clone, Debug)]
struct Watch<C, R, O> {
    /// Conditions and events, of which there are so many.
    conditions: C,
    count: usize,
    reactions: R,
    observer: O,
}

/// What limits an integration, as far as it is set.
#[derive(Clone, Copy, Debug, Default)]
struct Limits {
    max_steps: Option<u64>,
    singularity_tolerance: Option<f64>,
}

impl Limits {
    /// A method with what is watched, and these limits.
    fn driver<I, C, O>(self, method: I, conditions: C, observer: O) -> Driver<I, C, O> {
        Driver {
            integrator: method,
            conditions,
            observer,
            singularity_tolerance: self.singularity_tolerance,
        }
    }

    /// The way to an end within these limits.
    fn course(self, end: f64) -> Course {
        Course {
            end,
            max_steps: self.max_steps.unwrap_or(MAX_STEPS),
        }
    }

    /// What an integration has found, which an error ends, or the largest number of steps.
    fn found<S, D, T, K>(
        self,
        (mut outcome, result): (Outcome<D::State>, Result<(), IntegrationError>),
        collection: K::Collection,
        events: Events<S, D::State>,
    ) -> Found<S, D::State, K::Kept>
    where
        S: Scalar,
        D: Dynamics<S>,
        K: Keep<S, D, T>,
    {
        let result = result.and(self.check(&mut outcome));
        let solution = Solution::new(K::finish(collection, &outcome), events, outcome);
        match result {
            Ok(()) => Ok(solution),
            Err(error) => Err(Partial::new(error, solution)),
        }
    }

    /// An error at the largest number of steps, unless a limit is set.
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
    /// The problem of a model, `Problem::new(&model, start)`, or of [`Dynamics`], from an initial state on.
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

/// Problems in which nothing is watched for yet.
#[diagnostic::on_unimplemented(
    message = "the inputs are set before events, conditions and observers",
    note = "write `feedback`, `feedback_with_states`, `sampled_feedback`, `driven_by` or `under` directly behind `Problem::new`: a law may \
            add components to the state"
)]
pub trait NothingWatched {}

impl NothingWatched for ((), (), ()) {}

/// Problems of which nothing but the end is kept yet.
#[diagnostic::on_unimplemented(
    message = "what is kept of the motion was said before: `{Self}`",
    note = "call `save` once; `Dense` keeps the whole motion, so that `solution.at(t)` has every sample"
)]
pub trait NothingSaved {}

impl NothingSaved for End {}

impl<S: Scalar, D: Dynamics<S>, K, C, R, O> Problem<S, D, K, C, R, O> {
    /// The problem of other dynamics, before anything is watched for.
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
    /// Limits the number of steps, rejected ones included, in a [`Run`] for each call. Then the integration ends by
    /// [`StopReason::StepLimit`](crate::StopReason::StepLimit). Without a limit more than 10⁸ steps are an error,
    /// [`TooManySteps`](crate::IntegrationError::TooManySteps).
    pub fn max_steps(mut self, steps: u64) -> Self {
        self.limits.max_steps = Some(steps);
        self
    }

    /// Sets the relative error of the accelerations at which the integration ends near a singularity of the mass matrix: the
    /// machine epsilon over the smallest relative pivot. Infinity turns the check off.
    ///
    /// The default is the relative tolerance of an adaptive method and 10⁻⁶ for fixed steps, but not below 4096
    /// machine epsilons, since the pivots of regular models are small, too.
    pub fn singularity_tolerance(mut self, tolerance: f64) -> Self {
        self.limits.singularity_tolerance = Some(tolerance);
        self
    }

    /// Calls `observer` at every sample, at every event and at the end of every step. It returns nothing, or
    /// `ControlFlow::Break(())` where the integration is to end. Of several observers each is called, in the order in which they
    /// are set, also where one before it stops.
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

    /// Adds conditions and a reaction behind those that there are.
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

    /// The dynamics: the equations of motion of a model under its law.
    pub fn dynamics(&self) -> &D {
        &self.dynamics
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

    /// Integrates by a method until the time `end`, which may lie before the start, or until an event, a condition or an
    /// observer stops, or events follow each other ever faster, as the bounces of a ball that comes to rest:
    /// [`Solution::reason`](crate::Solution) tells which.
    ///
    /// # Errors
    ///
    /// Any of [`IntegrationError`](crate::IntegrationError), with the solution up to there.
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
                // No step is left to be taken.
                let _ = member.go_on(Steps::Own);
                member.finish()
            }
            Err(found) => found,
        }
    }
}

impl<S: Scalar, D: Dynamics<S>, N, C, R, O> Problem<S, D, N, C, R, O> {
    /// What is kept of the motion besides its end and its events: samples ([`Every`], a list of times, [`StepEnds`]), or
    /// all of it ([`Dense`]).
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
