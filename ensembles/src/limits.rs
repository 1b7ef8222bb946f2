//! All limits.

/// The least number of members in a chunk by default: lanes run empty at the end of a chunk when nothing follows.
pub(crate) const MIN_CHUNK: usize = 64;

/// The greatest number of members in a chunk by default: what a thread holds in memory grows with it.
pub(crate) const MAX_CHUNK: usize = 10_000;

/// The number of chunks by default, where their length is between the two.
pub(crate) const CHUNKS: usize = 1024;

/// The greatest dimension of Sobol's sequence: the direction numbers of Joe and Kuo (2008) that are compiled in.
pub(crate) const MAX_SOBOL_DIMENSION: usize = 1000;

/// The greatest dimension of Halton's sequence: its bases are primes below 256.
pub(crate) const MAX_HALTON_DIMENSION: usize = 54;

/// The number of centroids of the digests from which quantiles are estimated.
pub(crate) const MAX_CENTROIDS: usize = 1000;

/// The number of failures of which a summary keeps the index and the message.
pub(crate) const MAX_KEPT_FAILURES: usize = 100;

/// The number of members whose initial states, derivatives and ends are compared before a folder is resumed; of more
/// members, so many are chosen at equal distances.
#[cfg(feature = "parquet")]
pub(crate) const MAX_COMPARED_MEMBERS: usize = 10_000;
