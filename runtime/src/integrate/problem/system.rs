//! The systems of problems: models, or any dynamics.

use crate::integrate::dynamics::Dynamics;
use crate::scalar::Scalar;

/// The types that [`Problem::new`](crate::Problem::new) accepts as a system.
///
/// This is a model, either `&model`, or `model` itself, so that reactions can change its parameters; or any
/// [`Dynamics`], owned or borrowed. `Kind` distinguishes the implementations, and is always inferred.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no equations of motion to integrate",
    note = "a model enters by reference, `Problem::new(&model, start)`; `start` is a `State` with as many coordinates as it has, \
            on its scalar; other systems implement `Dynamics`"
)]
pub trait System<Kind, S: Scalar> {
    /// The type of the differential equations.
    type Dynamics: Dynamics<S, State = Self::State>;
    /// The type of their state.
    type State;

    /// Converts the system into its differential equations.
    fn into_dynamics(self) -> Self::Dynamics;
}

/// The kind of systems that are [`Dynamics`].
#[derive(Clone, Copy, Debug)]
pub struct ByDynamics;

impl<S: Scalar, D: Dynamics<S>> System<ByDynamics, S> for D {
    type Dynamics = D;
    type State = D::State;

    fn into_dynamics(self) -> D {
        self
    }
}
