//! Tapes of programs.

use crate::algebra::hashing::Table;
use crate::limits::HIGHEST_EXTERNAL_DERIVATIVE;
use crate::program::straight_line::{Operand, Operation};
use crate::validation::tape::{Entry, Slot, Tape};
use crate::{Expression, ExternalFunction, Graph, Node, Program, Symbol, Unary};

impl Tape {
    /// The tape of a program, its outputs one group after the other.
    pub(crate) fn of_program(program: &Program) -> Self {
        Self::of_programs([program])
    }

    /// The tape of several programs, one after the other.
    pub(crate) fn of_programs<'a>(programs: impl IntoIterator<Item = &'a Program>) -> Self {
        let mut tape = Self::default();
        for program in programs {
            tape.append(program, None);
        }
        tape
    }

    /// The same for a program on jets, scheduled from `graph`: partial derivatives of external functions are the declared
    /// ones.
    pub(crate) fn of_program_with_slopes(graph: &Graph, program: &Program) -> Self {
        let mut tape = Self::default();
        tape.append(program, Some(graph));
        tape
    }

    fn append(&mut self, program: &Program, derivatives: Option<&Graph>) {
        let mut values: Vec<Slot> = Vec::new();
        let mut loaded: Table<Operand, Slot> = Table::default();
        for group in &program.groups {
            for instruction in &group.instructions {
                let operation = &instruction.operation;
                let operands: Vec<Slot> = operation
                    .operands()
                    .map(|operand| self.load(operand, &values, &mut loaded))
                    .collect();
                if let (Some(graph), Operation::Application(function, _)) = (derivatives, operation)
                {
                    values.push(self.with_slopes(graph, *function, &operands, 0));
                } else {
                    self.translate(operation, &operands, &mut values);
                }
            }
            for operand in &group.outputs {
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

    /// An external function and its partial derivatives, themselves differentiable as often as it takes from this order on.
    fn with_slopes(
        &mut self,
        graph: &Graph,
        function: ExternalFunction,
        arguments: &[Slot],
        order: usize,
    ) -> Slot {
        let mut slopes = Vec::new();
        if order < HIGHEST_EXTERNAL_DERIVATIVE {
            for argument in 0..arguments.len() {
                let derivative = graph.declared_derivative(function, argument);
                let slope = match derivative {
                    Some(derivative) => self.expression_at(graph, derivative, arguments, order + 1),
                    // No series would do without it, unless the argument does not vary.
                    None => self.push(Entry::Constant(0.0)),
                };
                slopes.push(slope);
            }
        }
        let entry = self.application(function, arguments, &slopes);
        self.push(entry)
    }

    /// An expression in the symbols of arguments.
    fn expression_at(
        &mut self,
        graph: &Graph,
        expression: Expression,
        arguments: &[Slot],
        order: usize,
    ) -> Slot {
        let mut slots: Table<Expression, Slot> = Table::default();
        for descendant in graph.descendants(&[expression]) {
            let of = |x: Expression| slots.get(&x).copied().unwrap_or(0);
            let slot = match graph.node(descendant) {
                Node::Symbol(Symbol::Argument(i)) if (*i as usize) < arguments.len() => {
                    arguments[*i as usize]
                }
                Node::Application(function, operands) => {
                    let operands: Vec<Slot> = operands.iter().map(|x| of(*x)).collect();
                    self.with_slopes(graph, *function, &operands, order)
                }
                _ => self.node(graph, descendant, &of, &[]),
            };
            slots.insert(descendant, slot);
        }
        slots.get(&expression).copied().unwrap_or(0)
    }
}
