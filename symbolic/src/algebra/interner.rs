//! Interned nodes: each once, in order of insertion.
//!
//! An open-addressing hash table with linear probing (Knuth, The Art of Computer Programming, volume 3, 2nd edition
//! 1998, section 6.4, algorithm L). It is written here because it is the most frequent operation of the crate,
//! and because macros run without optimization, where layers of generic code are slow.

use core::hash::{Hash, Hasher};

use crate::Node;
use crate::algebra::hashing::Mixer;

/// Nodes by position, and positions by node.
#[derive(Clone, Debug, Default)]
pub(crate) struct Interner {
    nodes: Vec<Node>,
    /// The hash of each node.
    codes: Vec<u64>,
    /// Positions, each in the first free slot after the one its hash names. The number of slots is a power of
    /// two, and at most half of them are occupied.
    slots: Vec<u32>,
}

/// Marks a free slot.
const FREE: u32 = u32::MAX;

impl Interner {
    pub(crate) fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// The position of `node`, if it is here.
    pub(crate) fn position(&self, node: &Node) -> Option<usize> {
        let slot = self.slot(code(node), node)?;
        self.position_at(slot)
    }

    /// The position of the node with this code for which `is_wanted` holds, if it is here.
    pub(crate) fn find(&self, word: u64, is_wanted: impl Fn(&Node) -> bool) -> Option<usize> {
        let mask = self.slots.len().checked_sub(1)?;
        let code = finished(word);
        let mut slot = home_slot(code, mask);
        while let Some(position) = self.position_at(slot) {
            if self.codes[position] == code && is_wanted(&self.nodes[position]) {
                return Some(position);
            }
            slot = (slot + 1) & mask;
        }
        None
    }

    /// The position of `node`, which is here afterwards.
    pub(crate) fn insert(&mut self, node: Node) -> usize {
        if 2 * (self.nodes.len() + 1) > self.slots.len() {
            self.grow();
        }
        let code = code(&node);
        let slot = self.slot(code, &node).unwrap_or(0);
        if let Some(position) = self.position_at(slot) {
            return position;
        }
        let position = self.nodes.len();
        self.slots[slot] = entry(position);
        self.nodes.push(node);
        self.codes.push(code);
        position
    }

    /// The slot of a node, or the free one where it would be inserted; none in an empty table.
    fn slot(&self, code: u64, node: &Node) -> Option<usize> {
        let mask = self.slots.len().checked_sub(1)?;
        let mut slot = home_slot(code, mask);
        while let Some(position) = self.position_at(slot) {
            if self.codes[position] == code && self.nodes[position] == *node {
                break;
            }
            slot = (slot + 1) & mask;
        }
        Some(slot)
    }

    fn position_at(&self, slot: usize) -> Option<usize> {
        match self.slots[slot] {
            FREE => None,
            position => Some(position as usize),
        }
    }

    /// Removes the nodes from this position on.
    pub(crate) fn truncate(&mut self, length: usize) {
        self.nodes.truncate(length);
        self.codes.truncate(length);
        self.place(self.slots.len());
    }

    fn grow(&mut self) {
        self.place((2 * self.slots.len()).max(64));
    }

    /// Places all nodes in so many slots.
    fn place(&mut self, size: usize) {
        let mask = size.saturating_sub(1);
        self.slots = vec![FREE; size];
        for (position, code) in self.codes.iter().enumerate() {
            let mut slot = home_slot(*code, mask);
            while self.slots[slot] != FREE {
                slot = (slot + 1) & mask;
            }
            self.slots[slot] = entry(position);
        }
    }
}

fn code(node: &Node) -> u64 {
    let mut mixer = Mixer::default();
    node.hash(&mut mixer);
    mixer.finish()
}

/// The code of a node that is hashed as one word.
fn finished(word: u64) -> u64 {
    let mut mixer = Mixer::default();
    mixer.write_u64(word);
    mixer.finish()
}

#[allow(clippy::cast_possible_truncation)] // What is cut off is beyond the mask, or beyond memory.
fn home_slot(code: u64, mask: usize) -> usize {
    code as usize & mask
}

fn entry(position: usize) -> u32 {
    // Four billion nodes of at least forty bytes do not fit into a compiler's memory.
    u32::try_from(position).unwrap_or(FREE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Rational, Symbol};

    #[test]
    fn each_node_has_one_position() {
        let nodes: Vec<Node> = (0_i32..1000)
            .map(|i| match i % 2 {
                0 => Node::Constant(Rational::integer(i.into())),
                _ => Node::Symbol(Symbol::Coordinate(i.unsigned_abs())),
            })
            .collect();
        let mut interner = Interner::default();
        assert_eq!(interner.position(&nodes[0]), None);
        for round in 0..2 {
            for (position, node) in nodes.iter().enumerate() {
                assert_eq!(interner.position(node), (round == 1).then_some(position));
                assert_eq!(interner.insert(node.clone()), position);
            }
        }
        assert_eq!(interner.nodes(), nodes);
        interner.truncate(300);
        assert_eq!(interner.nodes(), &nodes[..300]);
        for (position, node) in nodes.iter().enumerate() {
            assert_eq!(
                interner.position(node),
                (position < 300).then_some(position)
            );
        }
    }
}
