//! Straight-line programs, the result that is emitted.
//!
//! A [`Program`] computes the values of several groups of roots, one group after the other, each value
//! once. Invariants, which the tests check: an operand is computed before it is used; no two
//! instructions do the same; each output has the value of its root. The order of instructions depends
//! on the graph alone.

use core::hash::{Hash, Hasher};
use core::ops::Range;

use crate::algebra::hashing::{Table, mix};
use crate::{Binary, Expression, ExternalFunction, Rational, Symbol, Unary};

/// An operand of an instruction.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Operand {
    /// The result of an earlier instruction.
    Value(usize),
    /// An exact number.
    Constant(Rational),
    /// The number π.
    Pi,
    /// The smallest positive number that has all digits of its format; 0 where numbers are exact. A divisor
    /// that is not negative is moved away from 0 by it.
    MinPositive,
    /// A coordinate, velocity, parameter …
    Symbol(Symbol),
}

/// One operation.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Operation {
    /// x + y.
    Add(Operand, Operand),
    /// x − y.
    Subtract(Operand, Operand),
    /// x · y.
    Multiply(Operand, Operand),
    /// x / y.
    Divide(Operand, Operand),
    /// −x.
    Negate(Operand),
    /// √x.
    SquareRoot(Operand),
    /// sin x, and cos x as the value after it.
    SineAndCosine(Operand),
    /// A function of one argument.
    Unary(Unary, Operand),
    /// A function of two arguments.
    Binary(Binary, Operand, Operand),
    /// An external function.
    Application(ExternalFunction, Vec<Operand>),
}

impl Operand {
    /// The number of the value, if the operand is the result of an instruction.
    #[must_use]
    pub const fn value(&self) -> Option<usize> {
        match self {
            Self::Value(value) => Some(*value),
            _ => None,
        }
    }

    /// A word that depends on all of the operand.
    fn code(&self) -> u64 {
        match self {
            Self::Value(number) => mix(1, *number as u64),
            Self::Constant(number) => mix(2, number.code()),
            Self::Pi => 3,
            Self::MinPositive => 4,
            Self::Symbol(symbol) => {
                let (kind, index) = symbol.code();
                mix(mix(5, kind), u64::from(index))
            }
        }
    }
}

impl Hash for Operand {
    fn hash<H: Hasher>(&self, state: &mut H) {
        state.write_u64(self.code());
    }
}

// Every instruction is looked up, so this is one call of the hasher.
impl Hash for Operation {
    fn hash<H: Hasher>(&self, state: &mut H) {
        let pair = |kind, x: &Operand, y: &Operand| mix(mix(kind, x.code()), y.code());
        let code = match self {
            Self::Add(x, y) => pair(1, x, y),
            Self::Subtract(x, y) => pair(2, x, y),
            Self::Multiply(x, y) => pair(3, x, y),
            Self::Divide(x, y) => pair(4, x, y),
            Self::Negate(x) => mix(5, x.code()),
            Self::SquareRoot(x) => mix(6, x.code()),
            Self::SineAndCosine(x) => mix(7, x.code()),
            Self::Unary(function, x) => mix(mix(8, *function as u64), x.code()),
            Self::Binary(function, x, y) => pair(mix(9, *function as u64), x, y),
            Self::Application(function, arguments) => {
                let code = mix(10, function.index() as u64);
                arguments.iter().fold(code, |code, x| mix(code, x.code()))
            }
        };
        state.write_u64(code);
    }
}

impl OutputGroup {
    /// The symbols that the group reads or returns, each once, in order.
    #[must_use]
    pub fn symbols(&self) -> Vec<Symbol> {
        symbols_of(core::slice::from_ref(self))
    }
}

/// The symbols of several groups, each once, in order.
fn symbols_of(groups: &[OutputGroup]) -> Vec<Symbol> {
    let mut symbols = Vec::new();
    // By kind and index: most symbols are read many times.
    let mut seen: Vec<Vec<bool>> = Vec::new();
    let mut note = |operand: &Operand| {
        let Operand::Symbol(symbol) = operand else {
            return;
        };
        let (kind, index) = symbol.code();
        let (kind, index) = (usize::try_from(kind).unwrap_or(0), index as usize);
        if kind >= seen.len() {
            seen.resize(kind + 1, Vec::new());
        }
        let seen = &mut seen[kind];
        if index >= seen.len() {
            seen.resize(index + 1, false);
        }
        if !seen[index] {
            seen[index] = true;
            symbols.push(*symbol);
        }
    };
    for group in groups {
        for instruction in &group.instructions {
            instruction.operation.operands().for_each(&mut note);
        }
        group.outputs.iter().for_each(&mut note);
    }
    symbols.sort_unstable();
    symbols
}

/// The operands of an operation. Chained iterators would take ten times as long without optimization.
struct Operands<'a> {
    x: Option<&'a Operand>,
    y: Option<&'a Operand>,
    others: core::slice::Iter<'a, Operand>,
}

impl<'a> Iterator for Operands<'a> {
    type Item = &'a Operand;

    fn next(&mut self) -> Option<&'a Operand> {
        if self.x.is_some() {
            return core::mem::take(&mut self.x);
        }
        if self.y.is_some() {
            return core::mem::take(&mut self.y);
        }
        self.others.next()
    }
}

impl Operation {
    /// The operands, in order.
    pub fn operands(&self) -> impl Iterator<Item = &Operand> {
        let (x, y, others) = match self {
            Self::Add(x, y)
            | Self::Subtract(x, y)
            | Self::Multiply(x, y)
            | Self::Divide(x, y)
            | Self::Binary(_, x, y) => (Some(x), Some(y), &[][..]),
            Self::Negate(x) | Self::SquareRoot(x) | Self::SineAndCosine(x) | Self::Unary(_, x) => {
                (Some(x), None, &[][..])
            }
            Self::Application(_, arguments) => (None, None, &arguments[..]),
        };
        Operands {
            x,
            y,
            others: others.iter(),
        }
    }

    /// Calls `visit` with each operand, in order.
    pub(crate) fn for_each_operand(&mut self, mut visit: impl FnMut(&mut Operand)) {
        match self {
            Self::Add(x, y)
            | Self::Subtract(x, y)
            | Self::Multiply(x, y)
            | Self::Divide(x, y)
            | Self::Binary(_, x, y) => {
                visit(x);
                visit(y);
            }
            Self::Negate(x) | Self::SquareRoot(x) | Self::SineAndCosine(x) | Self::Unary(_, x) => {
                visit(x);
            }
            Self::Application(_, arguments) => arguments.iter_mut().for_each(visit),
        }
    }

    /// How many values the operation computes.
    #[must_use]
    pub const fn results(&self) -> usize {
        match self {
            Self::SineAndCosine(_) => 2,
            _ => 1,
        }
    }
}

/// An operation and the number of its first result.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Instruction {
    /// What is computed.
    pub operation: Operation,
    /// The number of the value; a second result has the next one.
    pub value: usize,
    /// The expression whose value a result is, if it is that of one.
    pub expression: Option<Expression>,
}

impl Instruction {
    /// The numbers of the values that it computes.
    #[must_use]
    pub const fn values(&self) -> Range<usize> {
        self.value..self.value + self.operation.results()
    }
}

/// A group of outputs, and the instructions that it needs beyond those of earlier groups.
#[derive(Clone, Debug, Default)]
pub struct OutputGroup {
    /// In the order in which they run.
    pub instructions: Vec<Instruction>,
    /// Where the values of the roots are, in the order of the roots.
    pub outputs: Vec<Operand>,
}

/// A straight-line program.
#[derive(Clone, Debug, Default)]
pub struct Program {
    /// The groups, in order. Symbols may get their values between two of them.
    pub groups: Vec<OutputGroup>,
}

impl Program {
    /// All instructions, in the order in which they run.
    #[must_use]
    pub fn instructions(&self) -> impl DoubleEndedIterator<Item = &Instruction> {
        self.groups.iter().flat_map(|group| &group.instructions)
    }

    /// Numbers the values in the order in which they are computed.
    pub(crate) fn renumber(&mut self) {
        let mut numbers: Table<usize, usize> = Table::default();
        let mut next = 0;
        for group in &mut self.groups {
            let renumber = |operand: &mut Operand, numbers: &Table<usize, usize>| {
                if let Operand::Value(value) = operand
                    && let Some(number) = numbers.get(value)
                {
                    *value = *number;
                }
            };
            for instruction in &mut group.instructions {
                let operation = &mut instruction.operation;
                operation.for_each_operand(|operand| renumber(operand, &numbers));
                let results = operation.results();
                numbers.extend((0..results).map(|i| (instruction.value + i, next + i)));
                instruction.value = next;
                next += results;
            }
            for output in &mut group.outputs {
                renumber(output, &numbers);
            }
        }
    }

    /// Replaces symbols by operands, where `replacement` has one.
    pub(crate) fn replace_symbols(&mut self, replacement: impl Fn(Symbol) -> Option<Operand>) {
        let replace = |operand: &mut Operand| {
            if let Operand::Symbol(symbol) = operand
                && let Some(found) = replacement(*symbol)
            {
                *operand = found;
            }
        };
        for group in &mut self.groups {
            for instruction in &mut group.instructions {
                instruction.operation.for_each_operand(replace);
            }
            group.outputs.iter_mut().for_each(replace);
        }
    }

    /// The symbols that the program reads, in order.
    #[must_use]
    pub fn symbols(&self) -> Vec<Symbol> {
        symbols_of(&self.groups)
    }

    /// The exact numbers that the program contains.
    pub fn constants(&self) -> impl Iterator<Item = &Rational> {
        let outputs = self.groups.iter().flat_map(|group| &group.outputs);
        let operands = self
            .instructions()
            .flat_map(|instruction| instruction.operation.operands());
        operands.chain(outputs).filter_map(|operand| match operand {
            Operand::Constant(number) => Some(number),
            _ => None,
        })
    }

    /// The external functions that the program applies, in order.
    #[must_use]
    pub fn functions(&self) -> Vec<ExternalFunction> {
        let mut functions: Vec<ExternalFunction> = self
            .instructions()
            .filter_map(|instruction| match instruction.operation {
                Operation::Application(function, _) => Some(function),
                _ => None,
            })
            .collect();
        functions.sort_unstable();
        functions.dedup();
        functions
    }
}
