//! Programs run on any numbers, by a machine that knows nothing of the library's.

use lagrangian_symbolic::{Operand, Operation, Program, Rational, Symbol, Unary};

use crate::{Number, external};

/// The outputs of a program, group by group.
pub fn run<N: Number>(program: &Program, symbol: impl Fn(Symbol) -> N) -> Vec<Vec<N>> {
    let mut values: Vec<N> = Vec::new();
    let mut groups = Vec::new();
    for group in &program.groups {
        for instruction in &group.instructions {
            assert_eq!(instruction.value, values.len());
            execute(&instruction.operation, &mut values, &symbol);
        }
        let outputs = group.outputs.iter();
        groups.push(outputs.map(|x| fetch(x, &values, &symbol)).collect());
    }
    groups
}

fn fetch<N: Number>(operand: &Operand, values: &[N], symbol: &impl Fn(Symbol) -> N) -> N {
    match operand {
        Operand::Value(number) => values[*number],
        Operand::Constant(value) => N::rational(value),
        Operand::Pi => N::pi(),
        // That of binary32.
        Operand::MinPositive => N::rational(&Rational::HALF.power(126).unwrap()),
        Operand::Symbol(name) => symbol(*name),
    }
}

fn execute<N: Number>(operation: &Operation, values: &mut Vec<N>, symbol: &impl Fn(Symbol) -> N) {
    let of = |operand| fetch(operand, values, symbol);
    let minus = N::rational(&Rational::MINUS_ONE);
    let value = match operation {
        Operation::Add(x, y) => of(x).add(of(y)),
        Operation::Subtract(x, y) => of(x).add(minus.multiply(of(y))),
        Operation::Multiply(x, y) => of(x).multiply(of(y)),
        Operation::Divide(x, y) => of(x).multiply(of(y).power(&Rational::MINUS_ONE)),
        Operation::Negate(x) => minus.multiply(of(x)),
        Operation::SquareRoot(x) => of(x).power(&Rational::HALF),
        Operation::SineAndCosine(x) => {
            let angle = of(x);
            values.push(angle.unary(Unary::Sin));
            angle.unary(Unary::Cos)
        }
        Operation::Unary(function, x) => of(x).unary(*function),
        Operation::Binary(function, x, y) => of(x).binary(*function, of(y)),
        Operation::Application(function, arguments) => {
            let arguments: Vec<N> = arguments.iter().map(of).collect();
            external::value(*function, &arguments)
        }
    };
    values.push(value);
}
