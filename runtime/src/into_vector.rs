//! What a control law may return.

use nalgebra::SVector;

use crate::Scalar;

/// `K` numbers as a control law writes them: an `SVector<S, K>`, an array `[S; K]`, or a number if `K`
/// is 1.
///
/// ```
/// use lagrangian::IntoVector;
/// use nalgebra::SVector;
///
/// fn inputs<const U: usize>(returned: impl IntoVector<f64, U>) -> SVector<f64, U> {
///     returned.into_vector()
/// }
///
/// assert_eq!(inputs(2.0), SVector::from([2.0]));
/// assert_eq!(inputs([2.0, 3.0]), SVector::from([2.0, 3.0]));
/// assert_eq!(inputs(SVector::from([2.0, 3.0])), SVector::from([2.0, 3.0]));
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a vector of {K} components of type `{S}`",
    label = "{K} components of type `{S}` are expected",
    note = "return an array `[{S}; {K}]` or an `SVector<{S}, {K}>`, for one component also the number; for \
            a controller, the inputs and the derivatives of its states as a pair"
)]
pub trait IntoVector<S: Scalar, const K: usize> {
    /// The vector of these numbers.
    fn into_vector(self) -> SVector<S, K>;
}

impl<S: Scalar> IntoVector<S, 1> for S {
    #[inline]
    fn into_vector(self) -> SVector<S, 1> {
        SVector::from([self])
    }
}

impl<S: Scalar, const K: usize> IntoVector<S, K> for [S; K] {
    #[inline]
    fn into_vector(self) -> SVector<S, K> {
        self.into()
    }
}

impl<S: Scalar, const K: usize> IntoVector<S, K> for SVector<S, K> {
    #[inline]
    fn into_vector(self) -> SVector<S, K> {
        self
    }
}
