//! What only emitted code and the crate `lagrangian` use.

// Not in the root: the documentation of `lagrangian` would contain all of both crates.
pub use nalgebra;
pub use num_traits;

pub use nalgebra::{SMatrix, SVector};

pub use super::arrays::{matrix, vector};
pub use super::by_columns::{
    constant_state, constants, input_jacobian_by_columns, linearization_by_columns,
    mass_matrix_by_columns,
};
pub use super::directional_derivatives::{derivatives_along, derivatives_by_input};
pub use super::impacts::constrained_impulse_response;
pub use super::operations::operations;
pub use super::saddle_point::{
    SaddlePoint, constrained_pivots, constrained_response, constraint_sine, fix_rank,
    invalid_compliance, joined, least_pivot, parts, project, rows_of_accelerations, saddle_point,
    sizes_in_metric, violated_constraint,
};
pub use super::sensitivities::rows_of_multipliers;
pub use super::undeclared;

mod on_scalar;
mod series;

pub use super::members_in_lanes::SharesLanes;
pub use crate::integrate::{FactorPairs, PairSums};
pub use on_scalar::{Kept, OnScalar};

pub use series::{
    HigherOrders, Term, event_series, orders, taylor_series, taylor_series_in_quasi_velocities,
    visit_branches, visit_events,
};

use super::linearization::Linearization;
use crate::linalg::Factorization;
use crate::linalg::lane_select::{LaneSelect, greater};
use crate::scalar::Scalar;

/// A field type that is converted to a scalar.
pub trait Parameter {
    /// Converts the value to a scalar.
    fn on<S: Scalar>(self) -> S;
}

impl Parameter for f64 {
    #[inline]
    fn on<S: Scalar>(self) -> S {
        S::from_f64(self)
    }
}

impl Parameter for f32 {
    #[inline]
    fn on<S: Scalar>(self) -> S {
        S::from_f64(self.into())
    }
}

/// Converts the value of a field to the scalar of the evaluation.
#[inline]
pub fn parameter<S: Scalar>(field: impl Parameter) -> S {
    field.on()
}

/// Returns the values of some elements, all of which exist.
#[inline]
pub fn gather<S: Scalar, const K: usize>(values: &[S], elements: [usize; K]) -> [S; K] {
    elements.map(|element| values.get(element).copied().unwrap_or_else(S::zero))
}

/// Sets some elements to new values.
#[inline]
pub fn scatter<S: Scalar, const K: usize>(values: &mut [S], elements: [usize; K], new: [S; K]) {
    for (element, new) in elements.into_iter().zip(new) {
        if let Some(value) = values.get_mut(element) {
            *value = new;
        }
    }
}

/// Returns the gradient of one of some functions by coordinates, and its derivative by the time.
#[inline]
pub fn gradient<S: Scalar, const N: usize, const N1: usize>(
    gradients: &[[S; N1]],
    function: usize,
) -> (SVector<S, N>, S) {
    let none = [S::zero(); N1];
    let row = gradients.get(function).unwrap_or(&none);
    let by_time = row.last().copied().unwrap_or_else(S::zero);
    (SVector::from_fn(|i, _| row[i]), by_time)
}

/// Returns NaN velocities, for models whose emitted code does not solve for velocities.
#[must_use]
pub fn no_velocities<S: Scalar, const N: usize>() -> SVector<S, N> {
    SVector::repeat(S::from_f64(f64::NAN))
}

/// Returns `computed` in each lane in which all pivots are positive, and the value of `otherwise` in the others, where
/// M is indefinite or singular.
#[inline]
pub fn if_positive<S: Scalar, T: LaneSelect<S>, const K: usize>(
    pivots: [S; K],
    computed: T,
    otherwise: impl FnOnce() -> T,
) -> T {
    if pivots.into_iter().all(|pivot| pivot.smallest() > 0.0) {
        computed
    } else {
        let (other, definite) = without_positive(pivots, otherwise);
        computed.select(other, definite)
    }
}

/// Returns the mask of the lanes in which some pivot is not positive.
#[inline]
pub fn not_positive<S: Scalar, const K: usize>(pivots: [S; K]) -> S {
    let positive = |all, pivot| all * greater(pivot, S::zero());
    S::one() - pivots.into_iter().fold(S::one(), positive)
}

/// Returns the value of `otherwise`, and the mask of the lanes in which all pivots are positive. The computed value is
/// not passed to this function, so that it stays in registers.
#[cold]
#[inline(never)]
fn without_positive<S: Scalar, T, const K: usize>(
    pivots: [S; K],
    otherwise: impl FnOnce() -> T,
) -> (T, S) {
    let definite = S::one() - not_positive(pivots);
    (otherwise(), definite)
}

/// Returns the derivatives −M⁻¹ ∂(M q̈ − f)/∂x, given columns by q, by q̇ and, if there is one more, by t.
#[inline]
pub fn linearization<S: Scalar, const N: usize, const K: usize>(
    factors: &Factorization<S, N>,
    residuals: &SMatrix<S, N, K>,
) -> Linearization<S, N> {
    let columns = factors.solve(residuals);
    let part = |first: usize| SMatrix::from_fn(|i, j| -columns[(i, first + j)]);
    Linearization {
        position: part(0),
        velocity: part(N),
        time: if K > 2 * N {
            SVector::from_fn(|i, _| -columns[(i, 2 * N)])
        } else {
            SVector::zeros()
        },
    }
}

/// Returns the derivatives of q̈ from a function that computes the residual along a variation of q, q̇ and t.
#[inline]
pub fn linearization_along<S: Scalar, const N: usize, const K: usize>(
    factors: &Factorization<S, N>,
    residual: impl Fn([S; K]) -> SVector<S, N>,
) -> Linearization<S, N> {
    let mut columns = SMatrix::<S, N, K>::zeros();
    for j in 0..K {
        let variation = core::array::from_fn(|i| if i == j { S::one() } else { S::zero() });
        columns.set_column(j, &residual(variation));
    }
    linearization(factors, &columns)
}

/// Returns for each coordinate the product of the relative pivots at the positions through which its acceleration is
/// solved for.
///
/// A pivot is relative to the magnitude of the terms that determine its rounding errors, NaN where both are 0. The first pivots come
/// from an elimination of M with this `diagonal`: such a pivot is 0 where M is singular to working precision, that is, where
/// elimination leaves less than the machine epsilon times the diagonal entry.
#[inline]
pub fn relative_pivots<S: Scalar, const PIVOTS: usize, const ELIMINATED: usize, const N: usize>(
    pivots: [S; PIVOTS],
    magnitudes: [S; PIVOTS],
    diagonal: [S; ELIMINATED],
    positions: [&[usize]; N],
) -> SVector<S, N> {
    let relative: [S; PIVOTS] = core::array::from_fn(|i| {
        let relative = pivots[i].abs() / magnitudes[i];
        match diagonal.get(i) {
            Some(entry) => {
                let left = (pivots[i] / *entry).abs();
                greater(left, S::from_f64(S::machine_epsilon())) * relative
            }
            None => relative,
        }
    });
    SVector::from(positions.map(|positions| {
        let factors = positions
            .iter()
            .filter_map(|position| relative.get(*position));
        factors.fold(S::one(), |product, pivot| product * *pivot)
    }))
}

/// Returns the relative pivots of a numerical factorization of M, and 0 where M is singular to working precision.
pub fn factored_pivots<S: Scalar, const N: usize>(factors: &Factorization<S, N>) -> SVector<S, N> {
    let epsilon = S::from_f64(S::machine_epsilon());
    let found = factors.relative_pivots();
    found.map(|pivot| greater(pivot, epsilon) * pivot)
}
