//! A fast hasher: multiplicative hashing by the golden ratio (Knuth, The Art of Computer Programming, volume 3,
//! 2nd edition 1998, section 6.4).
//!
//! The keys are small integers, and nothing depends on the iteration order of hash tables. Macros run without
//! optimization, where the standard hasher, which resists chosen keys, costs more than the lookup itself.

use core::hash::{BuildHasherDefault, Hasher};
use std::collections::{HashMap, HashSet};

/// A hash table that must not be iterated.
pub(crate) type Table<K, V> = HashMap<K, V, BuildHasherDefault<Mixer>>;

/// A set that must not be iterated.
pub(crate) type Set<K> = HashSet<K, BuildHasherDefault<Mixer>>;

/// Mixes what is hashed into one word, a multiplication for each word.
#[derive(Clone, Copy, Default, Debug)]
pub(crate) struct Mixer(u64);

/// 2⁶⁴ over the golden ratio, odd.
const FACTOR: u64 = 0x9e37_79b9_7f4a_7c15;

/// The word `state` with another one mixed in.
pub(crate) const fn mix(state: u64, word: u64) -> u64 {
    (state.rotate_left(23) ^ word).wrapping_mul(FACTOR)
}

impl Hasher for Mixer {
    fn finish(&self) -> u64 {
        // The low bits of a product depend on the low bits of its factors only; tables use both ends.
        self.0 ^ (self.0 >> 32)
    }

    fn write(&mut self, bytes: &[u8]) {
        let mut position = 0;
        while position + 8 <= bytes.len() {
            let mut word = [0; 8];
            word.copy_from_slice(&bytes[position..position + 8]);
            self.0 = mix(self.0, u64::from_le_bytes(word));
            position += 8;
        }
        while position < bytes.len() {
            self.0 = mix(self.0, u64::from(bytes[position]));
            position += 1;
        }
    }

    fn write_u32(&mut self, word: u32) {
        self.0 = mix(self.0, u64::from(word));
    }

    fn write_u64(&mut self, word: u64) {
        self.0 = mix(self.0, word);
    }

    fn write_i64(&mut self, word: i64) {
        self.0 = mix(self.0, word.cast_unsigned());
    }

    fn write_usize(&mut self, word: usize) {
        self.0 = mix(self.0, word as u64);
    }

    fn write_isize(&mut self, word: isize) {
        self.0 = mix(self.0, word.cast_unsigned() as u64);
    }
}
