//! Instructions under construction, with local value numbering: no operation is there twice.

use crate::Expression;
use crate::algebra::hashing::Table;
use crate::program::straight_line::{Instruction, Operand, Operation, Program};

/// A list of instructions, each operation of which is known by the number of its first result.
#[derive(Default)]
pub(crate) struct Instructions {
    pub(crate) list: Vec<Instruction>,
    numbers: Table<Operation, usize>,
    next: usize,
}

impl Instructions {
    /// No instructions yet, of which there will be about so many.
    pub(crate) fn with_capacity(capacity: usize) -> Self {
        Self {
            numbers: Table::with_capacity_and_hasher(capacity, <_>::default()),
            ..Self::default()
        }
    }

    /// An empty list that continues the numbers of a program.
    pub(crate) fn behind(program: &Program) -> Self {
        let all = program.instructions();
        let ends = all.map(|instruction| instruction.values().end);
        let all = program.instructions();
        let numbers = all.map(|instruction| (instruction.operation.clone(), instruction.value));
        Self {
            list: Vec::new(),
            next: ends.max().unwrap_or(0),
            numbers: numbers.collect(),
        }
    }

    /// The value of an operation that is in the list or in the program before it.
    pub(crate) fn known(&self, operation: &Operation) -> Option<Operand> {
        self.numbers.get(operation).copied().map(Operand::Value)
    }

    /// The value of an operation, which joins the list unless it is known.
    pub(crate) fn emit(&mut self, operation: Operation) -> Operand {
        Operand::Value(self.number(operation, None))
    }

    /// The number of an operation, which joins the list as the value of an expression unless it is known.
    pub(crate) fn number(&mut self, operation: Operation, expression: Option<Expression>) -> usize {
        if let Some(number) = self.numbers.get(&operation) {
            return *number;
        }
        let value = self.next;
        self.next += operation.results();
        self.numbers.insert(operation.clone(), value);
        self.list.push(Instruction {
            operation,
            value,
            expression,
        });
        value
    }
}
