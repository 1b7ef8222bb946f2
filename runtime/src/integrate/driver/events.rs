//! Events, and integrations with reactions to them.

use super::Driver;
use crate::integrate::collector::Uncollected;
#[cfg(feature = "alloc")]
use crate::integrate::dense_output::DenseOutput;
#[cfg(feature = "alloc")]
use crate::integrate::dense_solution::DenseSolution;
use crate::integrate::dynamics::Dynamics;
use crate::integrate::error::IntegrationError;
use crate::integrate::event::{Crossing, DeclaredEvents, Event, Reaction, Watched, ZeroCrossing};
use crate::integrate::integrator::Integrator;
use crate::integrate::observer::Observer;
use crate::integrate::outcome::Outcome;
use crate::integrate::reacting::Reacting;
use crate::integrate::sample::InitialValue;
use crate::integrate::stop_condition::StopCondition;
#[cfg(feature = "alloc")]
use crate::integrate::trajectory::{PartialSolution, PartialTrajectory, Trajectory};
use crate::scalar::Scalar;

impl<I, C, O> Driver<I, C, O> {
    /// Stops where `function(t, x)` crosses zero in either direction; see
    /// [`stop_at_crossing`](Self::stop_at_crossing).
    #[must_use]
    pub fn stop_at_zero<F>(self, function: F) -> Driver<I, ZeroCrossing<F>, O> {
        self.stop_at_crossing(Crossing::Either, function)
    }

    /// Stops where `function(t, x)` crosses zero in the direction `crossing`, or reaches it: a terminal
    /// [event](Self::events). For several event functions, `function` returns an array of values and `crossing` is an
    /// array of the same length; [`Outcome::met`] tells which of them stopped the integration. A closure names the type
    /// of the state, as under [`stop_when`](Self::stop_when).
    #[must_use]
    pub fn stop_at_crossing<F, W: Watched>(
        self,
        crossing: W,
        function: F,
    ) -> Driver<I, ZeroCrossing<F, W>, O> {
        self.events(crossing, function)
    }

    /// Watches for events, at which `function(t, x)` crosses zero. Time and value are of the scalar of the integration: with
    /// dual numbers the time of an event has derivatives, and with double-doubles their digits. `events` is an [`Event`]
    /// or, for a function that returns an array of values, an array of the same length. Each says in which direction the function crosses zero,
    /// and whether the integration stops there. The others are seen by the observer, are listed in a
    /// [`Trajectory`](crate::Trajectory), and may be reacted to ([`run_reacting`](Self::run_reacting)). A closure names
    /// the type of the state, as under [`stop_when`](Self::stop_when).
    ///
    /// The function is evaluated at the ends of steps and, where a method has dense output, of eighths of steps
    /// ([`event_samples`](Driver::event_samples)). Where the signs at two neighbouring times differ, a zero is located
    /// between them, to the resolution of time, and the state is that just after it. A zero without a change of sign is
    /// not detected, nor are two between neighbouring times. Where the function is NaN, or zero for a while, the last sign
    /// counts. From zero there is no crossing: a function that reaches zero and stays there is reported once.
    ///
    /// A zero at the initial time is not a crossing, so that an integration can go on from where an event has stopped one.
    #[must_use]
    pub fn events<F, W: Watched>(self, events: W, function: F) -> Driver<I, ZeroCrossing<F, W>, O> {
        self.with_condition(ZeroCrossing {
            function,
            events,
            parts: None,
        })
    }

    /// Watches for events that the model declares, each by its index: `[(Ball::FLOOR, Event::falling())]`. They are
    /// numbered in the order in which they stand here.
    ///
    /// Under the [`Taylor`](crate::Taylor) method, with the clause `taylor` in the declaration, the function of an event is
    /// a polynomial within a step, and all its zeros are found: two that are next to each other, and one without a change
    /// of sign, which counts as reaching zero from its side. What is smaller than 8 machine epsilons times the sum of the
    /// magnitudes of its terms is zero. With other methods, and where an event depends on an external function without
    /// series or the inputs are set by a control law, the functions are sampled as under [`events`](Self::events).
    ///
    /// ```
    /// use lagrangian::prelude::*;
    ///
    /// #[derive(Lagrangian)]
    /// #[lagrangian(
    ///     taylor,
    ///     coordinates(x, y),
    ///     event(floor = y, apex = dot(y)),
    ///     kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    ///     potential = m * g * y,
    /// )]
    /// struct Stone { m: f64, g: f64 }
    ///
    /// let stone = Stone { m: 0.2, g: 10.0 };
    /// let start = State::new(0.0, [0.0, 0.0], [1.0, 20.0]);
    /// let driver = Taylor::new()
    ///     .driver()
    ///     .declared_events([(Stone::FLOOR, Event::falling().terminal()), (Stone::APEX, Event::falling())]);
    /// let flight = driver.sample(&stone.dynamics(), start, &[10.0])?;
    /// assert_eq!(flight.events().len(), 2);
    /// assert!((flight.events()[0].t - 2.0).abs() < 1e-15);
    /// assert!((flight.last().x.q[Stone::X] - 4.0).abs() < 1e-14);
    /// # Ok::<(), PartialTrajectory<_>>(())
    /// ```
    #[must_use]
    pub fn declared_events<const K: usize>(
        self,
        events: [(usize, Event); K],
    ) -> Driver<I, DeclaredEvents<K>, O> {
        self.with_condition(DeclaredEvents {
            events,
            parts: None,
        })
    }

    /// Integrates from `initial` until the time `end`, as [`run_until`](Self::run_until) does, and calls
    /// `reaction(event, t, x, dynamics)` at each [event](Self::events) that is not terminal. It may change the state, and
    /// the dynamics: those of a model that [own it](crate::Lagrangian::into_dynamics) are prepared again when it is
    /// changed.
    ///
    /// Events come in the order of time, simultaneous ones in the order of their indices, before the first of which the
    /// observer has seen them all. From a changed state the method begins anew. The zero to which the reaction was is not
    /// reported again: its event function counts again as soon as it has left its rounding errors. A sample at the time
    /// of a reaction has the state before it.
    ///
    /// Where the reactions to an event come more and more often, as the bounces of a ball do before it is at rest, the
    /// integration ends with [`StopReason::Zeno`](crate::StopReason::Zeno).
    ///
    /// With dual numbers, the time and the state of an event have derivative parts, and those of the motion jump as a
    /// reaction changes the state or the dynamics (the saltation matrix: Leine & Nijmeijer 2004, ch. 7). Of simultaneous
    /// events each sees what those before it have left.
    ///
    /// # Errors
    ///
    /// Any of [`IntegrationError`].
    pub fn run_reacting<S: Scalar, D: Dynamics<S> + ?Sized, F>(
        mut self,
        dynamics: &mut D,
        initial: impl InitialValue<D::State>,
        end: f64,
        reaction: F,
    ) -> Result<Outcome<D::State>, IntegrationError>
    where
        I: Integrator<S, D>,
        C: StopCondition<S, D>,
        O: Observer<D::State>,
        F: FnMut(usize, S, &mut D::State, &mut D) -> Reaction,
    {
        let initial = initial.into_sample();
        let mut system = Reacting { dynamics, reaction };
        let (outcome, result) = self.run_parts(&mut system, &initial, &[end], &mut Uncollected);
        result.map(|()| outcome)
    }

    /// The motion from `initial` at each of `times`, with reactions to events as under
    /// [`run_reacting`](Self::run_reacting).
    ///
    /// # Errors
    ///
    /// Any of [`IntegrationError`], with the samples up to then.
    #[cfg(feature = "alloc")]
    pub fn sample_reacting<S: Scalar, D: Dynamics<S> + ?Sized, F>(
        mut self,
        dynamics: &mut D,
        initial: impl InitialValue<D::State>,
        times: &[f64],
        reaction: F,
    ) -> Result<Trajectory<D::State, S>, PartialTrajectory<D::State, S>>
    where
        I: Integrator<S, D>,
        C: StopCondition<S, D>,
        O: Observer<D::State>,
        F: FnMut(usize, S, &mut D::State, &mut D) -> Reaction,
    {
        self.collect(&mut Reacting { dynamics, reaction }, initial, times)
    }

    /// The motion from `initial` until the time `end`, with reactions to events as under
    /// [`run_reacting`](Self::run_reacting), as a solution that can be asked at any time. Where a reaction has changed the
    /// state, [`DenseSolution::at`] is behind the jump and [`DenseSolution::before`] before it.
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
    /// let mut ball = Ball { m: 0.1, g: 10.0 }.into_dynamics();
    /// let driver = Taylor::new().driver().declared_events([(Ball::FLOOR, Event::falling())]);
    /// // It falls for 1 s, and loses half of its velocity.
    /// let start = State::new(0.0, [5.0], [0.0]);
    /// let solution = driver.solve_reacting(&mut ball, start, 1.5, |_, _, x, _| {
    ///     x.v[0] *= -0.5;
    ///     Reaction::Changed
    /// })?;
    /// let bounce = solution.times().nth_back(1).unwrap();
    /// assert!((bounce - 1.0).abs() < 1e-15);
    /// assert!((solution.before(bounce)?.v[0] + 10.0).abs() < 1e-13);
    /// assert!((solution.at(bounce)?.v[0] - 5.0).abs() < 1e-13);
    /// # Ok::<(), IntegrationError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// Any of [`IntegrationError`], with the solution up to then.
    #[cfg(feature = "alloc")]
    #[allow(clippy::type_complexity)] // The interpolant is that of the method's stepper.
    pub fn solve_reacting<S: Scalar, D: Dynamics<S> + ?Sized, T, F>(
        mut self,
        dynamics: &mut D,
        initial: impl InitialValue<D::State>,
        end: f64,
        reaction: F,
    ) -> Result<
        DenseSolution<D::State, T::Interpolant, S>,
        PartialSolution<D::State, T::Interpolant, S>,
    >
    where
        I: Integrator<S, D, Stepper = T>,
        T: DenseOutput<S, D>,
        C: StopCondition<S, D>,
        O: Observer<D::State>,
        F: FnMut(usize, S, &mut D::State, &mut D) -> Reaction,
    {
        self.collect_steps(&mut Reacting { dynamics, reaction }, initial, end)
    }
}

impl<I, F, W, O> Driver<I, ZeroCrossing<F, W>, O> {
    /// Sets the number of equal parts of each step at whose ends event functions are evaluated: 8 by default, and 1 for
    /// methods without dense output.
    #[must_use]
    pub fn event_samples(mut self, parts: u32) -> Self {
        self.condition.parts = Some(parts);
        self
    }
}

impl<I, O, const K: usize> Driver<I, DeclaredEvents<K>, O> {
    /// Sets the number of equal parts of each step at whose ends event functions are evaluated where they have no series:
    /// 8 by default, and 1 for methods without dense output.
    #[must_use]
    pub fn event_samples(mut self, parts: u32) -> Self {
        self.condition.parts = Some(parts);
        self
    }
}
