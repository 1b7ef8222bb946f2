//! When the values of a group are known, in cycles, if nothing waits but for its operands: the earliest start times of
//! scheduling (De Micheli, Synthesis and optimization of digital circuits, 1994, section 5.3).
//!
//! A product that one sum alone adds is fused with it. Of two products in one sum the later one is.

use crate::limits::{
    LATENCY_OF_ADDITION, LATENCY_OF_DIVISION, LATENCY_OF_FUNCTION, LATENCY_OF_FUSED,
    LATENCY_OF_PRODUCT,
};
use crate::program::straight_line::{Instruction, Operand, Operation, OutputGroup};

/// When one value is known.
#[derive(Clone, Copy, Default)]
pub(crate) struct Arrival {
    pub(crate) time: usize,
    /// Of a product that is fused with a sum: when its factors are.
    pub(crate) factors: Option<usize>,
}

/// How a value is used.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Use {
    Never,
    /// By this instruction of the group alone.
    Once(usize),
    /// By several, or as an output.
    Often,
}

/// When the values of a group are known; symbols and values of earlier groups are from the beginning.
pub(crate) struct Arrivals {
    /// By value.
    values: Vec<Arrival>,
    /// By value: how it is used.
    uses: Vec<Use>,
    /// By value: how long it takes from the time at which it is known to the end.
    tails: Vec<usize>,
    /// When all are known.
    end: usize,
}

impl Arrivals {
    /// Those of one group of a program.
    pub(crate) fn of(groups: &[OutputGroup], place: usize) -> Self {
        let group = &groups[place];
        let uses = uses(groups, place);
        let mut all = Self {
            values: vec![Arrival::default(); uses.len()],
            tails: vec![0; uses.len()],
            uses,
            end: 0,
        };
        for instruction in &group.instructions {
            let arrival = all.arrival(group, instruction);
            all.values[instruction.values()].fill(arrival);
            all.end = all.end.max(arrival.time);
        }
        for instruction in group.instructions.iter().rev() {
            let tails = &all.tails[instruction.values()];
            let tail = tails.iter().max().copied().unwrap_or(0) + latency(&instruction.operation);
            for value in instruction.operation.operands().filter_map(Operand::value) {
                all.tails[value] = all.tails[value].max(tail);
            }
        }
        all
    }

    /// When the result of an instruction is known.
    fn arrival(&self, group: &OutputGroup, instruction: &Instruction) -> Arrival {
        let operation = &instruction.operation;
        let known = operation.operands().map(|operand| self.get(operand).time);
        let known = known.max().unwrap_or(0);
        match operation {
            // Computed with all others, before everything else.
            Operation::SineAndCosine(Operand::Symbol(_)) => Arrival::default(),
            Operation::Multiply(..) => Arrival {
                time: known + LATENCY_OF_PRODUCT,
                factors: self.is_fused(group, instruction).then_some(known),
            },
            Operation::Add(x, y) | Operation::Subtract(x, y) => {
                let (x, y) = (self.get(x), self.get(y));
                let (before, last) = if x.time > y.time { (y, x) } else { (x, y) };
                let time = match (before.factors, last.factors) {
                    (_, Some(factors)) => before.time.max(factors) + LATENCY_OF_FUSED,
                    (Some(_), None) => last.time + LATENCY_OF_FUSED,
                    (None, None) => last.time + LATENCY_OF_ADDITION,
                };
                Arrival {
                    time,
                    factors: None,
                }
            }
            operation => Arrival {
                time: known + latency(operation),
                factors: None,
            },
        }
    }

    pub(crate) fn get(&self, operand: &Operand) -> Arrival {
        operand
            .value()
            .map_or_else(Arrival::default, |value| self.values[value])
    }

    /// How much later a value may be known without delay at the end.
    pub(crate) fn slack(&self, value: usize) -> usize {
        self.end
            .saturating_sub(self.values[value].time + self.tails[value])
    }

    /// The instruction that uses a value, if it is one alone and no output.
    pub(crate) fn user(&self, value: usize) -> Option<usize> {
        match self.uses[value] {
            Use::Once(user) => Some(user),
            Use::Never | Use::Often => None,
        }
    }

    /// Whether an instruction is computed with the one that uses it, as a product is with the sum that adds it and as a sign is.
    pub(crate) fn is_fused(&self, group: &OutputGroup, instruction: &Instruction) -> bool {
        let Some(user) = self.user(instruction.value) else {
            return false;
        };
        match (&instruction.operation, &group.instructions[user].operation) {
            (Operation::Multiply(..), Operation::Add(x, y) | Operation::Subtract(x, y)) => x != y,
            (Operation::Negate(_), _) => true,
            _ => false,
        }
    }
}

const fn latency(operation: &Operation) -> usize {
    match operation {
        Operation::Add(..) | Operation::Subtract(..) => LATENCY_OF_ADDITION,
        Operation::Multiply(..) => LATENCY_OF_PRODUCT,
        Operation::Negate(_) => 0,
        Operation::Divide(..) | Operation::SquareRoot(_) => LATENCY_OF_DIVISION,
        Operation::SineAndCosine(_)
        | Operation::Unary(..)
        | Operation::Binary(..)
        | Operation::Application(..) => LATENCY_OF_FUNCTION,
    }
}

/// How each value of a program is used, seen from one group.
fn uses(groups: &[OutputGroup], place: usize) -> Vec<Use> {
    let instructions = groups.iter().flat_map(|group| &group.instructions);
    let end = instructions
        .map(|instruction| instruction.values().end)
        .max();
    let mut uses = vec![Use::Never; end.unwrap_or(0)];
    for (number, group) in groups.iter().enumerate() {
        for value in group.outputs.iter().filter_map(Operand::value) {
            uses[value] = Use::Often;
        }
        for (index, instruction) in group.instructions.iter().enumerate() {
            for value in instruction.operation.operands().filter_map(Operand::value) {
                uses[value] = match uses[value] {
                    Use::Never if number == place => Use::Once(index),
                    Use::Once(user) if number == place && user == index => continue,
                    _ => Use::Often,
                };
            }
        }
    }
    uses
}
