//! The tolerances of adaptive methods.

use super::error::IntegrationError;
use crate::linalg::VectorSpace;
use crate::linalg::lane_select::{is_zero, one_if_zero};
use crate::scalar::Scalar;

/// The tolerances of the error of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Tolerance {
    pub(crate) relative: f64,
    pub(crate) absolute: f64,
}

impl Tolerance {
    pub(crate) fn check(self) -> Result<(), IntegrationError> {
        let Self { relative, absolute } = self;
        let valid = |tolerance: f64| tolerance.is_finite() && tolerance >= 0.0;
        if valid(relative) && valid(absolute) && relative + absolute > 0.0 {
            Ok(())
        } else {
            Err(IntegrationError::InvalidTolerance { relative, absolute })
        }
    }

    /// A component over its tolerance at the larger of two scales, in the worst of its lanes.
    /// A component that is zero counts as 0; any other one with the tolerance zero counts as `unscaled`.
    #[inline]
    fn ratio<S: Scalar>(self, component: S, [before, after]: [S; 2], unscaled: f64) -> f64 {
        let size = component.abs();
        let relative = S::from_f64(self.relative);
        let allowed = S::from_f64(self.absolute) + relative * before.max(after);
        if allowed.smallest() > 0.0 {
            return (size / allowed).largest();
        }
        let without = is_zero(allowed);
        let ratio = (size / one_if_zero(allowed) * (S::one() - without)).largest();
        if (size * without).largest() > 0.0 {
            ratio.max(unscaled)
        } else {
            ratio
        }
    }

    /// The reciprocals of the tolerances at these scales; 0 where the tolerance is 0.
    #[inline]
    pub(crate) fn weights<S: Scalar, X: VectorSpace<S>>(self, scale: &X) -> X {
        let [relative, absolute] = [self.relative, self.absolute].map(S::from_f64);
        scale.map(|scale| {
            let allowed = absolute + relative * scale;
            if allowed.smallest() > 0.0 {
                return S::one() / allowed;
            }
            (S::one() - is_zero(allowed)) / one_if_zero(allowed)
        })
    }

    /// The ratios of all components.
    #[inline]
    pub(crate) fn ratios<S: Scalar, X: VectorSpace<S>>(
        self,
        vector: &X,
        [before, after]: &[X; 2],
        unscaled: f64,
    ) -> impl Iterator<Item = f64> {
        let scales = before.components().zip(after.components());
        let scaled = vector.components().zip(scales);
        scaled.map(move |(component, (a, b))| self.ratio(component, [a, b], unscaled))
    }
}
