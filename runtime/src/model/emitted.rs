//! Functions that only emitted code calls.

pub use nalgebra::{SMatrix, SVector};

use super::linearization::Linearization;
use crate::linalg::Factorization;
use crate::linalg::lane_select::{LaneSelect, greater};
use crate::scalar::Scalar;

/// A type of a field that is converted to a scalar.
pub trait Parameter {
    /// The value on a scalar.
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

/// The value of a field, converted to the scalar of the evaluation.
#[inline]
pub fn parameter<S: Scalar>(field: impl Parameter) -> S {
    field.on()
}

/// `computed`, in each lane in which all pivots are positive; the value of `otherwise` in
/// the others, where M is indefinite or singular.
#[inline]
pub fn if_positive<S: Scalar, T: LaneSelect<S>, const K: usize>(
    pivots: [S; K],
    computed: T,
    otherwise: impl FnOnce() -> T,
) -> T {
    if pivots.into_iter().all(|pivot| pivot.smallest() > 0.0) {
        computed
    } else {
        select_if_positive(pivots, computed, otherwise)
    }
}

#[cold]
#[inline(never)]
fn select_if_positive<S: Scalar, T: LaneSelect<S>, const K: usize>(
    pivots: [S; K],
    computed: T,
    otherwise: impl FnOnce() -> T,
) -> T {
    let positive = |all, pivot| all * greater(pivot, S::zero());
    let definite = pivots.into_iter().fold(S::one(), positive);
    computed.select(otherwise(), definite)
}

/// The derivatives −M⁻¹ ∂(M q̈ − f)/∂x from columns by q, by q̇ and, if there is one more, by t.
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

/// Where M is positive definite, each pivot over the magnitude of the terms whose rounding errors it has; elsewhere
/// the relative pivots of a numerical factorization of M. 0 where M is singular to working precision: where elimination
/// leaves less than the machine epsilon times a diagonal entry.
#[inline]
pub fn relative_pivots<S: Scalar, const N: usize>(
    pivots: [S; N],
    magnitudes: [S; N],
    diagonal: [S; N],
    mass: impl FnOnce() -> SMatrix<S, N, N>,
) -> SVector<S, N> {
    let epsilon = S::from_f64(S::machine_epsilon());
    let computed = SVector::from_fn(|i, _| {
        let left = (pivots[i] / diagonal[i]).abs();
        greater(left, epsilon) * pivots[i].abs() / magnitudes[i]
    });
    if_positive(pivots, computed, || {
        let found = Factorization::new(mass()).relative_pivots();
        found.map(|pivot| greater(pivot, epsilon) * pivot)
    })
}
