//! Tables whose keys are small numbers, written as plain loops since macros run without optimization.

use crate::algebra::hashing::mix;

/// Small numbers by small numbers that are dense, such as positions of expressions.
#[derive(Clone, Debug, Default)]
pub(crate) struct IndexTable {
    /// One more than the value, 0 where there is none.
    entries: Vec<u32>,
}

impl IndexTable {
    pub(crate) fn get(&self, key: usize) -> Option<usize> {
        match self.entries.get(key) {
            None | Some(0) => None,
            Some(entry) => Some(*entry as usize - 1),
        }
    }

    pub(crate) fn insert(&mut self, key: usize, value: usize) {
        if key >= self.entries.len() {
            let mut longer = vec![0; (key + 1).next_power_of_two()];
            longer[..self.entries.len()].copy_from_slice(&self.entries);
            self.entries = longer;
        }
        self.entries[key] = u32::try_from(value + 1).unwrap_or(0);
    }
}

/// Values by pairs of small numbers: open addressing with linear probing (Knuth, The Art of Computer Programming,
/// volume 3, 2nd edition 1998, section 6.4, algorithm L). At most half of the slots are occupied.
#[derive(Clone, Debug)]
pub(crate) struct PairTable<V> {
    /// Key and one more than the position of the value, 0 where there is none.
    slots: Vec<(u64, u32)>,
    values: Vec<V>,
}

impl<V> Default for PairTable<V> {
    fn default() -> Self {
        Self {
            slots: Vec::new(),
            values: Vec::new(),
        }
    }
}

impl<V: Copy> PairTable<V> {
    pub(crate) fn get(&self, first: usize, second: usize) -> Option<V> {
        if self.slots.is_empty() {
            return None;
        }
        let (_, entry) = self.slots[self.slot(key(first, second))];
        self.values.get((entry as usize).wrapping_sub(1)).copied()
    }

    /// Enters a pair that is not here yet.
    pub(crate) fn insert(&mut self, first: usize, second: usize, value: V) {
        if 2 * (self.values.len() + 1) > self.slots.len() {
            self.grow();
        }
        self.values.push(value);
        let key = key(first, second);
        let slot = self.slot(key);
        self.slots[slot] = (key, u32::try_from(self.values.len()).unwrap_or(0));
    }

    /// The slot of a key, or the free one where it would be inserted.
    #[allow(clippy::cast_possible_truncation)] // What is cut off is beyond the mask.
    fn slot(&self, key: u64) -> usize {
        let mask = self.slots.len() - 1;
        let code = mix(0, key);
        let mut slot = (code ^ (code >> 32)) as usize & mask;
        while self.slots[slot].1 != 0 && self.slots[slot].0 != key {
            slot = (slot + 1) & mask;
        }
        slot
    }

    fn grow(&mut self) {
        let size = (2 * self.slots.len()).max(16);
        let slots = core::mem::replace(&mut self.slots, vec![(0, 0); size]);
        for (key, entry) in slots {
            if entry != 0 {
                let slot = self.slot(key);
                self.slots[slot] = (key, entry);
            }
        }
    }
}

/// Positions in the arena and in a product are below 2³².
fn key(first: usize, second: usize) -> u64 {
    (first as u64) << 32 | second as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_entered_is_found_and_nothing_else() {
        let (mut dense, mut pairs) = (IndexTable::default(), PairTable::default());
        assert_eq!((dense.get(0), pairs.get(0, 0)), (None, None));
        for k in (0..1000).step_by(3) {
            dense.insert(k, k / 2);
            pairs.insert(k % 30, k, k);
        }
        for k in 0..1000 {
            let entered = k % 3 == 0;
            assert_eq!(dense.get(k), entered.then_some(k / 2));
            assert_eq!(pairs.get(k % 30, k), entered.then_some(k));
            assert_eq!(pairs.get(k, 1001), None);
        }
        assert_eq!(dense.get(5000), None);
    }
}
