//! Conversion into vectors of fixed size.

use nalgebra::SVector;

use crate::scalar::Scalar;

/// A type that can be converted to a vector of `K` numbers: an `SVector<S, K>`, an array `[S; K]`, or a single number
/// if `K` is 1.
///
/// ```
/// use lagrangian::IntoVector;
/// use lagrangian::nalgebra::SVector;
///
/// fn coordinates<const N: usize>(written: impl IntoVector<f64, N>) -> SVector<f64, N> {
///     written.into_vector()
/// }
///
/// assert_eq!(coordinates(2.0), SVector::from([2.0]));
/// assert_eq!(coordinates([2.0, 3.0]), SVector::from([2.0, 3.0]));
/// assert_eq!(coordinates(SVector::from([2.0, 3.0])), SVector::from([2.0, 3.0]));
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a vector of {K} components of type `{S}`",
    label = "{K} components of type `{S}` are expected",
    note = "write an array `[{S}; {K}]` or an `SVector<{S}, {K}>`, for one component also the number; real \
            numbers have a point, such as `0.0`; a controller gives the inputs and the derivatives of its states \
            as a pair"
)]
pub trait IntoVector<S: Scalar, const K: usize> {
    /// Returns the vector of these numbers.
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
