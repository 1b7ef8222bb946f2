//! Quotients instead of products with reciprocals.
//!
//! A program computes 1/y once for all quotients by y, since a division takes longer than a product. In a recurrence both
//! take one convolution, so that the series of 1/y is one too many.

use crate::Rational;
use crate::program::straight_line::{Instruction, Operand, Operation, Program};

/// The instructions of a program, with x / y for x · (1/y).
pub(super) fn with_quotients(program: &Program) -> Vec<Instruction> {
    let mut instructions = Vec::new();
    // The divisor of which each value is the reciprocal.
    let mut divisors: Vec<Option<Operand>> = Vec::new();
    for instruction in program.instructions() {
        let operation = &instruction.operation;
        divisors.resize(instruction.values().end, None);
        if let Operation::Divide(Operand::Constant(one), y) = operation
            && *one == Rational::ONE
        {
            divisors[instruction.value] = Some(y.clone());
        }
        let operation = quotient(operation, &divisors).unwrap_or_else(|| operation.clone());
        instructions.push(Instruction {
            operation,
            ..*instruction
        });
    }
    instructions
}

/// The quotient that a product with a reciprocal is.
fn quotient(operation: &Operation, divisors: &[Option<Operand>]) -> Option<Operation> {
    let Operation::Multiply(x, y) = operation else {
        return None;
    };
    let divisor = |operand: &Operand| match operand {
        Operand::Value(value) => divisors.get(*value)?.clone(),
        _ => None,
    };
    let of = |x: &Operand, y: &Operand| Some(Operation::Divide(x.clone(), divisor(y)?));
    of(x, y).or_else(|| of(y, x))
}
