//! Taylor series of the values of a program (Moore, Interval Analysis, 1966, chapter 11; Griewank and Walther,
//! Evaluating Derivatives, 2nd edition 2008, section 13.2).
//!
//! Input: a program of coordinates, velocities, inputs and time. Output: the program once more, for the terms of order 0,
//! and a recurrence for those of any order k ≥ 1. In the recurrence a product is
//! wₖ = Σ xᵢ yₖ₋ᵢ = x₀ yₖ + xₖ y₀ + Σ₀﹤ᵢ﹤ₖ xᵢ yₖ₋ᵢ, and every other operation is made of such products. The last
//! sum, over orders below k, is a [convolution](Convolution), which a loop accumulates; what is left is linear in the
//! terms of order k, and short.

mod functions;
mod terms;

use crate::algebra::hashing::Table;
use crate::program::straight_line::{Instruction, Operand, Operation, OutputGroup, Program};
use crate::{Rational, Symbol};

/// The program for the Taylor coefficients of the accelerations.
///
/// Coefficient k of the coordinates, velocities, inputs and time is what the [recurrence](Self::recurrence) reads as these
/// symbols.
#[derive(Clone, Debug)]
pub struct TaylorProgram {
    /// Order 0. The first groups are those of the program; the last one computes the invariants of the recurrence.
    pub initial: Program,
    /// Order k ≥ 1. The first group computes the coefficients of the accelerations or, where they are solved for
    /// numerically, of f − Σ₀﹤ᵢ≤ₖ Mᵢ q̈ₖ₋ᵢ; the second one, to which the accelerations are known, the factors of
    /// the convolutions.
    pub recurrence: Program,
    /// The sums of orders below k.
    pub convolutions: Vec<Convolution>,
}

/// The sum Σ₀﹤ᵢ﹤ₖ xᵢ yₖ₋ᵢ, which the recurrence reads as a [symbol](Symbol::Convolution): the indices of x and y among
/// the factors.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Convolution(pub usize, pub usize);

/// The accelerations, as a program returns them.
#[derive(Clone, Copy, Debug)]
pub enum AccelerationOperands<'a> {
    /// q̈.
    Solved(&'a [Operand]),
    /// The lower triangle of M, row by row, and f.
    System(&'a [Operand], &'a [Operand]),
}

impl TaylorProgram {
    /// The number of factors of convolutions.
    #[must_use]
    pub fn factors(&self) -> usize {
        self.recurrence
            .groups
            .last()
            .map_or(0, |group| group.outputs.len())
    }

    /// The Taylor series of the accelerations that `program` returns; none if it applies external functions, whose
    /// series are not known.
    #[must_use]
    pub fn of(program: &Program, accelerations: AccelerationOperands<'_>) -> Option<Self> {
        let mut builder = Builder::new(program);
        for instruction in program.instructions() {
            builder.instruction(instruction)?;
        }
        let coefficients = match accelerations {
            AccelerationOperands::Solved(operands) => {
                let series = operands.iter().map(|operand| builder.series(operand));
                series.map(|series| series.coefficient).collect()
            }
            AccelerationOperands::System(mass, forcing) => builder.residuals(mass, forcing),
        };
        Some(builder.finish(program, coefficients))
    }
}

/// The Taylor series of a value.
#[derive(Clone, Debug)]
struct Series {
    /// Its term of order 0, an operand of the initial program.
    constant: Operand,
    /// Its coefficient of order k, an operand of the recurrence; 0 if it does not vary.
    coefficient: Operand,
}

impl Series {
    fn varies(&self) -> bool {
        self.coefficient != ZERO
    }
}

const ZERO: Operand = Operand::Constant(Rational::ZERO);

/// The index of a factor of convolutions.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Factor(usize);

/// A list of instructions under construction, with value numbering.
#[derive(Default)]
struct Instructions {
    list: Vec<Instruction>,
    numbers: Table<Operation, usize>,
    next: usize,
}

impl Instructions {
    fn emit(&mut self, operation: Operation) -> Operand {
        if let Some(value) = self.numbers.get(&operation) {
            return Operand::Value(*value);
        }
        let value = self.next;
        self.next += operation.results();
        self.numbers.insert(operation.clone(), value);
        self.list.push(Instruction {
            operation,
            value,
            expression: None,
        });
        Operand::Value(value)
    }
}

/// Different items, numbered in the order in which they were first met.
struct Numbered<T> {
    items: Vec<T>,
    numbers: Table<T, usize>,
}

impl<T: Clone + Eq + core::hash::Hash> Numbered<T> {
    fn new() -> Self {
        Self {
            items: Vec::new(),
            numbers: Table::default(),
        }
    }

    /// The number of an item.
    fn number(&mut self, item: T) -> u32 {
        let number = *self.numbers.entry(item).or_insert_with_key(|item| {
            self.items.push(item.clone());
            self.items.len() - 1
        });
        u32::try_from(number).unwrap_or(u32::MAX)
    }
}

struct Builder {
    /// What order 0 needs beyond the program.
    initial: Instructions,
    /// The operands of the initial program that the recurrence reads.
    invariants: Numbered<Operand>,
    recurrence: Instructions,
    /// The series of each value of the program.
    series: Vec<Series>,
    /// The factors of convolutions, operands of the recurrence; none while the operand is not known.
    factors: Vec<Option<Operand>>,
    /// The factor of each coefficient that is known.
    known_factors: Table<Operand, usize>,
    convolutions: Numbered<Convolution>,
    /// Sines and cosines, and hyperbolic ones, by their argument.
    pairs: Vec<(functions::Pair, Operand, [Series; 2])>,
}

impl Builder {
    fn new(program: &Program) -> Self {
        let results = program.instructions().map(|instruction| {
            // The initial program keeps the numbers of the program.
            instruction.value + instruction.operation.results()
        });
        let initial = Instructions {
            next: results.max().unwrap_or(0),
            ..Instructions::default()
        };
        Self {
            initial,
            invariants: Numbered::new(),
            recurrence: Instructions::default(),
            series: Vec::new(),
            factors: Vec::new(),
            known_factors: Table::default(),
            convolutions: Numbered::new(),
            pairs: Vec::new(),
        }
    }

    /// The series of an operand of the program.
    fn series(&self, operand: &Operand) -> Series {
        let varies = |symbol: &Symbol| {
            matches!(
                symbol,
                Symbol::Time | Symbol::Coordinate(_) | Symbol::Velocity(_) | Symbol::Input(_)
            )
        };
        match operand {
            Operand::Value(value) => self.series[*value].clone(),
            Operand::Symbol(symbol) if varies(symbol) => Series {
                constant: operand.clone(),
                coefficient: operand.clone(),
            },
            _ => Series {
                constant: operand.clone(),
                coefficient: ZERO,
            },
        }
    }

    /// Appends the series of what an instruction computes; `None` if there is none.
    fn instruction(&mut self, instruction: &Instruction) -> Option<()> {
        let operands = instruction.operation.operands();
        let operands: Vec<Series> = operands.map(|operand| self.series(operand)).collect();
        let results = instruction.operation.results();
        let constants = (0..results).map(|i| Operand::Value(instruction.value + i));
        let constants: Vec<Operand> = constants.collect();
        let coefficients = if operands.iter().any(Series::varies) {
            self.coefficients(&instruction.operation, &operands, &constants)?
        } else {
            vec![ZERO; results]
        };
        let series = constants.into_iter().zip(coefficients);
        self.series
            .extend(series.map(|(constant, coefficient)| Series {
                constant,
                coefficient,
            }));
        Some(())
    }

    fn coefficients(
        &mut self,
        operation: &Operation,
        operands: &[Series],
        results: &[Operand],
    ) -> Option<Vec<Operand>> {
        let coefficient = match (operation, operands) {
            (Operation::Add(..), [x, y]) => self.add(&x.coefficient, &y.coefficient),
            (Operation::Subtract(..), [x, y]) => self.subtract(&x.coefficient, &y.coefficient),
            (Operation::Negate(_), [x]) => self.negate(&x.coefficient),
            (Operation::Multiply(..), [x, y]) => self.product(x, y),
            (Operation::Divide(..), [x, y]) => self.quotient(x, y, &results[0]),
            (Operation::SquareRoot(_), [x]) => self.square_root(x, &results[0]),
            (Operation::SineAndCosine(_), [x]) => return Some(self.sine_and_cosine(x, results)),
            (Operation::Unary(function, _), [x]) => self.unary(*function, x, &results[0]),
            (Operation::Binary(function, ..), [x, y]) => self.binary(*function, x, y, &results[0]),
            // The derivatives of an external function are not those of an expression.
            _ => return None,
        };
        Some(vec![coefficient])
    }

    /// f − Σ₀﹤ᵢ≤ₖ Mᵢ q̈ₖ₋ᵢ, which M₀ q̈ₖ is.
    fn residuals(&mut self, mass: &[Operand], forcing: &[Operand]) -> Vec<Operand> {
        let n = forcing.len();
        let mut factors = Vec::with_capacity(n);
        for i in 0..n {
            let symbol = Symbol::Acceleration(u32::try_from(i).unwrap_or(u32::MAX));
            let acceleration = Operand::Symbol(symbol);
            factors.push((self.factor(&acceleration), self.invariant(&acceleration)));
        }
        let mut residuals = Vec::with_capacity(n);
        for (i, force) in forcing.iter().enumerate() {
            let mut residual = self.series(force).coefficient;
            for (j, (factor, initial)) in factors.iter().enumerate() {
                let (row, column) = (i.max(j), i.min(j));
                let entry = self.series(&mass[row * (row + 1) / 2 + column]);
                if !entry.varies() {
                    continue;
                }
                let of_mass = self.factor(&entry.coefficient);
                let sum = self.convolve(of_mass, *factor);
                let last = self.multiply(&entry.coefficient, initial);
                let sum = self.add(&sum, &last);
                residual = self.subtract(&residual, &sum);
            }
            residuals.push(residual);
        }
        residuals
    }

    fn finish(self, program: &Program, coefficients: Vec<Operand>) -> TaylorProgram {
        let mut initial = program.clone();
        initial.groups.push(OutputGroup {
            instructions: self.initial.list,
            outputs: self.invariants.items,
        });
        let factors = self
            .factors
            .into_iter()
            .map(|factor| factor.unwrap_or(ZERO));
        let accelerations = OutputGroup {
            instructions: self.recurrence.list,
            outputs: coefficients,
        };
        let factors = OutputGroup {
            instructions: Vec::new(),
            outputs: factors.collect(),
        };
        TaylorProgram {
            initial,
            recurrence: Program {
                groups: vec![accelerations, factors],
            },
            convolutions: self.convolutions.items,
        }
    }
}

/// The operations that are not functions.
impl Builder {
    /// The coefficient of x · y.
    fn product(&mut self, x: &Series, y: &Series) -> Operand {
        if x.varies() != y.varies() {
            let (constant, other) = if x.varies() { (y, x) } else { (x, y) };
            let initial = self.invariant(&constant.constant);
            return self.multiply(&initial, &other.coefficient);
        }
        if !x.varies() {
            return ZERO;
        }
        let factors = [x, y].map(|series| self.factor(&series.coefficient));
        let sum = self.convolve(factors[0], factors[1]);
        if x.coefficient == y.coefficient && x.constant == y.constant {
            let twice = self.twice(&x.constant);
            let ends = self.multiply(&twice, &x.coefficient);
            return self.add(&sum, &ends);
        }
        let ends = [(x, y), (y, x)].map(|(initial, other)| {
            let initial = self.invariant(&initial.constant);
            self.multiply(&initial, &other.coefficient)
        });
        let sum = self.add(&sum, &ends[0]);
        self.add(&sum, &ends[1])
    }

    /// The coefficient of w = x / y, from w · y = x.
    fn quotient(&mut self, x: &Series, y: &Series, result: &Operand) -> Operand {
        let reciprocal = self.reciprocal(&y.constant);
        if !y.varies() {
            return self.multiply(&x.coefficient, &reciprocal);
        }
        let (w, y_factor) = (self.unknown_factor(), self.factor(&y.coefficient));
        let sum = self.convolve(w, y_factor);
        let rest = self.subtract(&x.coefficient, &sum);
        let initial = self.invariant(result);
        let last = self.multiply(&initial, &y.coefficient);
        let rest = self.subtract(&rest, &last);
        let coefficient = self.multiply(&rest, &reciprocal);
        self.define(w, &coefficient);
        coefficient
    }

    /// The coefficient of w = √x, from w² = x. Where w is 0, as the size of a velocity at rest, it has a corner, and
    /// higher terms count as 0: the step then ends where the root leaves 0.
    fn square_root(&mut self, x: &Series, result: &Operand) -> Operand {
        let w = self.unknown_factor();
        let sum = self.convolve(w, w);
        let rest = self.subtract(&x.coefficient, &sum);
        let reciprocal = self.reciprocal_or_zero(result);
        let half = self.multiply(&Operand::Constant(Rational::HALF.clone()), &rest);
        let coefficient = self.multiply(&half, &reciprocal);
        self.define(w, &coefficient);
        coefficient
    }
}
