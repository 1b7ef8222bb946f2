//! Series with one error, which a check has to find out.

use lagrangian_symbolic::{Operation, TaylorProgram};

/// The series with another operation in place of each of those on the terms of the given groups of the recurrence, and with
/// another factor in each convolution; each with a name of the error.
pub fn wrong_series(right: &TaylorProgram, groups: &[usize]) -> Vec<(String, TaylorProgram)> {
    let mut wrong = Vec::new();
    for group in groups {
        for index in 0..right.recurrence.groups[*group].instructions.len() {
            let mut one = right.clone();
            let operation = &mut one.recurrence.groups[*group].instructions[index].operation;
            *operation = mutated(operation.clone());
            wrong.push((format!("group {group}, instruction {index}"), one));
        }
    }
    // Where there is one factor, there is no other.
    if right.factors() > 1 {
        for index in 0..right.convolutions.len() {
            let mut one = right.clone();
            let pair = &mut one.convolutions[index];
            pair.1 = (pair.1 + 1) % right.factors();
            wrong.push((format!("convolution {index}"), one));
        }
    }
    wrong
}

/// Another operation on terms.
fn mutated(operation: Operation) -> Operation {
    match operation {
        Operation::Add(x, y) => Operation::Subtract(x, y),
        Operation::Subtract(x, y) => Operation::Add(x, y),
        Operation::Multiply(x, y) => Operation::Divide(x, y),
        Operation::Negate(x) => Operation::Add(x.clone(), x),
        other => panic!("{other:?} is no operation on terms"),
    }
}
