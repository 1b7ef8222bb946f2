//! Chunks: fixed ranges of the indices of the members.

use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::limits::{MAX_CHUNKS, MIN_CHUNK};

/// The partition of the members of a study into ranges of one length. It depends on neither threads nor machines, so
/// that sums over chunks do not either.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Chunks {
    members: usize,
    length: usize,
}

impl Chunks {
    /// Divides `members` into chunks of a length, by default at most 1024 chunks.
    pub(crate) fn new(members: usize, length: Option<usize>) -> Self {
        let length = length.unwrap_or_else(|| members.div_ceil(MAX_CHUNKS).max(MIN_CHUNK));
        Self {
            members,
            length: length.max(1),
        }
    }

    #[cfg(feature = "parquet")]
    pub(crate) fn members(self) -> usize {
        self.members
    }

    #[cfg(feature = "parquet")]
    pub(crate) fn length(self) -> usize {
        self.length
    }

    /// Returns the number of chunks.
    pub(crate) fn count(self) -> usize {
        self.members.div_ceil(self.length)
    }

    /// Returns the indices of the members of a chunk.
    pub(crate) fn range(self, chunk: usize) -> Range<usize> {
        let start = chunk * self.length;
        start..self.members.min(start + self.length)
    }
}

/// Where workers take chunks from.
pub(crate) trait Source: Sync {
    /// Takes the next chunk; returns its place in the order of delivery, and its number.
    fn take(&self) -> Option<(usize, usize)>;

    /// Tells that a worker takes no more.
    fn leave(&self) {}
}

/// A list of chunks from which workers take one after the other.
#[derive(Debug)]
pub(crate) struct Queue {
    chunks: Vec<usize>,
    next: AtomicUsize,
}

impl Queue {
    pub(crate) fn new(chunks: impl IntoIterator<Item = usize>) -> Self {
        Self {
            chunks: chunks.into_iter().collect(),
            next: AtomicUsize::new(0),
        }
    }

    /// Returns the numbers of all chunks, in their order.
    #[cfg(feature = "parquet")]
    pub(crate) fn chunks(&self) -> &[usize] {
        &self.chunks
    }
}

impl Source for Queue {
    fn take(&self) -> Option<(usize, usize)> {
        let place = self.next.fetch_add(1, Ordering::Relaxed);
        self.chunks.get(place).map(|chunk| (place, *chunk))
    }
}
