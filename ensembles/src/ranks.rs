//! The ranks of an MPI program: rank 0 hands out the chunks.
//!
//! On each rank, the thread that has called the study sends and receives, while others integrate. A rank that wants a
//! chunk asks rank 0 for it, and gets its number, or none. A rank whose workers have all ended tells so. With each message it
//! sends how many members have ended since the last one.

use std::fmt;
use std::ops::ControlFlow;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{self, Receiver, Sender};
use std::thread;
use std::time::Duration;

use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::{Communicator, CommunicatorCollectives as _, Destination as _, Source as _};

use crate::chunks::{Queue, Source};
use crate::mutex::lock;
use crate::progress::Ended;

/// What a rank asks of rank 0.
const WANTS_CHUNK: u64 = 0;
const HAS_ENDED: u64 = 1;
/// As `HAS_ENDED`, by an error or a cancellation: all ranks are to stop.
const HAS_STOPPED: u64 = 2;

/// The answer of rank 0 when there are no more chunks.
const NO_CHUNK: u64 = u64::MAX;

/// The time for which rank 0 sleeps when nothing has arrived: MPI itself waits by looping, which would take a core from
/// the workers.
const PAUSE: Duration = Duration::from_micros(200);

/// The ranks of a communicator of its own, so that messages of the study are not confused with those of the caller.
pub(crate) struct Ranks {
    communicator: SimpleCommunicator,
}

impl Ranks {
    pub(crate) fn new(communicator: &impl Communicator) -> Self {
        Self {
            communicator: communicator.duplicate(),
        }
    }

    pub(crate) fn is_first(&self) -> bool {
        self.communicator.rank() == 0
    }

    /// Whether all ranks have what this one has. Waits for the others.
    pub(crate) fn have_all(&self, has: bool) -> bool {
        let mut have_all = false;
        self.communicator
            .all_reduce_into(&has, &mut have_all, SystemOperation::logical_and());
        have_all
    }

    /// Hands out the chunks of a queue to the other ranks until they have all ended; none after the study is stopped
    /// on any rank. Tells `observe` of the members that have ended there.
    pub(crate) fn hand_out(
        &self,
        queue: &Queue,
        is_stopped: &AtomicBool,
        observe: impl Fn(Ended) -> ControlFlow<()>,
    ) {
        let any = self.communicator.any_process();
        let mut others = self.communicator.size() - 1;
        while others > 0 {
            let Some(status) = any.immediate_probe() else {
                thread::sleep(PAUSE);
                continue;
            };
            let rank = self.communicator.process_at_rank(status.source_rank());
            let mut message = [0; 3];
            rank.receive_into(&mut message[..]);
            let [message, ended, failed] = message;
            let [ended, failed] = [ended, failed].map(|count| usize::try_from(count).unwrap_or(0));
            if ended > 0 && observe(Ended { ended, failed }).is_break() {
                is_stopped.store(true, Ordering::Relaxed);
            }
            if message == WANTS_CHUNK {
                let chunk = (!is_stopped.load(Ordering::Relaxed)).then(|| queue.take());
                let chunk = chunk.flatten().map_or(NO_CHUNK, |chunk| chunk as u64);
                rank.send(&chunk);
            } else {
                others -= 1;
                if message == HAS_STOPPED {
                    is_stopped.store(true, Ordering::Relaxed);
                }
            }
        }
    }

    /// Asks rank 0 for the chunks that the workers of this rank want, until they have all ended.
    pub(crate) fn ask(
        &self,
        (source, requests): (&Requests, &Receiver<Request>),
        mut workers: usize,
        is_stopped: &AtomicBool,
    ) {
        let first = self.communicator.process_at_rank(0);
        while workers > 0 {
            match requests.recv() {
                Ok(Request::Chunk(answer)) => {
                    first.send(&source.message(WANTS_CHUNK)[..]);
                    let (chunk, _) = first.receive::<u64>();
                    // The worker that has asked is waiting.
                    let _ = answer.send(usize::try_from(chunk).ok().filter(|_| chunk != NO_CHUNK));
                }
                Ok(Request::Leave) => workers -= 1,
                Err(_) => break,
            }
        }
        let message = if is_stopped.load(Ordering::Relaxed) {
            HAS_STOPPED
        } else {
            HAS_ENDED
        };
        first.send(&source.message(message)[..]);
    }
}

/// Ends all ranks if this one panics: they would wait for it.
pub(crate) struct AbortOnPanic<'a>(pub(crate) &'a Ranks);

impl Drop for AbortOnPanic<'_> {
    fn drop(&mut self) {
        if thread::panicking() {
            self.0.communicator.abort(1);
        }
    }
}

/// What a worker asks of the thread that sends and receives.
pub(crate) enum Request {
    /// A chunk, to be sent there.
    Chunk(Sender<Option<usize>>),
    /// Nothing more.
    Leave,
}

/// The chunks of rank 0, as the workers of another rank see them.
pub(crate) struct Requests {
    sender: Mutex<Sender<Request>>,
    /// The numbers of members that have ended, and of those that have failed, since the last message.
    ended: AtomicU64,
    failed: AtomicU64,
}

impl Requests {
    /// Creates a source of chunks, and the end at which its requests arrive.
    pub(crate) fn new() -> (Self, Receiver<Request>) {
        let (sender, receiver) = mpsc::channel();
        let source = Self {
            sender: Mutex::new(sender),
            ended: AtomicU64::new(0),
            failed: AtomicU64::new(0),
        };
        (source, receiver)
    }

    /// Counts members that have ended, for the next message.
    pub(crate) fn count(&self, Ended { ended, failed }: Ended) {
        self.ended.fetch_add(ended as u64, Ordering::Relaxed);
        self.failed.fetch_add(failed as u64, Ordering::Relaxed);
    }

    /// Returns the message to rank 0, with the members that have ended since the last one.
    fn message(&self, what: u64) -> [u64; 3] {
        let [ended, failed] =
            [&self.ended, &self.failed].map(|count| count.swap(0, Ordering::Relaxed));
        [what, ended, failed]
    }

    fn send(&self, request: Request) {
        // The other end waits until all workers have left.
        let _ = lock(&self.sender).send(request);
    }
}

impl Source for Requests {
    fn take(&self) -> Option<usize> {
        let (sender, answer) = mpsc::channel();
        self.send(Request::Chunk(sender));
        answer.recv().ok().flatten()
    }

    fn leave(&self) {
        self.send(Request::Leave);
    }
}

impl fmt::Debug for Ranks {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Ranks")
            .field("rank", &self.communicator.rank())
            .field("size", &self.communicator.size())
            .finish()
    }
}
