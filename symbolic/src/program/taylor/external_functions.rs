//! Taylor series of external functions, from their declared derivatives (the chain rule; Griewank and Walther, Evaluating
//! Derivatives, 2nd edition 2008, section 13.2).
//!
//! With D = t d/dt, w = f(u₁, u₂, …) has Dw = Σⱼ gⱼ Duⱼ, where the gⱼ = ∂f/∂uⱼ are programs in the arguments. Coefficient k
//! of w takes the gⱼ up to order k − 1, so that it is known before theirs: functions may be each other's derivatives. The
//! gⱼ get series by the same builder. These come to an end where every function that they apply, at the arguments at which
//! they apply it, has been met before.

use std::rc::Rc;

use super::builder::Builder;
use super::quotients::with_quotients;
use super::series::{Factor, NoSeries, Series, ZERO};
use crate::limits::MAX_APPLICATIONS_IN_A_SERIES;
use crate::program::liveness::LiveValues;
use crate::program::straight_line::{Operand, Operation, Program};
use crate::{ExternalFunction, Symbol, Unary};

/// The program of a declared derivative, in the symbols of the arguments.
pub(super) struct Derivative {
    steps: Vec<Step>,
    result: Operand,
}

/// An operation of it.
struct Step {
    operation: Operation,
    /// The operation whose series is taken.
    of_series: Operation,
    /// Whether the series is needed.
    needed: bool,
}

/// A derivative at the arguments of an application.
enum Slope {
    /// It does not vary.
    Constant(Operand),
    /// Its factor, and its term of order 0.
    Varying(Factor, Operand),
}

/// A derivative whose series is still to be made.
pub(super) struct Pending {
    factor: Factor,
    result: Operand,
    /// In terms of the initial program, with the numbers of the first results there.
    operations: Vec<(Operation, usize)>,
}

impl Derivative {
    fn new(program: &Program) -> Self {
        let result = program.groups.iter().flat_map(|group| &group.outputs);
        let result = result.last().cloned().unwrap_or(ZERO);
        let of_series = with_quotients(program);
        let live = LiveValues::of([&result].into_iter(), of_series.iter());
        let steps = program.instructions().zip(of_series);
        let steps = steps.map(|(instruction, of_series)| Step {
            operation: instruction.operation.clone(),
            needed: live.contain(&of_series),
            of_series: of_series.operation,
        });
        Self {
            steps: steps.collect(),
            result,
        }
    }
}

impl Builder<'_> {
    /// The coefficient of f(u₁, u₂, …).
    pub(super) fn application(
        &mut self,
        function: ExternalFunction,
        arguments: &[Series],
    ) -> Result<Operand, NoSeries> {
        self.applications += 1;
        if self.applications > MAX_APPLICATIONS_IN_A_SERIES {
            return Err(NoSeries {
                function,
                undeclared: None,
            });
        }
        let (mut steady, mut change) = (ZERO, ZERO);
        for (position, u) in arguments.iter().enumerate() {
            if !u.varies() {
                continue;
            }
            match self.slope(function, position, arguments)? {
                Slope::Constant(slope) => {
                    let slope = self.invariant(&slope);
                    let term = self.multiply(&slope, &u.coefficient);
                    steady = self.add(&steady, &term);
                }
                Slope::Varying(factor, slope) => {
                    let term = self.times_change(factor, &slope, &u.coefficient);
                    change = self.add(&change, &term);
                }
            }
        }
        let of_change = self.over_order(&change);
        Ok(self.add(&steady, &of_change))
    }

    /// Makes the series of all derivatives that are in use.
    pub(super) fn close(&mut self) -> Result<(), NoSeries> {
        while let Some(pending) = self.pending.pop() {
            for (operation, value) in pending.operations {
                self.append_operation(&operation, value)?;
            }
            let series = self.series(&pending.result);
            self.define(pending.factor, &series.coefficient);
        }
        Ok(())
    }

    /// ∂f/∂uⱼ at the arguments, computed by the initial program.
    fn slope(
        &mut self,
        function: ExternalFunction,
        argument: usize,
        arguments: &[Series],
    ) -> Result<Slope, NoSeries> {
        let derivative = self.derivative(function, argument)?;
        let mut inlined = Inlined {
            arguments,
            values: Vec::new(),
        };
        let mut operations = Vec::new();
        for step in &derivative.steps {
            let varies = inlined.varies(&step.operation);
            let operation = inlined.operation(&step.operation);
            let results = operation.results();
            let Operand::Value(first) = self.initial.emit(operation) else {
                continue;
            };
            if step.needed {
                operations.push((inlined.operation(&step.of_series), first));
            }
            let values = (first..first + results).map(|value| (Operand::Value(value), varies));
            inlined.values.extend(values);
        }
        let (result, varies) = inlined.operand(&derivative.result);
        if !varies {
            return Ok(Slope::Constant(result));
        }
        if self.known(&result).is_some() || matches!(result, Operand::Symbol(_)) {
            let series = self.series(&result);
            let factor = self.factor(&series.coefficient);
            return Ok(Slope::Varying(factor, result));
        }
        let factor = self.unknown_factor();
        self.pending.push(Pending {
            factor,
            result: result.clone(),
            operations,
        });
        Ok(Slope::Varying(factor, result))
    }

    /// The declared derivative.
    fn derivative(
        &mut self,
        function: ExternalFunction,
        argument: usize,
    ) -> Result<Rc<Derivative>, NoSeries> {
        if let Some(known) = self.derivatives.get(&(function, argument)) {
            return Ok(Rc::clone(known));
        }
        let Some(declared) = self.graph.declared_derivative(function, argument) else {
            return Err(NoSeries {
                function,
                undeclared: Some((function, argument)),
            });
        };
        let program = Program::schedule(self.graph, &[&[declared]]);
        let derivative = Rc::new(Derivative::new(&program));
        self.derivatives
            .insert((function, argument), Rc::clone(&derivative));
        Ok(derivative)
    }
}

/// A derivative that becomes a part of the initial program.
struct Inlined<'a> {
    arguments: &'a [Series],
    /// The values of its program as operands of the initial one, and whether they vary.
    values: Vec<(Operand, bool)>,
}

impl Inlined<'_> {
    /// An operand of the program as one of the initial program, and whether it varies.
    fn operand(&self, operand: &Operand) -> (Operand, bool) {
        let found = match operand {
            Operand::Value(value) => self.values.get(*value).cloned(),
            Operand::Symbol(Symbol::Argument(i)) => self
                .arguments
                .get(*i as usize)
                .map(|series| (series.constant.clone(), series.varies())),
            _ => None,
        };
        found.unwrap_or_else(|| (operand.clone(), false))
    }

    fn varies(&self, operation: &Operation) -> bool {
        let mut operands = operation.operands();
        let is_sign = matches!(operation, Operation::Unary(Unary::Signum, _));
        !is_sign && operands.any(|operand| self.operand(operand).1)
    }

    fn operation(&self, operation: &Operation) -> Operation {
        let mut operation = operation.clone();
        operation.for_each_operand(|operand| *operand = self.operand(operand).0);
        operation
    }
}
