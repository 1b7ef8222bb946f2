//! Problems of models whose inputs follow a law.

use nalgebra::SVector;

use super::augmented_phase::AugmentedPhase;
use super::controlled_by::ControlledBy;
use super::driven_by::DrivenBy;
use super::equations_of_motion::EquationsOfMotion;
use super::inputs::Inputs;
use super::quantities::Quantities;
use super::sampled_feedback::SampledFeedback;
use super::sampled_phase::SampledPhase;
use super::signals::Signals;
use super::state::State;
use super::with_controller::WithController;
use crate::integrate::{At, NothingWatched, Problem};
use crate::linalg::IntoVector;
use crate::scalar::Scalar;

/// The law of the inputs comes directly behind `Problem::new`, before events, conditions and observers: it may add components to the
/// state.
impl<'a, M, S, K, C, R, O, const N: usize> Problem<S, EquationsOfMotion<'a, M, S, N>, K, C, R, O>
where
    M: Quantities<N, S>,
    S: Scalar,
{
    /// Static state feedback: the inputs are a function of time, coordinates and velocities.
    ///
    /// The function returns one number for a model with one input, or as many as there are, in an array or a vector.
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
    ) -> Problem<S, ControlledBy<'a, M, F, S, N, U>, K, C, R, O>
    where
        (C, R, O): NothingWatched,
        M: Inputs<N, U, S>,
        F: Fn(&State<S, N>) -> A,
        A: IntoVector<S, U>,
    {
        self.with_dynamics(|dynamics, start| (ControlledBy::new(dynamics.model, law), start))
    }

    /// Dynamic feedback: a controller with states z of its own, from `initial` on. The function returns the inputs and ż.
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
    /// // The integral of the error leaves none, whatever the stiffness of the spring is.
    /// let end = Problem::new(&slider, State::new(0.0, [0.0], [0.0]))
    ///     .feedback_with_states([0.0], |x, z| {
    ///         let error = 1.0 - x.q[0];
    ///         (20.0 * error + 10.0 * z[0] - 5.0 * x.v[0], error)
    ///     })
    ///     .solve(60.0, Dop853::new())?;
    /// assert!((end.q[0] - 1.0).abs() < 1e-8);
    /// # Ok::<(), IntegrationError>(())
    /// ```
    #[allow(clippy::type_complexity)] // The law decides on the state.
    pub fn feedback_with_states<I, F, A, Z, const U: usize, const J: usize>(
        self,
        initial: I,
        law: F,
    ) -> Problem<S, WithController<'a, M, F, S, N, U, J>, K, C, R, O>
    where
        (C, R, O): NothingWatched,
        M: Inputs<N, U, S>,
        I: IntoVector<S, J>,
        F: Fn(&State<S, N>, &SVector<S, J>) -> (A, Z),
        A: IntoVector<S, U>,
        Z: IntoVector<S, J>,
    {
        self.with_dynamics(|dynamics, At { t, x }| {
            let x = AugmentedPhase {
                q: x.q,
                v: x.v,
                controller: initial.into_vector(),
            };
            (WithController::new(dynamics.model, law), At { t, x })
        })
    }

    /// Sampled feedback: a controller with a memory, from `initial` on, that is evaluated at the start and once each `period` from
    /// there. Its inputs are held in between (zero-order hold), and steps end where it is evaluated.
    ///
    /// Inputs and memory are part of the state, [`SampledPhase`]: samples and checkpoints have them.
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
    /// assert!((end.inputs[0] - 4.0).abs() < 1e-2);
    /// assert!((slider.potential_energy(&end.state()) - 2.0).abs() < 1e-2);
    /// # Ok::<(), IntegrationError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// A period that is not a positive finite number is an error of the integration,
    /// [`InvalidUpdate`](crate::IntegrationError::InvalidUpdate).
    pub fn sampled_feedback<I, F, A, const U: usize, const J: usize>(
        self,
        period: f64,
        initial: I,
        law: F,
    ) -> Problem<S, SampledFeedback<'a, M, F, S, N, U, J>, K, C, R, O>
    where
        (C, R, O): NothingWatched,
        M: Inputs<N, U, S>,
        I: IntoVector<S, J>,
        F: Fn(&State<S, N>, &mut SVector<S, J>) -> A,
        A: IntoVector<S, U>,
    {
        self.with_dynamics(|dynamics, At { t, x }| {
            let x = SampledPhase::before_sampling(x, initial.into_vector());
            let sampled = SampledFeedback::new(dynamics.model, law, t, period);
            (sampled, At { t, x })
        })
    }

    /// The inputs are functions of time, with their Taylor series: an array of [signals](crate::Signal), or a tuple of
    /// different ones.
    ///
    /// ```
    /// use lagrangian::{Sinusoid, prelude::*};
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
    ) -> Problem<S, DrivenBy<'a, M, I, S, N, U>, K, C, R, O>
    where
        (C, R, O): NothingWatched,
        M: Inputs<N, U, S>,
        I: Signals<S, U>,
    {
        self.with_dynamics(|dynamics, start| (DrivenBy::new(dynamics.model, signals), start))
    }
}
