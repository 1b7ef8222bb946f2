//! From the expression graph to straight-line code.
//!
//! Comes in: roots of the graph. Goes out: instructions that compute each value once. Subtraction,
//! negation and division, which the normal forms do not have, reappear here: terms of a sum with equal
//! coefficients share one multiplication, powers are built from squares, sine and cosine of one angle
//! are one operation, and a divisor that serves twice is inverted once. Values are numbered, so that
//! what two expressions have in common by accident is found as well.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use crate::program::{Instruction, Operand, Operation, Phase, Program};
use crate::{Binary, Expression, Graph, Node, Rational, Unary};

/// The state of a scheduling run.
pub(crate) struct Scheduler<'a> {
    graph: &'a Graph,
    /// Where the value of each expression is.
    operands: HashMap<Expression, Operand>,
    /// The number of the first result of each operation done.
    numbers: HashMap<Operation, usize>,
    /// Arguments of both a sine and a cosine.
    paired: BTreeSet<Expression>,
    /// Powers below 1 that divide more than once.
    shared_divisors: BTreeSet<(Expression, Rational)>,
    instructions: Vec<Instruction>,
    next: usize,
}

impl<'a> Scheduler<'a> {
    pub(crate) fn new(graph: &'a Graph, groups: &[&[Expression]]) -> Self {
        let roots = groups.concat();
        let descendants = graph.descendants(&roots);
        Self {
            graph,
            operands: HashMap::new(),
            numbers: HashMap::new(),
            paired: paired_arguments(graph, &descendants),
            shared_divisors: shared_divisors(graph, &descendants),
            instructions: Vec::new(),
            next: 0,
        }
    }

    pub(crate) fn run(mut self, groups: &[&[Expression]]) -> Program {
        let mut phases = Vec::with_capacity(groups.len());
        for roots in groups {
            for expression in self.graph.descendants(roots) {
                if !self.operands.contains_key(&expression) {
                    let operand = self.compute(expression);
                    self.operands.insert(expression, operand);
                }
            }
            let outputs = roots
                .iter()
                .map(|root| self.operands[root].clone())
                .collect();
            phases.push(Phase {
                instructions: core::mem::take(&mut self.instructions),
                outputs,
            });
        }
        Program { phases }
    }

    /// The operand that holds `expression`, whose operands have been computed.
    fn compute(&mut self, expression: Expression) -> Operand {
        let graph = self.graph;
        let operand = match graph.node(expression) {
            Node::Constant(value) => return Operand::Constant(value.clone()),
            Node::Pi => return Operand::Pi,
            Node::Symbol(symbol) => return Operand::Symbol(*symbol),
            Node::Sum(terms) => self.sum(terms),
            Node::Product(factors) => self.product(factors),
            Node::Unary(function, x) => self.unary(*function, *x),
            Node::Binary(function, x, y) => {
                let (x, y) = (self.operands[x].clone(), self.operands[y].clone());
                self.emit(Operation::Binary(*function, x, y))
            }
        };
        self.label(&operand, expression);
        operand
    }

    /// Notes whose value an instruction computes.
    fn label(&mut self, operand: &Operand, expression: Expression) {
        if let Operand::Value(number) = operand
            && let Some(last) = self.instructions.last_mut()
            && last.value == *number
        {
            last.expression.get_or_insert(expression);
        }
    }

    fn emit(&mut self, operation: Operation) -> Operand {
        if let Some(number) = self.numbers.get(&operation) {
            return Operand::Value(*number);
        }
        let value = self.next;
        self.next += operation.results();
        self.numbers.insert(operation.clone(), value);
        self.instructions.push(Instruction {
            operation,
            value,
            expression: None,
        });
        Operand::Value(value)
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
    fn sum(&mut self, terms: &[(Expression, Rational)]) -> Operand {
        let mut groups: BTreeMap<Rational, Vec<(Operand, bool)>> = BTreeMap::new();
        for (x, c) in terms {
            let (operand, magnitude) = match self.graph.node(*x) {
                // The number in a sum is a term of coefficient one.
                Node::Constant(_) => (Operand::Constant(c.abs()), Rational::ONE),
                _ => (self.operands[x].clone(), c.abs()),
            };
            let group = groups.entry(magnitude).or_default();
            group.push((operand, c.is_negative()));
        }
        let mut parts = Vec::new();
        for (magnitude, members) in groups {
            if magnitude.is_one() {
                parts.extend(members);
                continue;
            }
            // The sign of a group is that of its first term.
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

    /// The sum of operands, each taken negative where its flag says so.
    fn signed_sum(&mut self, parts: Vec<(Operand, bool)>) -> Operand {
        let (negative, positive): (Vec<_>, Vec<_>) = parts.into_iter().partition(|(_, sign)| *sign);
        let mut negative = negative.into_iter().map(|(operand, _)| operand);
        let mut positive = positive.into_iter().map(|(operand, _)| operand);
        let Some(first) = positive.next() else {
            let first = negative.next().unwrap_or(Operand::Constant(Rational::ZERO));
            let total = negative.fold(first, |total, operand| self.add(total, operand));
            return match total {
                Operand::Constant(value) => Operand::Constant(-&value),
                total => self.emit(Operation::Negate(total)),
            };
        };
        let total = positive.fold(first, |total, operand| self.add(total, operand));
        negative.fold(total, |total, operand| {
            self.emit(Operation::Subtract(total, operand))
        })
    }

    /// Π xᵢ^kᵢ: the positive powers over the negative ones.
    fn product(&mut self, factors: &[(Expression, Rational)]) -> Operand {
        let one = Operand::Constant(Rational::ONE);
        let (mut numerator, mut denominator) = (one.clone(), one.clone());
        for (x, k) in factors {
            if !k.is_negative() {
                let power = self.power(*x, k);
                numerator = self.multiply(numerator, power);
            } else if self.shared_divisors.contains(&(*x, k.clone())) {
                let power = self.power(*x, &-k);
                let reciprocal = self.emit(Operation::Divide(one.clone(), power));
                numerator = self.multiply(numerator, reciprocal);
            } else {
                let power = self.power(*x, &-k);
                denominator = self.multiply(denominator, power);
            }
        }
        if denominator == one {
            numerator
        } else {
            self.emit(Operation::Divide(numerator, denominator))
        }
    }

    /// x^k for k > 0: whole powers by squaring, halves by a square root, others by the power function.
    fn power(&mut self, base: Expression, exponent: &Rational) -> Operand {
        let x = self.operands[&base].clone();
        if let Some(k) = exponent.to_integer() {
            return self.integer_power(x, k);
        }
        match exponent.to_fraction() {
            Some((numerator, 2)) => {
                let root = self.emit(Operation::SquareRoot(x.clone()));
                let whole = self.integer_power(x, numerator / 2);
                self.multiply(whole, root)
            }
            _ => self.emit(Operation::Binary(
                Binary::Power,
                x,
                Operand::Constant(exponent.clone()),
            )),
        }
    }

    fn integer_power(&mut self, x: Operand, exponent: i64) -> Operand {
        let mut power = Operand::Constant(Rational::ONE);
        for bit in (0..64 - exponent.leading_zeros()).rev() {
            if !matches!(power, Operand::Constant(_)) {
                power = self.multiply(power.clone(), power);
            }
            if exponent >> bit & 1 == 1 {
                power = self.multiply(power, x.clone());
            }
        }
        power
    }

    fn unary(&mut self, function: Unary, x: Expression) -> Operand {
        let operand = self.operands[&x].clone();
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

/// The arguments of which both sine and cosine are wanted.
fn paired_arguments(graph: &Graph, descendants: &[Expression]) -> BTreeSet<Expression> {
    let arguments = |wanted: Unary| -> BTreeSet<Expression> {
        descendants
            .iter()
            .filter_map(|expression| match graph.node(*expression) {
                Node::Unary(function, x) if *function == wanted => Some(*x),
                _ => None,
            })
            .collect()
    };
    &arguments(Unary::Sin) & &arguments(Unary::Cos)
}

/// The negative powers that more than one product divides by.
fn shared_divisors(graph: &Graph, descendants: &[Expression]) -> BTreeSet<(Expression, Rational)> {
    let mut uses: BTreeMap<(Expression, Rational), usize> = BTreeMap::new();
    for expression in descendants {
        if let Node::Product(factors) = graph.node(*expression) {
            for (x, k) in factors.iter().filter(|(_, k)| k.is_negative()) {
                *uses.entry((*x, k.clone())).or_default() += 1;
            }
        }
    }
    uses.into_iter()
        .filter(|(_, uses)| *uses > 1)
        .map(|(divisor, _)| divisor)
        .collect()
}
