//! What the emitted code names, and nobody else.

pub use nalgebra::{SMatrix, SVector};

use crate::inverse::greater;
use crate::{Factorization, Linearization, Scalar};

/// A field's type, as far as scalars can be made from it.
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

/// The value of a field on the scalar that is being computed with.
#[inline]
pub fn parameter<S: Scalar>(field: impl Parameter) -> S {
    field.on()
}

/// What was computed with these pivots if all are positive; what `otherwise` gives if not, because M is
/// indefinite or singular there.
#[inline]
pub fn if_positive<S: Scalar, T, const K: usize>(
    pivots: [S; K],
    computed: T,
    otherwise: impl FnOnce() -> T,
) -> T {
    if pivots.into_iter().all(|pivot| pivot.smallest() > 0.0) {
        computed
    } else {
        cold(otherwise)
    }
}

#[cold]
#[inline(never)]
fn cold<T>(compute: impl FnOnce() -> T) -> T {
    compute()
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

/// Each pivot in relation to what its rounding error is proportional to, and 0 where M is singular to
/// working precision: where elimination has left less than the machine epsilon of a diagonal entry.
#[inline]
pub fn relative_pivots<S: Scalar, const N: usize>(
    pivots: [S; N],
    magnitudes: [S; N],
    diagonal: [S; N],
) -> SVector<S, N> {
    SVector::from_fn(|i, _| {
        let left = (pivots[i] / diagonal[i]).abs();
        let regular = greater(left, S::from_f64(S::machine_epsilon()));
        regular * pivots[i].abs() / magnitudes[i]
    })
}
