//! Studies: many motions, and what is kept of them.

use std::ops::ControlFlow;
use std::sync::Mutex;
use std::sync::atomic::AtomicBool;

use lagrangian::problem::Flow;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::chunks::{AllChunks, Chunks, Source};
use crate::collector::{Collector, InOrder};
use crate::column::Column;
use crate::error::Error;
use crate::members::{Integrated, Members};
use crate::metadata;
use crate::motion::{Failure, Motion};
use crate::mutex::lock;
use crate::points::Points;
use crate::progress::{Ended, Progress};
use crate::rows::Rows;
use crate::sinks::{Motions, Summaries, Tables};
use crate::summary::Summary;
use crate::table::{self, Table};
use crate::tree::Tree;
use crate::workers::{self, Sink, Work};

/// Many motions: one problem for each point, until an end, by a method.
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian_ensembles::{Axis, Grid, Study};
///
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     taylor,
///     coordinates(theta),
///     kinetic = 0.5 * dot(theta).powi(2),
///     potential = -g * cos(theta),
/// )]
/// struct Pendulum { g: f64 }
///
/// let starts = Grid::new([Axis::linear("theta", 0.1, 3.0, 30).unit("rad")]);
/// let problem = |[theta]: [f64; 1]| Problem::new(Pendulum { g: 9.81 }, State::new(0.0, [theta], [0.0]));
/// let study = Study::new(starts, problem, 10.0, Taylor::new());
/// for motion in study.solve()? {
///     let motion = motion.expect("pendulums are regular");
///     assert!(motion.q[0].abs() <= motion.point[0] + 1e-12);
/// }
/// # Ok::<(), lagrangian_ensembles::Error>(())
/// ```
///
/// Points are a range of indices, a `Vec`, a [`Grid`](crate::Grid) or a [`Sample`](crate::Sample). The problem of a point
/// has the events, samples and limits of any [`Problem`](lagrangian::Problem). The end is a time, or a function of the
/// point.
///
/// Members are integrated on all threads of the current pool of `rayon`, and by [`Taylor`](lagrangian::Taylor) in
/// [`lanes`](Self::lanes) on each. A member does not depend on the others, on the number of threads or on the chunk in
/// which it is, to the last bit: `Study::new(vec![point], …)` repeats it alone.
#[must_use = "a study is run by `solve`, `table`, `summary` or `write`"]
pub struct Study<'a, M> {
    pub(crate) members: M,
    threads: Option<usize>,
    chunk: Option<usize>,
    pub(crate) metadata: Vec<(String, String)>,
    observer: Option<Mutex<Observed<'a>>>,
}

type Observer<'a> = dyn FnMut(&Progress) -> ControlFlow<()> + Send + 'a;

/// An observer and the progress of which it is told.
struct Observed<'a> {
    observer: Box<Observer<'a>>,
    progress: Progress,
}

impl<P, F, E, I> Study<'_, Integrated<P, F, E, I, 4>> {
    /// Creates a study from points, the problem of each, the end of the motions, and the method.
    pub fn new<D, K, C, R, O>(points: P, problem: F, end: E, method: I) -> Self
    where
        P: Points,
        F: Fn(P::Point) -> lagrangian::Problem<f64, D, K, C, R, O>,
        D: lagrangian::Dynamics<f64>,
        Integrated<P, F, E, I, 4>: Members,
    {
        Self {
            members: Integrated {
                points,
                problem,
                end,
                method,
            },
            threads: None,
            chunk: None,
            metadata: Vec::new(),
            observer: None,
        }
    }
}

impl<'a, P, F, E, I, const L: usize> Study<'a, Integrated<P, F, E, I, L>> {
    /// Sets the number of SIMD lanes on each thread, by default 4; methods without lanes ignore it. 4 suits processors
    /// with AVX2, and 8 suits processors with AVX-512, when compiled with `-C target-cpu=native`.
    pub fn lanes<const N: usize>(self) -> Study<'a, Integrated<P, F, E, I, N>> {
        const { assert!(N > 0, "a study has at least one lane") }
        let Integrated {
            points,
            problem,
            end,
            method,
        } = self.members;
        Study {
            members: Integrated {
                points,
                problem,
                end,
                method,
            },
            threads: self.threads,
            chunk: self.chunk,
            metadata: self.metadata,
            observer: self.observer,
        }
    }
}

impl<'a, M: Members> Study<'a, M> {
    /// Sets the number of threads; 0 means one for each core. By default the study runs on the current pool of `rayon`,
    /// which has one thread for each core; `write` starts a pool of its own.
    pub fn threads(mut self, threads: usize) -> Self {
        self.threads = Some(threads);
        self
    }

    /// Sets the number of members of a chunk: what a thread or a machine takes at a time, and a file contains. By
    /// default there are 1024 chunks, or fewer of 64 members, or more of 10⁴. Statistics are summed chunk by chunk, and thus
    /// depend on this number in their last digits.
    pub fn chunk(mut self, members: usize) -> Self {
        self.chunk = Some(members);
        self
    }

    /// Adds an entry to the metadata of tables and files, such as the name of the model or a parameter that all members
    /// share. Each key is given once. A folder is only resumed with the same metadata.
    pub fn metadata(mut self, key: impl Into<String>, value: impl Into<String>) -> Self {
        self.metadata.push((key.into(), value.into()));
        self
    }

    /// Calls `observer` after each member, on the thread that has integrated it. It returns nothing, or
    /// `ControlFlow::Break(())` to cancel the study: members that have begun are then finished, and others are left out.
    ///
    /// On ranks of MPI (feature `mpi`) it is called on rank 0 alone, with the progress of all ranks, of whose members it
    /// is told chunk by chunk. A progress bar is thus one line, and to cancel stops all ranks.
    ///
    /// ```no_run
    /// # use lagrangian::prelude::*;
    /// # use lagrangian_ensembles::Study;
    /// # #[derive(Lagrangian)]
    /// # #[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2))]
    /// # struct Mass { m: f64 }
    /// # struct ProgressBar;
    /// # impl ProgressBar { fn new(_: u64) -> Self { Self } fn set_position(&self, _: u64) {} }
    /// # let problem = |_: usize| Problem::new(Mass { m: 1.0 }, State::new(0.0, [0.0], [1.0]));
    /// // `ProgressBar` of the crate `indicatif`.
    /// let bar = ProgressBar::new(1000);
    /// let study = Study::new(0..1000, problem, 10.0, Dop853::new())
    ///     .each_member(|progress| bar.set_position(progress.ended as u64));
    /// ```
    pub fn each_member<A: Flow>(
        mut self,
        mut observer: impl FnMut(&Progress) -> A + Send + 'a,
    ) -> Self {
        self.observer = Some(Mutex::new(Observed {
            observer: Box::new(move |progress| observer(progress).flow()),
            progress: Progress::default(),
        }));
        self
    }

    /// Integrates all members and returns their motions, in the order of the points. A member that fails is a
    /// [`Failure`], which contains its motion up to the error. If an observer cancels the study, members are missing.
    ///
    /// # Errors
    ///
    /// If there are no points or they are invalid.
    #[allow(clippy::type_complexity)] // The type says what a motion is.
    pub fn solve(
        &self,
    ) -> Result<
        Vec<
            Result<
                Motion<<M::Points as Points>::Point, M::State, M::Kept>,
                Failure<<M::Points as Points>::Point, M::State, M::Kept>,
            >,
        >,
        Error,
    > {
        self.members.check()?;
        let mut motions = Vec::new();
        self.run_all(&Motions, &InOrder::new(|part: Vec<_>| motions.extend(part)))?;
        Ok(motions)
    }

    /// Integrates all members and returns a table with the `rows` of each motion: `[x, y]` for a single row, or a `Vec`
    /// of rows. The parameters of the points are the first columns.
    ///
    /// ```
    /// use lagrangian::prelude::*;
    /// use lagrangian_ensembles::{Motion, Study};
    ///
    /// #[derive(Lagrangian)]
    /// #[lagrangian(
    ///     taylor,
    ///     coordinates(x),
    ///     kinetic = 0.5 * dot(x).powi(2),
    ///     potential = 0.5 * x.powi(2),
    ///     event(center = x),
    /// )]
    /// struct Oscillator;
    ///
    /// let problem = |x: f64| {
    ///     Problem::new(Oscillator, State::new(0.0, [x], [0.0]))
    ///         .on(Oscillator::CENTER)
    ///         .record()
    /// };
    /// let study = Study::new(vec![1.0, 2.0], problem, 5.0, Taylor::new());
    /// // The type of the argument is known where the function is written in the call.
    /// let rows = |motion: &Motion<f64, Phase<f64, 1>>| {
    ///     let passages = motion.events().iter().filter(|event| event.is(Oscillator::CENTER));
    ///     [motion.q[0], passages.count() as f64]
    /// };
    /// let (table, summary) = (study.table(["end", "passages"], rows)?, study.summary(["end", "passages"], rows)?);
    /// assert_eq!(table.column("passages"), Some(&[2.0, 2.0][..]));
    /// assert_eq!(summary, study.summary(["end", "passages"], rows)?);
    /// # Ok::<(), lagrangian_ensembles::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// If there are no points or they are invalid, or if two columns have one name.
    pub fn table<const N: usize, A: Into<Column>, B: Rows<N>>(
        &self,
        columns: [A; N],
        rows: impl Fn(&Motion<<M::Points as Points>::Point, M::State, M::Kept>) -> B + Sync,
    ) -> Result<Table, Error> {
        let columns = self.columns(columns)?;
        let points = self.members.points();
        let metadata = metadata::all(points.count(), points.description(), &self.metadata);
        let mut table = Table::new(columns.clone()).with_metadata(metadata);
        let sink = Tables::<_, N> { columns, rows };
        self.run_all(&sink, &InOrder::new(|part| table.append(part)))?;
        Ok(table)
    }

    /// Integrates all members and returns the statistics of the `rows` of each motion: `[x, y]` for a single row, or a
    /// `Vec` of rows. The parameters of the points are the first columns. Neither motions nor rows are kept beyond
    /// their chunk. (The summary of a [`table`](Self::table) is of one chunk, and differs in its last digits.)
    ///
    /// # Errors
    ///
    /// If there are no points or they are invalid, or if two columns have one name.
    pub fn summary<const N: usize, A: Into<Column>, B: Rows<N>>(
        &self,
        columns: [A; N],
        rows: impl Fn(&Motion<<M::Points as Points>::Point, M::State, M::Kept>) -> B + Sync,
    ) -> Result<Summary, Error> {
        let columns = self.columns(columns)?;
        let none = Summary::new(&columns);
        let sink = Summaries(Tables::<_, N> { columns, rows });
        let tree = Tree::new(Summary::merged);
        self.run_all(&sink, &tree)?;
        Ok(tree.finish().unwrap_or(none))
    }

    /// Returns the columns of the points and those of the rows, or an error if the study is invalid.
    pub(crate) fn columns<const N: usize, A: Into<Column>>(
        &self,
        columns: [A; N],
    ) -> Result<Vec<Column>, Error> {
        self.members.check()?;
        metadata::check(&self.metadata)?;
        let mut all = self.members.points().columns();
        all.extend(columns.map(Into::into));
        table::check(&all)?;
        Ok(all)
    }

    pub(crate) fn chunks(&self) -> Chunks {
        Chunks::new(self.members.points().count(), self.chunk)
    }

    /// Integrates all members.
    fn run_all<K: Sink<M>>(
        &self,
        sink: &K,
        collector: &impl Collector<K::Part>,
    ) -> Result<(), Error> {
        let all = AllChunks::new(self.chunks().count());
        let pool = self.threads.map(pool_of).transpose()?;
        let members = self.members.points().count();
        let observer = |ended| self.observe(ended);
        let source = (&all, members, &observer as &_);
        self.run(source, pool.as_ref(), sink, collector, |_, _| ())
    }

    /// Returns a pool of its own, with one thread for each core unless their number was set.
    #[cfg(feature = "parquet")]
    pub(crate) fn own_pool(&self) -> Result<ThreadPool, Error> {
        pool_of(self.threads.unwrap_or_default())
    }

    /// Integrates the members of the chunks of a source, at most `members`, and tells the observer of those that have ended.
    /// Meanwhile calls `serve` with the number of workers and the flag that stops them.
    pub(crate) fn run<Q: Source, K: Sink<M>>(
        &self,
        (source, members, observer): (&Q, usize, &workers::Observer<'_>),
        pool: Option<&ThreadPool>,
        sink: &K,
        collector: &impl Collector<K::Part>,
        serve: impl FnOnce(usize, &AtomicBool),
    ) -> Result<(), Error> {
        if let Some(observed) = &self.observer {
            lock(observed).progress = Progress {
                members,
                ..Progress::default()
            };
        }
        let work = Work {
            members: &self.members,
            chunks: self.chunks(),
            source,
            sink,
            observer,
            pool,
        };
        work.run(collector, serve)
    }

    /// Tells the observer of the study of members that have ended.
    pub(crate) fn observe(&self, Ended { ended, failed }: Ended) -> ControlFlow<()> {
        let Some(observed) = &self.observer else {
            return ControlFlow::Continue(());
        };
        let Observed { observer, progress } = &mut *lock(observed);
        progress.ended += ended;
        progress.failed += failed;
        observer(progress)
    }
}

/// Returns a pool with this number of threads; 0 means one for each core.
fn pool_of(threads: usize) -> Result<ThreadPool, Error> {
    let pool = ThreadPoolBuilder::new().num_threads(threads);
    pool.build().map_err(Error::Threads)
}
