//! What a problem is made of: a model, or any dynamics.

use crate::integrate::dynamics::Dynamics;
use crate::scalar::Scalar;

/// What [`Problem::new`](crate::Problem::new) takes: a model, `&model`, or `model` itself, whose parameters reactions can then change;
/// or any [`Dynamics`], owned or borrowed.
///
/// `Kind` tells the implementations apart, and is always inferred.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no equations of motion to integrate",
    note = "a model enters by reference, `Problem::new(&model, start)`; `start` is a `State` with as many coordinates as it has, \
            on its scalar; other systems implement `Dynamics`"
)]
pub trait System<Kind, S: Scalar> {
    /// The differential equations.
    type Dynamics: Dynamics<S, State = Self::State>;
    /// Their state.
    type State;

    /// The differential equations.
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
