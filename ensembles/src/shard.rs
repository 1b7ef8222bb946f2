//! Shards: the parts of a study that separate processes compute.

use std::fmt;
use std::str::FromStr;

use crate::error::Error;

/// One of several parts of a study, each of which a process of its own computes: a job of an array of Slurm, of GNU
/// parallel or of Kubernetes. It is written `k/n`, with k from 1 to n.
///
/// ```
/// use lagrangian_ensembles::Shard;
///
/// let shard: Shard = "2/4".parse()?;
/// assert_eq!(shard, Shard::new(2, 4)?);
/// assert_eq!(Shard::new(5, 4).unwrap_err().to_string(), "there is no shard 5/4: in k/n, k is from 1 to n");
/// # Ok::<(), lagrangian_ensembles::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    number: usize,
    count: usize,
}

impl Shard {
    /// Creates the shard `number` of `count`.
    ///
    /// # Errors
    ///
    /// [`Error::Shard`] if `number` is not from 1 to `count`.
    pub fn new(number: usize, count: usize) -> Result<Self, Error> {
        if (1..=count).contains(&number) {
            Ok(Self { number, count })
        } else {
            let text = format!("there is no shard {number}/{count}: in k/n, k is from 1 to n");
            Err(Error::Shard(text))
        }
    }

    /// Whether a chunk is part of this shard: neighbours are of different shards, since neighbours cost alike.
    #[cfg(feature = "parquet")]
    pub(crate) fn contains(self, chunk: usize) -> bool {
        chunk % self.count == self.number - 1
    }
}

impl FromStr for Shard {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self, Error> {
        let parts = text.split_once('/');
        let parts =
            parts.and_then(|(number, count)| Some((number.parse().ok()?, count.parse().ok()?)));
        match parts {
            Some((number, count)) => Self::new(number, count),
            None => Err(Error::Shard(format!(
                "`{text}` is not a shard: write k/n, such as 2/4"
            ))),
        }
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.number, self.count)
    }
}
