//! Sums with their common factors in front.

use crate::algebra::index_table::IndexTable;
use crate::{Expression, Rational};

/// A sum as number · Π common · rest.
#[derive(Clone, Debug)]
pub(crate) struct Split {
    pub(crate) number: Rational,
    pub(crate) common: Vec<(Expression, Rational)>,
    pub(crate) rest: Expression,
}

/// The splits of sums that have been computed. Most sums have none.
#[derive(Clone, Debug, Default)]
pub(crate) struct KnownSplits {
    /// By sum: 0 where it has no split, else one more than its place among the splits.
    places: IndexTable,
    splits: Vec<Split>,
}

impl KnownSplits {
    /// The place of the split of a sum, if it has been computed.
    pub(super) fn place(&self, sum: Expression) -> Option<usize> {
        self.places.get(sum.index())
    }

    /// The split at a place.
    pub(super) fn at(&self, place: usize) -> Option<Split> {
        self.splits.get(place.checked_sub(1)?).cloned()
    }

    pub(super) fn keep(&mut self, sum: Expression, split: Option<&Split>) {
        self.splits.extend(split.cloned());
        let place = split.map_or(0, |_| self.splits.len());
        self.places.insert(sum.index(), place);
    }
}
