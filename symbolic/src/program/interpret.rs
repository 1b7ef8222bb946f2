//! The interpreter of programs.
//!
//! The same instructions are interpreted in binary64, modulo a prime, or on expressions, so that an emitted program
//! can be checked against the expressions that it was scheduled from.

use crate::identity::modular_point::ModularPoint;
use crate::identity::residue;
use crate::program::straight_line::{Operand, Operation, Program};
use crate::{Binary, Expression, ExternalFunction, Graph, Rational, Symbol, Unary};

/// An arithmetic in which a program is interpreted. `None` is an undefined value.
trait Arithmetic {
    type Number: Copy;

    fn constant(&mut self, value: &Rational) -> Option<Self::Number>;
    fn pi(&mut self) -> Option<Self::Number>;
    fn min_positive(&mut self) -> Option<Self::Number>;
    fn symbol(&mut self, symbol: Symbol) -> Option<Self::Number>;
    fn add(&mut self, x: Self::Number, y: Self::Number) -> Option<Self::Number>;
    fn negate(&mut self, x: Self::Number) -> Option<Self::Number>;
    fn multiply(&mut self, x: Self::Number, y: Self::Number) -> Option<Self::Number>;
    fn divide(&mut self, x: Self::Number, y: Self::Number) -> Option<Self::Number>;
    fn square_root(&mut self, x: Self::Number) -> Option<Self::Number>;
    fn unary(&mut self, function: Unary, x: Self::Number) -> Option<Self::Number>;
    fn binary(
        &mut self,
        function: Binary,
        x: Self::Number,
        y: Self::Number,
    ) -> Option<Self::Number>;
    fn apply(
        &mut self,
        function: ExternalFunction,
        arguments: &[Self::Number],
    ) -> Option<Self::Number>;
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

    /// The expressions of all outputs, built again from the instructions.
    pub fn expand(&self, graph: &mut Graph) -> Vec<Vec<Expression>> {
        self.run(graph).unwrap_or_default()
    }

    /// The values of all outputs modulo a prime; every function is an arbitrary one of its argument.
    pub(crate) fn evaluate_at(&self, mut point: ModularPoint) -> Option<Vec<Vec<u64>>> {
        self.run(&mut point)
    }

    fn run<A: Arithmetic>(&self, arithmetic: &mut A) -> Option<Vec<Vec<A::Number>>> {
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
        Operand::Constant(value) => arithmetic.constant(value),
        Operand::Pi => arithmetic.pi(),
        Operand::MinPositive => arithmetic.min_positive(),
        Operand::Symbol(symbol) => arithmetic.symbol(*symbol),
    }
}

fn execute<A: Arithmetic>(
    arithmetic: &mut A,
    operation: &Operation,
    values: &mut Vec<A::Number>,
) -> Option<()> {
    if let Operation::Application(function, arguments) = operation {
        let arguments = arguments.iter();
        let arguments: Option<Vec<_>> = arguments.map(|x| fetch(arithmetic, x, values)).collect();
        values.push(arithmetic.apply(*function, &arguments?)?);
        return Some(());
    }
    let mut operands = [None; 2];
    for (slot, operand) in operands.iter_mut().zip(operation.operands()) {
        *slot = fetch(arithmetic, operand, values);
    }
    let x = operands[0]?;
    let y = |operands: [Option<A::Number>; 2]| operands[1];
    let result = match operation {
        Operation::Add(..) => arithmetic.add(x, y(operands)?)?,
        Operation::Subtract(..) => {
            let opposite = arithmetic.negate(y(operands)?)?;
            arithmetic.add(x, opposite)?
        }
        Operation::Multiply(..) => arithmetic.multiply(x, y(operands)?)?,
        Operation::Divide(..) => arithmetic.divide(x, y(operands)?)?,
        Operation::Negate(_) => arithmetic.negate(x)?,
        Operation::SquareRoot(_) => arithmetic.square_root(x)?,
        Operation::SineAndCosine(_) => {
            values.push(arithmetic.unary(Unary::Sin, x)?);
            arithmetic.unary(Unary::Cos, x)?
        }
        Operation::Unary(function, _) => arithmetic.unary(*function, x)?,
        Operation::Binary(function, ..) => arithmetic.binary(*function, x, y(operands)?)?,
        Operation::Application(..) => return None,
    };
    values.push(result);
    Some(())
}

/// The values of symbols and of external functions.
struct Binary64<F, G>(F, G);

impl<F: Fn(Symbol) -> f64, G: Fn(ExternalFunction, &[f64]) -> f64> Arithmetic for Binary64<F, G> {
    type Number = f64;

    fn constant(&mut self, value: &Rational) -> Option<f64> {
        Some(value.to_f64())
    }

    fn pi(&mut self) -> Option<f64> {
        Some(core::f64::consts::PI)
    }

    fn min_positive(&mut self) -> Option<f64> {
        Some(f64::MIN_POSITIVE)
    }

    fn symbol(&mut self, symbol: Symbol) -> Option<f64> {
        Some((self.0)(symbol))
    }

    fn add(&mut self, x: f64, y: f64) -> Option<f64> {
        Some(x + y)
    }

    fn negate(&mut self, x: f64) -> Option<f64> {
        Some(-x)
    }

    fn multiply(&mut self, x: f64, y: f64) -> Option<f64> {
        Some(x * y)
    }

    fn divide(&mut self, x: f64, y: f64) -> Option<f64> {
        Some(x / y)
    }

    fn square_root(&mut self, x: f64) -> Option<f64> {
        Some(x.sqrt())
    }

    fn unary(&mut self, function: Unary, x: f64) -> Option<f64> {
        Some(function.value(x))
    }

    fn binary(&mut self, function: Binary, x: f64, y: f64) -> Option<f64> {
        Some(function.value(x, y))
    }

    fn apply(&mut self, function: ExternalFunction, arguments: &[f64]) -> Option<f64> {
        Some((self.1)(function, arguments))
    }
}

impl Arithmetic for Graph {
    type Number = Expression;

    fn constant(&mut self, value: &Rational) -> Option<Expression> {
        Some(Self::constant(self, value))
    }

    fn pi(&mut self) -> Option<Expression> {
        Some(Self::pi(self))
    }

    fn min_positive(&mut self) -> Option<Expression> {
        Some(self.zero())
    }

    fn symbol(&mut self, symbol: Symbol) -> Option<Expression> {
        Some(Self::symbol(self, symbol))
    }

    fn add(&mut self, x: Expression, y: Expression) -> Option<Expression> {
        Some(Self::add(self, x, y))
    }

    fn negate(&mut self, x: Expression) -> Option<Expression> {
        Some(Self::negate(self, x))
    }

    fn multiply(&mut self, x: Expression, y: Expression) -> Option<Expression> {
        Some(Self::multiply(self, x, y))
    }

    fn divide(&mut self, x: Expression, y: Expression) -> Option<Expression> {
        Some(Self::divide(self, x, y))
    }

    fn square_root(&mut self, x: Expression) -> Option<Expression> {
        Some(Self::square_root(self, x))
    }

    fn unary(&mut self, function: Unary, x: Expression) -> Option<Expression> {
        Some(Self::unary(self, function, x))
    }

    fn binary(&mut self, function: Binary, x: Expression, y: Expression) -> Option<Expression> {
        Some(Self::binary(self, function, x, y))
    }

    fn apply(
        &mut self,
        function: ExternalFunction,
        arguments: &[Expression],
    ) -> Option<Expression> {
        Some(Self::apply(self, function, arguments))
    }
}

impl Arithmetic for ModularPoint {
    type Number = u64;

    fn constant(&mut self, value: &Rational) -> Option<u64> {
        ModularPoint::constant(*self, value)
    }

    fn pi(&mut self) -> Option<u64> {
        Some(Self::pi(*self))
    }

    fn min_positive(&mut self) -> Option<u64> {
        Some(0)
    }

    fn symbol(&mut self, symbol: Symbol) -> Option<u64> {
        Some(Self::symbol(*self, symbol))
    }

    fn add(&mut self, x: u64, y: u64) -> Option<u64> {
        Some(residue::add(x, y, self.p()))
    }

    fn negate(&mut self, x: u64) -> Option<u64> {
        Some(residue::negate(x, self.p()))
    }

    fn multiply(&mut self, x: u64, y: u64) -> Option<u64> {
        Some(residue::multiply(x, y, self.p()))
    }

    fn divide(&mut self, x: u64, y: u64) -> Option<u64> {
        Some(residue::multiply(
            x,
            residue::reciprocal(y, self.p())?,
            self.p(),
        ))
    }

    fn square_root(&mut self, x: u64) -> Option<u64> {
        self.power(x, &Rational::HALF)
    }

    fn unary(&mut self, function: Unary, x: u64) -> Option<u64> {
        Self::unary(*self, function, self.atom(x))
    }

    fn binary(&mut self, function: Binary, x: u64, y: u64) -> Option<u64> {
        Some(Self::binary(*self, function, x, y))
    }

    fn apply(&mut self, function: ExternalFunction, arguments: &[u64]) -> Option<u64> {
        Some(Self::apply(*self, function, arguments.iter().copied()))
    }
}
