//! Collectors: what becomes of the chunks that are finished.

use std::collections::BTreeMap;
use std::sync::Mutex;

use crate::mutex::lock;

/// Takes what is kept of the chunks, as soon as each is finished, on all threads.
pub(crate) trait Collector<P>: Sync {
    /// Takes what is kept of the chunk with this number.
    fn collect(&self, chunk: usize, part: P);
}

/// Collects nothing: what is kept has been stored already.
impl Collector<()> for () {
    fn collect(&self, _: usize, (): ()) {}
}

/// Passes on the parts of all chunks in the order of their numbers; parts whose turn has not come wait.
pub(crate) struct InOrder<P, F>(Mutex<Waiting<P, F>>);

struct Waiting<P, F> {
    next: usize,
    parts: BTreeMap<usize, P>,
    pass: F,
}

impl<P, F: FnMut(P)> InOrder<P, F> {
    pub(crate) fn new(pass: F) -> Self {
        Self(Mutex::new(Waiting {
            next: 0,
            parts: BTreeMap::new(),
            pass,
        }))
    }
}

impl<P: Send, F: FnMut(P) + Send> Collector<P> for InOrder<P, F> {
    fn collect(&self, chunk: usize, part: P) {
        let Waiting { next, parts, pass } = &mut *lock(&self.0);
        parts.insert(chunk, part);
        while let Some(part) = parts.remove(next) {
            pass(part);
            *next += 1;
        }
    }
}
