//! Lagrange's equations as a system of first-order differential equations.

use nalgebra::SVector;

use super::generalized_coordinates::GeneralizedCoordinates;
use super::lagrangian::Lagrangian;
use super::law::{Held, Law};
use super::phase::Phase;
use super::poles::pole_between;
use super::quantities::Quantities;
use super::singular_configuration::Configuration;
use super::state::State;
use super::whole_periods::{is_large, less_whole_periods};
use crate::integrate::{ComponentName, Dynamics, IntegrationError, Projection, Singularity};
use crate::linalg::{ErrorTolerance, VectorSpace as _};
use crate::scalar::Scalar;

/// The inputs of a model.
pub(super) type InputsOf<M, S, const N: usize> =
    <<M as Lagrangian<N, S>>::Model as Quantities<N, S>>::Inputs;

/// The quantities that depend only on the parameters of a model.
type PreparedOf<M, S, const N: usize> =
    <<M as Lagrangian<N, S>>::Model as Quantities<N, S>>::Prepared;

/// Lagrange's equations as first-order equations (q, q̇)˙ = (q̇, q̈); constructed by
/// [`Lagrangian::dynamics`](crate::Lagrangian::dynamics).
///
/// The model is owned or a reference, and a law `L` sets its inputs. Quantities that depend only on parameters are
/// computed once, at construction. A controller that evaluates the model in its loop calls
/// [`accelerations`](Self::accelerations) and [`inverse_dynamics`](Self::inverse_dynamics).
///
/// # A model that changes
///
/// A reaction to an event can change the parameters of an owned model: a crane drops its load, and the pendulum
/// continues with less mass and on a shorter rope.
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
///
/// # Parallel integrations
///
/// Integrations do not change the equations, so that threads can share them. A parallel iterator, such as rayon's
/// `amplitudes.par_iter().map(|amplitude| …)`, does what the threads do here:
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
/// A model on a scalar with several SIMD lanes integrates several motions in one thread, with the steps of the most
/// demanding motion.
#[derive(Clone, Debug)]
pub struct EquationsOfMotion<M, S, const N: usize, L = Held>
where
    M: Lagrangian<N, S>,
    S: Scalar,
{
    pub(super) model: M,
    pub(super) inputs: InputsOf<M, S, N>,
    pub(super) prepared: PreparedOf<M, S, N>,
    pub(super) law: L,
}

impl<M, S, const N: usize> EquationsOfMotion<M, S, N>
where
    M: Lagrangian<N, S>,
    S: Scalar,
{
    pub(crate) fn new(model: M) -> Self {
        Self::under(model, Held)
    }

    /// Returns the accelerations q̈; see [`Lagrangian::accelerations`](crate::Lagrangian::accelerations).
    #[inline]
    pub fn accelerations(&self, state: &State<S, N>) -> SVector<S, N> {
        self.model
            .model()
            .accelerations(state, &self.inputs, &self.prepared)
    }

    /// Returns the forces M q̈ − f; see [`Lagrangian::inverse_dynamics`](crate::Lagrangian::inverse_dynamics).
    #[inline]
    pub fn inverse_dynamics(
        &self,
        state: &State<S, N>,
        accelerations: &SVector<S, N>,
    ) -> SVector<S, N> {
        self.model
            .model()
            .inverse_dynamics(state, &self.inputs, accelerations, &self.prepared)
    }
}

impl<M, S, const N: usize, L> EquationsOfMotion<M, S, N, L>
where
    M: Lagrangian<N, S>,
    S: Scalar,
{
    /// Creates the equations of motion under a law.
    pub(crate) fn under(model: M, law: L) -> Self {
        Self {
            inputs: Lagrangian::inputs(&model),
            prepared: model.model().prepare(),
            model,
            law,
        }
    }

    /// Changes the model and prepares it again.
    ///
    /// [`then_with`](crate::problem::When::then_with) and [`Run::change`](crate::problem::Run::change) restart the
    /// method afterwards; code that drives a [`Stepper`](crate::Stepper) has to restart it.
    pub fn change<R>(&mut self, change: impl FnOnce(&mut M) -> R) -> R
    where
        M: Quantities<N, S>,
    {
        let result = change(&mut self.model);
        self.inputs = Lagrangian::inputs(&self.model);
        self.prepared = self.model.model().prepare();
        result
    }

    /// Returns the model.
    pub fn model(&self) -> &M {
        &self.model
    }

    /// Returns the model and drops the equations.
    pub fn into_model(self) -> M {
        self.model
    }

    /// Returns the law of the inputs.
    pub fn law(&self) -> &L {
        &self.law
    }

    /// Returns what is singular or regular at a time.
    #[inline]
    fn configuration<Z>(&self, t: S, x: &Phase<S, N, Z>) -> Configuration<'_, M::Model, S, N> {
        Configuration {
            model: self.model.model(),
            prepared: &self.prepared,
            state: x.at_time(t),
        }
    }
}

impl<M, S, const N: usize, L> EquationsOfMotion<M, S, N, L>
where
    M: Lagrangian<N, S>,
    S: Scalar,
    L: Law<N, InputsOf<M, S, N>, S>,
{
    /// Returns the inputs at a state.
    pub fn inputs(&self, state: &State<S, N, L::States>) -> InputsOf<M, S, N> {
        self.law.evaluate(&self.inputs, state.t, &state.x).0
    }
}

impl<M, S, const N: usize, L> Dynamics<S> for EquationsOfMotion<M, S, N, L>
where
    M: Lagrangian<N, S>,
    S: Scalar,
    L: Law<N, InputsOf<M, S, N>, S>,
{
    type State = Phase<S, N, L::States>;

    #[inline]
    fn derivative(&self, t: S, x: &Self::State) -> Self::State {
        let (inputs, z) = self.law.evaluate(&self.inputs, t, x);
        let model = self.model.model();
        Phase {
            q: x.v,
            v: model.accelerations(&x.at_time(t), &inputs, &self.prepared),
            z,
        }
    }

    /// The size of an angle, which is periodic, is 1. The size of another ignorable coordinate, whose value does not
    /// matter, is |q̇ᵢ| over the rate.
    #[inline]
    fn allowed_error(&self, x: &Self::State, tolerance: &ErrorTolerance<S>) -> Self::State {
        let time = S::one() / tolerance.rate;
        let size = |i: usize| {
            if M::ANGLES[i] {
                S::one()
            } else if M::IGNORABLE[i] {
                x.v[i].abs() * time
            } else {
                x.q[i].abs()
            }
        };
        Phase {
            q: SVector::from_fn(|i, _| tolerance.of_coordinate(size(i))),
            v: x.v.map(|v| tolerance.of_velocity(v.abs())),
            z: x.z.allowed_error(tolerance),
        }
    }

    #[inline]
    fn rounding_sizes(&self, t: S, x: &Self::State, sizes: &Self::State) -> Option<Self::State> {
        let (model, phase) = (self.model.model(), Phase::new(sizes.q, sizes.v));
        let found = model.sizes_in_metric(&x.at_time(t), &self.prepared, &phase)?;
        Some(Phase {
            q: found.q,
            v: found.v,
            z: sizes.z.clone(),
        })
    }

    /// Subtracts whole periods from angles, unless a law reads them.
    #[inline]
    fn reduced(&self, x: &Self::State, compensation: &Self::State) -> Self::State {
        let mut reduced = x.clone();
        if L::READS_MOTION {
            return reduced;
        }
        for (i, angle) in reduced.q.iter_mut().enumerate() {
            let period = M::PERIODS[i];
            if period > 0 && !M::IGNORABLE[i] && is_large(*angle) {
                *angle = less_whole_periods(*angle, compensation.q[i], period);
            }
        }
        reduced
    }

    #[inline]
    fn singularity(&self, t: S, x: &Self::State, min_pivot: f64) -> Option<Singularity> {
        self.configuration(t, x).singularity(min_pivot)
    }

    #[inline]
    fn singularity_in_motion(&self, t: S, x: &Self::State, min_pivot: f64) -> Option<Singularity> {
        self.configuration(t, x).singularity_in_motion(min_pivot)
    }

    #[inline]
    fn singularity_between(
        &self,
        before: &Self::State,
        (t, after): (S, &Self::State),
    ) -> Option<Singularity> {
        pole_between::<M::Model, S, N>(&before.q, &after.at_time(t))
    }

    fn vanishing_inertia(&self, t: S, x: &Self::State) -> Option<Singularity> {
        self.configuration(t, x).vanishing_inertia()
    }

    fn vanishing_inertia_in_lane(&self, lane: usize, t: S, x: &Self::State) -> Option<Singularity> {
        self.configuration(t, x).vanishing_inertia_in_lane(lane)
    }

    fn check(&self) -> Result<(), IntegrationError> {
        if let Some((constraint, compliance)) =
            self.model.model().invalid_compliance(&self.prepared)
        {
            return Err(IntegrationError::InvalidCompliance {
                constraint: self.constraint_name(constraint),
                compliance,
            });
        }
        self.law.check()
    }

    #[inline]
    fn begin(&mut self, t: S, x: &Self::State) {
        let model = self.model.model();
        model.fix_rank(&x.at_time(t), &mut self.prepared);
    }

    fn next_update(&self, x: &Self::State) -> Option<f64> {
        self.law.next_update(&x.z)
    }

    fn update(&self, t: S, x: &mut Self::State) {
        self.law.update(t, x);
    }

    #[inline]
    fn project(&self, t: S, x: &Self::State) -> Option<Projection<S, Self::State>> {
        let model = self.model.model();
        let found = model.project(&x.at_time(t), &self.prepared)?;
        Some(found.map(|phase| phase.with(x.z.clone())))
    }

    fn constraint_sine(&self, t: S, x: &Self::State) -> Option<S> {
        let model = self.model.model();
        model.constraint_sine(&x.at_time(t), &self.prepared)
    }

    fn violated_constraint(&self, t: S, x: &Self::State) -> Option<(usize, S)> {
        let model = self.model.model();
        model.violated_constraint(&x.at_time(t), &self.prepared)
    }

    fn constraint_name(&self, index: usize) -> &'static str {
        let names = <M::Model as Quantities<N, S>>::CONSTRAINTS;
        names.get(index).copied().unwrap_or("?")
    }

    fn component_name(&self, index: usize) -> ComponentName {
        component_name::<M, N>(index)
    }
}

/// Returns the name of a component of a phase.
fn component_name<M: GeneralizedCoordinates<N> + ?Sized, const N: usize>(
    index: usize,
) -> ComponentName {
    let coordinate = M::COORDINATES.get(index);
    let velocity = index.checked_sub(N).and_then(|i| M::COORDINATES.get(i));
    match (coordinate, velocity) {
        (Some(name), _) => ComponentName::Coordinate(name),
        (None, Some(name)) => ComponentName::Velocity(name),
        (None, None) => ComponentName::Controller(index.saturating_sub(2 * N)),
    }
}
