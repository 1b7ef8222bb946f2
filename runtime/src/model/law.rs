//! Laws: what sets the inputs of a model along its motions.

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

/// A law for the inputs, of type `V`, of a model with `N` coordinates: an `SVector<S, U>` for `U` inputs.
///
/// Problems make laws of closures and signals ([`Problem::feedback`](crate::Problem::feedback) and its neighbours), and take any other by
/// [`Problem::under`](crate::Problem::under):
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
    /// The states z of the law, which are integrated beside coordinates and velocities: `()` without any, an `SVector<S, K>`
    /// for the `K` states of a controller.
    type States: LawStates<S>;

    /// Whether the inputs depend on coordinates and velocities, other than where the law is [updated](Self::update). Then
    /// angles keep their whole turns, which a law may count.
    const READS_MOTION: bool = true;

    /// Whether the inputs are those that the model has, at any time.
    #[doc(hidden)]
    const IS_HELD: bool = false;

    /// The inputs u and the derivative ż, where the model has the inputs `given` without the law.
    fn evaluate(&self, given: &V, t: S, x: &Phase<S, N, Self::States>) -> (V, Self::States);

    /// An error if a parameter of the law has no meaning.
    ///
    /// # Errors
    ///
    /// None by default.
    fn check(&self) -> Result<(), IntegrationError> {
        Ok(())
    }

    /// The next time at which the law is updated, as far as its states tell; none by default.
    fn next_update(&self, z: &Self::States) -> Option<f64> {
        let _ = z;
        None
    }

    /// Updates the states at the time that [`next_update`](Self::next_update) told, which is a later one from then on.
    fn update(&self, t: S, x: &mut Phase<S, N, Self::States>) {
        let _ = (t, x);
    }

    /// What comes of the Taylor coefficients of the inputs, from order 0 on, and those of the states, from order 1 on, about a
    /// time in this unit of it; there are at most 2·`HALF` of each, and those that are not given are 0. `None` by default: where
    /// the law depends on the motion.
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

/// A law whose [`series`](Law::series) are known, so that [`Taylor`](crate::Taylor) integrates a model under it: held inputs,
/// signals, a sampled controller, and an actuator's lag behind one of them.
#[diagnostic::on_unimplemented(
    message = "the Taylor series of the law `{Self}` is not known",
    note = "integrate by `Dop853`, or sample the law: `sampled_feedback(period, [], |x, _| …)`; inputs that are functions of time \
            are signals, `driven_by([signal])`"
)]
pub trait LawSeries<const N: usize, V, S: Scalar = f64>: Law<N, V, S> {}
