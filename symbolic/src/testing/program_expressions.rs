//! Programs as expressions.

use crate::program::interpret::Arithmetic;
use crate::program::straight_line::{Operand, Operation, Program};
use crate::{Expression, Graph};

impl Program {
    /// The expressions of all outputs, built again from the instructions.
    pub fn expand(&self, graph: &mut Graph) -> Vec<Vec<Expression>> {
        self.run(graph).unwrap_or_default()
    }
}

impl Arithmetic for Graph {
    type Number = Expression;

    fn load(&mut self, operand: &Operand) -> Option<Expression> {
        match operand {
            Operand::Value(_) => None,
            Operand::Constant(value) => Some(self.constant(value)),
            Operand::Pi => Some(self.pi()),
            Operand::MinPositive => Some(self.zero()),
            Operand::Symbol(symbol) => Some(self.symbol(*symbol)),
        }
    }

    fn perform(&mut self, operation: &Operation, operands: &[Expression]) -> Option<Expression> {
        Some(match (operation, operands) {
            (Operation::Add(..), [x, y]) => self.add(*x, *y),
            (Operation::Subtract(..), [x, y]) => self.subtract(*x, *y),
            (Operation::Multiply(..), [x, y]) => self.multiply(*x, *y),
            (Operation::Divide(..), [x, y]) => self.divide(*x, *y),
            (Operation::Negate(_), [x]) => self.negate(*x),
            (Operation::SquareRoot(_), [x]) => self.square_root(*x),
            (Operation::Unary(function, _), [x]) => self.unary(*function, *x),
            (Operation::Binary(function, ..), [x, y]) => self.binary(*function, *x, *y),
            (Operation::Application(function, _), _) => self.apply(*function, operands),
            _ => return None,
        })
    }
}
