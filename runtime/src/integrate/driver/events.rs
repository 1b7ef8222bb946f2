//! Events, and integrations with reactions to them.

use super::Driver;
use crate::integrate::at::InitialValue;
use crate::integrate::collector::Uncollected;
#[cfg(feature = "alloc")]
use crate::integrate::dense_output::DenseOutput;
#[cfg(feature = "alloc")]
use crate::integrate::dense_solution::DenseSolution;
use crate::integrate::dynamics::Dynamics;
use crate::integrate::error::IntegrationError;
use crate::integrate::event::{
    Both, Crossing, DeclaredEvents, Event, Reaction, Watched, ZeroCrossing,
};
use crate::integrate::integrator::Integrator;
use crate::integrate::observer::Observer;
use crate::integrate::outcome::Outcome;
use crate::integrate::reacting::Reacting;
use crate::integrate::stop_condition::{Extensible, StopCondition};
#[cfg(feature = "alloc")]
use crate::integrate::trajectory::{PartialSolution, PartialTrajectory, Trajectory};
use crate::scalar::Scalar;

impl<I, C, O> Driver<I, C, O> {
    /// Stops where `function(t, x)` crosses zero in either direction; see
    /// [`stop_at_crossing`](Self::stop_at_crossing).
    #[must_use]
    pub fn stop_at_zero<F>(self, function: F) -> Driver<I, C::With<ZeroCrossing<F>>, O>
    where
        C: Extensible,
    {
        self.stop_at_crossing(Crossing::Either, function)
    }

    /// Stops where `function(t, x)` crosses zero in the direction `crossing`, a [`Crossing`] or an [`Event`], or reaches it: a
    /// terminal [event](Self::events), whether or not it says so itself. For several event functions, `function` returns an array of values and `crossing` is an
    /// array of the same length; [`Outcome::met`] tells which of them stopped the integration. A closure names the type
    /// of the state, as under [`stop_when`](Self::stop_when).
    #[must_use]
    pub fn stop_at_crossing<F, W: Watched>(
        self,
        crossing: W,
        function: F,
    ) -> Driver<I, C::With<ZeroCrossing<F, W>>, O>
    where
        C: Extensible,
    {
        self.with_condition(ZeroCrossing {
            function,
            events: crossing,
            stops: true,
            parts: None,
        })
    }

    /// Watches for events, at which `function(t, x)` crosses zero. Time and value are of the scalar of the integration: with
    /// dual numbers the time of an event has derivatives, and with double-doubles their digits. `events` is an [`Event`]
    /// or, for a function that returns an array of values, an array of the same length. Each says in which direction the function crosses zero,
    /// and whether the integration stops there; a [`Crossing`] is an event that does not. The others are seen by the observer, are listed in a
    /// [`Trajectory`](crate::Trajectory), and may be reacted to ([`run_reacting`](Self::run_reacting)). A closure names
    /// the type of the state, as under [`stop_when`](Self::stop_when).
    ///
    /// The function is evaluated at the ends of steps and, where a method has dense output, of eighths of steps
    /// ([`event_samples`](Driver::event_samples)). Where the signs at two neighbouring times differ, a zero is located
    /// between them, to the resolution of time, and the state is that just after it. A zero without a change of sign is
    /// not detected, nor are two between neighbouring times. Where the function is NaN, or zero for a while, the last sign
    /// counts. From zero there is no crossing: a function that reaches zero and stays there is reported once.
    ///
    /// Of two integrations, the second of which goes on from the state at which the first has ended, for whatever reason, each
    /// event is reported by one: by the first if its function has reached zero or changed its sign in that state, and otherwise by
    /// the second. A function is zero there where rounding cannot tell it from zero: where a few roundings of the time and of
    /// the components of the state change it by as much as its value or, for an event in either direction, where it changes its
    /// sign within the resolution of time. The first integration reports that it has reached zero, and the second leaves zero,
    /// which is no crossing; so it is at any initial time. Within an integration, too, a value nearer to zero than that does not
    /// say that the sign has changed.
    ///
    /// What was set before counts as well: see [`stop_when`](Self::stop_when).
    #[must_use]
    pub fn events<F, W: Watched>(
        self,
        events: W,
        function: F,
    ) -> Driver<I, C::With<ZeroCrossing<F, W>>, O>
    where
        C: Extensible,
    {
        self.with_condition(ZeroCrossing {
            function,
            events,
            stops: false,
            parts: None,
        })
    }

    /// Watches for events that the model declares, each by its index: `[(Ball::FLOOR, Event::falling())]`. They are
    /// numbered in the order in which they stand here, behind conditions and events that were set before
    /// ([`stop_when`](Self::stop_when)). To which of two integrations an event belongs is decided as for other
    /// [events](Self::events).
    ///
    /// Under the [`Taylor`](crate::Taylor) method, with the clause `taylor` in the declaration, the function of an event is
    /// a polynomial within a step, and all its zeros are found: two that are next to each other, and one without a change
    /// of sign, which counts as reaching zero from its side. What is smaller than 8 machine epsilons times the sum of the
    /// magnitudes of its terms is zero, and so is what a few roundings of the motion make of terms that cancel: √(x² + y²) − 1 on the
    /// unit circle has no zeros, while a small function whose terms do not cancel has all of its own. With other methods, and
    /// where an event depends on an external function without series or the inputs are set by a control law, the functions are
    /// sampled as under [`events`](Self::events).
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
    ) -> Driver<I, C::With<DeclaredEvents<K>>, O>
    where
        C: Extensible,
    {
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
        let initial = initial.into_initial();
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

/// Sets the number of parts of steps for the events that were set last.
macro_rules! event_samples {
    ($([$($parameter:tt)*] $conditions:ty, $last:ident => $place:expr;)*) => {$(
        impl<I, O, $($parameter)*> Driver<I, $conditions, O> {
            /// Sets the number of equal parts of each step at whose ends the functions of the events that were set last are
            /// evaluated, where they have no series: 8 by default, and 1 for methods without dense output.
            #[must_use]
            pub fn event_samples(mut self, parts: u32) -> Self {
                let $last = &mut self.condition;
                $place.parts = Some(parts);
                self
            }
        }
    )*};
}

event_samples! {
    [F, W] ZeroCrossing<F, W>, last => last;
    [const K: usize] DeclaredEvents<K>, last => last;
    [A, F, W] Both<A, ZeroCrossing<F, W>>, last => last.1;
    [A, const K: usize] Both<A, DeclaredEvents<K>>, last => last.1;
}
