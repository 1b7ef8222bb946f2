//! The sines and cosines that a group computes at once, and before everything else.
//!
//! Several angles take less time together than one by one. Together go those that are known when the
//! group begins: coordinates and other symbols, and sums and products of them.

use std::collections::BTreeSet;

use lagrangian_symbolic::{Operand, Operation, OutputGroup};

/// What is computed at once, by the indices of the instructions.
pub(super) struct Angles {
    /// What the angles are made of.
    pub(super) operands_of_angles: BTreeSet<usize>,
    /// The sines and cosines.
    pub(super) pairs: Vec<usize>,
}

/// The values of a group that angles may be made of.
struct Arithmetic {
    /// The first value of the group.
    first: usize,
    /// By value, from the first on: the instruction that computes it.
    instructions: Vec<Option<usize>>,
}

impl Arithmetic {
    fn of(&self, value: usize) -> Option<usize> {
        let place = value.checked_sub(self.first)?;
        *self.instructions.get(place)?
    }

    fn note(&mut self, value: usize, index: usize) {
        let Some(place) = value.checked_sub(self.first) else {
            return;
        };
        if place >= self.instructions.len() {
            self.instructions.resize(place + 1, None);
        }
        self.instructions[place] = Some(index);
    }
}

impl Angles {
    /// All these instructions: the operands, and then the sines and cosines.
    pub(super) fn instructions(&self) -> impl Iterator<Item = usize> + '_ {
        self.operands_of_angles.iter().chain(&self.pairs).copied()
    }

    /// The angles known at the beginning of a group, if they are two or more; `earlier` tells which
    /// values are those of groups before.
    pub(super) fn of(group: &OutputGroup, earlier: impl Fn(usize) -> bool) -> Option<Self> {
        let is_pair = |operation: &Operation| matches!(operation, Operation::SineAndCosine(_));
        let all = group.instructions.iter();
        let pairs = all.filter(|instruction| is_pair(&instruction.operation));
        if pairs.count() < 2 {
            return None;
        }
        let values = group.instructions.iter();
        let first = values.map(|instruction| instruction.value).min()?;
        let mut arithmetic = Arithmetic {
            first,
            instructions: Vec::new(),
        };
        let mut pairs = Vec::new();
        for (index, instruction) in group.instructions.iter().enumerate() {
            let is_known = |operand: &Operand| match operand {
                Operand::Value(value) => arithmetic.of(*value).is_some() || earlier(*value),
                _ => true,
            };
            if !instruction.operation.operands().all(is_known) {
                continue;
            }
            if is_arithmetic(&instruction.operation) {
                arithmetic.note(instruction.value, index);
            } else if is_pair(&instruction.operation) {
                pairs.push(index);
            }
        }
        (pairs.len() > 1).then(|| Self {
            operands_of_angles: ancestors(group, &pairs, &arithmetic),
            pairs,
        })
    }
}

const fn is_arithmetic(operation: &Operation) -> bool {
    matches!(
        operation,
        Operation::Add(..)
            | Operation::Subtract(..)
            | Operation::Multiply(..)
            | Operation::Divide(..)
            | Operation::Negate(_)
    )
}

/// The instructions whose values the pairs are made of.
fn ancestors(group: &OutputGroup, pairs: &[usize], arithmetic: &Arithmetic) -> BTreeSet<usize> {
    let mut found = BTreeSet::new();
    let mut waiting = pairs.to_vec();
    while let Some(index) = waiting.pop() {
        for operand in group.instructions[index].operation.operands() {
            if let Operand::Value(value) = operand
                && let Some(index) = arithmetic.of(*value)
                && found.insert(index)
            {
                waiting.push(index);
            }
        }
    }
    found
}
