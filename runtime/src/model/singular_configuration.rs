//! States at which the mass matrix is singular, and the reports about them.

use nalgebra::{SMatrix, SVector};

use super::generalized_coordinates::GeneralizedCoordinates;
use super::named_singularity::named;
use super::poles::{at_pole, pole_between};
use super::quantities::Quantities;
use super::state::State;
use crate::integrate::Singularity;
use crate::limits::{REFERENCE_OFFSETS, VANISHING_INERTIA};
use crate::linalg::Factorization;
use crate::scalar::Scalar;

/// Returns the constraint that depends on others, or else the coordinate with the smallest relative pivot, if that is below
/// `min_pivot`.
#[inline]
pub(crate) fn singularity<M, S, const N: usize>(
    model: &M,
    prepared: &M::Prepared,
    state: &State<S, N>,
    min_pivot: f64,
) -> Option<Singularity>
where
    M: Quantities<N, S> + ?Sized,
    S: Scalar,
{
    let (pivots, constraint) = model.pivots(state, prepared);
    if let Some((constraint, pivot)) = constraint
        && pivot < min_pivot
    {
        return Some(Singularity::of_constraint(
            pivot,
            constraint,
            M::CONSTRAINTS,
        ));
    }
    let regular = pivots
        .iter()
        .all(|pivot| pivot.abs().smallest() >= min_pivot);
    if regular {
        at_pole::<M, S, N>(state, min_pivot)
    } else {
        let found = report::<M, S, N>(&pivots, state);
        let value = model.lagrangian(state, &model.inputs(), prepared);
        let is_outside = value.smallest().is_nan();
        Some(if is_outside {
            found.outside_domain()
        } else {
            found
        })
    }
}

/// Tests for a singularity in the course of a motion.
#[inline]
pub(crate) fn singularity_in_motion<M, S, const N: usize>(
    model: &M,
    prepared: &M::Prepared,
    state: &State<S, N>,
    min_pivot: f64,
) -> Option<Singularity>
where
    M: Quantities<N, S> + ?Sized,
    S: Scalar,
{
    if M::STAYS_REGULAR {
        at_pole::<M, S, N>(state, min_pivot)
    } else {
        singularity(model, prepared, state, min_pivot)
    }
}

/// Returns a pole between the coordinates before a step and the state after it, in any lane.
#[inline]
pub(crate) fn singularity_between<M, S, const N: usize>(
    before: &SVector<S, N>,
    after: &State<S, N>,
) -> Option<Singularity>
where
    M: Quantities<N, S> + ?Sized,
    S: Scalar,
{
    pole_between::<M, S, N>(before, after)
}

/// Returns the report of the smallest relative pivot.
#[cold]
fn report<M, S, const N: usize>(pivots: &SVector<S, N>, state: &State<S, N>) -> Singularity
where
    M: GeneralizedCoordinates<N> + ?Sized,
    S: Scalar,
{
    // A NaN pivot results from a division by zero and counts as zero.
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

/// Returns the coordinate whose inertia is the smallest relative to its inertia at other configurations, if it has
/// nearly vanished.
#[cold]
pub(crate) fn vanishing_inertia<M, S, const N: usize>(
    model: &M,
    prepared: &M::Prepared,
    state: &State<S, N>,
) -> Option<Singularity>
where
    M: Quantities<N, S> + ?Sized,
    S: Scalar,
{
    let (coordinate, ratio) = least_inertia(model, prepared, state, Scalar::smallest)?;
    Some(named::<M, S, N>(coordinate, ratio, state))
}

/// Returns the coordinate whose inertia has nearly vanished in one lane.
#[cold]
pub(super) fn vanishing_inertia_in_lane<M, S, const N: usize>(
    model: &M,
    prepared: &M::Prepared,
    lane: usize,
    state: &State<S, N>,
) -> Option<Singularity>
where
    M: Quantities<N, S> + ?Sized,
    S: Scalar,
{
    let (coordinate, ratio) =
        least_inertia(model, prepared, state, |inertia| inertia.in_lane(lane))?;
    Some(named::<M, f64, N>(coordinate, ratio, &in_lane(lane, state)))
}

/// Returns the coordinate with the smallest relative inertia, and its inertia relative to other configurations.
fn least_inertia<M, S, const N: usize>(
    model: &M,
    prepared: &M::Prepared,
    state: &State<S, N>,
    read: impl Fn(S) -> f64,
) -> Option<(usize, f64)>
where
    M: Quantities<N, S> + ?Sized,
    S: Scalar,
{
    let here = inertias(model, prepared, state);
    let ratios = (0..N).map(|i| {
        let elsewhere = REFERENCE_OFFSETS.map(|distance| {
            let mut moved = *state;
            for j in M::SINGULARITIES[i] {
                moved.q[*j] += S::from_f64(distance);
            }
            read(inertias(model, prepared, &moved)[i])
        });
        let most = elsewhere.into_iter().fold(0.0, f64::max);
        (i, read(here[i]) / most)
    });
    let least = ratios.fold((0, VANISHING_INERTIA), |least, (i, ratio)| {
        if ratio < least.1 { (i, ratio) } else { least }
    });
    (least.1 < VANISHING_INERTIA).then_some(least)
}

/// Returns the state in a lane.
fn in_lane<S: Scalar, const N: usize>(lane: usize, state: &State<S, N>) -> State<f64, N> {
    State::new(
        state.t.in_lane(lane),
        state.q.map(|coordinate| coordinate.in_lane(lane)),
        state.v.map(|velocity| velocity.in_lane(lane)),
    )
}

/// Returns the magnitude of the effective inertia of each coordinate while the others are free: 1 / (M⁻¹)ᵢᵢ.
fn inertias<M, S, const N: usize>(
    model: &M,
    prepared: &M::Prepared,
    state: &State<S, N>,
) -> SVector<S, N>
where
    M: Quantities<N, S> + ?Sized,
    S: Scalar,
{
    let unit = SMatrix::<S, N, N>::from_fn(|i, j| if i == j { S::one() } else { S::zero() });
    let inverse = Factorization::new(model.mass_matrix(state, prepared)).solve(&unit);
    SVector::from_fn(|i, _| S::one() / inverse[(i, i)].abs())
}
