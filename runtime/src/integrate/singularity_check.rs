//! Checks that the mass matrix is regular at the start of an integration and at the ends of its steps.

use super::dynamics::Dynamics;
use super::error::IntegrationError;
use super::singularity::Singularity;
use crate::scalar::Scalar;

/// Returns an error if a relative pivot is below `min_pivot`.
pub(crate) fn check_singularity<S: Scalar, D: Dynamics<S> + ?Sized>(
    dynamics: &D,
    t: f64,
    x: &D::State,
    min_pivot: f64,
) -> Result<(), IntegrationError> {
    if min_pivot <= 0.0 {
        return Ok(());
    }
    let found = dynamics.singularity(S::from_f64(t), x, min_pivot);
    found.map_or(Ok(()), |found| Err(singular::<S>(t, found)))
}

/// Returns an error if, at the end of a step, a relative pivot is below `min_pivot`.
#[inline]
pub(crate) fn check_singularity_in_motion<S: Scalar, D: Dynamics<S> + ?Sized>(
    dynamics: &D,
    t: f64,
    x: &D::State,
    min_pivot: f64,
) -> Result<(), IntegrationError> {
    if min_pivot <= 0.0 {
        return Ok(());
    }
    let found = dynamics.singularity_in_motion(S::from_f64(t), x, min_pivot);
    found.map_or(Ok(()), |found| Err(singular::<S>(t, found)))
}

/// Returns the error for a singularity.
#[cold]
pub(crate) fn singular<S: Scalar>(time: f64, singularity: Singularity) -> IntegrationError {
    IntegrationError::SingularConfiguration {
        time,
        estimated_error: S::machine_epsilon() / singularity.relative_pivot(),
        singularity,
    }
}
