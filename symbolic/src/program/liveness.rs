//! Which values of a straight-line program are live: what its results are made of (Aho, Lam, Sethi and Ullman, Compilers, 2nd
//! edition 2007, section 9.2.5).

use crate::program::straight_line::{Instruction, Operand};

/// The values on which some operands depend.
pub struct LiveValues(Vec<bool>);

impl LiveValues {
    /// The values on which these operands depend, in a program of these instructions.
    pub fn of<'a>(
        operands: impl Iterator<Item = &'a Operand>,
        instructions: impl DoubleEndedIterator<Item = &'a Instruction>,
    ) -> Self {
        let mut live = Self(Vec::new());
        live.add(operands);
        for instruction in instructions.rev() {
            if live.contain(instruction) {
                live.add(instruction.operation.operands());
            }
        }
        live
    }

    fn add<'a>(&mut self, operands: impl Iterator<Item = &'a Operand>) {
        for value in operands.filter_map(Operand::value) {
            if self.0.len() <= value {
                self.0.resize(value + 1, false);
            }
            self.0[value] = true;
        }
    }

    /// Whether a value that an instruction computes is live.
    #[must_use]
    pub fn contain(&self, instruction: &Instruction) -> bool {
        let mut values = instruction.values();
        values.any(|value| self.0.get(value) == Some(&true))
    }
}
