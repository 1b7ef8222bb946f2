//! The results of a study in folders, chunk by chunk.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::chunks::Chunks;
use crate::column::Column;
use crate::error::Error;
use crate::manifest::{MANIFEST, Manifest};
use crate::parquet::{self, Writer};
use crate::summary::Summary;
use crate::table::Table;
use crate::tree::Tree;

/// The results of a study in one or several folders.
#[derive(Clone, Debug)]
pub struct Results {
    manifest: Manifest,
    folder: PathBuf,
    /// The files of the finished chunks.
    files: BTreeMap<usize, PathBuf>,
}

impl Results {
    /// Opens the results of a study: its folder, or those of its shards.
    ///
    /// # Errors
    ///
    /// If a folder contains no results or those of another study, or a file cannot be read.
    pub fn open<P: AsRef<Path>>(folders: impl IntoIterator<Item = P>) -> Result<Self, Error> {
        let results = Self::find(folders)?;
        results.check()?;
        Ok(results)
    }

    /// Returns an error if a file is not complete.
    pub(crate) fn check(&self) -> Result<(), Error> {
        self.files().try_for_each(parquet::check)
    }

    /// Finds the files of the finished chunks by their names.
    pub(crate) fn find<P: AsRef<Path>>(
        folders: impl IntoIterator<Item = P>,
    ) -> Result<Self, Error> {
        let mut results: Option<Self> = None;
        for folder in folders {
            let folder = folder.as_ref();
            let manifest = Manifest::read(folder)?.ok_or_else(|| Error::Folder {
                path: folder.to_path_buf(),
                text: format!("it has no {MANIFEST}: it does not contain the results of a study"),
            })?;
            let results = match &mut results {
                Some(results) => {
                    if let Some([part, other, first]) = results.manifest.difference(&manifest) {
                        let before = results.folder.display();
                        return Err(Error::Folder {
                            path: folder.to_path_buf(),
                            text: format!(
                                "it contains the results of another study than {before}; the {part}: {other} here, {first} there; name the folders of one study"
                            ),
                        });
                    }
                    results
                }
                none => none.insert(Self {
                    manifest,
                    folder: folder.to_path_buf(),
                    files: BTreeMap::new(),
                }),
            };
            let files = fs::read_dir(folder).map_err(Error::file(folder, "read"))?;
            for file in files {
                let path = file.map_err(Error::file(folder, "read"))?.path();
                let chunk = path.file_name().and_then(|name| number(name.to_str()?));
                if let Some(chunk) = chunk.filter(|chunk| *chunk < results.chunks().count()) {
                    results.files.entry(chunk).or_insert(path);
                }
            }
        }
        results.ok_or_else(|| Error::Folder {
            path: PathBuf::new(),
            text: "there is none to open".to_owned(),
        })
    }

    /// Whether a chunk is finished.
    pub(crate) fn contains(&self, chunk: usize) -> bool {
        self.files.contains_key(&chunk)
    }

    fn chunks(&self) -> Chunks {
        self.manifest.chunks()
    }

    /// Whether the files of all chunks are there.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.files.len() == self.chunks().count()
    }

    /// Returns the number of members in the files that are there.
    #[must_use]
    pub fn finished(&self) -> usize {
        let chunks = self.chunks();
        self.files
            .keys()
            .map(|chunk| chunks.range(*chunk).len())
            .sum()
    }

    /// Returns the files of the finished chunks, in the order of the members.
    pub fn files(&self) -> impl Iterator<Item = &Path> {
        self.files.values().map(PathBuf::as_path)
    }

    /// Reads the rows of all chunks.
    ///
    /// # Errors
    ///
    /// If a file cannot be read.
    pub fn table(&self) -> Result<Table, Error> {
        let columns = self.manifest.columns();
        let mut all = Table::new(columns.clone()).with_metadata(self.manifest.metadata());
        for chunk in self.files.keys() {
            all.append(self.read(*chunk, &columns)?);
        }
        Ok(all)
    }

    /// Returns the statistics of the columns, chunk by chunk: to the last bit those of
    /// [`Study::summary`](crate::Study::summary).
    ///
    /// # Errors
    ///
    /// If a file cannot be read.
    pub fn summary(&self) -> Result<Summary, Error> {
        let columns = self.manifest.columns();
        let tree = Tree::new(Summary::merged);
        for chunk in self.files.keys() {
            tree.add(*chunk, self.read(*chunk, &columns)?.summary());
        }
        Ok(tree.finish().unwrap_or_else(|| Summary::new(&columns)))
    }

    /// Reads the rows of a finished chunk.
    fn read(&self, chunk: usize, columns: &[Column]) -> Result<Table, Error> {
        let mut table = Table::new(columns.to_vec());
        if let Some(path) = self.files.get(&chunk) {
            table = parquet::read(path, columns)?;
            // Members without rows have ended, too.
            table.count(self.chunks().range(chunk).len());
        }
        Ok(table)
    }

    /// Merges the files of all chunks into one, chunk by chunk.
    ///
    /// # Errors
    ///
    /// If chunks are missing, or a file cannot be read or written.
    pub fn merge_into(&self, path: impl AsRef<Path>) -> Result<(), Error> {
        let count = self.chunks().count();
        let missing: Vec<usize> = (0..count).filter(|chunk| !self.contains(*chunk)).collect();
        if let Some(first) = missing.first() {
            return Err(Error::Folder {
                path: self.folder.clone(),
                text: format!(
                    "{} of {count} chunks are missing, the first is {}: run the study again, or name the folders of all shards",
                    missing.len(),
                    name(*first)
                ),
            });
        }
        let columns = self.manifest.columns();
        let mut whole = Writer::new(path.as_ref(), &columns, &self.manifest.metadata())?;
        for path in self.files() {
            whole.add(&parquet::read(path, &columns)?)?;
        }
        whole.finish()
    }
}

/// Returns the name of the file of a chunk.
pub(crate) fn name(chunk: usize) -> String {
    format!("chunk-{chunk:06}.parquet")
}

/// Returns the number of the chunk whose file has a name.
fn number(file: &str) -> Option<usize> {
    let number = file
        .strip_prefix("chunk-")?
        .strip_suffix(".parquet")?
        .parse()
        .ok()?;
    (name(number) == file).then_some(number)
}
