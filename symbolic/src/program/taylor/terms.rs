//! Operations on terms of order k, operands of the recurrence, and on terms of order 0, which it reads as invariants.

use super::builder::Builder;
use super::series::{Convolution, Factor, ZERO};
use crate::program::straight_line::{Operand, Operation};
use crate::{Rational, Symbol, Unary};

impl Builder<'_> {
    pub(super) fn add(&mut self, x: &Operand, y: &Operand) -> Operand {
        match (x == &ZERO, y == &ZERO) {
            (true, _) => y.clone(),
            (_, true) => x.clone(),
            _ => self.recurrence.emit(Operation::Add(x.clone(), y.clone())),
        }
    }

    pub(super) fn subtract(&mut self, x: &Operand, y: &Operand) -> Operand {
        match (x == &ZERO, y == &ZERO) {
            (true, _) => self.negate(y),
            (_, true) => x.clone(),
            _ => {
                let operation = Operation::Subtract(x.clone(), y.clone());
                self.recurrence.emit(operation)
            }
        }
    }

    pub(super) fn negate(&mut self, x: &Operand) -> Operand {
        if x == &ZERO {
            return ZERO;
        }
        self.recurrence.emit(Operation::Negate(x.clone()))
    }

    pub(super) fn multiply(&mut self, x: &Operand, y: &Operand) -> Operand {
        let is_one = |x: &Operand| matches!(x, Operand::Constant(number) if number.is_one());
        if x == &ZERO || y == &ZERO {
            return ZERO;
        }
        if is_one(x) {
            return y.clone();
        }
        if is_one(y) {
            return x.clone();
        }
        let operation = Operation::Multiply(x.clone(), y.clone());
        self.recurrence.emit(operation)
    }

    /// k xₖ: the coefficient of the derivative t ẋ.
    pub(super) fn times_order(&mut self, x: &Operand) -> Operand {
        self.multiply(&Operand::Symbol(Symbol::Order), x)
    }

    /// xₖ / k.
    pub(super) fn over_order(&mut self, x: &Operand) -> Operand {
        self.multiply(&Operand::Symbol(Symbol::ReciprocalOrder), x)
    }

    /// A function of a term of order 0.
    pub(super) fn initial_value(&mut self, function: Unary, constant: &Operand) -> Operand {
        self.initial
            .emit(Operation::Unary(function, constant.clone()))
    }

    /// The product of two terms of order 0.
    pub(super) fn initial_product(&mut self, x: &Operand, y: &Operand) -> Operand {
        self.initial.emit(Operation::Multiply(x.clone(), y.clone()))
    }

    /// 1 − x for a term x of order 0.
    pub(super) fn complement(&mut self, constant: &Operand) -> Operand {
        let one = Operand::Constant(Rational::ONE);
        self.initial
            .emit(Operation::Subtract(one, constant.clone()))
    }

    /// A term of order 0 that is the same with its operands exchanged: one value for both orders.
    pub(super) fn symmetric(
        &mut self,
        operation: impl Fn(Operand, Operand) -> Operation,
        [x, y]: [Operand; 2],
    ) -> Operand {
        let known = self.initial.known(&operation(y.clone(), x.clone()));
        known.unwrap_or_else(|| self.initial.emit(operation(x, y)))
    }

    /// A term of order 0, as the recurrence reads it.
    pub(super) fn invariant(&mut self, constant: &Operand) -> Operand {
        if !matches!(constant, Operand::Value(_) | Operand::Symbol(_)) {
            return constant.clone();
        }
        Operand::Symbol(Symbol::Invariant(self.invariants.number(constant.clone())))
    }

    /// The reciprocal of a term of order 0, as the recurrence reads it.
    pub(super) fn reciprocal(&mut self, constant: &Operand) -> Operand {
        let one = Operand::Constant(Rational::ONE);
        let reciprocal = self.initial.emit(Operation::Divide(one, constant.clone()));
        self.invariant(&reciprocal)
    }

    /// The same, but 0 where the term is 0: with s its sign, s²/(x + 1 − s²).
    pub(super) fn reciprocal_or_zero(&mut self, constant: &Operand) -> Operand {
        let sign = self.initial_value(Unary::Signum, constant);
        let square = self.initial_product(&sign, &sign);
        let vanishes = self.complement(&square);
        let divisor = Operation::Add(constant.clone(), vanishes);
        let divisor = self.initial.emit(divisor);
        let reciprocal = self.initial.emit(Operation::Divide(square, divisor));
        self.invariant(&reciprocal)
    }

    /// Twice a term of order 0, as the recurrence reads it.
    pub(super) fn twice(&mut self, constant: &Operand) -> Operand {
        let twice = self.initial_product(&Operand::Constant(Rational::integer(2)), constant);
        self.invariant(&twice)
    }

    /// The factor with this coefficient.
    pub(super) fn factor(&mut self, coefficient: &Operand) -> Factor {
        let index = *self
            .known_factors
            .entry(coefficient.clone())
            .or_insert_with(|| {
                self.factors.push(Some(coefficient.clone()));
                self.factors.len() - 1
            });
        Factor(index)
    }

    /// A factor whose coefficient is said later: it occurs in its own recurrence.
    pub(super) fn unknown_factor(&mut self) -> Factor {
        self.factors.push(None);
        Factor(self.factors.len() - 1)
    }

    /// Says the coefficient of a factor.
    pub(super) fn define(&mut self, factor: Factor, coefficient: &Operand) {
        self.factors[factor.0] = Some(coefficient.clone());
        self.known_factors
            .entry(coefficient.clone())
            .or_insert(factor.0);
    }

    /// Σ₀﹤ᵢ﹤ₖ xᵢ yₖ₋ᵢ.
    pub(super) fn convolve(&mut self, x: Factor, y: Factor) -> Operand {
        let convolution = Convolution(x.0.min(y.0), x.0.max(y.0));
        Operand::Symbol(Symbol::Convolution(self.convolutions.number(convolution)))
    }
}
