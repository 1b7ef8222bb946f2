//! The equations of motion of a constrained model as one symmetric system,
//!
//! ⎡ M  −Gᵀ⎤ ⎡q̈⎤   ⎡f⎤
//! ⎣−G   0 ⎦ ⎣λ⎦ = ⎣γ⎦
//!
//! M. Benzi, G. H. Golub & J. Liesen, *Numerical solution of saddle point problems*, Acta Numerica **14** (2005) 1–137.
//! `N` accelerations and `C` multipliers are `K` unknowns.

use nalgebra::{SMatrix, SVector};

use super::constraints::Constraints;
use super::phase::Phase;
use super::state::State;
use crate::integrate::Projection;
use crate::limits::projection::{MAX_RESIDUAL, POSITION_SWEEPS, VELOCITY_SWEEPS};
use crate::linalg::Factorization;
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

/// Factors the matrix with this mass matrix and Jacobian.
#[inline]
pub fn saddle_point<S: Scalar, const N: usize, const C: usize, const K: usize>(
    mass: &SMatrix<S, N, N>,
    jacobian: &SMatrix<S, C, N>,
) -> Factorization<S, K> {
    let lower = SMatrix::from_fn(|i, j| {
        if i < N && j < N {
            mass[(i, j)]
        } else if i >= N && j < N {
            -jacobian[(i - N, j)]
        } else {
            S::zero()
        }
    });
    saddle_point_factors(lower, N)
}

/// Factors a matrix of a saddle point problem with so many accelerations, whose lower triangle alone is read.
#[inline]
pub fn saddle_point_factors<S: Scalar, const K: usize>(
    lower: SMatrix<S, K, K>,
    coordinates: usize,
) -> Factorization<S, K> {
    Factorization::of_saddle_point(lower, coordinates)
}

/// Returns measures of the conditioning for each coordinate and for each constraint: for a constraint sin² of the angle
/// between its gradient and those of the constraints before it, in the metric of M⁻¹, where M is well-conditioned.
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
    let mass = model.mass_matrix(state, prepared);
    let jacobian = model.constraint_jacobian(state, prepared);
    let factors: Factorization<S, K> = saddle_point(&mass, &jacobian);
    parts(&factors.relative_pivots())
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

/// Projects a state onto the constraints in the metric of M: coordinates by Newton's method with the factors at the
/// state, then velocities with the constraints at the projected coordinates.
///
/// E. Hairer, C. Lubich & G. Wanner, *Geometric Numerical Integration*, 2nd edition (2006), IV.4 and VII.1.
pub fn project<M, S, const N: usize, const C: usize, const K: usize>(
    model: &M,
    state: &State<S, N>,
    prepared: &M::Prepared,
) -> Projection<S, Phase<S, N>>
where
    M: Constraints<N, C, S>,
    S: Scalar,
{
    let mass = model.mass_matrix(state, prepared);
    let jacobian = model.constraint_jacobian(state, prepared);
    let factors: Factorization<S, K> = saddle_point(&mass, &jacobian);
    let change = |residuals: &SVector<S, C>| -> SVector<S, N> {
        let right = joined::<S, N, C, K>(&SVector::from_element(S::zero()), residuals);
        parts::<S, N, C, K>(&factors.solve(&right)).0
    };
    let mut projected = *state;
    let before = model.constraint_positions(state, prepared);
    if M::HOLONOMIC > 0 {
        for _ in 0..POSITION_SWEEPS {
            let residuals = model.constraint_positions(&projected, prepared);
            projected.q += change(&residuals);
        }
    }
    for _ in 0..VELOCITY_SWEEPS {
        let residuals = model.constraint_velocities(&projected, prepared);
        projected.v += change(&residuals);
    }
    let positions = model.constraint_positions(&projected, prepared);
    let velocities = model.constraint_velocities(&projected, prepared);
    let mut projection = Projection::new(projected.x);
    let tolerance = S::from_f64(MAX_RESIDUAL);
    for j in 0..C {
        let mut sizes = [S::zero(); 2];
        for i in 0..N {
            let slope = jacobian[(j, i)].abs();
            sizes[0] += slope * projected.q[i].abs();
            sizes[1] += slope * projected.v[i].abs();
        }
        let before = before[j].abs();
        projection = projection
            .checked(j, positions[j], (sizes[0] + before) * tolerance)
            .checked(j, velocities[j], sizes[1] * tolerance);
    }
    projection
}
