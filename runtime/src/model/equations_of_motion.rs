//! Lagrange's equations as a system of first-order differential equations.

use nalgebra::SVector;

use super::common_dynamics::{errors_of_the_model, reduced};
use super::phase::Phase;
use super::quantities::Quantities;
use super::state::State;
use crate::integrate::Dynamics;
use crate::scalar::Scalar;

/// Lagrange's equations as first-order equations (q, q̇)˙ = (q̇, q̈); made by
/// [`Lagrangian::dynamics`](crate::Lagrangian::dynamics).
///
/// The quantities that depend on parameters alone are computed when it is made: a controller that evaluates the model in its
/// loop asks it for [`accelerations`](Self::accelerations) and [`inverse_dynamics`](Self::inverse_dynamics).
///
/// # Parallel integrations
///
/// Integrations do not change it, so that threads can share it. A parallel iterator, such as rayon's
/// `amplitudes.par_iter().map(|amplitude| …)`, does the same as the threads here:
///
/// ```
/// use lagrangian::prelude::*;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     coordinates(theta),
///     kinetic = 0.5 * m * l.powi(2) * dot(theta).powi(2),
///     potential = -m * g * l * cos(theta),
/// )]
/// struct Pendulum { m: f64, g: f64, l: f64 }
///
/// let pendulum = Pendulum { m: 1.0, g: 9.81, l: 1.0 };
/// let dynamics = pendulum.dynamics();
/// let swing = &|amplitude: f64| {
///     let start = State::new(0.0, [amplitude], [0.0]);
///     Problem::new(&dynamics, start).solve(10.0, Dop853::new())
/// };
/// let amplitudes = [0.5, 1.0, 1.5, 2.0];
/// let ends = std::thread::scope(|scope| {
///     let threads = amplitudes.map(|amplitude| scope.spawn(move || swing(amplitude)));
///     threads.map(|thread| thread.join().expect("an integration does not panic"))
/// });
/// for (end, amplitude) in ends.into_iter().zip(amplitudes) {
///     assert_eq!(end?, swing(amplitude)?);
/// }
/// # Ok::<(), IntegrationError>(())
/// ```
///
/// A model on a scalar of several SIMD lanes integrates several motions in one thread, with the steps of the
/// most demanding one.
#[derive(Debug)]
pub struct EquationsOfMotion<'a, M, S, const N: usize>
where
    M: Quantities<N, S> + ?Sized,
    S: Scalar,
{
    pub(super) model: &'a M,
    pub(super) inputs: M::Inputs,
    pub(super) prepared: M::Prepared,
}

impl<'a, M, S, const N: usize> EquationsOfMotion<'a, M, S, N>
where
    M: Quantities<N, S> + ?Sized,
    S: Scalar,
{
    pub(crate) fn new(model: &'a M, inputs: M::Inputs) -> Self {
        Self {
            model,
            inputs,
            prepared: model.prepare(),
        }
    }

    /// The accelerations q̈: [`Lagrangian::accelerations`](crate::Lagrangian::accelerations).
    #[inline]
    pub fn accelerations(&self, state: &State<S, N>) -> SVector<S, N> {
        self.model
            .accelerations(state, &self.inputs, &self.prepared)
    }

    /// The forces M q̈ − f: [`Lagrangian::inverse_dynamics`](crate::Lagrangian::inverse_dynamics).
    #[inline]
    pub fn inverse_dynamics(
        &self,
        state: &State<S, N>,
        accelerations: &SVector<S, N>,
    ) -> SVector<S, N> {
        self.model
            .inverse_dynamics(state, &self.inputs, accelerations, &self.prepared)
    }
}

impl<M, S, const N: usize> Clone for EquationsOfMotion<'_, M, S, N>
where
    M: Quantities<N, S> + ?Sized,
    S: Scalar,
{
    fn clone(&self) -> Self {
        Self {
            model: self.model,
            inputs: self.inputs.clone(),
            prepared: self.prepared.clone(),
        }
    }
}

impl<M, S, const N: usize> Dynamics<S> for EquationsOfMotion<'_, M, S, N>
where
    M: Quantities<N, S> + ?Sized,
    S: Scalar,
{
    type State = Phase<S, N>;

    #[inline]
    fn derivative(&self, t: S, x: &Phase<S, N>) -> Phase<S, N> {
        Phase {
            q: x.v,
            v: self.accelerations(&x.at(t)),
        }
    }

    #[inline]
    fn reduced(&self, x: &Phase<S, N>, compensation: &Phase<S, N>) -> Phase<S, N> {
        reduced::<M, S, N>(x, compensation)
    }

    errors_of_the_model!();
}
