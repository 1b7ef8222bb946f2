//! Sets of conditions and events.

use core::fmt;

/// A set of stop conditions that are met, of events that occur, or of event functions that are watched, as numbers below 64. Events
/// and conditions are counted from 0 in the order of the settings, functions in the order of the declaration.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct MetConditions(u64);

impl fmt::Debug for MetConditions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_set().entries(self.indices()).finish()
    }
}

impl MetConditions {
    /// The largest number of conditions.
    pub(crate) const MAX: usize = 64;

    /// The empty set.
    pub(crate) const EMPTY: Self = Self(0);

    /// Returns the set of the indices at which the iterator is true.
    pub(crate) fn of(conditions: impl Iterator<Item = bool>) -> Self {
        let bits = (0..u64::BITS).zip(conditions);
        Self(bits.fold(0, |met, (i, is_met)| met | u64::from(is_met) << i))
    }

    /// Returns the set whose indices are the bits of a number.
    pub(crate) fn from_bits(bits: u64) -> Self {
        Self(bits)
    }

    pub(crate) fn bits(self) -> u64 {
        self.0
    }

    /// Returns the set in a list with `count` other conditions before it.
    #[must_use]
    pub(crate) fn shifted(self, count: usize) -> Self {
        let count = u32::try_from(count).unwrap_or(u32::MAX);
        Self(self.0.checked_shl(count).unwrap_or(0))
    }

    /// Returns the conditions from the index `count` on, renumbered from 0.
    #[must_use]
    pub(crate) fn behind(self, count: usize) -> Self {
        let count = u32::try_from(count).unwrap_or(u32::MAX);
        Self(self.0.checked_shr(count).unwrap_or(0))
    }

    /// Returns the conditions before the index `count`.
    #[must_use]
    pub(crate) fn before(self, count: usize) -> Self {
        let others = self.behind(count).shifted(count);
        Self(self.0 & !others.0)
    }

    /// Adds an index below 64.
    #[inline]
    pub(crate) fn insert(&mut self, index: usize) {
        self.0 |= u32::try_from(index).map_or(0, |i| 1_u64.checked_shl(i).unwrap_or(0));
    }

    /// Whether the set is not empty.
    #[must_use]
    #[inline]
    pub fn any(self) -> bool {
        self.0 != 0
    }

    /// Whether the set contains the condition with this index.
    #[must_use]
    #[inline]
    pub fn contains(self, index: usize) -> bool {
        let shifted = u32::try_from(index)
            .ok()
            .and_then(|i| self.0.checked_shr(i));
        shifted.is_some_and(|bits| bits & 1 == 1)
    }

    /// Returns the indices in ascending order.
    pub fn indices(self) -> impl Iterator<Item = usize> {
        let mut rest = self.0;
        core::iter::from_fn(move || {
            let first = (rest != 0).then(|| rest.trailing_zeros() as usize);
            // The lowest bit is removed.
            rest &= rest.wrapping_sub(1);
            first
        })
    }

    /// Returns the indices of this set that are not in another one.
    #[must_use]
    #[inline]
    pub(crate) fn without(self, other: Self) -> Self {
        Self(self.0 & !other.0)
    }

    /// Returns the union of two sets.
    #[must_use]
    #[inline]
    pub(crate) fn or(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}
