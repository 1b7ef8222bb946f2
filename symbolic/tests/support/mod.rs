//! What several tests share: random trees as a user would write them, and numbers that know how far
//! rounding may have carried them.
#![allow(dead_code, clippy::float_cmp)] // Each test uses its part; exact comparisons are meant.

pub(crate) mod bounded;
pub(crate) mod draft;
pub(crate) mod dual;
pub(crate) mod frames;
pub(crate) mod machine;
pub(crate) mod external;
pub(crate) mod rows;
pub(crate) mod systems;
pub(crate) mod tree;

use lagrangian_symbolic::{Binary, Expression, Graph, Node, Rational, Symbol, Unary};

/// The arithmetic in which expressions are evaluated.
pub(crate) trait Number: Copy {
    fn rational(value: &Rational) -> Self;
    fn pi() -> Self;
    fn add(self, other: Self) -> Self;
    fn multiply(self, other: Self) -> Self;
    /// An exact power.
    fn power(self, exponent: &Rational) -> Self;
    fn unary(self, function: Unary) -> Self;
    fn binary(self, function: Binary, other: Self) -> Self;
}

/// The value of `root`, node by node.
pub(crate) fn evaluate<N: Number>(
    graph: &Graph,
    root: Expression,
    symbol: impl Fn(Symbol) -> N,
) -> N {
    let zero = N::rational(&Rational::ZERO);
    let one = N::rational(&Rational::ONE);
    let mut values = vec![zero; root.index() + 1];
    for expression in graph.descendants(&[root]) {
        let of = |operand: Expression| values[operand.index()];
        values[expression.index()] = match graph.node(expression) {
            Node::Constant(value) => N::rational(value),
            Node::Pi => N::pi(),
            Node::Symbol(name) => symbol(*name),
            Node::Sum(terms) => terms
                .iter()
                .fold(zero, |sum, (x, c)| sum.add(N::rational(c).multiply(of(*x)))),
            Node::Product(factors) => factors
                .iter()
                .fold(one, |product, (x, k)| product.multiply(of(*x).power(k))),
            Node::Unary(function, x) => of(*x).unary(*function),
            Node::Binary(function, x, y) => of(*x).binary(*function, of(*y)),
            Node::Application(function, arguments) => {
                let arguments: Vec<N> = arguments.iter().map(|x| of(*x)).collect();
                external::value(*function, &arguments)
            }
            Node::Opaque(x) => of(*x),
        };
    }
    values[root.index()]
}
