//! Plants: systems whose inputs a controller sets.

use nalgebra::SVector;

use super::controlled_by::ControlledBy;
use super::inputs::Inputs;
use super::state::State;
use super::with_controller::WithController;
use crate::linalg::IntoVector;
use crate::scalar::Scalar;

/// A plant: a system whose `U` inputs a controller sets. `#[derive(Lagrangian)]` implements it for every
/// model with inputs.
///
/// A law is evaluated wherever the derivative is: at every stage of every step, those that are rejected
/// included, at the time and the state of the stage. It acts in continuous time, without a hold, and must be a
/// function of its arguments only; the memory of a controller is a state of its own, which
/// [`with_controller`](Self::with_controller) integrates. Where a law is discontinuous or not differentiable, the steps
/// of an adaptive method become short. A sampled controller with a zero-order hold is
/// [`Problem::sampled_feedback`](crate::Problem::sampled_feedback).
///
/// The law is evaluated on [`Scalar`](Self::Scalar); on another one,
/// [`ControlledBy::new`] and [`WithController::new`] take it, with the types of its arguments written.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no inputs for a control law to set",
    note = "mark the fields that it sets `#[lagrangian(input)]`"
)]
pub trait Plant<const N: usize, const U: usize>: Inputs<N, U, Self::Scalar> {
    /// The scalar of its control laws: `f64`, or `T` for a `struct Arm<T: Scalar>`, or what the
    /// declaration names by `scalar = …`.
    type Scalar: Scalar;

    /// The same system under the static feedback u = law(state), which may depend on the time `state.t`.
    /// The law returns an array, an `SVector`, or one number for one input.
    ///
    /// ```
    /// use lagrangian::prelude::*;
    ///
    /// #[derive(Lagrangian)]
    /// #[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), force(x = push))]
    /// struct Cart { m: f64, #[lagrangian(input)] push: f64 }
    ///
    /// // Critically damped: x = (1 + t) e^(−t).
    /// let cart = Cart { m: 1.0, push: 0.0 };
    /// let loop_ = cart.controlled_by(|state| -state.q[Cart::X] - 2.0 * state.v[Cart::X]);
    /// let end = Problem::new(&loop_, State::new(0.0, [1.0], [0.0])).solve(3.0, Dop853::new())?;
    /// assert!((end.q[0] - 4.0 * (-3.0_f64).exp()).abs() < 1e-9);
    /// # Ok::<(), IntegrationError>(())
    /// ```
    fn controlled_by<C, R>(&self, law: C) -> ControlledBy<'_, Self, C, Self::Scalar, N, U>
    where
        C: Fn(&State<Self::Scalar, N>) -> R,
        R: IntoVector<Self::Scalar, U>,
    {
        ControlledBy::new(self, law)
    }

    /// The same system under a controller with `K` states z of its own (dynamic feedback),
    /// (u, ż) = law(state, z): the integral of a PID controller, an observer, a filter, the lag of an
    /// actuator.
    ///
    /// The states are integrated together with the motion, by the same method and to the same
    /// tolerance, and are sampled with it: a state has z in [`controller`](crate::AugmentedPhase::controller).
    ///
    /// ```
    /// use lagrangian::prelude::*;
    ///
    /// #[derive(Lagrangian)]
    /// #[lagrangian(
    ///     coordinates(x),
    ///     kinetic = 0.5 * m * dot(x).powi(2),
    ///     force(x = push + wind),
    /// )]
    /// struct Cart { m: f64, wind: f64, #[lagrangian(input)] push: f64 }
    ///
    /// // A PID controller: z is the integral of the error, which balances the wind.
    /// let cart = Cart { m: 2.0, wind: -3.0, push: 0.0 };
    /// let pid = cart.with_controller(|state, z| {
    ///     let (error, rate) = (1.0 - state.q[Cart::X], -state.v[Cart::X]);
    ///     (6.0 * error + 2.0 * z[0] + 6.0 * rate, error)
    /// });
    /// let zero = SVector::from([0.0]);
    /// let start = At { t: 0.0, x: AugmentedPhase { q: zero, v: zero, controller: zero } };
    /// let end = Problem::new(&pid, start).solve(60.0, Dop853::new())?;
    /// assert!((end.q[Cart::X] - 1.0).abs() < 1e-8);
    /// assert!((2.0 * end.controller[0] - 3.0).abs() < 1e-8);
    /// # Ok::<(), IntegrationError>(())
    /// ```
    fn with_controller<C, R, Z, const K: usize>(
        &self,
        law: C,
    ) -> WithController<'_, Self, C, Self::Scalar, N, U, K>
    where
        C: Fn(&State<Self::Scalar, N>, &SVector<Self::Scalar, K>) -> (R, Z),
        R: IntoVector<Self::Scalar, U>,
        Z: IntoVector<Self::Scalar, K>,
    {
        WithController::new(self, law)
    }
}
