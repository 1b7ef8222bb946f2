//! The order in which terms and factors are printed.
//!
//! Factors go from the constant to the changing: numbers, parameters, time, inputs, coordinates,
//! velocities, sums, roots, and functions last, so that `m g l cos θ` and `φ̇ sin θ` cannot be misread.
//! Terms begin with a number, then come those with accelerations, with velocities, and the rest, each
//! in the order in which they were first written.

use crate::{Contents, Expression, Graph, Node, Rational, Symbol, Unary};

/// The place of a term among others.
pub(crate) fn term_rank(contents: Contents) -> u8 {
    match (contents.has_acceleration(), contents.has_velocity()) {
        (true, _) => 1,
        (_, true) => 2,
        _ => 3,
    }
}

/// The place of a symbol among factors.
pub(crate) fn symbol_rank(symbol: Symbol) -> (u8, u32) {
    match symbol {
        Symbol::Parameter(index) => (2, index),
        Symbol::Time => (3, 0),
        Symbol::Input(index)
        | Symbol::Invariant(index)
        | Symbol::Argument(index)
        | Symbol::Convolution(index) => (4, index),
        Symbol::Order | Symbol::ReciprocalOrder => (3, 1),
        Symbol::Coordinate(index) | Symbol::PositionComponent(index) => (5, index),
        Symbol::Velocity(index)
        | Symbol::VelocityComponent(index)
        | Symbol::QuasiVelocity(index) => (6, index),
        Symbol::Acceleration(index) => (7, index),
    }
}

/// The place of a factor that is called by name.
pub(crate) const NAMED: u8 = 8;

/// The place of the factor base^exponent: its class, and for functions their argument and kind.
pub(crate) fn factor_rank(
    graph: &Graph,
    base: Expression,
    exponent: &Rational,
) -> (u8, u8, u32, u8) {
    let class = |class| (class, 0, 0, 0);
    if matches!(graph.node(base), Node::Constant(_)) {
        return class(0);
    }
    if *exponent == Rational::HALF || *exponent == -&Rational::HALF {
        return class(12);
    }
    if !exponent.is_integer() {
        return class(11);
    }
    match graph.node(base) {
        Node::Constant(_) | Node::Pi => class(1),
        Node::Symbol(symbol) => {
            let (rank, index) = symbol_rank(*symbol);
            (rank, 0, index, 0)
        }
        Node::Unary(Unary::Exp | Unary::Abs | Unary::Signum, _) => class(9),
        Node::Unary(function, x) => {
            let (rank, index) = match graph.node(*x) {
                Node::Symbol(symbol) => symbol_rank(*symbol),
                _ => (u8::MAX, x.index().try_into().unwrap_or(u32::MAX)),
            };
            (13, rank, index, *function as u8)
        }
        Node::Binary(crate::Binary::Power, ..) => class(11),
        Node::Binary(..) | Node::Application(..) => class(9),
        Node::Sum(_) | Node::Product(_) | Node::Opaque(_) => class(10),
    }
}
