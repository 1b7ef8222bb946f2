//! The family of coordinates whose equations may be folded, and the members that are its samples.

use core::ops;

use crate::Expression;
use crate::limits::MIN_FOLDED_LINES;
use crate::print::index::{Index, Range};
use crate::print::listing::composer::Composer;
use crate::print::listing::index_families::Families;
use crate::print::listing::index_letters::IndexLetters;

/// A family of coordinates, one behind the other, and a pair of its members.
pub(crate) struct Sampling {
    pub(crate) families: Families,
    /// The position of the first member among the coordinates.
    pub(crate) place: usize,
    /// The first and the last index.
    pub(crate) first: i64,
    pub(crate) last: i64,
    /// The indices of two members, neither of them at an end where there are many.
    pub(crate) pair: [i64; 2],
}

impl Sampling {
    /// The longest family of a model, if it is long enough to be folded.
    pub(crate) fn of(composer: &Composer<'_>) -> Option<Self> {
        let families = Families::of(&composer.declared.names);
        let (place, [first, last]) = families.longest_run(composer.model.coordinates)?;
        let count = last - first + 1;
        let fewest: i64 = MIN_FOLDED_LINES.try_into().ok()?;
        let start = first + count / 4;
        let pair = [start, start + (count + 1) / 3];
        (count >= fewest && pair[1] < last).then_some(Self {
            families,
            place,
            first,
            last,
            pair,
        })
    }

    /// The positions of the pair among the coordinates.
    pub(crate) fn positions(&self) -> [usize; 2] {
        self.pair
            .map(|index| self.place + usize::try_from(index - self.first).unwrap_or(0))
    }

    /// The positions of the family among the coordinates.
    pub(crate) fn rows(&self) -> ops::Range<usize> {
        let count = usize::try_from(self.last - self.first + 1).unwrap_or(0);
        self.place..self.place + count
    }

    /// The rows and columns of the family.
    pub(crate) fn block(&self, mass: &[Vec<Expression>]) -> Vec<Vec<Expression>> {
        let rows = mass[self.rows()].iter();
        rows.map(|row| row[self.rows()].to_vec()).collect()
    }

    /// All pairs, row by row.
    pub(crate) fn pairs(&self) -> impl Iterator<Item = [i64; 2]> {
        let [first, last] = [self.first, self.last];
        (first..=last).flat_map(move |i| (first..=last).map(move |j| [i, j]))
    }

    /// The range of an index.
    pub(crate) fn range(&self, index: char, letters: IndexLetters) -> Range {
        Range {
            variable: letters.text(index),
            first: Index::Number(self.first),
            last: Index::Number(self.last),
        }
    }
}
