//! Values of expressions in binary64, node by node: the oracle of the tests.

use crate::{Expression, ExternalFunction, Graph, Node, Rational, Symbol};

impl Graph {
    /// The values of the roots in binary64, where `value` gives those of the symbols.
    ///
    /// External functions evaluate to NaN.
    #[must_use]
    pub fn evaluate(&self, roots: &[Expression], value: impl Fn(Symbol) -> f64) -> Vec<f64> {
        self.evaluate_with(roots, value, |_, _| f64::NAN)
    }

    /// The values of the roots in binary64, where `external` gives those of external functions.
    #[must_use]
    pub fn evaluate_with(
        &self,
        roots: &[Expression],
        value: impl Fn(Symbol) -> f64,
        external: impl Fn(ExternalFunction, &[f64]) -> f64,
    ) -> Vec<f64> {
        let descendants = self.descendants(roots);
        let length = descendants.last().map_or(0, |last| last.index() + 1);
        let mut values = vec![f64::NAN; length];
        for expression in descendants {
            let of = |operand: Expression| values[operand.index()];
            values[expression.index()] = match self.node(expression) {
                Node::Constant(number) => number.to_f64(),
                Node::Pi => core::f64::consts::PI,
                Node::Symbol(symbol) => value(*symbol),
                Node::Sum(terms) => terms.iter().map(|(x, c)| c.to_f64() * of(*x)).sum(),
                Node::Product(factors) => factors.iter().map(|(x, k)| power(of(*x), k)).product(),
                Node::Unary(function, x) => function.value(of(*x)),
                Node::Binary(function, x, y) => function.value(of(*x), of(*y)),
                Node::Application(function, arguments) => {
                    let arguments: Vec<_> = arguments.iter().map(|x| of(*x)).collect();
                    external(*function, &arguments)
                }
                Node::Opaque(x) => of(*x),
            };
        }
        roots.iter().map(|root| values[root.index()]).collect()
    }
}

fn power(base: f64, exponent: &Rational) -> f64 {
    if *exponent == Rational::HALF {
        return base.sqrt();
    }
    match exponent.to_integer().and_then(|k| i32::try_from(k).ok()) {
        Some(k) => base.powi(k),
        None => base.powf(exponent.to_f64()),
    }
}
