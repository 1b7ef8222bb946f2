//! Problems for models whose inputs follow a law.

#![allow(clippy::type_complexity)] // The law of a problem is in its type, as its settings are.

use nalgebra::SVector;

use super::equations_of_motion::{EquationsOfMotion, InputsOf};
use super::inputs::Inputs;
use super::lagrangian::Lagrangian;
use super::law::{Driven, DynamicFeedback, Feedback, Lagged, Law, Sampled, SampledFeedback};
use super::phase::Phase;
use super::signals::Signals;
use super::state::State;
use crate::integrate::{At, NothingWatched, Problem};
use crate::linalg::IntoVector;
use crate::scalar::Scalar;

/// The law of the inputs is given directly after `Problem::new`, before events, conditions and observers, since it may
/// add components to the state.
impl<M, S, K, C, R, O, const N: usize> Problem<S, EquationsOfMotion<M, S, N>, K, C, R, O>
where
    M: Lagrangian<N, S>,
    S: Scalar,
{
    /// Sets static state feedback: the inputs are a function of time, coordinates and velocities.
    ///
    /// The function returns a number for a model with one input, or as many numbers as there are inputs, as an array or
    /// a vector.
    ///
    /// ```
    /// use lagrangian::prelude::*;
    ///
    /// #[derive(Lagrangian)]
    /// #[lagrangian(
    ///     coordinates(x),
    ///     kinetic = 0.5 * m * dot(x).powi(2),
    ///     potential = 0.5 * k * x.powi(2),
    ///     force(x = push),
    /// )]
    /// struct Slider { m: f64, k: f64, #[lagrangian(input)] push: f64 }
    ///
    /// let slider = Slider { m: 1.0, k: 4.0, push: 0.0 };
    /// // It is held at x = 1 by an actuator that saturates.
    /// let end = Problem::new(&slider, State::new(0.0, [0.0], [0.0]))
    ///     .feedback(|x| (4.0 - 10.0 * (x.q[0] - 1.0) - 5.0 * x.v[0]).clamp(-8.0, 8.0))
    ///     .solve(20.0, Dop853::new())?;
    /// assert!((end.q[0] - 1.0).abs() < 1e-8);
    /// # Ok::<(), IntegrationError>(())
    /// ```
    pub fn feedback<F, A, const U: usize>(
        self,
        law: F,
    ) -> Problem<S, EquationsOfMotion<M, S, N, Feedback<F, U>>, K, C, R, O>
    where
        (C, R, O): NothingWatched,
        M: Lagrangian<N, S, Model: Inputs<N, U, S>>,
        F: Fn(&State<S, N>) -> A,
        A: IntoVector<S, U>,
    {
        self.under(Feedback(law))
    }

    /// Sets dynamic feedback by a controller with states z of its own, starting from `initial`. The function returns
    /// the inputs and ż.
    ///
    /// ```
    /// use lagrangian::prelude::*;
    /// # #[derive(Lagrangian)]
    /// # #[lagrangian(
    /// #     coordinates(x),
    /// #     kinetic = 0.5 * m * dot(x).powi(2),
    /// #     potential = 0.5 * k * x.powi(2),
    /// #     force(x = push),
    /// # )]
    /// # struct Slider { m: f64, k: f64, #[lagrangian(input)] push: f64 }
    ///
    /// let slider = Slider { m: 1.0, k: 4.0, push: 0.0 };
    /// // Integrating the error removes it, whatever the stiffness of the spring is.
    /// let end = Problem::new(&slider, State::new(0.0, [0.0], [0.0]))
    ///     .feedback_with_states([0.0], |x, z| {
    ///         let error = 1.0 - x.q[0];
    ///         (20.0 * error + 10.0 * z[0] - 5.0 * x.v[0], error)
    ///     })
    ///     .solve(60.0, Dop853::new())?;
    /// assert!((end.q[0] - 1.0).abs() < 1e-8);
    /// # Ok::<(), IntegrationError>(())
    /// ```
    pub fn feedback_with_states<I, F, A, Z, const U: usize, const J: usize>(
        self,
        initial: I,
        law: F,
    ) -> Problem<S, EquationsOfMotion<M, S, N, DynamicFeedback<F, U, J>>, K, C, R, O>
    where
        (C, R, O): NothingWatched,
        M: Lagrangian<N, S, Model: Inputs<N, U, S>>,
        I: IntoVector<S, J>,
        F: Fn(&State<S, N>, &SVector<S, J>) -> (A, Z),
        A: IntoVector<S, U>,
        Z: IntoVector<S, J>,
    {
        let law = DynamicFeedback(law);
        self.under_law_with_states(|_| law, initial.into_vector())
    }

    /// Sets sampled feedback by a controller with a memory, starting from `initial`.
    ///
    /// The controller is evaluated at the start and then once per `period`. In between, its inputs are held (zero-order
    /// hold), and steps end where it is evaluated. It is evaluated only forwards in time: backwards, the inputs keep
    /// their values.
    ///
    /// Inputs and memory are part of the state, in [`z`](Phase::z), and hence of samples and checkpoints.
    ///
    /// ```
    /// use lagrangian::prelude::*;
    /// # #[derive(Lagrangian)]
    /// # #[lagrangian(
    /// #     taylor,
    /// #     coordinates(x),
    /// #     kinetic = 0.5 * m * dot(x).powi(2),
    /// #     potential = 0.5 * k * x.powi(2),
    /// #     force(x = push),
    /// # )]
    /// # struct Slider { m: f64, k: f64, #[lagrangian(input)] push: f64 }
    ///
    /// let slider = Slider { m: 1.0, k: 4.0, push: 0.0 };
    /// // Fifty times a second, with the sum of the errors in its memory.
    /// let end = Problem::new(&slider, State::new(0.0, [0.0], [0.0]))
    ///     .sampled_feedback(0.02, [0.0], |x, sum| {
    ///         let error = 1.0 - x.q[0];
    ///         sum[0] += 0.02 * error;
    ///         20.0 * error + 10.0 * sum[0] - 5.0 * x.v[0]
    ///     })
    ///     .solve(20.0, Taylor::new())?;
    /// assert!((end.q[0] - 1.0).abs() < 1e-3);
    /// assert!((end.z.inputs[0] - 4.0).abs() < 1e-2);
    /// assert!((slider.potential_energy(&end.state()) - 2.0).abs() < 1e-2);
    /// # Ok::<(), IntegrationError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// If the period is not a positive finite number, the integration fails with
    /// [`InvalidPeriod`](crate::IntegrationError::InvalidPeriod).
    pub fn sampled_feedback<I, F, A, const U: usize, const J: usize>(
        self,
        period: f64,
        initial: I,
        law: F,
    ) -> Problem<S, EquationsOfMotion<M, S, N, SampledFeedback<F, U, J>>, K, C, R, O>
    where
        (C, R, O): NothingWatched,
        M: Lagrangian<N, S, Model: Inputs<N, U, S>>,
        I: IntoVector<S, J>,
        F: Fn(&State<S, N>, &mut SVector<S, J>) -> A,
        A: IntoVector<S, U>,
    {
        let begin = |start| SampledFeedback { law, start, period };
        self.under_law_with_states(begin, Sampled::before(initial.into_vector()))
    }

    /// Sets the inputs to functions of time with Taylor series: an array of [signals](crate::signals), or a tuple of
    /// different ones.
    ///
    /// ```
    /// use lagrangian::{prelude::*, signals::Sinusoid};
    /// # #[derive(Lagrangian)]
    /// # #[lagrangian(
    /// #     taylor,
    /// #     coordinates(x),
    /// #     kinetic = 0.5 * m * dot(x).powi(2),
    /// #     potential = 0.5 * k * x.powi(2),
    /// #     force(x = push),
    /// # )]
    /// # struct Slider { m: f64, k: f64, #[lagrangian(input)] push: f64 }
    ///
    /// let slider = Slider { m: 1.0, k: 4.0, push: 0.0 };
    /// let push = Sinusoid { amplitude: 3.0, angular_frequency: 1.0, phase: 0.0 };
    /// // x = sin t − ½ sin 2t
    /// let end = Problem::new(&slider, State::new(0.0, [0.0], [0.0]))
    ///     .driven_by([push])
    ///     .solve(1.0, Taylor::new())?;
    /// assert!((end.q[0] - (1.0_f64.sin() - 0.5 * 2.0_f64.sin())).abs() < 1e-14);
    /// # Ok::<(), IntegrationError>(())
    /// ```
    pub fn driven_by<I, const U: usize>(
        self,
        signals: I,
    ) -> Problem<S, EquationsOfMotion<M, S, N, Driven<I, U>>, K, C, R, O>
    where
        (C, R, O): NothingWatched,
        M: Lagrangian<N, S, Model: Inputs<N, U, S>>,
        I: Signals<S, U>,
    {
        self.under(Driven(signals))
    }

    /// Lets the inputs follow a [`Law`] without states.
    pub fn under<L>(self, law: L) -> Problem<S, EquationsOfMotion<M, S, N, L>, K, C, R, O>
    where
        (C, R, O): NothingWatched,
        L: Law<N, InputsOf<M, S, N>, S, States = ()>,
    {
        self.under_law_with_states(|_| law, ())
    }

    /// Lets the inputs follow a law that is made for the start time, with these initial states.
    fn under_law_with_states<L>(
        self,
        law: impl FnOnce(f64) -> L,
        z: L::States,
    ) -> Problem<S, EquationsOfMotion<M, S, N, L>, K, C, R, O>
    where
        (C, R, O): NothingWatched,
        L: Law<N, InputsOf<M, S, N>, S>,
    {
        self.with_dynamics(|dynamics, At { t, x }| {
            let equations = EquationsOfMotion::under(dynamics.into_model(), law(t));
            (equations, At { t, x: x.with(z) })
        })
    }
}

impl<M, S, K, C, R, O, L, const N: usize> Problem<S, EquationsOfMotion<M, S, N, L>, K, C, R, O>
where
    M: Lagrangian<N, S>,
    S: Scalar,
    L: Law<N, InputsOf<M, S, N>, S>,
{
    /// Lets actuators follow the law with first-order lags u̇ = (a − u)/τ, where a is the output of the law.
    ///
    /// The time constants τ must be positive; the inputs start at the values of the model. The lagged inputs are
    /// states, `z.1`, after the states of the law.
    ///
    /// ```
    /// use lagrangian::prelude::*;
    ///
    /// #[derive(Lagrangian)]
    /// #[lagrangian(
    ///     taylor,
    ///     coordinates(x),
    ///     kinetic = 0.5 * m * dot(x).powi(2),
    ///     force(x = push),
    /// )]
    /// struct Cart { m: f64, #[lagrangian(input)] push: f64 }
    ///
    /// // The force 1 is commanded at once, and follows with a time constant of 0.5 s: v = t − (1 − e^(−2t))/2.
    /// let cart = Cart { m: 1.0, push: 0.0 };
    /// let end = Problem::new(&cart, State::new(0.0, [0.0], [0.0]))
    ///     .driven_by([lagrangian::signals::Constant(1.0)])
    ///     .lagged([0.5])
    ///     .solve(2.0, Taylor::new())?;
    /// assert!((end.v[0] - (2.0 - 0.5 * (1.0 - (-4.0_f64).exp()))).abs() < 1e-14);
    /// assert!((end.z.1[0] - (1.0 - (-4.0_f64).exp())).abs() < 1e-14);
    /// # Ok::<(), IntegrationError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// If a time constant is not a positive finite number, the integration fails with
    /// [`InvalidTimeConstant`](crate::IntegrationError::InvalidTimeConstant).
    pub fn lagged<const U: usize>(
        self,
        time_constants: impl IntoVector<S, U>,
    ) -> Problem<S, EquationsOfMotion<M, S, N, Lagged<L, S, U>>, K, C, R, O>
    where
        (C, R, O): NothingWatched,
        M: Lagrangian<N, S, Model: Inputs<N, U, S>>,
    {
        let time_constants = time_constants.into_vector();
        self.with_dynamics(|dynamics, At { t, x }| {
            let EquationsOfMotion {
                model, law, inputs, ..
            } = dynamics;
            let law = Lagged {
                law,
                time_constants,
            };
            let Phase { q, v, z } = x;
            let x = Phase {
                q,
                v,
                z: (z, inputs),
            };
            (EquationsOfMotion::under(model, law), At { t, x })
        })
    }
}
