//! Tapes of programs.

use crate::algebra::hashing::Table;
use crate::program::straight_line::{Operand, Operation};
use crate::validation::tape::{Entry, Slot, Tape};
use crate::{Program, Unary};

impl Tape {
    /// The tape of a program, its outputs one group after the other.
    pub(crate) fn of_program(program: &Program) -> Self {
        Self::of_programs([program])
    }

    /// The tape of several programs, one after the other.
    pub(crate) fn of_programs<'a>(programs: impl IntoIterator<Item = &'a Program>) -> Self {
        let mut tape = Self::default();
        for program in programs {
            tape.append(program);
        }
        tape
    }

    fn append(&mut self, program: &Program) {
        let mut values: Vec<Slot> = Vec::new();
        let mut loaded: Table<Operand, Slot> = Table::default();
        for group in &program.groups {
            for instruction in &group.instructions {
                let operation = &instruction.operation;
                let operands: Vec<Slot> = operation
                    .operands()
                    .map(|operand| self.load(operand, &values, &mut loaded))
                    .collect();
                self.translate(operation, &operands, &mut values);
            }
            for operand in &group.outputs {
                let slot = self.load(operand, &values, &mut loaded);
                self.outputs.push(slot);
            }
        }
    }

    fn load(
        &mut self,
        operand: &Operand,
        values: &[Slot],
        loaded: &mut Table<Operand, Slot>,
    ) -> Slot {
        let entry = match operand {
            Operand::Value(number) => return values[*number],
            Operand::Constant(value) => Entry::Constant(value.to_f64()),
            Operand::Pi => Entry::Constant(core::f64::consts::PI),
            Operand::MinPositive => Entry::Constant(f64::MIN_POSITIVE),
            Operand::Symbol(symbol) => Entry::Symbol(*symbol),
        };
        if let Some(slot) = loaded.get(operand) {
            return *slot;
        }
        let slot = self.push(entry);
        loaded.insert(operand.clone(), slot);
        slot
    }

    fn translate(&mut self, operation: &Operation, operands: &[Slot], values: &mut Vec<Slot>) {
        let entry = match (operation, operands) {
            (Operation::Add(..), [x, y]) => Entry::Add(*x, *y),
            (Operation::Subtract(..), [x, y]) => Entry::Subtract(*x, *y),
            (Operation::Multiply(..), [x, y]) => Entry::Multiply(*x, *y),
            (Operation::Divide(..), [x, y]) => Entry::Divide(*x, *y),
            (Operation::Binary(function, ..), [x, y]) => Entry::Binary(*function, *x, *y),
            (Operation::Negate(_), [x]) => Entry::Scale(-1.0, *x),
            (Operation::SquareRoot(_), [x]) => Entry::Power(0.5, *x),
            (Operation::Unary(function, _), [x]) => Entry::Unary(*function, *x),
            (Operation::SineAndCosine(_), [x]) => {
                let sine = self.push(Entry::Unary(Unary::Sin, *x));
                values.push(sine);
                Entry::Unary(Unary::Cos, *x)
            }
            (Operation::Application(function, _), arguments) => {
                self.application(*function, arguments, &[])
            }
            _ => Entry::Constant(f64::NAN),
        };
        let slot = self.push(entry);
        values.push(slot);
    }
}
