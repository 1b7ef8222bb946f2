//! The interpreter of programs.
//!
//! The instructions are interpreted in binary64; tests interpret them modulo a prime and on expressions, too, and compare a program
//! with the expressions that it was scheduled from.

use crate::program::straight_line::{Operand, Operation, Program};
use crate::{ExternalFunction, Symbol, Unary};

/// An arithmetic in which a program is interpreted. `None` is an undefined value.
pub(crate) trait Arithmetic {
    type Number: Copy;

    /// An operand that no instruction computes.
    fn load(&mut self, operand: &Operand) -> Option<Self::Number>;
    /// The result of an operation on operands. Sine and cosine of one angle are two operations.
    fn perform(&mut self, operation: &Operation, operands: &[Self::Number])
    -> Option<Self::Number>;
}

impl Program {
    /// The values of all outputs in binary64, group by group, where `value` gives those of the symbols.
    ///
    /// External functions evaluate to NaN.
    #[must_use]
    pub fn evaluate(&self, value: impl Fn(Symbol) -> f64) -> Vec<Vec<f64>> {
        self.evaluate_with(value, |_, _| f64::NAN)
    }

    /// The values of all outputs in binary64, where `external` gives those of external functions.
    #[must_use]
    pub fn evaluate_with(
        &self,
        value: impl Fn(Symbol) -> f64,
        external: impl Fn(ExternalFunction, &[f64]) -> f64,
    ) -> Vec<Vec<f64>> {
        self.run(&mut Binary64(value, external)).unwrap_or_default()
    }

    /// The values of all outputs in an arithmetic, group by group; none where an operation has none.
    pub(crate) fn run<A: Arithmetic>(&self, arithmetic: &mut A) -> Option<Vec<Vec<A::Number>>> {
        let mut values = Vec::new();
        let mut groups = Vec::new();
        for group in &self.groups {
            for instruction in &group.instructions {
                execute(arithmetic, &instruction.operation, &mut values)?;
            }
            let outputs: Option<Vec<_>> = group
                .outputs
                .iter()
                .map(|operand| fetch(arithmetic, operand, &values))
                .collect();
            groups.push(outputs?);
        }
        Some(groups)
    }
}

fn fetch<A: Arithmetic>(
    arithmetic: &mut A,
    operand: &Operand,
    values: &[A::Number],
) -> Option<A::Number> {
    match operand {
        Operand::Value(number) => values.get(*number).copied(),
        other => arithmetic.load(other),
    }
}

fn execute<A: Arithmetic>(
    arithmetic: &mut A,
    operation: &Operation,
    values: &mut Vec<A::Number>,
) -> Option<()> {
    let operands = operation.operands();
    let operands: Option<Vec<_>> = operands.map(|x| fetch(arithmetic, x, values)).collect();
    let operands = operands?;
    if let Operation::SineAndCosine(x) = operation {
        for function in [Unary::Sin, Unary::Cos] {
            let operation = Operation::Unary(function, x.clone());
            values.push(arithmetic.perform(&operation, &operands)?);
        }
        return Some(());
    }
    values.push(arithmetic.perform(operation, &operands)?);
    Some(())
}

/// The values of symbols and of external functions.
struct Binary64<F, G>(F, G);

impl<F: Fn(Symbol) -> f64, G: Fn(ExternalFunction, &[f64]) -> f64> Arithmetic for Binary64<F, G> {
    type Number = f64;

    fn load(&mut self, operand: &Operand) -> Option<f64> {
        match operand {
            Operand::Value(_) => None,
            Operand::Constant(value) => Some(value.to_f64()),
            Operand::Pi => Some(core::f64::consts::PI),
            Operand::MinPositive => Some(f64::MIN_POSITIVE),
            Operand::Symbol(symbol) => Some((self.0)(*symbol)),
        }
    }

    fn perform(&mut self, operation: &Operation, operands: &[f64]) -> Option<f64> {
        Some(match (operation, operands) {
            (Operation::Add(..), [x, y]) => x + y,
            (Operation::Subtract(..), [x, y]) => x - y,
            (Operation::Multiply(..), [x, y]) => x * y,
            (Operation::Divide(..), [x, y]) => x / y,
            (Operation::Negate(_), [x]) => -x,
            (Operation::SquareRoot(_), [x]) => x.sqrt(),
            (Operation::Unary(function, _), [x]) => function.value(*x),
            (Operation::Binary(function, ..), [x, y]) => function.value(*x, *y),
            (Operation::Application(function, _), _) => (self.1)(*function, operands),
            _ => return None,
        })
    }
}
