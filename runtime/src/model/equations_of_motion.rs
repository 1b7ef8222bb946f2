//! Lagrange's equations as a system of first-order differential equations.

use core::marker::PhantomData;

use nalgebra::{SMatrix, SVector};

use super::generalized_coordinates::GeneralizedCoordinates;
use super::lagrangian::Lagrangian;
use super::phase::Phase;
use super::state::State;
use super::whole_periods::{is_large, less_whole_periods};
use crate::integrate::{ComponentName, Dynamics, Singularity};
use crate::limits::{REFERENCE_OFFSETS, VANISHING_INERTIA};
use crate::linalg::{ErrorTolerance, Factorization};
use crate::scalar::Scalar;

/// Lagrange's equations as first-order equations (q, q̇)˙ = (q̇, q̈); made by
/// [`Lagrangian::dynamics`].
///
/// The quantities that depend on parameters only are computed when it is made.
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
///     Dop853::new().integrate_to(&dynamics, start, 10.0)
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
    M: Lagrangian<N, S> + ?Sized,
    S: Scalar,
{
    pub(super) model: &'a M,
    pub(super) prepared: M::Prepared,
}

impl<'a, M, S, const N: usize> EquationsOfMotion<'a, M, S, N>
where
    M: Lagrangian<N, S> + ?Sized,
    S: Scalar,
{
    pub(crate) fn new(model: &'a M) -> Self {
        Self {
            model,
            prepared: model.prepare(),
        }
    }
}

impl<M, S, const N: usize> Clone for EquationsOfMotion<'_, M, S, N>
where
    M: Lagrangian<N, S> + ?Sized,
    S: Scalar,
{
    fn clone(&self) -> Self {
        Self {
            model: self.model,
            prepared: self.prepared.clone(),
        }
    }
}

/// What the dynamics of a model say of allowed errors, of singularities and of the names of components, whatever sets the
/// inputs: `self.model` is the model or a reference to it.
macro_rules! errors_of_the_model {
    () => {
        #[inline]
        fn allowed_error(
            &self,
            x: &$crate::Phase<S, N>,
            tolerance: &$crate::ErrorTolerance<S>,
        ) -> $crate::Phase<S, N> {
            $crate::model::equations_of_motion::allowed_error::<M, S, N>(x, tolerance)
        }

        #[inline]
        fn singularity(
            &self,
            t: S,
            x: &$crate::Phase<S, N>,
            min_pivot: f64,
        ) -> Option<$crate::Singularity> {
            use $crate::model::equations_of_motion::singularity;
            singularity::<M, S, N>(&self.model, &x.at(t), min_pivot)
        }

        #[inline]
        fn singularity_in_motion(
            &self,
            t: S,
            x: &$crate::Phase<S, N>,
            min_pivot: f64,
        ) -> Option<$crate::Singularity> {
            use $crate::model::equations_of_motion::singularity_in_motion;
            singularity_in_motion::<M, S, N>(&self.model, &x.at(t), min_pivot)
        }

        #[inline]
        fn singularity_in_lane(
            &self,
            lane: usize,
            t: S,
            x: &$crate::Phase<S, N>,
            min_pivot: f64,
        ) -> Option<$crate::Singularity> {
            use $crate::model::equations_of_motion::singularity_in_lane;
            singularity_in_lane::<M, S, N>(&self.model, lane, &x.at(t), min_pivot)
        }

        fn vanishing_inertia(&self, t: S, x: &$crate::Phase<S, N>) -> Option<$crate::Singularity> {
            use $crate::model::equations_of_motion::vanishing_inertia;
            vanishing_inertia::<M, S, N>(&self.model, &x.at(t))
        }

        fn vanishing_inertia_in_lane(
            &self,
            lane: usize,
            t: S,
            x: &$crate::Phase<S, N>,
        ) -> Option<$crate::Singularity> {
            use $crate::model::equations_of_motion::vanishing_inertia_in_lane;
            vanishing_inertia_in_lane::<M, S, N>(&self.model, lane, &x.at(t))
        }

        fn component_name(&self, index: usize) -> $crate::ComponentName {
            $crate::model::equations_of_motion::component_name::<M, N>(index)
        }
    };
}
pub(super) use errors_of_the_model;

impl<M, S, const N: usize> Dynamics<S> for EquationsOfMotion<'_, M, S, N>
where
    M: Lagrangian<N, S> + ?Sized,
    S: Scalar,
{
    type State = Phase<S, N>;

    #[inline]
    fn derivative(&self, t: S, x: &Phase<S, N>) -> Phase<S, N> {
        Phase {
            q: x.v,
            v: self.model.accelerations_prepared(&x.at(t), &self.prepared),
        }
    }

    #[inline]
    fn reduced(&self, x: &Phase<S, N>, compensation: &Phase<S, N>) -> Phase<S, N> {
        reduced::<M, S, N>(x, compensation)
    }

    errors_of_the_model!();
}

/// The phase with angles less whole periods.
#[inline]
pub(super) fn reduced<M, S, const N: usize>(
    x: &Phase<S, N>,
    compensation: &Phase<S, N>,
) -> Phase<S, N>
where
    M: GeneralizedCoordinates<N> + ?Sized,
    S: Scalar,
{
    let mut reduced = *x;
    for (i, angle) in reduced.q.iter_mut().enumerate() {
        let period = M::PERIODS[i];
        if period > 0 && !M::IGNORABLE[i] && is_large(*angle) {
            *angle = less_whole_periods(*angle, compensation.q[i], period);
        }
    }
    reduced
}

/// The allowed errors of coordinates of sizes |qᵢ| and of velocities of sizes |q̇ᵢ|. The size of an angle, which is
/// periodic, is 1, and that of another ignorable coordinate, whose value does not matter, is |q̇ᵢ| over the rate.
#[inline]
pub(crate) fn allowed_error<M, S, const N: usize>(
    x: &Phase<S, N>,
    tolerance: &ErrorTolerance<S>,
) -> Phase<S, N>
where
    M: GeneralizedCoordinates<N> + ?Sized,
    S: Scalar,
{
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
    }
}

/// The coordinate with the smallest relative pivot, if that is below `min_pivot`.
#[inline]
pub(crate) fn singularity<M, S, const N: usize>(
    model: &M,
    state: &State<S, N>,
    min_pivot: f64,
) -> Option<Singularity>
where
    M: Lagrangian<N, S> + ?Sized,
    S: Scalar,
{
    let pivots = model.relative_pivots(state);
    let regular = pivots
        .iter()
        .all(|pivot| pivot.abs().smallest() >= min_pivot);
    if regular {
        None
    } else {
        Some(report::<M, S, N>(&pivots, state))
    }
}

/// The same in the course of a motion.
#[inline]
pub(crate) fn singularity_in_motion<M, S, const N: usize>(
    model: &M,
    state: &State<S, N>,
    min_pivot: f64,
) -> Option<Singularity>
where
    M: Lagrangian<N, S> + ?Sized,
    S: Scalar,
{
    if M::STAYS_REGULAR {
        None
    } else {
        singularity(model, state, min_pivot)
    }
}

/// The same in one lane.
pub(super) fn singularity_in_lane<M, S, const N: usize>(
    model: &M,
    lane: usize,
    state: &State<S, N>,
    min_pivot: f64,
) -> Option<Singularity>
where
    M: Lagrangian<N, S> + ?Sized,
    S: Scalar,
{
    let pivots = model.relative_pivots(state);
    let pivots = pivots.map(|pivot| pivot.in_lane(lane));
    let regular = pivots.iter().all(|pivot| pivot.abs() >= min_pivot);
    (!regular).then(|| report::<M, f64, N>(&pivots, &in_lane(lane, state)))
}

/// The report of the smallest relative pivot.
#[cold]
fn report<M, S, const N: usize>(pivots: &SVector<S, N>, state: &State<S, N>) -> Singularity
where
    M: GeneralizedCoordinates<N> + ?Sized,
    S: Scalar,
{
    // A pivot that is NaN comes from a division by zero and counts as zero.
    let sizes = pivots.iter().map(|pivot| {
        let size = pivot.abs().smallest();
        if size.is_nan() { 0.0 } else { size }
    });
    let (coordinate, least) = sizes
        .enumerate()
        .fold((0, f64::INFINITY), |least, (i, size)| {
            if size < least.1 { (i, size) } else { least }
        });
    named::<M, S, N>(coordinate, least, state)
}

/// The report of a coordinate, with those that make its block of the mass matrix singular.
fn named<M, S, const N: usize>(
    coordinate: usize,
    relative_pivot: f64,
    state: &State<S, N>,
) -> Singularity
where
    M: GeneralizedCoordinates<N> + ?Sized,
    S: Scalar,
{
    let dependencies = StaticNames::<M, N>::SINGULARITIES
        .get(coordinate)
        .copied()
        .unwrap_or_default();
    Singularity::new(
        relative_pivot,
        coordinate,
        StaticNames::<M, N>::COORDINATES,
        dependencies,
        |i| state.q.get(i).map_or(f64::NAN, |value| value.smallest()),
    )
}

/// The coordinate whose inertia is the smallest relative to that elsewhere, if it has nearly vanished.
#[cold]
pub(crate) fn vanishing_inertia<M, S, const N: usize>(
    model: &M,
    state: &State<S, N>,
) -> Option<Singularity>
where
    M: Lagrangian<N, S> + ?Sized,
    S: Scalar,
{
    let (coordinate, ratio) = least_inertia(model, state, Scalar::smallest)?;
    Some(named::<M, S, N>(coordinate, ratio, state))
}

/// The same in one lane.
#[cold]
pub(super) fn vanishing_inertia_in_lane<M, S, const N: usize>(
    model: &M,
    lane: usize,
    state: &State<S, N>,
) -> Option<Singularity>
where
    M: Lagrangian<N, S> + ?Sized,
    S: Scalar,
{
    let (coordinate, ratio) = least_inertia(model, state, |inertia| inertia.in_lane(lane))?;
    Some(named::<M, f64, N>(coordinate, ratio, &in_lane(lane, state)))
}

/// That coordinate, and its inertia relative to that elsewhere.
fn least_inertia<M, S, const N: usize>(
    model: &M,
    state: &State<S, N>,
    read: impl Fn(S) -> f64,
) -> Option<(usize, f64)>
where
    M: Lagrangian<N, S> + ?Sized,
    S: Scalar,
{
    let here = inertias(model, state);
    let ratios = (0..N).map(|i| {
        let elsewhere = REFERENCE_OFFSETS.map(|distance| {
            let mut moved = *state;
            for j in M::SINGULARITIES[i] {
                moved.q[*j] += S::from_f64(distance);
            }
            read(inertias(model, &moved)[i])
        });
        let most = elsewhere.into_iter().fold(0.0, f64::max);
        (i, read(here[i]) / most)
    });
    let least = ratios.fold((0, VANISHING_INERTIA), |least, (i, ratio)| {
        if ratio < least.1 { (i, ratio) } else { least }
    });
    (least.1 < VANISHING_INERTIA).then_some(least)
}

/// The state in a lane.
fn in_lane<S: Scalar, const N: usize>(lane: usize, state: &State<S, N>) -> State<f64, N> {
    State {
        t: state.t.in_lane(lane),
        q: state.q.map(|coordinate| coordinate.in_lane(lane)),
        v: state.v.map(|velocity| velocity.in_lane(lane)),
    }
}

/// The magnitude of the effective inertia of each coordinate, with the others free: 1 / (M⁻¹)ᵢᵢ.
fn inertias<M, S, const N: usize>(model: &M, state: &State<S, N>) -> SVector<S, N>
where
    M: Lagrangian<N, S> + ?Sized,
    S: Scalar,
{
    let unit = SMatrix::<S, N, N>::from_fn(|i, j| if i == j { S::one() } else { S::zero() });
    let inverse = Factorization::new(model.mass_matrix(state)).solve(&unit);
    SVector::from_fn(|i, _| S::one() / inverse[(i, i)].abs())
}

pub(crate) fn component_name<M: GeneralizedCoordinates<N> + ?Sized, const N: usize>(
    index: usize,
) -> ComponentName {
    let names = StaticNames::<M, N>::COORDINATES;
    let coordinate = names.get(index);
    let velocity = index.checked_sub(N).and_then(|i| names.get(i));
    match (coordinate, velocity) {
        (Some(name), _) => ComponentName::Coordinate(name),
        (None, Some(name)) => ComponentName::Velocity(name),
        (None, None) => ComponentName::Index(index),
    }
}

/// The constants of a system as `'static` slices.
struct StaticNames<M: ?Sized, const N: usize>(PhantomData<M>);

impl<M: GeneralizedCoordinates<N> + ?Sized, const N: usize> StaticNames<M, N> {
    const COORDINATES: &'static [&'static str] = &M::COORDINATES;
    const SINGULARITIES: &'static [&'static [usize]] = &M::SINGULARITIES;
}
