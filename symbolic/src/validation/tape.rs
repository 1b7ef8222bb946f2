//! Tapes: expressions and programs as lists of elementary operations, run forward on numbers and backward
//! for gradients (reverse accumulation: Griewank and Walther, Evaluating Derivatives, 2nd edition 2008,
//! chapter 3).
//!
//! An expression is written down as it stands, node by node; nothing is simplified. A run may perturb every
//! result a little, so that it shows how much rounding can matter (Monte Carlo arithmetic: Parker, 1997).

use crate::algebra::hashing::Table;
use crate::decision::residue::mix;
use crate::program::straight_line::{Operand, Operation};
use crate::validation::hyper_dual::{HyperDual, real_power};
use crate::{Binary, Expression, Function, Graph, Node, Program, Rational, Symbol, Unary};

/// The position of a result on a tape.
type Slot = u32;

/// One elementary operation.
#[derive(Clone, Copy, Debug)]
enum Entry {
    Symbol(Symbol),
    Constant(f64),
    Add(Slot, Slot),
    Subtract(Slot, Slot),
    Multiply(Slot, Slot),
    Divide(Slot, Slot),
    Scale(f64, Slot),
    Power(f64, Slot),
    Unary(Unary, Slot),
    Binary(Binary, Slot, Slot),
    /// A function from outside: where its arguments begin, how many they are, and whether as many slopes
    /// follow them.
    Apply(Function, Slot, Slot, bool),
}

/// A list of operations, and where the results are.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tape {
    entries: Vec<Entry>,
    /// Arguments and slopes of functions from outside.
    arguments: Vec<Slot>,
    outputs: Vec<Slot>,
}

/// Numbers on which a tape is run.
pub(crate) trait Number: Copy {
    const ZERO: Self;
    fn constant(value: f64) -> Self;
    fn value(self) -> f64;
    fn add(self, y: Self) -> Self;
    fn subtract(self, y: Self) -> Self;
    fn multiply(self, y: Self) -> Self;
    fn divide(self, y: Self) -> Self;
    fn scaled(self, factor: f64) -> Self;
    fn power(self, k: f64) -> Self;
    fn unary(self, function: Unary) -> Self;
    fn binary(self, function: Binary, y: Self) -> Self;
    fn composed(value: f64, slopes: &[Self], arguments: &[Self]) -> Self;
}

/// How far the results of a run are moved, relative to their size; by nothing without a seed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Perturbation(pub(crate) Option<u64>);

impl Perturbation {
    /// 2⁻³⁶: far above rounding, and far below what a wrong term is.
    const SIZE: f64 = 1.0 / 68_719_476_736.0;

    /// The factor of the result at a position.
    #[allow(clippy::cast_precision_loss)] // Thirty-two bits are enough.
    fn factor(self, position: usize) -> f64 {
        match self.0 {
            None => 1.0,
            Some(seed) => {
                let word = mix(seed, position as u64) >> 32;
                1.0 + Self::SIZE * (word as f64 / f64::from(u32::MAX) * 2.0 - 1.0)
            }
        }
    }
}

/// A function from outside that nobody knows: smooth, positive, another one for each.
#[allow(clippy::cast_precision_loss)] // The index is small.
fn unknown_function<N: Number>(function: Function, arguments: &[N]) -> f64 {
    let mut phase = function.index() as f64;
    for (position, x) in arguments.iter().enumerate() {
        phase += (0.7 + 0.2 * position as f64) * x.value();
    }
    1.3 + 0.7 * libm::sin(phase)
}

impl Tape {
    /// The tape of some roots. Slopes of functions from outside are taken from their declared derivatives.
    pub(crate) fn of_expressions(graph: &Graph, roots: &[Expression]) -> Self {
        let mut writer = Writer {
            tape: Self::default(),
            slots: Vec::new(),
        };
        if graph.functions().next().is_some() {
            let mut graph = graph.clone();
            writer.write_with_slopes(&mut graph, roots, 0);
        } else {
            writer.write(graph, roots);
        }
        let slot = |root: &Expression| writer.slots[0][root.index()];
        writer.tape.outputs = roots.iter().map(slot).collect();
        writer.tape
    }

    /// The tape of a program, its outputs one group after the other.
    pub(crate) fn of_program(program: &Program) -> Self {
        Self::of_programs([program])
    }

    /// The tape of several programs, one after the other.
    pub(crate) fn of_programs<'a>(programs: impl IntoIterator<Item = &'a Program>) -> Self {
        let mut tape = Self::default();
        for program in programs {
            tape.append(program);
        }
        tape
    }

    fn append(&mut self, program: &Program) {
        let mut values: Vec<Slot> = Vec::new();
        let mut loaded: Table<Operand, Slot> = Table::default();
        for phase in &program.phases {
            for instruction in &phase.instructions {
                let operation = &instruction.operation;
                let operands: Vec<Slot> = operation
                    .operands()
                    .map(|operand| self.load(operand, &values, &mut loaded))
                    .collect();
                self.translate(operation, &operands, &mut values);
            }
            for operand in &phase.outputs {
                let slot = self.load(operand, &values, &mut loaded);
                self.outputs.push(slot);
            }
        }
    }

    fn load(
        &mut self,
        operand: &Operand,
        values: &[Slot],
        loaded: &mut Table<Operand, Slot>,
    ) -> Slot {
        let entry = match operand {
            Operand::Value(number) => return values[*number],
            Operand::Constant(value) => Entry::Constant(value.to_f64()),
            Operand::Pi => Entry::Constant(core::f64::consts::PI),
            Operand::MinPositive => Entry::Constant(f64::MIN_POSITIVE),
            Operand::Symbol(symbol) => Entry::Symbol(*symbol),
        };
        if let Some(slot) = loaded.get(operand) {
            return *slot;
        }
        let slot = self.push(entry);
        loaded.insert(operand.clone(), slot);
        slot
    }

    fn translate(&mut self, operation: &Operation, operands: &[Slot], values: &mut Vec<Slot>) {
        let entry = match (operation, operands) {
            (Operation::Add(..), [x, y]) => Entry::Add(*x, *y),
            (Operation::Subtract(..), [x, y]) => Entry::Subtract(*x, *y),
            (Operation::Multiply(..), [x, y]) => Entry::Multiply(*x, *y),
            (Operation::Divide(..), [x, y]) => Entry::Divide(*x, *y),
            (Operation::Binary(function, ..), [x, y]) => Entry::Binary(*function, *x, *y),
            (Operation::Negate(_), [x]) => Entry::Scale(-1.0, *x),
            (Operation::SquareRoot(_), [x]) => Entry::Power(0.5, *x),
            (Operation::Unary(function, _), [x]) => Entry::Unary(*function, *x),
            (Operation::SineAndCosine(_), [x]) => {
                let sine = self.push(Entry::Unary(Unary::Sin, *x));
                values.push(sine);
                Entry::Unary(Unary::Cos, *x)
            }
            (Operation::Application(function, _), arguments) => {
                self.application(*function, arguments, &[])
            }
            _ => Entry::Constant(f64::NAN),
        };
        let slot = self.push(entry);
        values.push(slot);
    }

    fn application(&mut self, function: Function, arguments: &[Slot], slopes: &[Slot]) -> Entry {
        let start = position(self.arguments.len());
        self.arguments.extend_from_slice(arguments);
        self.arguments.extend_from_slice(slopes);
        let has_slopes = !slopes.is_empty();
        Entry::Apply(function, start, position(arguments.len()), has_slopes)
    }

    fn push(&mut self, entry: Entry) -> Slot {
        self.entries.push(entry);
        position(self.entries.len() - 1)
    }

    /// The positions of the outputs.
    pub(crate) fn outputs(&self) -> &[Slot] {
        &self.outputs
    }

    /// The values of the outputs alone.
    pub(crate) fn evaluate(
        &self,
        symbol: &dyn Fn(Symbol) -> f64,
        perturbation: Perturbation,
    ) -> Vec<f64> {
        let values = self.run(symbol, perturbation);
        let mut outputs = Vec::with_capacity(self.outputs.len());
        for slot in &self.outputs {
            outputs.push(values[*slot as usize]);
        }
        outputs
    }

    /// The values of all entries.
    pub(crate) fn run<N: Number>(
        &self,
        symbol: &dyn Fn(Symbol) -> N,
        perturbation: Perturbation,
    ) -> Vec<N> {
        let mut results = vec![N::ZERO; self.entries.len()];
        // Macros run without optimization: a plain loop over slices.
        let (values, entries) = (&mut results[..], &self.entries[..]);
        let mut position = 0;
        while position < entries.len() {
            let value = match entries[position] {
                Entry::Symbol(x) => symbol(x),
                Entry::Constant(x) => N::constant(x),
                Entry::Add(x, y) => values[x as usize].add(values[y as usize]),
                Entry::Subtract(x, y) => values[x as usize].subtract(values[y as usize]),
                Entry::Multiply(x, y) => values[x as usize].multiply(values[y as usize]),
                Entry::Divide(x, y) => values[x as usize].divide(values[y as usize]),
                Entry::Scale(factor, x) => values[x as usize].scaled(factor),
                Entry::Power(k, x) => values[x as usize].power(k),
                Entry::Unary(function, x) => values[x as usize].unary(function),
                Entry::Binary(function, x, y) => {
                    values[x as usize].binary(function, values[y as usize])
                }
                Entry::Apply(function, start, count, has_slopes) => {
                    let [arguments, slopes] = self.operands(values, start, count, has_slopes);
                    let value = unknown_function(function, &arguments);
                    N::composed(value, &slopes, &arguments)
                }
            };
            let is_loaded = matches!(entries[position], Entry::Symbol(_) | Entry::Constant(_));
            values[position] = match perturbation.0 {
                Some(_) if !is_loaded => value.scaled(perturbation.factor(position)),
                _ => value,
            };
            position += 1;
        }
        results
    }

    /// The arguments of a function from outside, and its slopes if they are known.
    fn operands<N: Number>(
        &self,
        values: &[N],
        start: Slot,
        count: Slot,
        has_slopes: bool,
    ) -> [Vec<N>; 2] {
        let (start, count) = (start as usize, count as usize);
        let of = |slots: &[Slot]| slots.iter().map(|slot| values[*slot as usize]).collect();
        let arguments = of(&self.arguments[start..start + count]);
        let slopes = if has_slopes {
            of(&self.arguments[start + count..start + 2 * count])
        } else {
            Vec::new()
        };
        [arguments, slopes]
    }

    /// The derivatives of Σ wᵢ·outputᵢ by the symbols, which `receive` gets one by one; `values` are those of
    /// all entries.
    pub(crate) fn gradient(
        &self,
        values: &[HyperDual],
        weights: &[(Slot, f64)],
        perturbation: Perturbation,
        receive: &mut dyn FnMut(Symbol, HyperDual),
    ) {
        let mut adjoints = vec![HyperDual::ZERO; self.entries.len()];
        let (adjoints, entries) = (&mut adjoints[..], &self.entries[..]);
        for (slot, weight) in weights {
            let adjoint = &mut adjoints[*slot as usize];
            *adjoint = *adjoint + HyperDual::constant(*weight);
        }
        let mut next = entries.len();
        while next > 0 {
            next -= 1;
            let mut adjoint = adjoints[next];
            if adjoint.is_zero() {
                continue;
            }
            if perturbation.0.is_some() {
                adjoint = adjoint.scaled(perturbation.factor(entries.len() + next));
            }
            let mut add = |slot: Slot, change: HyperDual| {
                adjoints[slot as usize] = adjoints[slot as usize] + change;
            };
            match entries[next] {
                Entry::Symbol(symbol) => receive(symbol, adjoint),
                Entry::Constant(_) => {}
                Entry::Add(x, y) => {
                    add(x, adjoint);
                    add(y, adjoint);
                }
                Entry::Subtract(x, y) => {
                    add(x, adjoint);
                    add(y, -adjoint);
                }
                Entry::Multiply(x, y) => {
                    add(x, adjoint * values[y as usize]);
                    add(y, adjoint * values[x as usize]);
                }
                Entry::Divide(x, y) => {
                    let change = adjoint * values[y as usize].reciprocal();
                    add(x, change);
                    add(y, -(change * values[next]));
                }
                Entry::Scale(factor, x) => add(x, adjoint.scaled(factor)),
                Entry::Power(k, x) => add(x, adjoint * values[x as usize].power_slope(k)),
                Entry::Unary(function, x) => add(x, adjoint * values[x as usize].slope(function)),
                Entry::Binary(function, x, y) => {
                    let slopes = values[x as usize].slopes(function, values[y as usize]);
                    add(x, adjoint * slopes[0]);
                    add(y, adjoint * slopes[1]);
                }
                Entry::Apply(_, start, count, has_slopes) => {
                    let [_, slopes] = self.operands(values, start, count, has_slopes);
                    for (slope, x) in slopes.iter().zip(&self.arguments[start as usize..]) {
                        add(*x, adjoint * *slope);
                    }
                }
            }
        }
    }
}

/// How often a function from outside is differentiated: Lagrange's equations and their linearization take
/// third derivatives of the Lagrangian function.
const HIGHEST_DERIVATIVE: usize = 3;

/// Writes expressions on a tape.
struct Writer {
    tape: Tape,
    /// By order of the derivative for which they are needed, and by expression.
    slots: Vec<Vec<Slot>>,
}

/// What is not written yet.
const ABSENT: Slot = Slot::MAX;

impl Writer {
    fn write(&mut self, graph: &Graph, roots: &[Expression]) {
        for expression in graph.descendants(roots) {
            if !self.is_written(expression, 0) {
                let slot = self.node(graph, expression, 0, &[]);
                self.slots[0][expression.index()] = slot;
            }
        }
    }

    /// The same, where functions from outside have slopes, as long as derivatives of them are needed.
    fn write_with_slopes(&mut self, graph: &mut Graph, roots: &[Expression], order: usize) {
        for expression in graph.descendants(roots) {
            if self.is_written(expression, order) {
                continue;
            }
            let mut slopes = Vec::new();
            if let Node::Application(function, arguments) = graph.node(expression).clone()
                && order < HIGHEST_DERIVATIVE
            {
                for argument in 0..arguments.len() {
                    slopes.push(graph.slope(function, argument, &arguments));
                }
                self.write_with_slopes(graph, &slopes, order + 1);
            }
            let slopes: Vec<Slot> = slopes
                .iter()
                .map(|slope| self.slots[order + 1][slope.index()])
                .collect();
            let slot = self.node(graph, expression, order, &slopes);
            self.slots[order][expression.index()] = slot;
        }
    }

    fn is_written(&mut self, expression: Expression, order: usize) -> bool {
        while self.slots.len() <= order {
            self.slots.push(Vec::new());
        }
        let slots = &mut self.slots[order];
        if slots.len() <= expression.index() {
            slots.resize(expression.index() + 1, ABSENT);
        }
        slots[expression.index()] != ABSENT
    }

    fn node(
        &mut self,
        graph: &Graph,
        expression: Expression,
        order: usize,
        slopes: &[Slot],
    ) -> Slot {
        let slots = &self.slots[order];
        let of = |x: Expression| slots[x.index()];
        let entry = match graph.node(expression) {
            Node::Constant(value) => Entry::Constant(value.to_f64()),
            Node::Pi => Entry::Constant(core::f64::consts::PI),
            Node::Symbol(symbol) => Entry::Symbol(*symbol),
            Node::Whole(x) => return of(*x),
            Node::Unary(function, x) => Entry::Unary(*function, of(*x)),
            Node::Binary(function, x, y) => Entry::Binary(*function, of(*x), of(*y)),
            Node::Application(function, arguments) => {
                let arguments: Vec<Slot> = arguments.iter().map(|x| of(*x)).collect();
                self.tape.application(*function, &arguments, slopes)
            }
            Node::Sum(terms) => {
                let terms: Vec<_> = terms.iter().map(|(x, c)| (of(*x), c)).collect();
                return self.sum(&terms);
            }
            Node::Product(factors) => {
                let factors: Vec<_> = factors.iter().map(|(x, k)| (of(*x), k)).collect();
                return self.product(&factors);
            }
        };
        self.tape.push(entry)
    }

    fn sum(&mut self, terms: &[(Slot, &Rational)]) -> Slot {
        let mut total = None;
        for (x, c) in terms {
            let term = if c.abs().is_one() {
                *x
            } else {
                self.tape.push(Entry::Scale(c.abs().to_f64(), *x))
            };
            total = Some(match total {
                Some(sum) if c.is_negative() => self.tape.push(Entry::Subtract(sum, term)),
                Some(sum) => self.tape.push(Entry::Add(sum, term)),
                None if c.is_negative() => self.tape.push(Entry::Scale(-1.0, term)),
                None => term,
            });
        }
        total.unwrap_or_else(|| self.tape.push(Entry::Constant(0.0)))
    }

    fn product(&mut self, factors: &[(Slot, &Rational)]) -> Slot {
        let mut total = None;
        for (x, k) in factors {
            let power = if k.is_one() {
                *x
            } else {
                self.tape.push(Entry::Power(k.to_f64(), *x))
            };
            total = Some(match total {
                Some(product) => self.tape.push(Entry::Multiply(product, power)),
                None => power,
            });
        }
        total.unwrap_or_else(|| self.tape.push(Entry::Constant(1.0)))
    }
}

fn position(index: usize) -> Slot {
    // Four billion entries do not fit into a compiler's memory.
    Slot::try_from(index).unwrap_or(Slot::MAX)
}

impl Number for f64 {
    const ZERO: Self = 0.0;

    fn constant(value: f64) -> Self {
        value
    }

    fn value(self) -> f64 {
        self
    }

    fn add(self, y: Self) -> Self {
        self + y
    }

    fn subtract(self, y: Self) -> Self {
        self - y
    }

    fn multiply(self, y: Self) -> Self {
        self * y
    }

    fn divide(self, y: Self) -> Self {
        self / y
    }

    fn scaled(self, factor: f64) -> Self {
        self * factor
    }

    fn power(self, k: f64) -> Self {
        real_power(self, k)
    }

    fn unary(self, function: Unary) -> Self {
        function.value(self)
    }

    fn binary(self, function: Binary, y: Self) -> Self {
        function.value(self, y)
    }

    fn composed(value: f64, _: &[Self], _: &[Self]) -> Self {
        value
    }
}

impl Number for HyperDual {
    const ZERO: Self = Self::constant(0.0);

    fn constant(value: f64) -> Self {
        Self::constant(value)
    }

    fn value(self) -> f64 {
        self.value
    }

    fn add(self, y: Self) -> Self {
        self + y
    }

    fn subtract(self, y: Self) -> Self {
        self - y
    }

    fn multiply(self, y: Self) -> Self {
        self * y
    }

    fn divide(self, y: Self) -> Self {
        self * y.reciprocal()
    }

    fn scaled(self, factor: f64) -> Self {
        Self::scaled(self, factor)
    }

    fn power(self, k: f64) -> Self {
        Self::power(self, k)
    }

    fn unary(self, function: Unary) -> Self {
        Self::unary(self, function)
    }

    fn binary(self, function: Binary, y: Self) -> Self {
        Self::binary(self, function, y)
    }

    fn composed(value: f64, slopes: &[Self], arguments: &[Self]) -> Self {
        Self::composed(value, slopes, arguments)
    }
}
