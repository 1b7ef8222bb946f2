//! Equations of motion whose model may change.

use super::common_dynamics::{errors_of_the_model, reduced};
use super::phase::Phase;
use super::quantities::Quantities;
use crate::integrate::Dynamics;
use crate::scalar::Scalar;

/// Lagrange's equations as first-order equations, together with their model, so that a reaction to an event can change
/// its parameters; made by [`Lagrangian::into_dynamics`](crate::Lagrangian::into_dynamics).
///
/// A crane drops its load, and the pendulum goes on with less mass and on a shorter rope:
///
/// ```
/// use lagrangian::prelude::*;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     coordinates(theta),
///     kinetic = 0.5 * m * (l * dot(theta)).powi(2),
///     potential = -m * g * l * cos(theta),
/// )]
/// struct Crane { m: f64, g: f64, l: f64 }
///
/// let crane = Crane { m: 900.0, g: 9.81, l: 12.0 };
/// let mut run = Problem::new(crane, State::new(0.0, [-0.2], [0.0]))
///     .when(|x| x.q[Crane::THETA] - 0.1)
///     .rising()
///     .then_with(|_, crane| crane.change(|crane| (crane.m, crane.l) = (100.0, 11.0)))
///     .start(Dop853::new())?;
/// let end = run.advance(10.0)?;
/// assert_eq!(end.events()[0].event, 0);
/// assert_eq!(run.dynamics().model().m, 100.0);
/// # Ok::<(), IntegrationError>(())
/// ```
#[derive(Debug)]
pub struct OwnedEquations<M, S, const N: usize>
where
    M: Quantities<N, S>,
    S: Scalar,
{
    pub(super) model: M,
    pub(super) inputs: M::Inputs,
    pub(super) prepared: M::Prepared,
}

impl<M, S, const N: usize> OwnedEquations<M, S, N>
where
    M: Quantities<N, S>,
    S: Scalar,
{
    pub(crate) fn new(model: M) -> Self {
        Self {
            inputs: model.inputs(),
            prepared: model.prepare(),
            model,
        }
    }

    /// The model.
    #[must_use]
    pub fn model(&self) -> &M {
        &self.model
    }

    /// Changes the model, and prepares it again. [`then_with`](crate::problem::When::then_with) and
    /// [`Run::change`](crate::problem::Run::change) restart the method afterwards; whoever drives a [`Stepper`](crate::Stepper) restarts it.
    pub fn change<R>(&mut self, change: impl FnOnce(&mut M) -> R) -> R {
        let result = change(&mut self.model);
        (self.inputs, self.prepared) = (self.model.inputs(), self.model.prepare());
        result
    }

    /// The model, back.
    #[must_use]
    pub fn into_model(self) -> M {
        self.model
    }
}

impl<M, S, const N: usize> Clone for OwnedEquations<M, S, N>
where
    M: Quantities<N, S> + Clone,
    S: Scalar,
{
    fn clone(&self) -> Self {
        Self {
            model: self.model.clone(),
            inputs: self.inputs.clone(),
            prepared: self.prepared.clone(),
        }
    }
}

impl<M, S, const N: usize> Dynamics<S> for OwnedEquations<M, S, N>
where
    M: Quantities<N, S>,
    S: Scalar,
{
    type State = Phase<S, N>;

    #[inline]
    fn derivative(&self, t: S, x: &Phase<S, N>) -> Phase<S, N> {
        Phase {
            q: x.v,
            v: self
                .model
                .accelerations(&x.at(t), &self.inputs, &self.prepared),
        }
    }

    #[inline]
    fn reduced(&self, x: &Phase<S, N>, compensation: &Phase<S, N>) -> Phase<S, N> {
        reduced::<M, S, N>(x, compensation)
    }

    errors_of_the_model!();
}
