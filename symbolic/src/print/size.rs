//! How long an expression is in print.

use std::cell::RefCell;
use std::collections::BTreeMap;

use crate::limits::MAX_ARRANGED_LENGTH;
use crate::print::names::Letters;
use crate::{Expression, Graph, Node};

/// The numbers of symbols of expressions where they stand in others, as far as they are known. An expression keeps its
/// number, since the graph is append-only.
#[derive(Clone, Debug, Default)]
pub(crate) struct WrittenSizes {
    by_name: RefCell<Vec<Option<u64>>>,
    in_full: RefCell<Vec<Option<u64>>>,
}

impl Graph {
    /// The number of symbols, numbers and functions of expressions that are written out, whose operands are called by
    /// their names.
    pub(crate) fn written_symbols(&self, roots: &[Expression], letters: &Letters) -> u64 {
        let is_named = |part| letters.definition(part).is_some();
        self.sizes(roots, &letters.sizes.by_name, is_named)
    }

    /// The same of one expression without names.
    pub(crate) fn symbols_in_full(&self, root: Expression, letters: &Letters) -> u64 {
        self.sizes(&[root], &letters.sizes.in_full, |_| false)
    }

    fn sizes(
        &self,
        roots: &[Expression],
        known: &RefCell<Vec<Option<u64>>>,
        is_named: impl Fn(Expression) -> bool,
    ) -> u64 {
        let mut known = known.borrow_mut();
        let sizes = &mut *known;
        if sizes.len() < self.len() {
            sizes.resize(self.len(), None);
        }
        let mut open = Vec::new();
        for root in roots {
            self.node(*root).for_each_operand(|x| open.push(x));
        }
        while let Some(part) = open.last().copied() {
            let before = open.len();
            if sizes[part.index()].is_none() {
                let size = if is_named(part) {
                    1
                } else {
                    self.node(part).for_each_operand(|x| {
                        if sizes[x.index()].is_none() {
                            open.push(x);
                        }
                    });
                    if open.len() > before {
                        continue;
                    }
                    self.size_of(part, sizes)
                };
                sizes[part.index()] = Some(size);
            }
            open.pop();
        }
        let each = roots.iter().map(|root| self.size_of(*root, sizes));
        each.fold(0, u64::saturating_add)
    }

    /// The size of an expression from those of its operands.
    fn size_of(&self, expression: Expression, sizes: &[Option<u64>]) -> u64 {
        let node = self.node(expression);
        let mut size = match node {
            Node::Sum(_) | Node::Product(_) | Node::Opaque(_) => 0,
            _ => 1,
        };
        node.for_each_operand(|operand| {
            size = u64::saturating_add(size, sizes[operand.index()].unwrap_or(0));
        });
        size
    }

    /// The first of the shortest, where each length counts so many times.
    pub(crate) fn shortest_of(
        &self,
        candidates: &[(Expression, usize)],
        letters: &Letters,
    ) -> Expression {
        let mut best = (usize::MAX, candidates[0].0);
        let mut lengths: BTreeMap<Expression, usize> = BTreeMap::new();
        for (candidate, weight) in candidates {
            let most = best.0.min(MAX_ARRANGED_LENGTH);
            let length = lengths
                .entry(*candidate)
                .or_insert_with(|| self.display_in(*candidate, letters).length(most));
            if weight * *length < best.0 {
                best = (weight * *length, *candidate);
            }
        }
        best.1
    }
}
