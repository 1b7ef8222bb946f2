//! The event functions that have no zero in a step.

use super::met_conditions::MetConditions;

/// The functions of [`EventDynamics`](super::EventDynamics) that have one sign in a whole step, as far as their first terms tell.
#[derive(Clone, Copy, Debug, Default)]
pub struct OneSigned {
    examined: MetConditions,
    positive: MetConditions,
    negative: MetConditions,
}

impl OneSigned {
    /// Records the sign of the function with an index, or 0 if it may have a zero. Functions beyond the first 64 are not
    /// recorded.
    #[inline]
    pub(crate) fn insert(&mut self, index: usize, sign: f64) {
        self.examined.insert(index);
        if sign > 0.0 {
            self.positive.insert(index);
        } else if sign < 0.0 {
            self.negative.insert(index);
        }
    }

    /// Returns the sign of the function with an index, if it has one in the whole step.
    #[inline]
    pub(crate) fn sign(self, index: usize) -> Option<f64> {
        if self.positive.contains(index) {
            Some(1.0)
        } else {
            self.negative.contains(index).then_some(-1.0)
        }
    }

    /// Whether the first terms of the function with an index do not exclude a zero.
    #[inline]
    pub(crate) fn may_have_zero(self, index: usize) -> bool {
        self.examined.contains(index) && self.sign(index).is_none()
    }
}
