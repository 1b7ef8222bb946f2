//! Instruction selection and scheduling: from the DAG to straight-line code.
//!
//! Input: roots of the graph. Output: instructions that compute each value once, operands first. Subtraction,
//! negation and division, which the normal forms do not have, reappear here: terms of a sum with equal
//! coefficients share one multiplication, and sine and cosine of one angle are one operation. Powers are computed
//! by squaring (Knuth, The Art of Computer Programming, volume 2, 3rd edition 1997, section 4.6.3). Local value
//! numbering (Cocke and Schwartz, Programming Languages and Their Compilers, 1970) finds the remaining repetitions.

use std::collections::{BTreeMap, BTreeSet};

use crate::program::dag::{Dag, DagOperation, ValueId};
use crate::program::numbering::Instructions;
use crate::program::straight_line::{Operand, Operation, OutputGroup, Program};
use crate::{Expression, Graph, Pass, Rational, Unary};

/// What is done with invariants, which depend on parameters alone.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Invariants {
    InPlace,
    Gathered,
}

impl Program {
    /// The program that computes the groups of roots, one after the other.
    #[must_use]
    pub fn schedule(graph: &Graph, groups: &[&[Expression]]) -> Self {
        Scheduler::new(graph, groups, Invariants::InPlace).run(groups)
    }

    /// The same with invariants gathered, so that much of it can be hoisted.
    #[must_use]
    pub fn schedule_for_staging(graph: &Graph, groups: &[&[Expression]]) -> Self {
        Scheduler::new(graph, groups, Invariants::Gathered).run(groups)
    }
}

/// The state of a scheduling run.
pub(crate) struct Scheduler {
    dag: Dag,
    /// The operand that holds each value, once it has been computed.
    operands: Vec<Option<Operand>>,
    /// Arguments of both a sine and a cosine.
    paired: BTreeSet<ValueId>,
    instructions: Instructions,
}

impl Scheduler {
    pub(crate) fn new(graph: &Graph, groups: &[&[Expression]], invariants: Invariants) -> Self {
        let roots = groups.concat();
        let passes = graph.passes;
        let mut dag = Dag::new(graph, &roots);
        if passes.has(Pass::Collecting) {
            let uses = dag.uses(&roots);
            dag.collect(&uses);
        }
        if passes.has(Pass::Factoring) {
            let uses = dag.uses(&roots);
            dag.factor(&uses);
        }
        if invariants == Invariants::Gathered {
            dag.gather_invariants(passes, &roots);
        }
        dag.eliminate_dead_values(&roots);
        dag.share(passes);
        let paired = if passes.has(Pass::Pairing) {
            paired_arguments(&dag)
        } else {
            BTreeSet::new()
        };
        Self {
            operands: vec![None; dag.operations.len()],
            instructions: Instructions::with_capacity(dag.operations.len()),
            paired,
            dag,
        }
    }

    pub(crate) fn run(mut self, roots: &[&[Expression]]) -> Program {
        let mut groups = Vec::with_capacity(roots.len());
        for roots in roots {
            let outputs = roots
                .iter()
                .map(|root| {
                    let value = self.dag.value(*root);
                    self.compute(value);
                    self.operand(value)
                })
                .collect();
            groups.push(OutputGroup {
                instructions: core::mem::take(&mut self.instructions.list),
                outputs,
            });
        }
        Program { groups }
    }

    /// Computes a value and its operands, each as late as possible.
    fn compute(&mut self, value: ValueId) {
        let mut waiting = vec![value];
        while let Some(value) = waiting.last().copied() {
            if self.operands[value].is_some() {
                waiting.pop();
                continue;
            }
            let before = waiting.len();
            self.dag.operations[value].for_each_operand(|operand| {
                if self.operands[operand].is_none() {
                    waiting.push(operand);
                }
            });
            // The first operand is computed first.
            waiting[before..].reverse();
            if waiting.len() == before {
                let operand = self.perform(value);
                self.operands[value] = Some(operand);
                waiting.pop();
            }
        }
    }

    /// The operand that holds a value which has been computed.
    fn operand(&self, value: ValueId) -> Operand {
        self.operands[value]
            .clone()
            .unwrap_or(Operand::Constant(Rational::ZERO))
    }

    /// Computes a value whose operands have been.
    fn perform(&mut self, value: ValueId) -> Operand {
        // Each operation is needed once.
        let done = DagOperation::Constant(Rational::ZERO);
        let operand = match core::mem::replace(&mut self.dag.operations[value], done) {
            DagOperation::Constant(number) => return Operand::Constant(number),
            DagOperation::Pi => return Operand::Pi,
            DagOperation::MinPositive => return Operand::MinPositive,
            DagOperation::Symbol(symbol) => return Operand::Symbol(symbol),
            DagOperation::Sum(terms) => self.sum(&terms),
            DagOperation::Quotient(numerator, denominator) => {
                self.quotient(&numerator, &denominator)
            }
            DagOperation::Power(x, exponent) => self.power(x, exponent),
            DagOperation::SquareRoot(x) => self.emit(Operation::SquareRoot(self.operand(x))),
            DagOperation::Unary(function, x) => self.unary(function, x),
            DagOperation::Binary(function, x, y) => self.emit(Operation::Binary(
                function,
                self.operand(x),
                self.operand(y),
            )),
            DagOperation::Application(function, arguments) => {
                let arguments = arguments.into_iter().map(|x| self.operand(x)).collect();
                self.emit(Operation::Application(function, arguments))
            }
        };
        self.label(&operand, self.dag.expressions[value]);
        operand
    }

    /// Records the expression whose value the last instruction computes.
    fn label(&mut self, operand: &Operand, expression: Option<Expression>) {
        if let Operand::Value(number) = operand
            && let Some(last) = self.instructions.list.last_mut()
            && last.values().contains(number)
        {
            last.expression = last.expression.or(expression);
        }
    }

    fn emit(&mut self, operation: Operation) -> Operand {
        self.instructions.emit(operation)
    }

    fn add(&mut self, x: Operand, y: Operand) -> Operand {
        self.emit(Operation::Add(x, y))
    }

    fn multiply(&mut self, x: Operand, y: Operand) -> Operand {
        match (&x, &y) {
            (Operand::Constant(c), _) if c.is_one() => y,
            (_, Operand::Constant(c)) if c.is_one() => x,
            _ => self.emit(Operation::Multiply(x, y)),
        }
    }

    /// Σ cᵢ·xᵢ: one multiplication for each magnitude of c, then additions and subtractions.
    fn sum(&mut self, terms: &[(ValueId, Rational)]) -> Operand {
        if let Some(parts) = self.plain_terms(terms) {
            return self.signed_sum(parts);
        }
        let mut groups: BTreeMap<Rational, Vec<(Operand, bool)>> = BTreeMap::new();
        for (x, c) in terms {
            let (operand, magnitude) = match self.operand(*x) {
                // A number in a sum is a term of coefficient one.
                Operand::Constant(number) => {
                    let term = &number * c;
                    groups
                        .entry(Rational::ONE)
                        .or_default()
                        .push((Operand::Constant(term.abs()), term.is_negative()));
                    continue;
                }
                operand => (operand, c.abs()),
            };
            groups
                .entry(magnitude)
                .or_default()
                .push((operand, c.is_negative()));
        }
        let mut parts = Vec::new();
        for (magnitude, members) in groups {
            if magnitude.is_one() {
                parts.extend(members);
                continue;
            }
            // A group that is negative throughout is subtracted.
            let negative = members.iter().all(|(_, negative)| *negative);
            let members = members
                .into_iter()
                .map(|(x, sign)| (x, sign != negative))
                .collect();
            let total = self.signed_sum(members);
            let scaled = self.multiply(Operand::Constant(magnitude), total);
            parts.push((scaled, negative));
        }
        self.signed_sum(parts)
    }

    /// The terms of a sum whose coefficients are all ±1, as most are, and none of which is a number.
    fn plain_terms(&self, terms: &[(ValueId, Rational)]) -> Option<Vec<(Operand, bool)>> {
        let mut parts = Vec::with_capacity(terms.len());
        for (x, c) in terms {
            let is_negative = match c.to_integer() {
                Some(1) => false,
                Some(-1) => true,
                _ => return None,
            };
            match self.operand(*x) {
                Operand::Constant(_) => return None,
                operand => parts.push((operand, is_negative)),
            }
        }
        Some(parts)
    }

    /// The sum of operands, each taken negative where its flag says so: first those that are added.
    fn signed_sum(&mut self, parts: Vec<(Operand, bool)>) -> Operand {
        let (mut negative, mut total) = (Vec::new(), None);
        for (operand, is_negative) in parts {
            if is_negative {
                negative.push(operand);
                continue;
            }
            total = Some(match total {
                Some(total) => self.add(total, operand),
                None => operand,
            });
        }
        if let Some(mut total) = total {
            for operand in negative {
                total = self.emit(Operation::Subtract(total, operand));
            }
            return total;
        }
        for operand in negative {
            total = Some(match total {
                Some(total) => self.add(total, operand),
                None => operand,
            });
        }
        match total {
            None => Operand::Constant(Rational::ZERO),
            Some(Operand::Constant(value)) => Operand::Constant(-&value),
            Some(total) => self.emit(Operation::Negate(total)),
        }
    }

    fn quotient(&mut self, numerator: &[ValueId], denominator: &[ValueId]) -> Operand {
        let numerator = self.factors(numerator);
        if denominator.is_empty() {
            return numerator;
        }
        let denominator = self.factors(denominator);
        self.emit(Operation::Divide(numerator, denominator))
    }

    /// The product of factors, those that repeat by squaring.
    fn factors(&mut self, factors: &[ValueId]) -> Operand {
        let mut factors = factors.to_vec();
        factors.sort_unstable();
        let mut product = Operand::Constant(Rational::ONE);
        for run in factors.chunk_by(|x, y| x == y) {
            let power = self.power(run[0], run.len());
            product = self.multiply(product, power);
        }
        product
    }

    /// x^k by squaring.
    fn power(&mut self, x: ValueId, exponent: usize) -> Operand {
        let x = self.operand(x);
        let mut power = Operand::Constant(Rational::ONE);
        for bit in (0..usize::BITS - exponent.leading_zeros()).rev() {
            power = self.multiply(power.clone(), power);
            if exponent >> bit & 1 == 1 {
                power = self.multiply(power, x.clone());
            }
        }
        power
    }

    fn unary(&mut self, function: Unary, x: ValueId) -> Operand {
        let operand = self.operand(x);
        let paired = self.paired.contains(&x);
        match (function, paired) {
            (Unary::Sin, true) => self.emit(Operation::SineAndCosine(operand)),
            (Unary::Cos, true) => match self.emit(Operation::SineAndCosine(operand)) {
                Operand::Value(sine) => Operand::Value(sine + 1),
                other => other,
            },
            _ => self.emit(Operation::Unary(function, operand)),
        }
    }
}

/// The arguments of both a sine and a cosine.
fn paired_arguments(dag: &Dag) -> BTreeSet<ValueId> {
    let arguments = |wanted: Unary| -> BTreeSet<ValueId> {
        dag.operations
            .iter()
            .filter_map(|operation| match operation {
                DagOperation::Unary(function, x) if *function == wanted => Some(*x),
                _ => None,
            })
            .collect()
    };
    &arguments(Unary::Sin) & &arguments(Unary::Cos)
}
