//! The verifier: whether a program computes its roots, by a polynomial identity test (Schwartz, Fast probabilistic
//! algorithms for verification of polynomial identities, 1980).

use crate::algebra::hashing::Set;
use crate::identity::modular_point::ModularPoint;
use crate::identity::residue;
use crate::program::interpret::Arithmetic;
use crate::program::straight_line::{Operand, Operation, Program};
use crate::{Expression, Graph, Rational};

/// A fault of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fault {
    /// A value is used before it is computed.
    Undefined(usize),
    /// Two instructions do the same.
    Repeated(Operation),
    /// No point was found at which all roots have a value.
    Undecided,
    /// This output of this group does not have the value of its root.
    WrongOutput {
        /// The group.
        group: usize,
        /// The position in the group.
        output: usize,
    },
}

impl Program {
    /// Checks the program's invariants against the roots that it was made from.
    ///
    /// The values of the outputs are compared at a random point in modular arithmetic, so that neither
    /// rounding nor the order of terms matters: a wrong program passes with a probability below 10⁻¹⁵.
    ///
    /// # Errors
    ///
    /// The first [`Fault`] found.
    pub fn verify(&self, graph: &Graph, groups: &[&[Expression]]) -> Result<(), Fault> {
        self.verify_order()?;
        let roots = groups.concat();
        let points = ModularPoint::attempts();
        let points = points.map(|point| point.without_addition_theorems().uninterpreted());
        for point in points {
            let expected = point.evaluate(graph, &roots);
            if let (Some(expected), Some(found)) = (expected, self.evaluate_at(point)) {
                return compare(groups, &expected, &found);
            }
        }
        Err(Fault::Undecided)
    }

    /// The values of all outputs modulo a prime; every function is an arbitrary one of its argument.
    fn evaluate_at(&self, mut point: ModularPoint) -> Option<Vec<Vec<u64>>> {
        self.run(&mut point)
    }

    /// Checks that operands precede their uses, and that no operation is done twice.
    fn verify_order(&self) -> Result<(), Fault> {
        let mut computed = 0;
        let mut done = Set::default();
        let defined = |operand: &Operand, computed: usize| match operand {
            Operand::Value(number) if *number >= computed => Err(Fault::Undefined(*number)),
            _ => Ok(()),
        };
        for group in &self.groups {
            for instruction in &group.instructions {
                for operand in instruction.operation.operands() {
                    defined(operand, computed)?;
                }
                if instruction.value != computed || !done.insert(&instruction.operation) {
                    return Err(Fault::Repeated(instruction.operation.clone()));
                }
                computed += instruction.operation.results();
            }
            for operand in &group.outputs {
                defined(operand, computed)?;
            }
        }
        Ok(())
    }
}

fn compare(groups: &[&[Expression]], expected: &[u64], found: &[Vec<u64>]) -> Result<(), Fault> {
    let mut expected = expected.iter();
    for (group, (roots, values)) in groups.iter().zip(found).enumerate() {
        for output in 0..roots.len() {
            if expected.next() != values.get(output) {
                return Err(Fault::WrongOutput { group, output });
            }
        }
    }
    Ok(())
}

impl Arithmetic for ModularPoint {
    type Number = u64;

    fn load(&mut self, operand: &Operand) -> Option<u64> {
        match operand {
            Operand::Value(_) => None,
            Operand::Constant(value) => ModularPoint::constant(*self, value),
            Operand::Pi => Some(self.pi()),
            Operand::MinPositive => Some(0),
            Operand::Symbol(symbol) => Some(ModularPoint::symbol(*self, *symbol)),
        }
    }

    fn perform(&mut self, operation: &Operation, operands: &[u64]) -> Option<u64> {
        let p = self.p();
        match (operation, operands) {
            (Operation::Add(..), [x, y]) => Some(residue::add(*x, *y, p)),
            (Operation::Subtract(..), [x, y]) => Some(residue::add(*x, residue::negate(*y, p), p)),
            (Operation::Multiply(..), [x, y]) => Some(residue::multiply(*x, *y, p)),
            (Operation::Divide(..), [x, y]) => {
                Some(residue::multiply(*x, residue::reciprocal(*y, p)?, p))
            }
            (Operation::Negate(_), [x]) => Some(residue::negate(*x, p)),
            (Operation::SquareRoot(_), [x]) => self.power(*x, &Rational::HALF),
            (Operation::Unary(function, _), [x]) => {
                let x = self.atom(*x);
                ModularPoint::unary(*self, *function, x)
            }
            (Operation::Binary(function, ..), [x, y]) => {
                Some(ModularPoint::binary(*self, *function, *x, *y))
            }
            (Operation::Application(function, _), _) => {
                let arguments = operands.iter().copied();
                Some(ModularPoint::apply(*self, *function, arguments))
            }
            _ => None,
        }
    }
}
