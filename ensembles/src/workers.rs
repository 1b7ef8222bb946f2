//! Workers: threads that take chunks, integrate their members, and pass on what is kept of them.

use std::cell::RefCell;
use std::collections::VecDeque;
use std::iter;
use std::ops::{ControlFlow, Range};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;

use rayon::{Scope, ThreadPool};

use crate::chunks::{Chunks, Source};
use crate::collector::Collector;
use crate::error::Error;
use crate::members::{Found, Members};
use crate::mutex::lock;
use crate::progress::Ended;

/// What is kept of the members of a study.
pub(crate) trait Sink<M: Members>: Sync {
    /// The type of what is kept of a member.
    type Entry;
    /// The type of what is kept of a chunk.
    type Part: Send;

    /// Converts the result of a member into what is kept of it, as soon as it has ended.
    fn entry(&self, members: &M, index: usize, found: Found<M::State, M::Kept>) -> Self::Entry;

    /// Converts the entries of a chunk, in the order of their indices, into what is kept of it. Entries are missing only
    /// if the study was cancelled.
    fn part(&self, chunk: usize, entries: Entries<Self::Entry>) -> Result<Self::Part, Error>;
}

/// The entries of a chunk, in the order of the indices of the members.
pub(crate) struct Entries<E> {
    pub(crate) entries: Vec<E>,
    #[cfg_attr(not(feature = "parquet"), allow(dead_code))] // Incomplete chunks are not written.
    pub(crate) are_complete: bool,
}

/// Is told of members that have ended, and tells whether the study goes on.
pub(crate) type Observer<'a> = dyn Fn(Ended) -> ControlFlow<()> + Sync + 'a;

/// The work of a study.
pub(crate) struct Work<'a, M, Q, K> {
    pub(crate) members: &'a M,
    pub(crate) chunks: Chunks,
    pub(crate) source: &'a Q,
    pub(crate) sink: &'a K,
    pub(crate) observer: &'a Observer<'a>,
    /// The pool of threads; `None` for the current one.
    pub(crate) pool: Option<&'a ThreadPool>,
}

impl<M: Members, Q: Source, K: Sink<M>> Work<'_, M, Q, K> {
    /// Integrates all members, and passes what is kept of each chunk to the collector, on the thread that has integrated
    /// the chunk. Meanwhile calls `serve`, on this thread, with the number of workers and the flag that stops them.
    pub(crate) fn run<C: Collector<K::Part>>(
        &self,
        collector: &C,
        serve: impl FnOnce(usize, &AtomicBool),
    ) -> Result<(), Error> {
        let shared = Shared {
            is_stopped: AtomicBool::new(false),
            error: Mutex::new(None),
            collector,
        };
        match self.pool {
            None => rayon::in_place_scope(|scope| {
                self.start(&shared, scope, rayon::current_num_threads());
                serve(rayon::current_num_threads(), &shared.is_stopped);
            }),
            Some(pool) => pool.in_place_scope(|scope| {
                self.start(&shared, scope, pool.current_num_threads());
                serve(pool.current_num_threads(), &shared.is_stopped);
            }),
        }
        let error = shared.error.into_inner();
        match error.unwrap_or_else(PoisonError::into_inner) {
            Some(error) => Err(error),
            None => Ok(()),
        }
    }

    fn start<'s, C: Collector<K::Part>>(
        &'s self,
        shared: &'s Shared<'s, C>,
        scope: &Scope<'s>,
        threads: usize,
    ) {
        for _ in 0..threads {
            scope.spawn(|_| self.work(shared));
        }
    }

    /// The work of one thread.
    fn work<C: Collector<K::Part>>(&self, shared: &Shared<'_, C>) {
        let _leaving = Leaving {
            source: self.source,
            is_stopped: &shared.is_stopped,
        };
        let open = RefCell::new(OpenChunks::default());
        let indices = iter::from_fn(|| {
            if shared.is_stopped.load(Ordering::Relaxed) {
                return None;
            }
            open.borrow_mut().next_index(|| {
                let chunk = self.source.take()?;
                Some((chunk, self.chunks.range(chunk)))
            })
        });
        self.members.integrate(indices, |position, found| {
            let index = open.borrow().index(position);
            let ended = Ended {
                ended: 1,
                failed: usize::from(found.is_err()),
            };
            let entry = self.sink.entry(self.members, index, found);
            let complete = open.borrow_mut().keep(position, entry);
            if let Some(chunk) = complete {
                self.finish(chunk, shared);
            }
            if (self.observer)(ended).is_break() {
                shared.is_stopped.store(true, Ordering::Relaxed);
            }
        });
        // Chunks whose members were not all begun.
        for chunk in open.into_inner().chunks {
            self.finish(chunk, shared);
        }
    }

    /// Keeps a chunk whose members have ended.
    fn finish<C: Collector<K::Part>>(&self, chunk: OpenChunk<K::Entry>, shared: &Shared<'_, C>) {
        let are_complete = chunk.is_complete();
        let entries = chunk.entries.into_iter().flatten().collect();
        let entries = Entries {
            entries,
            are_complete,
        };
        match self.sink.part(chunk.number, entries) {
            Ok(part) => shared.collector.collect(chunk.number, part),
            Err(error) => {
                shared.is_stopped.store(true, Ordering::Relaxed);
                lock(&shared.error).get_or_insert(error);
            }
        }
    }
}

/// What the threads share.
struct Shared<'a, C> {
    is_stopped: AtomicBool,
    /// The first error.
    error: Mutex<Option<Error>>,
    collector: &'a C,
}

/// The chunks of a thread whose members have not all ended. The lanes of a chunk that ends are refilled from the next
/// one.
struct OpenChunks<E> {
    chunks: VecDeque<OpenChunk<E>>,
    /// The number of members that have been begun.
    begun: usize,
}

impl<E> Default for OpenChunks<E> {
    fn default() -> Self {
        Self {
            chunks: VecDeque::new(),
            begun: 0,
        }
    }
}

struct OpenChunk<E> {
    number: usize,
    range: Range<usize>,
    /// The position of the first member among all members that the thread has begun.
    position: usize,
    /// One for each member that has been begun: a chunk of any length takes no memory before.
    entries: Vec<Option<E>>,
    ended: usize,
}

impl<E> OpenChunk<E> {
    fn is_complete(&self) -> bool {
        self.ended == self.range.len()
    }
}

impl<E> OpenChunks<E> {
    /// Returns the index of the next member, from a new chunk if all members of the last one are begun.
    fn next_index(
        &mut self,
        take: impl FnOnce() -> Option<(usize, Range<usize>)>,
    ) -> Option<usize> {
        // The last chunk may have ended before an earlier one.
        let is_begun = |chunk: &OpenChunk<E>| chunk.entries.len() == chunk.range.len();
        if self.chunks.back().is_none_or(is_begun) {
            let (number, range) = take()?;
            self.chunks.push_back(OpenChunk {
                number,
                position: self.begun,
                entries: Vec::new(),
                range,
                ended: 0,
            });
        }
        let chunk = self.chunks.back_mut()?;
        chunk.entries.push(None);
        let position = self.begun;
        self.begun += 1;
        Some(self.index(position))
    }

    /// Returns the chunk of a member.
    fn find(&self, position: usize) -> usize {
        self.chunks
            .partition_point(|chunk| chunk.position <= position)
            - 1
    }

    /// Returns the index of a member.
    fn index(&self, position: usize) -> usize {
        let chunk = &self.chunks[self.find(position)];
        chunk.range.start + (position - chunk.position)
    }

    /// Keeps the entry of a member that has ended; returns its chunk if it was the last one.
    fn keep(&mut self, position: usize, entry: E) -> Option<OpenChunk<E>> {
        let place = self.find(position);
        let chunk = &mut self.chunks[place];
        chunk.entries[position - chunk.position] = Some(entry);
        chunk.ended += 1;
        chunk
            .is_complete()
            .then(|| self.chunks.remove(place))
            .flatten()
    }
}

/// Tells that a worker has ended, and stops the others if it was by a panic in a function of the caller.
struct Leaving<'a, Q: Source> {
    source: &'a Q,
    is_stopped: &'a AtomicBool,
}

impl<Q: Source> Drop for Leaving<'_, Q> {
    fn drop(&mut self) {
        if thread::panicking() {
            self.is_stopped.store(true, Ordering::Relaxed);
        }
        self.source.leave();
    }
}
