//! The tree in which statistics of chunks are merged.

use std::collections::BTreeMap;
use std::sync::Mutex;

use crate::collector::Collector;
use crate::mutex::lock;

/// Merges the parts of chunks in the shape of a binary tree.
///
/// The leaves are the numbers of the chunks. The node at `position` of a level covers the nodes 2 `position` and
/// 2 `position` + 1 of the level below; where one of these is missing, it is the other one. The result thus depends on the
/// numbers of the chunks alone, and not on when and on which thread they are finished.
///
/// Two parts are merged as soon as both are there, on the thread that has brought the second one, and without holding the
/// lock. When chunks are begun in the order of their numbers, at most two parts of each level wait for each chunk that is
/// being integrated.
pub(crate) struct Tree<P, F> {
    merge: F,
    /// The parts without a sibling, by level and position.
    waiting: Mutex<BTreeMap<(u32, usize), P>>,
}

impl<P, F: Fn(P, P) -> P> Tree<P, F> {
    /// Creates a tree without parts. `merge` takes two neighbours in their order.
    pub(crate) fn new(merge: F) -> Self {
        Self {
            merge,
            waiting: Mutex::new(BTreeMap::new()),
        }
    }

    /// Adds the part of a chunk.
    pub(crate) fn add(&self, chunk: usize, part: P) {
        self.add_node((0, chunk), part);
    }

    /// Adds a node, and merges it with its sibling, if that waits, and so on towards the root.
    fn add_node(&self, mut node: (u32, usize), mut part: P) {
        while let Some((left, right)) = self.pair(node, part) {
            let (level, position) = node;
            part = (self.merge)(left, right);
            node = (level + 1, position / 2);
        }
    }

    /// Returns a node and its sibling in their order; lets it wait if there is no sibling yet.
    fn pair(&self, node: (u32, usize), part: P) -> Option<(P, P)> {
        let (level, position) = node;
        let mut waiting = lock(&self.waiting);
        match waiting.remove(&(level, position ^ 1)) {
            Some(sibling) if position % 2 == 0 => Some((part, sibling)),
            Some(sibling) => Some((sibling, part)),
            None => {
                waiting.insert(node, part);
                None
            }
        }
    }

    /// Merges what is still waiting for chunks that do not come; `None` if there was no part.
    pub(crate) fn finish(self) -> Option<P> {
        loop {
            let ((level, position), part) = lock(&self.waiting).pop_first()?;
            if lock(&self.waiting).is_empty() {
                return Some(part);
            }
            self.add_node((level + 1, position / 2), part);
        }
    }
}

impl<P: Send, F: Fn(P, P) -> P + Sync> Collector<P> for Tree<P, F> {
    fn collect(&self, chunk: usize, part: P) {
        self.add(chunk, part);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tree() -> Tree<String, impl Fn(String, String) -> String> {
        Tree::new(|left, right| format!("({left} {right})"))
    }

    fn merged(chunks: impl IntoIterator<Item = usize>) -> Option<String> {
        let tree = tree();
        for chunk in chunks {
            tree.add(chunk, chunk.to_string());
        }
        tree.finish()
    }

    #[test]
    fn the_shape_depends_on_the_numbers_alone() {
        assert_eq!(merged([]), None);
        assert_eq!(merged([3]).as_deref(), Some("3"));
        assert_eq!(merged(0..7).as_deref(), Some("(((0 1) (2 3)) ((4 5) 6))"));
        // As if the others were empty.
        assert_eq!(
            merged([1, 2, 3, 8, 6]).as_deref(),
            Some("(((1 (2 3)) 6) 8)")
        );
        let in_order = merged(0..1000);
        // 7 and 1000 have no common divisor.
        assert_eq!(merged((0..1000).map(|chunk| chunk * 7 % 1000)), in_order);
        assert_eq!(merged((0..1000).rev()), in_order);
    }

    /// Parts behind a slow chunk are merged with each other.
    #[test]
    fn few_parts_wait_for_a_slow_chunk() {
        let tree = tree();
        for chunk in (0..1000).filter(|chunk| *chunk != 5) {
            tree.add(chunk, String::new());
            let waiting = lock(&tree.waiting).len();
            // Two for each of ten levels.
            assert!(waiting <= 20, "{waiting} parts wait at chunk {chunk}");
        }
    }
}
