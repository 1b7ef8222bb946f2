//! Tapes of expressions.

use crate::limits::HIGHEST_EXTERNAL_DERIVATIVE;
use crate::validation::tape::{Entry, Slot, Tape};
use crate::{Expression, Graph, Node, Rational};

impl Tape {
    /// The tape of some roots. Partial derivatives of external functions are the declared ones.
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
}

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

    /// The same, with the partial derivatives of external functions, as long as derivatives of them are needed.
    fn write_with_slopes(&mut self, graph: &mut Graph, roots: &[Expression], order: usize) {
        for expression in graph.descendants(roots) {
            if self.is_written(expression, order) {
                continue;
            }
            let mut slopes = Vec::new();
            if let Node::Application(function, arguments) = graph.node(expression).clone()
                && order < HIGHEST_EXTERNAL_DERIVATIVE
            {
                for argument in 0..arguments.len() {
                    slopes.push(graph.partial_derivative(function, argument, &arguments));
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
        self.tape
            .node(graph, expression, &|x| slots[x.index()], slopes)
    }
}

impl Tape {
    /// An expression whose operands are in the slots `of`, an external function with these partial derivatives.
    pub(super) fn node(
        &mut self,
        graph: &Graph,
        expression: Expression,
        of: &dyn Fn(Expression) -> Slot,
        slopes: &[Slot],
    ) -> Slot {
        let entry = match graph.node(expression) {
            Node::Constant(value) => Entry::Constant(value.to_f64()),
            Node::Pi => Entry::Constant(core::f64::consts::PI),
            Node::Symbol(symbol) => Entry::Symbol(*symbol),
            Node::Opaque(x) => return of(*x),
            Node::Unary(function, x) => Entry::Unary(*function, of(*x)),
            Node::Binary(function, x, y) => Entry::Binary(*function, of(*x), of(*y)),
            Node::Application(function, arguments) => {
                let arguments: Vec<Slot> = arguments.iter().map(|x| of(*x)).collect();
                self.application(*function, &arguments, slopes)
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
        self.push(entry)
    }

    fn sum(&mut self, terms: &[(Slot, &Rational)]) -> Slot {
        let mut total = None;
        for (x, c) in terms {
            let term = if c.abs().is_one() {
                *x
            } else {
                self.push(Entry::Scale(c.abs().to_f64(), *x))
            };
            total = Some(match total {
                Some(sum) if c.is_negative() => self.push(Entry::Subtract(sum, term)),
                Some(sum) => self.push(Entry::Add(sum, term)),
                None if c.is_negative() => self.push(Entry::Scale(-1.0, term)),
                None => term,
            });
        }
        total.unwrap_or_else(|| self.push(Entry::Constant(0.0)))
    }

    fn product(&mut self, factors: &[(Slot, &Rational)]) -> Slot {
        let mut total = None;
        for (x, k) in factors {
            let power = if k.is_one() {
                *x
            } else {
                self.push(Entry::Power(k.to_f64(), *x))
            };
            total = Some(match total {
                Some(product) => self.push(Entry::Multiply(product, power)),
                None => power,
            });
        }
        total.unwrap_or_else(|| self.push(Entry::Constant(1.0)))
    }
}
