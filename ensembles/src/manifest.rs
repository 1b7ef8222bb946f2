//! The manifest of a folder: which study its chunks are of.

use std::fs;
use std::io::{self, Write as _};
use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::chunks::Chunks;
use crate::column::{Bins, Column};
use crate::error::Error;
use crate::metadata;
use crate::parquet::temporary;

/// The name of the file.
/// Readers of folders of Parquet files ignore names with an underscore.
pub(crate) const MANIFEST: &str = "_manifest.json";

/// Which study the chunks of a folder are of. A folder is resumed only by a study with an equal manifest.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub(crate) struct Manifest {
    /// The version of the library.
    lagrangian: String,
    members: usize,
    /// The number of members of a chunk.
    chunk: usize,
    /// The description of the points.
    points: String,
    /// The type of the problems: their equations, events, reactions, and what is kept.
    problem: String,
    /// The method with its settings.
    method: String,
    /// A hash of initial states, derivatives there and nearby, and ends.
    fingerprint: String,
    columns: Vec<ManifestColumn>,
    metadata: Vec<(String, String)>,
}

#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
struct ManifestColumn {
    name: String,
    unit: String,
    histogram: Option<(f64, f64, usize)>,
}

/// What distinguishes a study from others.
pub(crate) struct Identity<'a> {
    pub(crate) chunks: Chunks,
    pub(crate) points: String,
    pub(crate) problem: String,
    pub(crate) method: String,
    /// Numbers of some members.
    pub(crate) numbers: Vec<f64>,
    pub(crate) columns: &'a [Column],
    pub(crate) metadata: &'a [(String, String)],
}

impl Manifest {
    pub(crate) fn new(identity: Identity<'_>) -> Self {
        let columns = identity.columns.iter().map(|column| ManifestColumn {
            name: column.name.clone(),
            unit: column.unit.clone(),
            histogram: column.bins.map(|bins| (bins.low, bins.high, bins.count)),
        });
        Self {
            lagrangian: env!("CARGO_PKG_VERSION").to_owned(),
            members: identity.chunks.members(),
            chunk: identity.chunks.length(),
            points: identity.points,
            problem: identity.problem,
            method: identity.method,
            fingerprint: format!("{:016x}", hash(&identity.numbers)),
            columns: columns.collect(),
            metadata: identity.metadata.to_vec(),
        }
    }

    pub(crate) fn chunks(&self) -> Chunks {
        Chunks::new(self.members, Some(self.chunk))
    }

    pub(crate) fn columns(&self) -> Vec<Column> {
        let columns = self.columns.iter().map(|column| {
            let bins = column.histogram;
            Column {
                name: column.name.clone(),
                unit: column.unit.clone(),
                bins: bins.map(|(low, high, count)| Bins { low, high, count }),
            }
        });
        columns.collect()
    }

    /// Returns the metadata of the files.
    pub(crate) fn metadata(&self) -> Vec<(String, String)> {
        metadata::all(self.members, self.points.clone(), &self.metadata)
    }

    /// Reads the manifest of a folder; `None` if there is none.
    pub(crate) fn read(folder: &Path) -> Result<Option<Self>, Error> {
        let path = folder.join(MANIFEST);
        let text = match fs::read_to_string(&path) {
            Ok(text) => text,
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
            Err(error) => return Err(Error::file(&path, "read")(error)),
        };
        serde_json::from_str(&text)
            .map(Some)
            .map_err(Error::file(&path, "read"))
    }

    /// Writes the manifest of a folder unless there is one; it appears as a whole.
    pub(crate) fn write_first(&self, folder: &Path) -> Result<(), Error> {
        let path = folder.join(MANIFEST);
        let mut file = temporary(&path)?;
        serde_json::to_writer_pretty(&mut file, self).map_err(Error::file(&path, "written"))?;
        file.flush().map_err(Error::file(&path, "written"))?;
        file.as_file()
            .sync_all()
            .map_err(Error::file(&path, "written"))?;
        match file.persist_noclobber(&path) {
            Err(error) if error.error.kind() != io::ErrorKind::AlreadyExists => {
                Err(Error::file(&path, "written")(error.error))
            }
            _ => Ok(()),
        }
    }

    /// Returns what differs in the manifest of another study, there and in this one.
    pub(crate) fn difference(&self, other: &Self) -> Option<[String; 3]> {
        let text = |value: &dyn std::fmt::Debug| format!("{value:?}");
        let parts = [
            (
                "version of lagrangian",
                text(&self.lagrangian),
                text(&other.lagrangian),
            ),
            (
                "number of members",
                text(&self.members),
                text(&other.members),
            ),
            (
                "number of members in a chunk",
                text(&self.chunk),
                text(&other.chunk),
            ),
            ("points", text(&self.points), text(&other.points)),
            ("problem", text(&self.problem), text(&other.problem)),
            ("method", text(&self.method), text(&other.method)),
            ("columns", text(&self.columns), text(&other.columns)),
            ("metadata", text(&self.metadata), text(&other.metadata)),
            (
                "fingerprint of parameters, initial states and ends",
                text(&self.fingerprint),
                text(&other.fingerprint),
            ),
        ];
        let different = parts.into_iter().find(|(_, this, other)| this != other);
        different.map(|(part, this, other)| [part.to_owned(), other, this])
    }
}

/// Returns a hash of numbers, bit by bit (Fowler, Noll, Vo, FNV-1a with 64 bits).
fn hash(numbers: &[f64]) -> u64 {
    // Compilers differ in the sign of NaN.
    let number = |number: &f64| if number.is_nan() { f64::NAN } else { *number };
    let bytes = numbers
        .iter()
        .flat_map(|x| number(x).to_bits().to_le_bytes());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

#[cfg(test)]
mod tests {
    use super::hash;

    #[test]
    fn hashes_are_of_bits_besides_the_sign_of_nan() {
        assert_eq!(hash(&[1.0, f64::NAN]), hash(&[1.0, -f64::NAN]));
        for other in [[1.0, 2.0], [-1.0, f64::NAN], [1.0 + f64::EPSILON, f64::NAN]] {
            assert_ne!(hash(&[1.0, f64::NAN]), hash(&other));
        }
    }
}
