//! What the tests of `lagrangian-symbolic` share: mechanical systems, random trees as a user would write them,
//! arithmetic other than the library's, and numbers that know how far rounding may have carried them.
//!
//! Models are written with operators on [`Draft`], which the unit tests of the library need as well: they and the
//! systems are a module of it, behind its feature `testing`.
#![allow(
    missing_docs,
    clippy::must_use_candidate,
    clippy::return_self_not_must_use,
    clippy::missing_panics_doc
)]
#![allow(clippy::float_cmp)] // Exact comparisons are meant.

pub mod bounded;
pub mod dual;
pub mod external;
pub mod frames;
pub mod machine;
pub mod mutation;
pub mod reader;
pub mod rows;
pub mod tree;

pub use lagrangian_symbolic::testing::{Draft, Quantity, systems, vector};

use lagrangian_symbolic::{Binary, Expression, Graph, Node, Rational, Symbol, Unary};

/// The arithmetic in which expressions are evaluated.
pub trait Number: Copy {
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
pub fn evaluate<N: Number>(graph: &Graph, root: Expression, symbol: impl Fn(Symbol) -> N) -> N {
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

/// Values for a few symbols, the same on every run.
pub fn value(symbol: Symbol) -> f64 {
    match symbol {
        Symbol::Time => 0.3,
        Symbol::Coordinate(i) => 0.7 + 0.4 * f64::from(i),
        Symbol::Velocity(i) => 1.1 - 0.6 * f64::from(i),
        Symbol::Acceleration(i) => -0.5 + 0.9 * f64::from(i),
        Symbol::Parameter(i) => 1.3 + 0.5 * f64::from(i),
        Symbol::Input(_)
        | Symbol::Invariant(_)
        | Symbol::Argument(_)
        | Symbol::Order
        | Symbol::ReciprocalOrder
        | Symbol::Convolution(_)
        | Symbol::QuasiVelocity(_)
        | Symbol::QuasiVelocityRate(_)
        | Symbol::RightHandSide(_)
        | Symbol::PositionComponent(_)
        | Symbol::VelocityComponent(_)
        | Symbol::Variation(_) => 0.2,
    }
}

#[track_caller]
pub fn assert_close(found: f64, expected: f64) {
    let error = (found - expected).abs() / expected.abs().max(1.0);
    assert!(error < 1e-13, "{found} is not {expected}: {error:e}");
}
