//! Which expressions depend on which symbols: sparsity propagation by bit sets (Griewank and Walther, Evaluating
//! Derivatives, 2nd edition 2008, chapter 7).
//!
//! Input: roots, and the symbols of interest. Output: for each symbol the expressions that contain it, children
//! before parents. A derivative visits those alone, so that a Jacobian costs its number of nonzero terms and
//! not the size of the arena for each symbol.

use std::collections::BTreeMap;

use crate::{Expression, Graph, Node, Symbol};

/// For each of several symbols, the descendants of some roots that contain it.
pub(crate) struct Dependence {
    dependents: Vec<Vec<Expression>>,
}

impl Dependence {
    pub(crate) fn of(graph: &Graph, roots: &[Expression], symbols: &[Symbol]) -> Self {
        let positions: BTreeMap<Symbol, usize> = symbols
            .iter()
            .enumerate()
            .map(|(position, symbol)| (*symbol, position))
            .collect();
        let descendants = graph.descendants(roots);
        let length = descendants.last().map_or(0, |last| last.index() + 1);
        let mut sets = BitSets::new(length, symbols.len());
        let mut dependents = vec![Vec::new(); symbols.len()];
        for expression in descendants {
            match graph.node(expression) {
                Node::Symbol(symbol) => {
                    if let Some(position) = positions.get(symbol) {
                        sets.insert(expression.index(), *position);
                    }
                }
                node => node.for_each_operand(|x| sets.unite(expression.index(), x.index())),
            }
            sets.for_each(expression.index(), |position| {
                dependents[position].push(expression);
            });
        }
        Self { dependents }
    }

    /// The expressions that contain the symbol at `position`, children before parents.
    pub(crate) fn on(&self, position: usize) -> &[Expression] {
        &self.dependents[position]
    }

    /// Of the same expressions those that other roots are made of.
    pub(crate) fn within(
        &self,
        graph: &Graph,
        roots: &[Expression],
        position: usize,
    ) -> Vec<Expression> {
        let dependents = self.on(position);
        let length = dependents.last().map_or(0, |last| last.index() + 1);
        let mut reached = vec![false; length];
        let mut reach = |expression: Expression| {
            if let Some(reached) = reached.get_mut(expression.index()) {
                *reached = true;
            }
        };
        for root in roots {
            reach(*root);
        }
        let mut within = Vec::new();
        for expression in dependents.iter().rev() {
            if reached[expression.index()] {
                within.push(*expression);
                let node = graph.node(*expression);
                node.for_each_operand(|operand| reached[operand.index()] = true);
            }
        }
        within.reverse();
        within
    }
}

/// Sets of small numbers, all of the same size.
struct BitSets {
    words: Vec<u64>,
    /// How many words each set has.
    stride: usize,
}

const BITS: usize = u64::BITS as usize;

impl BitSets {
    fn new(sets: usize, members: usize) -> Self {
        let stride = members.div_ceil(BITS);
        Self {
            words: vec![0; sets * stride],
            stride,
        }
    }

    fn insert(&mut self, set: usize, member: usize) {
        self.words[set * self.stride + member / BITS] |= 1 << (member % BITS);
    }

    fn unite(&mut self, set: usize, other: usize) {
        let mut word = 0;
        while word < self.stride {
            self.words[set * self.stride + word] |= self.words[other * self.stride + word];
            word += 1;
        }
    }

    fn for_each(&self, set: usize, mut visit: impl FnMut(usize)) {
        for word in 0..self.stride {
            let mut rest = self.words[set * self.stride + word];
            while rest != 0 {
                visit(word * BITS + rest.trailing_zeros() as usize);
                rest &= rest - 1;
            }
        }
    }
}
