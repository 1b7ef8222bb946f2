//! The event functions that have no zero in a step.

use super::met_conditions::MetConditions;

/// The functions of [`EventDynamics`](super::EventDynamics) that have one sign in a whole step, as far as their first terms tell.
#[derive(Clone, Copy, Debug)]
pub struct OneSigned {
    examined: MetConditions,
    positive: MetConditions,
    negative: MetConditions,
}

impl OneSigned {
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

/// The event functions that have one sign in the step of each lane.
pub(crate) struct OneSignedInLanes<const L: usize> {
    /// Functions are examined in every lane at once.
    examined: MetConditions,
    positive: [MetConditions; L],
    negative: [MetConditions; L],
}

impl<const L: usize> OneSignedInLanes<L> {
    /// Nothing is known of any function.
    pub(crate) const UNKNOWN: Self = Self {
        examined: MetConditions::EMPTY,
        positive: [MetConditions::EMPTY; L],
        negative: [MetConditions::EMPTY; L],
    };

    /// Records the sign of the function with an index in each lane, or 0 if it may have a zero. Functions beyond the first 64 are not
    /// recorded.
    #[inline]
    pub(crate) fn insert(&mut self, index: usize, signs: &[f64; L]) {
        let mut function = MetConditions::EMPTY;
        function.insert(index);
        self.examined = self.examined.or(function);
        let added = |is_of_sign| {
            if is_of_sign {
                function
            } else {
                MetConditions::EMPTY
            }
        };
        for (positive, sign) in self.positive.iter_mut().zip(signs) {
            *positive = positive.or(added(*sign > 0.0));
        }
        for (negative, sign) in self.negative.iter_mut().zip(signs) {
            *negative = negative.or(added(*sign < 0.0));
        }
    }

    /// Returns the functions in the step of a lane.
    #[inline]
    pub(crate) fn of_lane(&self, lane: usize) -> OneSigned {
        OneSigned {
            examined: self.examined,
            positive: self.positive[lane],
            negative: self.negative[lane],
        }
    }
}
