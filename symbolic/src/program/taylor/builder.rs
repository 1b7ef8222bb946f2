//! The recurrence under construction.

use std::rc::Rc;

use super::external_functions::{Derivative, Pending};
use super::series::{Convolution, NoSeries, Numbered, Pair, Series, ZERO};
use crate::algebra::hashing::Table;
use crate::program::numbering::Instructions;
use crate::program::straight_line::{Operand, Operation, Program};
use crate::{ExternalFunction, Graph, Rational, Symbol};

pub(super) struct Builder<'a> {
    /// Where the derivatives of external functions are declared.
    pub(super) graph: &'a Graph,
    /// What order 0 needs beyond the program.
    pub(super) initial: Instructions,
    /// The operands of the initial program that the recurrence reads.
    pub(super) invariants: Numbered<Operand>,
    pub(super) recurrence: Instructions,
    /// The series of values of the initial program, by their numbers there, as far as they are known.
    series: Vec<Option<Series>>,
    /// The factors of convolutions, operands of the recurrence; none while the operand is not known.
    pub(super) factors: Vec<Option<Operand>>,
    /// The factor of each coefficient that is known.
    pub(super) known_factors: Table<Operand, usize>,
    pub(super) convolutions: Numbered<Convolution>,
    /// What does not vary.
    constants_of_motion: Vec<Symbol>,
    /// Sines and cosines, and hyperbolic ones, by their argument.
    pub(super) pairs: Vec<(Pair, Operand, [Series; 2])>,
    /// sech and tanh by their argument, where both are needed.
    pub(super) secants: Vec<(Operand, [Series; 2])>,
    /// Logistic functions by their argument.
    pub(super) logistics: Vec<(Operand, Series)>,
    /// Derivatives of external functions, by the positions of their arguments.
    pub(super) derivatives: Table<(ExternalFunction, usize), Rc<Derivative>>,
    /// Those that are in use and have no series yet.
    pub(super) pending: Vec<Pending>,
    /// How many applications of external functions the series of the present operation has taken.
    pub(super) applications: usize,
}

impl<'a> Builder<'a> {
    pub(super) fn new(
        graph: &'a Graph,
        program: &Program,
        constants_of_motion: Vec<Symbol>,
    ) -> Self {
        Self {
            graph,
            initial: Instructions::behind(program),
            invariants: Numbered::new(),
            recurrence: Instructions::default(),
            series: Vec::new(),
            factors: Vec::new(),
            known_factors: Table::default(),
            convolutions: Numbered::new(),
            constants_of_motion,
            pairs: Vec::new(),
            secants: Vec::new(),
            logistics: Vec::new(),
            derivatives: Table::default(),
            pending: Vec::new(),
            applications: 0,
        }
    }

    /// The series of a value of the initial program, if it is known.
    pub(super) fn known(&self, operand: &Operand) -> Option<&Series> {
        match operand {
            Operand::Value(value) => self.series.get(*value)?.as_ref(),
            _ => None,
        }
    }

    /// The series of an operand of the initial program.
    pub(super) fn series(&self, operand: &Operand) -> Series {
        let varies = |symbol: &Symbol| {
            let varies = matches!(
                symbol,
                Symbol::Time
                    | Symbol::Coordinate(_)
                    | Symbol::Velocity(_)
                    | Symbol::Acceleration(_)
                    | Symbol::QuasiVelocity(_)
                    | Symbol::Input(_)
            );
            varies && !self.constants_of_motion.contains(symbol)
        };
        let coefficient = match operand {
            Operand::Symbol(symbol) if varies(symbol) => operand.clone(),
            _ => ZERO,
        };
        let known = self.known(operand).cloned();
        known.unwrap_or_else(|| Series {
            constant: operand.clone(),
            coefficient,
        })
    }

    /// Finds the series of what an operation of the program computes, whose first result has the number `value`.
    pub(super) fn append(&mut self, operation: &Operation, value: usize) -> Result<(), NoSeries> {
        self.applications = 0;
        self.append_operation(operation, value)
            .and_then(|()| self.close())
            .map_err(|missing| match operation {
                Operation::Application(function, _) => NoSeries {
                    function: *function,
                    ..missing
                },
                _ => missing,
            })
    }

    /// The same for an operation of the initial program, unless that is known already; the derivatives of external
    /// functions that it needs remain [pending](Self::pending).
    pub(super) fn append_operation(
        &mut self,
        operation: &Operation,
        value: usize,
    ) -> Result<(), NoSeries> {
        if self.known(&Operand::Value(value)).is_some() {
            return Ok(());
        }
        let operands = operation.operands();
        let operands: Vec<Series> = operands.map(|operand| self.series(operand)).collect();
        let results = operation.results();
        let constants = (0..results).map(|i| Operand::Value(value + i));
        let constants: Vec<Operand> = constants.collect();
        let coefficients = if operands.iter().any(Series::varies) {
            self.coefficients(operation, &operands, &constants)?
        } else {
            vec![ZERO; results]
        };
        if self.series.len() < value + results {
            self.series.resize(value + results, None);
        }
        let series = constants.into_iter().zip(coefficients);
        for (known, (constant, coefficient)) in self.series[value..].iter_mut().zip(series) {
            *known = Some(Series {
                constant,
                coefficient,
            });
        }
        Ok(())
    }

    fn coefficients(
        &mut self,
        operation: &Operation,
        operands: &[Series],
        results: &[Operand],
    ) -> Result<Vec<Operand>, NoSeries> {
        let coefficient = match (operation, operands) {
            (Operation::Add(..), [x, y]) => self.add(&x.coefficient, &y.coefficient),
            (Operation::Subtract(..), [x, y]) => self.subtract(&x.coefficient, &y.coefficient),
            (Operation::Negate(_), [x]) => self.negate(&x.coefficient),
            (Operation::Multiply(..), [x, y]) => self.product(x, y),
            (Operation::Divide(..), [x, y]) => self.quotient(x, y, &results[0]),
            (Operation::SquareRoot(_), [x]) => self.square_root(x, &results[0]),
            (Operation::SineAndCosine(_), [x]) => return Ok(self.sine_and_cosine(x, results)),
            (Operation::Unary(function, _), [x]) => self.unary(*function, x, &results[0]),
            (Operation::Binary(function, ..), [x, y]) => self.binary(*function, x, y, &results[0]),
            (Operation::Application(function, _), arguments) => {
                self.application(*function, arguments)?
            }
            // An operation has as many operands as it takes.
            _ => ZERO,
        };
        Ok(vec![coefficient])
    }

    /// f − Σ₀﹤ᵢ≤ₖ Mᵢ q̈ₖ₋ᵢ, which M₀ q̈ₖ is.
    pub(super) fn residuals(&mut self, mass: &[Operand], forcing: &[Operand]) -> Vec<Operand> {
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
}

/// The operations that are not functions.
impl Builder<'_> {
    /// The coefficient of x · y.
    pub(super) fn product(&mut self, x: &Series, y: &Series) -> Operand {
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
