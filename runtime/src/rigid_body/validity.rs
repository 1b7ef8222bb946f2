//! Physical validity of masses and inertia tensors.

use super::error::BodyError;
use super::inertia_tensor::InertiaTensor;
use crate::integrate::SingleNumber;
use crate::scalar::Scalar;

/// Checks that a number is positive and finite.
pub(crate) fn positive<S: SingleNumber>(quantity: &'static str, value: S) -> Result<S, BodyError> {
    finite(quantity, value)?;
    if value.smallest() > 0.0 {
        return Ok(value);
    }
    let value = value.smallest();
    Err(BodyError::NotPositive { quantity, value })
}

/// Checks that a number is finite.
pub(crate) fn finite<S: SingleNumber>(quantity: &'static str, value: S) -> Result<S, BodyError> {
    if value.is_finite() {
        return Ok(value);
    }
    let value = value.largest();
    Err(BodyError::NotFinite { quantity, value })
}

/// Checks that a tensor about the centre of gravity belongs to a mass distribution: no principal moment is negative,
/// and none exceeds the sum of the others, by more than `allowed`.
///
/// This means that ∫ **r** **r**ᵀ dm is positive semidefinite: ∫ x₁² dm = ½ (I₂ + I₃ − I₁) ≥ 0, and so on.
pub(super) fn physical<S: SingleNumber>(
    inertia: &InertiaTensor<S>,
    allowed: f64,
) -> Result<(), BodyError> {
    for entry in inertia.matrix().iter() {
        finite("an entry of the inertia tensor", *entry)?;
    }
    let principal = inertia.principal_axes().moments;
    let excess = (principal[2] - principal[1] - principal[0]).largest();
    let moments = principal.map(Scalar::largest);
    if moments[0] < -allowed {
        return Err(BodyError::NegativeMoment { moments });
    }
    if excess > allowed {
        return Err(BodyError::TriangleInequality { moments, excess });
    }
    Ok(())
}
