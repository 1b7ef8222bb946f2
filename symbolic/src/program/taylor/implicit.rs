//! The series of accelerations from that of M q̈ − f = 0 (Griewank and Walther, Evaluating Derivatives, 2nd edition 2008,
//! section 13.4 on Taylor series of implicit functions).
//!
//! The residual M q̈ − f of order k is M₀ q̈ₖ and what it is for q̈ₖ = 0. It is computed for q̈ₖ = 0, then q̈ₖ is solved for with
//! the factors of M₀, and what depends on q̈ₖ is computed once more for the convolutions of higher orders. The factors of M
//! need no series.

use std::collections::BTreeSet;

use super::TaylorProgram;
use super::builder::Builder;
use super::series::ZERO;
use crate::Symbol;
use crate::program::straight_line::{Instruction, Operand, Operation, OutputGroup, Program};

impl Builder<'_> {
    /// The program whose first outputs are q̈ₖ or, where there is no `solution`, M₀ q̈ₖ. The first group of `program`
    /// computes the accelerations of order 0.
    pub(super) fn solved(
        mut self,
        program: &Program,
        residuals: &[Operand],
        solution: &[Operand],
    ) -> TaylorProgram {
        let instructions = self.recurrence.list.clone();
        let zeros = vec![ZERO; residuals.len()];
        let values = self.with_accelerations(&instructions, &zeros);
        let right: Vec<Operand> = residuals
            .iter()
            .map(|residual| self.negate(&substituted(residual, &values, &zeros)))
            .collect();
        let mut order_zero = program.clone();
        let others = order_zero.groups.split_off(1);
        let others = others.into_iter().flat_map(|group| group.instructions);
        let list = others.chain(core::mem::take(&mut self.initial.list));
        self.initial.list = list.collect();
        if solution.is_empty() {
            return self.finish(&order_zero, right);
        }
        let accelerations = self.solution(program, &right, solution);
        let values = self.with_accelerations(&instructions, &accelerations);
        for factor in self.factors.iter_mut().flatten() {
            *factor = substituted(factor, &values, &accelerations);
        }
        self.finish(&order_zero, accelerations)
    }

    /// The values of the recurrence with other operands for the accelerations, where they change.
    fn with_accelerations(
        &mut self,
        instructions: &[Instruction],
        accelerations: &[Operand],
    ) -> Vec<Option<Operand>> {
        let mut values: Vec<Option<Operand>> = Vec::with_capacity(instructions.len());
        for instruction in instructions {
            let operation = &instruction.operation;
            let mut operands = operation.operands();
            let changes = operands.any(|x| substituted(x, &values, accelerations) != *x);
            let value = changes.then(|| {
                let mut operation = operation.clone();
                operation.for_each_operand(|x| *x = substituted(x, &values, accelerations));
                self.term(&operation)
            });
            values.push(value);
        }
        values
    }

    /// A sum, difference or product of terms; 0 for any other operation, which is not linear in them.
    fn term(&mut self, operation: &Operation) -> Operand {
        match operation {
            Operation::Add(x, y) => self.add(x, y),
            Operation::Subtract(x, y) => self.subtract(x, y),
            Operation::Multiply(x, y) => self.multiply(x, y),
            Operation::Negate(x) => self.negate(x),
            _ => ZERO,
        }
    }

    /// The solution of M₀ x = r: what does not depend on r is of order 0.
    fn solution(
        &mut self,
        program: &Program,
        right: &[Operand],
        solution: &[Operand],
    ) -> Vec<Operand> {
        // The values that depend on r.
        let mut values: Vec<Option<Operand>> = Vec::new();
        let term = |operand: &Operand, values: &[Option<Operand>]| match operand {
            Operand::Symbol(Symbol::RightHandSide(i)) => Some(right[*i as usize].clone()),
            Operand::Value(value) => values.get(*value).cloned().flatten(),
            _ => None,
        };
        for Instruction {
            operation, value, ..
        } in program.instructions()
        {
            let mut operands = operation.operands();
            if operands.any(|operand| term(operand, &values).is_some()) {
                let mut operation = operation.clone();
                if let Operation::Divide(x, y) = &operation {
                    let reciprocal = self.reciprocal(y);
                    let x = term(x, &values).unwrap_or(ZERO);
                    operation = Operation::Multiply(x, reciprocal);
                } else {
                    operation.for_each_operand(|operand| {
                        let known = term(operand, &values);
                        *operand = known.unwrap_or_else(|| self.invariant(operand));
                    });
                }
                let result = self.term(&operation);
                values.resize(*value, None);
                values.push(Some(result));
            }
        }
        let solution = solution.iter().map(|operand| term(operand, &values));
        solution.map(|x| x.unwrap_or(ZERO)).collect()
    }
}

/// An operand of the recurrence with other operands for the accelerations.
fn substituted(
    operand: &Operand,
    values: &[Option<Operand>],
    accelerations: &[Operand],
) -> Operand {
    let known = match operand {
        Operand::Symbol(Symbol::Acceleration(i)) => accelerations.get(*i as usize).cloned(),
        Operand::Value(value) => values.get(*value).cloned().flatten(),
        _ => None,
    };
    known.unwrap_or_else(|| operand.clone())
}

/// The program that computes the coefficients and the factors: what depends on accelerations comes after the former.
pub(super) fn in_two_groups(
    instructions: Vec<Instruction>,
    coefficients: Vec<Operand>,
    factors: Vec<Operand>,
) -> Program {
    let mut later: BTreeSet<usize> = BTreeSet::new();
    let mut groups = [coefficients, factors].map(|outputs| OutputGroup {
        instructions: Vec::new(),
        outputs,
    });
    for instruction in instructions {
        let depends = |operand: &Operand| match operand {
            Operand::Value(value) => later.contains(value),
            operand => matches!(operand, Operand::Symbol(Symbol::Acceleration(_))),
        };
        let depends = instruction.operation.operands().any(depends);
        if depends {
            later.insert(instruction.value);
        }
        groups[usize::from(depends)].instructions.push(instruction);
    }
    let mut program = Program {
        groups: groups.into(),
    };
    program.renumber();
    program
}
