//! Studies in folders: one file for each chunk, computed by whoever comes first.

use std::fs;
#[cfg(feature = "mpi")]
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
#[cfg(feature = "mpi")]
use std::sync::atomic::AtomicBool;

use crate::chunks::Queue;
use crate::column::Column;
use crate::error::Error;
use crate::limits::MAX_COMPARED_MEMBERS;
use crate::manifest::{Identity, MANIFEST, Manifest};
use crate::members::{Found, Members};
use crate::motion::Motion;
use crate::parquet::{self, Writer};
use crate::points::Points;
#[cfg(feature = "mpi")]
use crate::ranks::{AbortOnPanic, Ranks, Requests};
use crate::results::{Results, name};
use crate::rows::Rows;
use crate::shard::Shard;
use crate::sinks::Tables;
use crate::study::Study;
use crate::table::Table;
use crate::workers::{Entries, Sink};

/// The folder into which a study is written, and which part of the study this process computes.
///
/// A path is a folder for the whole study: `study.write("flips", …)`.
#[derive(Debug)]
pub struct Folder {
    path: PathBuf,
    shard: Option<Shard>,
    #[cfg(feature = "mpi")]
    ranks: Option<Ranks>,
}

impl Folder {
    /// Creates a folder for the whole study.
    pub fn new(path: impl Into<PathBuf>) -> Self {
        Self {
            path: path.into(),
            shard: None,
            #[cfg(feature = "mpi")]
            ranks: None,
        }
    }

    /// Computes only a part of the study in this process. Others compute the others, into the same folder or into one of
    /// their own.
    #[must_use]
    pub fn shard(mut self, shard: Shard) -> Self {
        self.shard = Some(shard);
        self
    }

    /// Computes the study on all ranks of a communicator of MPI, all of which call [`Study::write`](crate::Study::write).
    /// Rank 0 hands out the chunks on request. Each rank computes on all its threads; only the calling thread uses MPI,
    /// which must be initialized by `mpi::initialize_with_threading(mpi::Threading::Funneled)`.
    ///
    /// If a rank dies, MPI ends all; the study then continues after the finished chunks, with any number of ranks.
    #[cfg(feature = "mpi")]
    #[must_use]
    pub fn ranks(mut self, communicator: &impl mpi::traits::Communicator) -> Self {
        self.ranks = Some(Ranks::new(communicator));
        self
    }
}

impl From<&str> for Folder {
    fn from(path: &str) -> Self {
        Self::new(path)
    }
}

impl From<&Path> for Folder {
    fn from(path: &Path) -> Self {
        Self::new(path)
    }
}

impl From<PathBuf> for Folder {
    fn from(path: PathBuf) -> Self {
        Self::new(path)
    }
}

impl<M: Members> Study<'_, M> {
    /// Integrates all members, and writes the `rows` of each motion into a folder: one Parquet file for each chunk, and a
    /// manifest that tells which study it is. `rows` returns `[x, y]` for a single row, or a `Vec` of rows; the
    /// parameters of the points are the first columns.
    ///
    /// A file appears when it is complete. Chunks whose files are there are not computed again: a study that was
    /// interrupted, even by the end of its process, continues after them. The bytes of the files depend on neither
    /// interruptions nor threads nor shards. If an observer cancels the study, chunks that are not complete are left out.
    ///
    /// # Errors
    ///
    /// If there are no points or they are invalid, two columns have one name, the folder contains the results of
    /// another study, or a file cannot be read or written. Finished chunks are kept.
    pub fn write<const N: usize, A: Into<Column>, B: Rows<N>>(
        &self,
        folder: impl Into<Folder>,
        columns: [A; N],
        rows: impl Fn(&Motion<<M::Points as Points>::Point, M::State, M::Kept>) -> B + Sync,
    ) -> Result<Results, Error> {
        let folder = folder.into();
        let columns = self.columns(columns)?;
        let manifest = self.manifest(&columns);
        let path = &folder.path;
        let pool = self.own_pool();
        #[cfg(feature = "mpi")]
        let _guard = folder.ranks.as_ref().map(AbortOnPanic);
        let claimed = claim(path, &manifest).and_then(|()| Results::find([path]));
        let claimed = claimed.and_then(|before| Ok((before, pool?)));
        #[cfg(feature = "mpi")]
        let is_first = folder.ranks.as_ref().is_none_or(Ranks::is_first);
        #[cfg(not(feature = "mpi"))]
        let is_first = true;
        let claimed = match claimed {
            Ok((before, pool)) if is_first => before.check().map(|()| (before, pool)),
            claimed => claimed,
        };
        #[cfg(feature = "mpi")]
        let claimed = agree(folder.ranks.as_ref(), claimed, path);
        let (before, pool) = claimed?;
        let chunks = self.chunks();
        let is_ours = |chunk: &usize| folder.shard.is_none_or(|shard| shard.contains(*chunk));
        let missing = (0..chunks.count()).filter(|chunk| !before.contains(*chunk));
        let queue = Queue::new(missing.filter(is_ours));
        let count = queue
            .chunks()
            .iter()
            .map(|chunk| chunks.range(*chunk).len());
        let count = count.sum();
        let sink = Files {
            tables: Tables::<_, N> { columns, rows },
            path,
            metadata: manifest.metadata(),
        };
        let pool = Some(&pool);
        let observer = |ended| self.observe(ended);
        let own = (&queue, count, &observer as &_);
        #[cfg(feature = "mpi")]
        let run = match &folder.ranks {
            Some(ranks) if ranks.is_first() => {
                let serve =
                    |_, is_stopped: &AtomicBool| ranks.hand_out(&queue, is_stopped, observer);
                self.run(own, pool, &sink, &(), serve)
            }
            Some(ranks) => {
                let (source, requests) = Requests::new();
                let serve = |workers, is_stopped: &AtomicBool| {
                    ranks.ask((&source, &requests), workers, is_stopped);
                };
                let observer = |ended| {
                    source.count(ended);
                    ControlFlow::Continue(())
                };
                self.run((&source, count, &observer), pool, &sink, &(), serve)
            }
            None => self.run(own, pool, &sink, &(), |_, _| ()),
        };
        #[cfg(feature = "mpi")]
        let run = agree(folder.ranks.as_ref(), run, path);
        #[cfg(not(feature = "mpi"))]
        let run = self.run(own, pool, &sink, &(), |_, _| ());
        run?;
        Results::find([path])
    }

    fn manifest(&self, columns: &[Column]) -> Manifest {
        let chunks = self.chunks();
        let count = chunks.members();
        let spacing = count.div_ceil(MAX_COMPARED_MEMBERS).max(1);
        let compared = (0..count).step_by(spacing).chain([count - 1]);
        let [problem, method] = self.members.description();
        Manifest::new(Identity {
            chunks,
            points: self.members.points().description(),
            problem,
            method,
            numbers: compared
                .flat_map(|member| self.members.numbers(member))
                .collect(),
            columns,
            metadata: &self.metadata,
        })
    }
}

/// Returns an error on all ranks if there is one on any of them.
#[cfg(feature = "mpi")]
fn agree<T>(ranks: Option<&Ranks>, result: Result<T, Error>, path: &Path) -> Result<T, Error> {
    let Some(ranks) = ranks else { return result };
    if ranks.have_all(result.is_ok()) {
        return result;
    }
    result.and(Err(Error::Folder {
        path: path.to_path_buf(),
        text: "another rank failed; see its error".to_owned(),
    }))
}

/// Creates a folder for a study, or makes sure that it is of this study, and that files can be written.
fn claim(path: &Path, manifest: &Manifest) -> Result<(), Error> {
    fs::create_dir_all(path).map_err(Error::file(path, "created"))?;
    if Manifest::read(path)?.is_none() {
        let mut files = fs::read_dir(path).map_err(Error::file(path, "read"))?;
        let is_other = |name: &str| !name.starts_with('.');
        let is_used =
            files.any(|file| file.is_ok_and(|file| file.file_name().to_str().is_none_or(is_other)));
        // Another process may have begun meanwhile.
        if is_used && Manifest::read(path)?.is_none() {
            return Err(Error::Folder {
                path: path.to_path_buf(),
                text: format!(
                    "it exists and has no {MANIFEST}, so it is not of a study; choose another folder, or an empty one"
                ),
            });
        }
        manifest.write_first(path)?;
    } else {
        // Report a folder that is read-only before the first member is integrated.
        parquet::temporary(&path.join(MANIFEST))?;
    }
    // Of several processes that begin, the first one has written.
    let found = Manifest::read(path)?;
    match found.and_then(|found| manifest.difference(&found)) {
        None => Ok(()),
        Some([part, there, here]) => Err(Error::Folder {
            path: path.to_path_buf(),
            text: format!(
                "it contains the results of another study; the {part}: {there} there, {here} in this study; choose another folder, or remove this one \
                 to compute all anew"
            ),
        }),
    }
}

/// Writes a file for each chunk.
struct Files<'a, K> {
    tables: K,
    path: &'a Path,
    metadata: Vec<(String, String)>,
}

impl<M: Members, K: Sink<M, Part = Table>> Sink<M> for Files<'_, K> {
    type Entry = K::Entry;
    type Part = ();

    fn entry(&self, members: &M, index: usize, found: Found<M::State, M::Kept>) -> Self::Entry {
        self.tables.entry(members, index, found)
    }

    fn part(&self, chunk: usize, entries: Entries<Self::Entry>) -> Result<(), Error> {
        if !entries.are_complete {
            return Ok(());
        }
        let table = self.tables.part(chunk, entries)?;
        let path = self.path.join(name(chunk));
        let mut file = Writer::new(&path, table.columns(), &self.metadata)?;
        file.add(&table)?;
        file.finish()
    }
}
