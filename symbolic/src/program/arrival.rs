//! When the values of a group are known, in cycles, if nothing waits but for its operands: the earliest start times of
//! scheduling (De Micheli, Synthesis and optimization of digital circuits, 1994, section 5.3).
//!
//! A product that one sum alone adds is fused with it. Of two products in one sum the later one is.

use crate::algebra::hashing::Table;
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

/// When the values of a group are known; symbols and values of earlier groups are from the beginning.
pub(crate) struct Arrivals {
    values: Table<usize, Arrival>,
    /// The instruction of the group that uses a value, if it is one alone and no output.
    users: Table<usize, Option<usize>>,
    /// How long it takes from the time at which a value is known to the end.
    tails: Table<usize, usize>,
    /// When all are known.
    end: usize,
}

impl Arrivals {
    /// Those of one group of a program.
    pub(crate) fn of(groups: &[OutputGroup], place: usize) -> Self {
        let group = &groups[place];
        let mut all = Self {
            values: Table::default(),
            users: users(groups, place),
            tails: Table::default(),
            end: 0,
        };
        for instruction in &group.instructions {
            let arrival = all.arrival(group, instruction);
            let first = instruction.value;
            let results = first..first + instruction.operation.results();
            all.values.extend(results.map(|value| (value, arrival)));
            all.end = all.end.max(arrival.time);
        }
        for instruction in group.instructions.iter().rev() {
            let first = instruction.value;
            let results = first..first + instruction.operation.results();
            let tail = results.map(|value| all.tail(value)).max().unwrap_or(0);
            let latency = latency(&instruction.operation);
            for value in instruction.operation.operands().filter_map(Operand::value) {
                let known = all.tails.entry(value).or_default();
                *known = (tail + latency).max(*known);
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
        let arrival = operand.value().and_then(|value| self.values.get(&value));
        arrival.copied().unwrap_or_default()
    }

    fn tail(&self, value: usize) -> usize {
        self.tails.get(&value).copied().unwrap_or(0)
    }

    /// How much later a value may be known without delay at the end.
    pub(crate) fn slack(&self, value: usize) -> usize {
        let time = self.values.get(&value).map_or(0, |arrival| arrival.time);
        self.end.saturating_sub(time + self.tail(value))
    }

    /// The instruction that uses a value, if it is one alone and no output.
    pub(crate) fn user(&self, value: usize) -> Option<usize> {
        self.users.get(&value).copied().flatten()
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

/// Of each value that is used: by which instruction of a group, if it is one alone. Outputs are used elsewhere.
fn users(groups: &[OutputGroup], place: usize) -> Table<usize, Option<usize>> {
    let mut users: Table<usize, Option<usize>> = Table::default();
    for (number, group) in groups.iter().enumerate() {
        for value in group.outputs.iter().filter_map(Operand::value) {
            users.insert(value, None);
        }
        for (index, instruction) in group.instructions.iter().enumerate() {
            let user = (number == place).then_some(index);
            for value in instruction.operation.operands().filter_map(Operand::value) {
                let known = users.entry(value).or_insert(user);
                if *known != user {
                    *known = None;
                }
            }
        }
    }
    users
}
