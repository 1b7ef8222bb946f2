//! Laws, which set the inputs of a model along its motion.

mod driven;
mod dynamic_feedback;
mod feedback;
mod held;
mod in_lanes;
mod lagged;
mod sampled_feedback;
mod states;

pub use driven::Driven;
pub use dynamic_feedback::DynamicFeedback;
pub use feedback::Feedback;
pub use held::Held;
pub use in_lanes::{LawsInLanes, StatesInLanes};
pub use lagged::Lagged;
pub use sampled_feedback::{Sampled, SampledFeedback};
pub use states::LawStates;

use super::phase::Phase;
use crate::integrate::IntegrationError;
use crate::scalar::Scalar;

/// A law for the inputs of a model with `N` coordinates. The inputs have the type `V`: an `SVector<S, U>` for `U`
/// inputs.
///
/// Problems construct laws from closures and signals ([`Problem::feedback`](crate::Problem::feedback) and related
/// methods), and accept any other law by [`Problem::under`](crate::Problem::under):
///
/// ```
/// use lagrangian::laws::Law;
/// use lagrangian::prelude::*;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), force(x = push))]
/// struct Cart { m: f64, #[lagrangian(input)] push: f64 }
///
/// /// A spring and a damper that an actuator imitates.
/// struct Impedance { stiffness: f64, damping: f64 }
///
/// impl Law<1, SVector<f64, 1>> for Impedance {
///     type States = ();
///
///     fn evaluate(&self, _: &SVector<f64, 1>, _: f64, x: &Phase<f64, 1>) -> (SVector<f64, 1>, ()) {
///         (-self.stiffness * x.q - self.damping * x.v, ())
///     }
/// }
///
/// // Critically damped: x = (1 + t) e^(−t).
/// let cart = Cart { m: 1.0, push: 0.0 };
/// let end = Problem::new(&cart, State::new(0.0, [1.0], [0.0]))
///     .under(Impedance { stiffness: 1.0, damping: 2.0 })
///     .solve(3.0, Dop853::new())?;
/// assert!((end.q[0] - 4.0 * (-3.0_f64).exp()).abs() < 1e-9);
/// # Ok::<(), IntegrationError>(())
/// ```
pub trait Law<const N: usize, V, S: Scalar = f64> {
    /// The states z of the law, which are integrated together with coordinates and velocities: `()` for none, an
    /// `SVector<S, K>` for the `K` states of a controller.
    type States: LawStates<S>;

    /// Whether the inputs depend on coordinates and velocities other than where the law is [updated](Self::update). If
    /// so, angles keep their whole turns, which the law may count.
    const READS_MOTION: bool = true;

    /// Whether the inputs always have the values stored in the model.
    #[doc(hidden)]
    const IS_HELD: bool = false;

    /// Returns the inputs u and the derivative ż; `given` are the inputs that the model has without the law.
    fn evaluate(&self, given: &V, t: S, x: &Phase<S, N, Self::States>) -> (V, Self::States);

    /// Checks the parameters of the law.
    ///
    /// # Errors
    ///
    /// There are none by default.
    fn check(&self) -> Result<(), IntegrationError> {
        Ok(())
    }

    /// Returns the next time at which the law is updated, according to its states; `None` by default.
    fn next_update(&self, z: &Self::States) -> Option<f64> {
        let _ = z;
        None
    }

    /// Updates the states at the time given by [`next_update`](Self::next_update), which returns a later time
    /// afterwards.
    fn update(&self, t: S, x: &mut Phase<S, N, Self::States>) {
        let _ = (t, x);
    }

    /// Calls `then` with the Taylor coefficients of the inputs, from order 0 on, and of the states, from order 1 on.
    ///
    /// The expansion is about a time, in the given unit of time. There are at most 2·`HALF` coefficients of each;
    /// missing ones are 0. Returns `None` by default, if the law depends on the motion.
    fn series<const HALF: usize, R>(
        &self,
        given: &V,
        (t, x): (S, &Phase<S, N, Self::States>),
        unit: S,
        then: impl FnOnce(&[V], &[Self::States]) -> R,
    ) -> Option<R> {
        let _ = (given, t, x, unit, then);
        None
    }
}

/// A law whose [`series`](Law::series) is known, so that [`Taylor`](crate::Taylor) integrates a model under it: held
/// inputs, signals, a sampled controller, or the lag of an actuator that follows one of them.
#[diagnostic::on_unimplemented(
    message = "the Taylor series of the law `{Self}` is not known",
    note = "integrate by `Dop853`, or sample the law: `sampled_feedback(period, [], |x, _| …)`; inputs that are functions of time \
            are signals, `driven_by([signal])`"
)]
pub trait LawSeries<const N: usize, V, S: Scalar = f64>: Law<N, V, S> {}
