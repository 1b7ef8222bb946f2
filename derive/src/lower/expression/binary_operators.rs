//! Chains of `+ - * /`, and of `%` in indices, left-associative: loops, not recursion.

use lagrangian_symbolic::{Components, Rational, TypedGraph, Value};
use syn::{BinOp, Expr, ExprBinary};

use super::Lowerer;
use crate::lower::hints;
use crate::lower::value::{Product, Sum};
use crate::syntax::shape::Shape;

/// A run of operators of one precedence, collected until it ends.
#[derive(Clone)]
enum OperatorChain {
    Sum(Sum),
    Product(Product),
}

impl OperatorChain {
    fn value(self, typed: &mut TypedGraph) -> Option<Value> {
        match self {
            Self::Sum(sum) => sum.value(typed),
            Self::Product(product) => product.value(typed),
        }
    }

    /// The chain with one more operand; the shape of what stands before the operator, if the two do not fit.
    fn extend(self, typed: &mut TypedGraph, operator: &BinOp, value: Value) -> Result<Self, Shape> {
        let sign = match operator {
            BinOp::Sub(_) | BinOp::Div(_) => Rational::MINUS_ONE,
            _ => Rational::ONE,
        };
        if matches!(operator, BinOp::Add(_) | BinOp::Sub(_)) {
            let mut sum = match self {
                Self::Sum(sum) => sum,
                before @ Self::Product(_) => {
                    let before = before.value(typed).ok_or(Shape::Scalar)?;
                    Sum::of(typed, before)
                }
            };
            sum.add(typed, value, sign)?;
            Ok(Self::Sum(sum))
        } else {
            let mut product = match self {
                Self::Product(product) => product,
                before @ Self::Sum(_) => {
                    let mut product = Product::default();
                    let before = before.value(typed).ok_or(Shape::Scalar)?;
                    product.multiply(typed, before, Rational::ONE)?;
                    product
                }
            };
            product.multiply(typed, value, sign)?;
            Ok(Self::Product(product))
        }
    }
}

impl Lowerer<'_> {
    pub(super) fn chain(&mut self, binary: &ExprBinary) -> Option<Value> {
        let mut steps = vec![(&binary.op, &*binary.right)];
        let mut first = &*binary.left;
        while let Expr::Binary(inner) = first {
            steps.push((&inner.op, &*inner.right));
            first = &*inner.left;
        }
        let first = self.lower(first);
        let mut chain = first.map(|first| OperatorChain::Sum(Sum::of(&self.typed, first)));
        for (operator, operand) in steps.into_iter().rev() {
            let value = self.operand(operator, operand);
            chain = match (chain, value) {
                (Some(chain), Some(value)) => self.extend(chain, operator, value),
                _ => None,
            };
        }
        chain?.value(&mut self.typed)
    }

    /// The right operand, where the operator is supported.
    fn operand(&mut self, operator: &BinOp, operand: &Expr) -> Option<Value> {
        let is_remainder = self.within_index && matches!(operator, BinOp::Rem(_));
        if let Some(hint) = hints::unsupported_operator(operator)
            && !is_remainder
        {
            return self.reject(operator, hint);
        }
        let value = self.lower(operand)?;
        if matches!(operator, BinOp::Div(_) | BinOp::Rem(_)) && self.vanishes(value) {
            return self.reject(
                operand,
                "this divisor is zero: the quotient has no value anywhere",
            );
        }
        Some(value)
    }

    /// Whether a value is the number zero.
    pub(super) fn vanishes(&self, value: Value) -> bool {
        match self.typed.components(value) {
            Components::Scalar(expression) => self.graph().is_zero(*expression),
            Components::EmptySum => true,
            Components::Array(_) => false,
        }
    }

    fn extend(
        &mut self,
        chain: OperatorChain,
        operator: &BinOp,
        value: Value,
    ) -> Option<OperatorChain> {
        if matches!(operator, BinOp::Rem(_)) {
            return self.remainder(chain, operator, value);
        }
        let right = self.shape(value);
        match chain.extend(&mut self.typed, operator, value) {
            Ok(chain) if self.within_index && matches!(operator, BinOp::Div(_)) => {
                self.integer_quotient(chain, operator)
            }
            Ok(chain) => Some(chain),
            Err(left) => self.reject(operator, hints::incompatible_shapes(operator, left, right)),
        }
    }

    /// A remainder of integers, with the sign of the dividend, as in Rust.
    fn remainder(
        &mut self,
        chain: OperatorChain,
        operator: &BinOp,
        divisor: Value,
    ) -> Option<OperatorChain> {
        let dividend = chain.value(&mut self.typed)?;
        let integers = [dividend, divisor].map(|value| match self.typed.components(value) {
            Components::Scalar(value) => self.graph().as_constant(*value)?.to_integer(),
            Components::EmptySum => Some(0),
            Components::Array(_) => None,
        });
        let remainder = match integers {
            [Some(dividend), Some(divisor)] => dividend.checked_rem(divisor),
            _ => None,
        };
        let Some(remainder) = remainder else {
            return self.reject(operator, "a remainder in an index is one of integers");
        };
        let remainder = self.constant(remainder)?;
        Some(OperatorChain::Sum(Sum::of(&self.typed, remainder)))
    }

    /// Division is exact: in an index `5 / 4` would be five quarters, and 1 in Rust.
    fn integer_quotient(
        &mut self,
        chain: OperatorChain,
        operator: &BinOp,
    ) -> Option<OperatorChain> {
        let quotient = chain.clone().value(&mut self.typed)?;
        let constant = self.typed.as_constant(quotient);
        if constant.is_none_or(Rational::is_integer) {
            return Some(chain);
        }
        self.reject(
            operator,
            "this quotient is no integer, as an index or the end of a range has to be, and is not rounded as in Rust: write a \
             range for each part, as in `(0..3).map(|i| f[i + 1])`, and the last one by itself",
        )
    }
}
