//! The equations of motion of constrained models as saddle point problems, and projections onto constraints.

use nalgebra::{SMatrix, SVector};

use super::constraints::Constraints;
use super::phase::Phase;
use super::quantities::Quantities;
use super::state::State;
use crate::integrate::Projection;
use crate::limits::projection::{
    NEARBY, POSITION_SWEEPS, ROUNDED_EPSILONS, TO_NEARBY, VELOCITY_SWEEPS, max_residual,
};
pub use crate::linalg::SaddlePoint;
use crate::linalg::lane_select::{from_index, greater, is_zero, one_if_zero, square_root};
use crate::linalg::smallest_sine;
use crate::scalar::Scalar;

/// Returns the accelerations and the multipliers.
#[inline]
pub fn parts<S: Scalar, const N: usize, const C: usize, const K: usize>(
    solution: &SVector<S, K>,
) -> (SVector<S, N>, SVector<S, C>) {
    (
        SVector::from_fn(|i, _| solution[i]),
        SVector::from_fn(|i, _| solution[N + i]),
    )
}

/// Returns a right-hand side of its parts.
#[inline]
pub fn joined<S: Scalar, const N: usize, const C: usize, const K: usize>(
    forcing: &SVector<S, N>,
    rates: &SVector<S, C>,
) -> SVector<S, K> {
    SVector::from_fn(|i, _| if i < N { forcing[i] } else { rates[i - N] })
}

/// Returns the rows of the accelerations.
#[inline]
pub fn rows_of_accelerations<S: Scalar, const N: usize, const K: usize, const P: usize>(
    matrix: &SMatrix<S, K, P>,
) -> SMatrix<S, N, P> {
    SMatrix::from_fn(|i, j| matrix[(i, j)])
}

/// Returns the factored saddle point problem with this mass matrix and Jacobian.
#[inline]
pub fn saddle_point<S: Scalar, const N: usize, const C: usize, const K: usize>(
    mass: &SMatrix<S, N, N>,
    jacobian: &SMatrix<S, C, N>,
    rank: S,
) -> SaddlePoint<S, N, C, K> {
    SaddlePoint::new(SaddlePoint::<S, N, C, K>::lower(mass, jacobian), rank)
}

/// Returns the smallest change in the metric of M that takes these residuals away to first order: M δ = Gᵀ λ, G δ = −r.
fn correction<S: Scalar, const N: usize, const C: usize, const K: usize>(
    factors: &SaddlePoint<S, N, C, K>,
    residuals: &SVector<S, C>,
) -> SVector<S, N> {
    let right = joined::<S, N, C, K>(&SVector::from_element(S::zero()), residuals);
    parts::<S, N, C, K>(&factors.solve(&right)).0
}

/// Returns the rank that [`fix_rank`] has noted, the last of the prepared numbers; 0 where it is not known.
fn noted_rank<S: Scalar>(prepared: &impl AsRef<[S]>) -> S {
    prepared.as_ref().last().copied().unwrap_or_else(S::zero)
}

/// Returns the factored saddle point problem at a state.
fn at_state<M, S, const N: usize, const C: usize, const K: usize>(
    model: &M,
    state: &State<S, N>,
    prepared: &M::Prepared,
) -> SaddlePoint<S, N, C, K>
where
    M: Constraints<N, C, S>,
    S: Scalar,
{
    let mass = model.mass_matrix(state, prepared);
    let jacobian = model.constraint_jacobian(state, prepared);
    saddle_point(&mass, &jacobian, noted_rank(prepared))
}

/// Finds the number of independent constraints in the neighbourhood of a consistent state, and notes it behind the other
/// prepared numbers. At a singular configuration fewer are independent than nearby.
pub fn fix_rank<M, S, const N: usize, const C: usize, const K: usize>(
    model: &M,
    state: &State<S, N>,
    prepared: &mut M::Prepared,
) where
    M: Constraints<N, C, S>,
    S: Scalar,
{
    note_rank(prepared, S::zero());
    let factors = at_state::<M, S, N, C, K>(model, state, prepared);
    let mut found = factors.rank();
    if found.smallest() < from_index::<S>(C).smallest() {
        // A change that the constraints allow at this state.
        let free = without_symmetry(&state.q) * S::from_f64(NEARBY);
        let jacobian = model.constraint_jacobian(state, prepared);
        let residuals = SVector::<S, C>::from_fn(|j, _| {
            (0..N).fold(S::zero(), |sum, i| sum + jacobian[(j, i)] * free[i])
        });
        let mut nearby = *state;
        nearby.q += free + correction(&factors, &residuals);
        for _ in 0..TO_NEARBY {
            nearby.x = project::<M, S, N, C, K>(model, &nearby, prepared, None).into_state();
        }
        let there = at_state::<M, S, N, C, K>(model, &nearby, prepared);
        found = found.max(there.rank());
    }
    note_rank(prepared, found);
}

fn note_rank<S: Scalar>(prepared: &mut impl AsMut<[S]>, rank: S) {
    if let Some(last) = prepared.as_mut().last_mut() {
        *last = rank;
    }
}

/// Returns the change δ of coordinates or of velocities with M δ = p + Gᵀ λ and G δ = −r, for an impulse p and residuals r of the
/// first `count` constraints, with δᵢ = 0 for each component that is held. Without an impulse it is the smallest in the metric of M
/// that takes the residuals away to first order.
pub fn constrained_response<M, S, const N: usize, const C: usize, const K: usize>(
    model: &M,
    state: &State<S, N>,
    prepared: &M::Prepared,
    (impulse, residuals): (&SVector<S, N>, &SVector<S, C>),
    held: &[bool; N],
    count: usize,
) -> SVector<S, N>
where
    M: Constraints<N, C, S>,
    S: Scalar,
{
    let of_held = |i: usize, j: usize| if i == j { S::one() } else { S::zero() };
    let mass = model.mass_matrix(state, prepared);
    let mass = SMatrix::from_fn(|i, j| {
        if held[i] || held[j] {
            of_held(i, j)
        } else {
            mass[(i, j)]
        }
    });
    let jacobian = model.constraint_jacobian(state, prepared);
    let (zero, acts) = (S::zero(), |i, j: usize| i < count && !held[j]);
    let jacobian = SMatrix::from_fn(|i, j| if acts(i, j) { jacobian[(i, j)] } else { zero });
    let factors: SaddlePoint<S, N, C, K> = saddle_point(&mass, &jacobian, S::zero());
    let impulse = SVector::from_fn(|i, _| if held[i] { S::zero() } else { impulse[i] });
    let right = joined::<S, N, C, K>(&impulse, residuals);
    parts::<S, N, C, K>(&factors.solve(&right)).0
}

/// Returns Σᵢ |Gⱼᵢ xᵢ|, the size of the terms of a constraint at coordinates or velocities x, to which rounding errors of its
/// residual are proportional.
pub(super) fn row_size<S: Scalar, const N: usize, const C: usize>(
    jacobian: &SMatrix<S, C, N>,
    constraint: usize,
    x: &SVector<S, N>,
) -> S {
    (0..N).fold(S::zero(), |sum, i| {
        sum + (jacobian[(constraint, i)] * x[i]).abs()
    })
}

/// Returns the residuals that rounding may leave in each constraint of coordinates, and of velocities, which have these sizes.
///
/// The terms of a constraint in the coordinates may vanish at a state where terms without them cancel. Its rounding errors are
/// in proportion to the terms that it has elsewhere.
#[cold]
#[inline(never)]
pub(super) fn rounding_errors<M, S, const N: usize, const C: usize>(
    model: &M,
    state: &State<S, N>,
    prepared: &M::Prepared,
    sizes: &Phase<S, N>,
) -> [SVector<S, C>; 2]
where
    M: Constraints<N, C, S> + ?Sized,
    S: Scalar,
{
    let here = model.constraint_jacobian(state, prepared);
    let mut elsewhere = *state;
    elsewhere.q += without_symmetry(&state.q);
    let there = model.constraint_jacobian(&elsewhere, prepared);
    let largest = here.zip_map(&there, |here, there| {
        let (here, there) = (here.abs(), there.abs());
        here + (there - here).masked(greater(there, here))
    });
    let positions = SVector::<S, N>::from_fn(|i, _| {
        // The functions of an angle are of order 1 whatever it is.
        if M::ANGLES[i] {
            sizes.q[i].max(S::one())
        } else {
            sizes.q[i]
        }
    });
    let unit = S::from_f64(ROUNDED_EPSILONS * S::machine_epsilon());
    [positions, sizes.v].map(|sizes| SVector::from_fn(|j, _| row_size(&largest, j, &sizes) * unit))
}

/// Returns a change of coordinates by parts of their size, or of 1, between −½ and ½ and without symmetry.
fn without_symmetry<S: Scalar, const N: usize>(q: &SVector<S, N>) -> SVector<S, N> {
    let mut part = 1.0;
    q.map(|x| {
        part = (part + 0.618_033_988_749_894_9) % 1.0;
        (x.abs() + S::one()) * S::from_f64(part - 0.5)
    })
}

/// Returns the constraint with the largest residual relative to its terms, or the first whose residual is NaN, and the residual.
pub fn violated_constraint<M, S, const N: usize, const C: usize>(
    model: &M,
    state: &State<S, N>,
    prepared: &M::Prepared,
) -> Option<(usize, S)>
where
    M: Constraints<N, C, S>,
    S: Scalar,
{
    let jacobian = model.constraint_jacobian(state, prepared);
    let sizes = sizes_in_metric(model, state, prepared, &state.x);
    let [of_positions, of_velocities] = rounding_errors(model, state, prepared, &sizes);
    let residuals = [
        (
            model.constraint_positions(state, prepared),
            state.q,
            of_positions,
        ),
        (
            model.constraint_velocities(state, prepared),
            state.v,
            of_velocities,
        ),
    ];
    let mut most: Option<(usize, S, f64)> = None;
    for (residuals, of, rounding) in residuals {
        for j in 0..C {
            let size = row_size(&jacobian, j, &of);
            let ratio = residuals[j].abs() / one_if_zero(size);
            if ratio.largest().is_nan() {
                return Some((j, residuals[j]));
            }
            let exceeds = greater(residuals[j].abs(), rounding[j]);
            let ratio = ratio.masked(exceeds).largest();
            if ratio > max_residual::<S>() && most.is_none_or(|(.., other)| ratio > other) {
                most = Some((j, residuals[j], ratio));
            }
        }
        if most.is_some() {
            break;
        }
    }
    most.map(|(constraint, residual, _)| (constraint, residual))
}

/// Returns the constraint whose compliance is not positive and finite in some lane, and the compliance.
pub fn invalid_compliance<M, S, const N: usize, const C: usize>(
    model: &M,
    prepared: &M::Prepared,
) -> Option<(usize, f64)>
where
    M: Constraints<N, C, S>,
    S: Scalar,
{
    let compliances = model.compliances(prepared);
    let mut lanes = compliances.iter().enumerate().flat_map(|(i, compliance)| {
        [compliance.smallest(), compliance.largest()].map(|lane| (i, lane))
    });
    lanes.find(|(_, lane)| !(lane.is_finite() && *lane > 0.0))
}

/// Returns measures of the conditioning for each coordinate, and for each constraint the sine of the angle between its
/// gradient and the span of the other gradients.
#[inline]
pub fn constrained_pivots<M, S, const N: usize, const C: usize, const K: usize>(
    model: &M,
    state: &State<S, N>,
    prepared: &M::Prepared,
) -> (SVector<S, N>, SVector<S, C>)
where
    M: Constraints<N, C, S>,
    S: Scalar,
{
    at_state::<M, S, N, C, K>(model, state, prepared).relative_pivots()
}

/// Returns in each lane the smallest sine of the angle between the gradient of a constraint and the span of the gradients of
/// others.
pub fn constraint_sine<M, S, const N: usize, const C: usize>(
    model: &M,
    state: &State<S, N>,
    prepared: &M::Prepared,
) -> S
where
    M: Constraints<N, C, S>,
    S: Scalar,
{
    let mass = model.mass_matrix(state, prepared).diagonal();
    let jacobian = model.constraint_jacobian(state, prepared);
    smallest_sine(&jacobian, &mass, noted_rank(prepared))
}

/// Returns the constraint with the smallest pivot in any lane, and that pivot; NaN counts as 0.
#[inline]
pub fn least_pivot<S: Scalar, const C: usize>(pivots: &SVector<S, C>) -> Option<(usize, f64)> {
    let sizes = pivots.iter().map(|pivot| {
        let size = pivot.abs().smallest();
        if size.is_nan() { 0.0 } else { size }
    });
    let mut least: Option<(usize, f64)> = None;
    for (constraint, size) in sizes.enumerate() {
        if least.is_none_or(|(_, other)| size < other) {
            least = Some((constraint, size));
        }
    }
    least
}

/// Returns the largest component of each kind that a vector of this length has, in the metric of M.
fn in_metric<S: Scalar, const N: usize>(
    mass: &SMatrix<S, N, N>,
    vector: &SVector<S, N>,
) -> SVector<S, N> {
    let square = (0..N).fold(S::zero(), |sum, i| {
        sum + mass[(i, i)].abs() * vector[i] * vector[i]
    });
    SVector::from_fn(|i, _| {
        let has_mass = S::one() - is_zero(mass[(i, i)]);
        let square = (square / one_if_zero(mass[(i, i)].abs())).masked(has_mass);
        square_root(square).max(vector[i].abs())
    })
}

fn phase_in_metric<S: Scalar, const N: usize>(
    mass: &SMatrix<S, N, N>,
    phase: &Phase<S, N>,
) -> Phase<S, N> {
    Phase::new(in_metric(mass, &phase.q), in_metric(mass, &phase.v))
}

/// Returns the largest component of each kind that coordinates and velocities of these sizes have in the metric of M.
pub fn sizes_in_metric<M, S, const N: usize>(
    model: &M,
    state: &State<S, N>,
    prepared: &M::Prepared,
    sizes: &Phase<S, N>,
) -> Phase<S, N>
where
    M: Quantities<N, S> + ?Sized,
    S: Scalar,
{
    phase_in_metric(&model.mass_matrix(state, prepared), sizes)
}

/// Projects a state onto the constraints in the metric of M: coordinates by Newton's method with the factors at the
/// state, then velocities with the constraints at the projected coordinates.
///
/// Where accelerations are solved for with pivoting, the projection is `pivoted`; without that, where its own factors are.
///
/// E. Hairer, C. Lubich & G. Wanner, *Geometric Numerical Integration*, 2nd edition (2006), IV.4 and VII.1.
pub fn project<M, S, const N: usize, const C: usize, const K: usize>(
    model: &M,
    state: &State<S, N>,
    prepared: &M::Prepared,
    pivoted: Option<S>,
) -> Projection<S, Phase<S, N>>
where
    M: Constraints<N, C, S>,
    S: Scalar,
{
    let jacobian = model.constraint_jacobian(state, prepared);
    let mass = model.mass_matrix(state, prepared);
    let factors: SaddlePoint<S, N, C, K> = saddle_point(&mass, &jacobian, noted_rank(prepared));
    let mut projected = *state;
    let before = model.constraint_positions(state, prepared);
    if M::HOLONOMIC > 0 {
        projected.q += correction(&factors, &before);
        for _ in 1..POSITION_SWEEPS {
            let residuals = model.constraint_positions(&projected, prepared);
            projected.q += correction(&factors, &residuals);
        }
    }
    let before_velocities = model.constraint_velocities(&projected, prepared);
    projected.v += correction(&factors, &before_velocities);
    for _ in 1..VELOCITY_SWEEPS {
        let residuals = model.constraint_velocities(&projected, prepared);
        projected.v += correction(&factors, &residuals);
    }
    let positions = model.constraint_positions(&projected, prepared);
    let velocities = model.constraint_velocities(&projected, prepared);
    let sizes = phase_in_metric(&mass, &projected.x);
    let pivoted = pivoted.unwrap_or_else(|| factors.pivoted());
    let mut projection = Projection::new(projected.x)
        .with_sizes(sizes)
        .with_pivoting(pivoted);
    let tolerance = S::from_f64(max_residual::<S>());
    let allowed = |before: &SVector<S, C>, x: &SVector<S, N>| {
        SVector::<S, C>::from_fn(|j, _| (before[j].abs() + row_size(&jacobian, j, x)) * tolerance)
    };
    let mut allowed = [
        allowed(&before, &projected.q),
        allowed(&before_velocities, &projected.v),
    ];
    let exceeds = |residuals: &SVector<S, C>, allowed: &SVector<S, C>| {
        let mut pairs = residuals.iter().zip(allowed);
        pairs.any(|(residual, allowed)| greater(residual.abs(), *allowed).largest() > 0.0)
    };
    if exceeds(&positions, &allowed[0]) || exceeds(&velocities, &allowed[1]) {
        let rounding = rounding_errors(model, &projected, prepared, &sizes);
        for (allowed, rounding) in allowed.iter_mut().zip(&rounding) {
            *allowed = allowed.zip_map(rounding, Scalar::max);
        }
    }
    for j in 0..C {
        projection = projection.checked(j, positions[j], allowed[0][j]);
        projection = projection.checked(j, velocities[j], allowed[1][j]);
    }
    projection
}
