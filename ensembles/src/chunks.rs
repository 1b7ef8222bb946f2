//! Chunks: fixed ranges of the indices of the members.

use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::limits::{CHUNKS, MAX_CHUNK, MIN_CHUNK};

/// The partition of the members of a study into ranges of one length. It depends on neither threads nor machines, so
/// that sums over chunks do not either.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Chunks {
    members: usize,
    length: usize,
}

impl Chunks {
    /// Divides `members` into chunks of a length, by default into 1024 chunks, unless these are too short or too long.
    pub(crate) fn new(members: usize, length: Option<usize>) -> Self {
        let length = length.unwrap_or_else(|| members.div_ceil(CHUNKS).clamp(MIN_CHUNK, MAX_CHUNK));
        Self {
            members,
            length: length.clamp(1, members.max(1)),
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
        start..self.members.min(start.saturating_add(self.length))
    }
}

/// Where workers take chunks from.
pub(crate) trait Source: Sync {
    /// Takes the next chunk, and returns its number.
    fn take(&self) -> Option<usize>;

    /// Tells that a worker takes no more.
    fn leave(&self) {}
}

/// All chunks of a study, from which workers take one after the other.
#[derive(Debug)]
pub(crate) struct AllChunks {
    count: usize,
    next: AtomicUsize,
}

impl AllChunks {
    pub(crate) fn new(count: usize) -> Self {
        Self {
            count,
            next: AtomicUsize::new(0),
        }
    }
}

impl Source for AllChunks {
    fn take(&self) -> Option<usize> {
        let chunk = self.next.fetch_add(1, Ordering::Relaxed);
        (chunk < self.count).then_some(chunk)
    }
}

/// A list of chunks from which workers take one after the other.
#[cfg(feature = "parquet")]
#[derive(Debug)]
pub(crate) struct Queue {
    chunks: Vec<usize>,
    next: AtomicUsize,
}

#[cfg(feature = "parquet")]
impl Queue {
    pub(crate) fn new(chunks: impl IntoIterator<Item = usize>) -> Self {
        Self {
            chunks: chunks.into_iter().collect(),
            next: AtomicUsize::new(0),
        }
    }

    /// Returns the numbers of all chunks, in their order.
    pub(crate) fn chunks(&self) -> &[usize] {
        &self.chunks
    }
}

#[cfg(feature = "parquet")]
impl Source for Queue {
    fn take(&self) -> Option<usize> {
        let place = self.next.fetch_add(1, Ordering::Relaxed);
        self.chunks.get(place).copied()
    }
}
