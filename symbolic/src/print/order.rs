//! The order in which terms and factors are printed.
//!
//! Factors go from the constant to the changing: numbers, parameters and sums of them, time, inputs, coordinates and
//! sums of them, velocities, sums of these, roots, and functions last, so that `m g l cos θ` and `φ̇ sin θ` cannot be misread.
//! Terms begin with a number, then come those with accelerations, with velocities, and the rest: those with
//! velocities by degree, the highest first, then by the order of the velocities; terms alike in that by the order of
//! their parameters, and at last in the order in which they were first written.

use std::cmp::Reverse;
use std::collections::BTreeSet;

use crate::{Contents, Expression, Graph, Node, Rational, Symbol, Unary};

/// The place of a term among others: its class, degree and symbols.
pub(crate) type TermPlace = (u8, Vec<u32>, Reverse<i64>, Vec<u32>, Vec<u32>, Expression);

/// The place of a term among others.
pub(crate) fn term_place(graph: &Graph, x: Expression) -> TermPlace {
    let class = if x == graph.one() {
        0
    } else {
        term_rank(graph.contents(x))
    };
    let (mut degree, mut accelerations) = (0, Vec::new());
    let (mut velocities, mut parameters) = (Vec::new(), Vec::new());
    for (base, exponent) in graph.factors(x) {
        let power = exponent.to_integer().unwrap_or(1);
        let repeats = usize::try_from(power.unsigned_abs().min(8)).unwrap_or(1);
        match graph.node(base) {
            Node::Symbol(Symbol::Acceleration(i) | Symbol::QuasiVelocityRate(i)) => {
                accelerations.push(*i);
            }
            Node::Symbol(Symbol::Velocity(i) | Symbol::QuasiVelocity(i)) => {
                degree += power;
                velocities.extend(vec![*i; repeats]);
            }
            Node::Symbol(Symbol::Parameter(i)) => parameters.extend(vec![*i; repeats]),
            _ if graph.contents(base).has_velocity() => {
                let (of_sum, occurring) = velocities_of_sum(graph, base);
                degree += power * of_sum;
                velocities.extend(occurring);
            }
            _ => {}
        }
    }
    velocities.sort_unstable();
    parameters.sort_unstable();
    (
        class,
        accelerations,
        Reverse(degree),
        velocities,
        parameters,
        x,
    )
}

/// The degree of a sum in the velocities and which they are, as far as its terms are products of them.
fn velocities_of_sum(graph: &Graph, base: Expression) -> (i64, BTreeSet<u32>) {
    let mut occurring = BTreeSet::new();
    let Node::Sum(terms) = graph.node(base) else {
        return (1, occurring);
    };
    let mut degree = 0;
    for (x, _) in terms {
        let mut of_term = 0;
        for (factor, exponent) in graph.factors(*x) {
            if let Node::Symbol(Symbol::Velocity(i) | Symbol::QuasiVelocity(i)) = graph.node(factor)
            {
                occurring.insert(*i);
                of_term += exponent.to_integer().unwrap_or(1);
            } else if graph.contents(factor).has_velocity() {
                of_term += 1;
            }
        }
        degree = of_term.max(degree);
    }
    (degree, occurring)
}

/// The class of a term.
fn term_rank(contents: Contents) -> u8 {
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
        Symbol::Time => (4, 0),
        Symbol::Input(index)
        | Symbol::Invariant(index)
        | Symbol::Argument(index)
        | Symbol::Convolution(index) => (5, index),
        Symbol::Order | Symbol::ReciprocalOrder => (4, 1),
        Symbol::Coordinate(index) | Symbol::PositionComponent(index) => (6, index),
        Symbol::Velocity(index)
        | Symbol::VelocityComponent(index)
        | Symbol::QuasiVelocity(index) => (8, index),
        Symbol::Acceleration(index)
        | Symbol::QuasiVelocityRate(index)
        | Symbol::RightHandSide(index)
        | Symbol::Variation(index) => (9, index),
    }
}

/// The place of a factor that is called by name.
pub(crate) const NAMED: u8 = 10;

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
        return class(14);
    }
    if !exponent.is_integer() {
        return class(13);
    }
    match graph.node(base) {
        Node::Constant(_) | Node::Pi => class(1),
        Node::Symbol(symbol) => {
            let (rank, index) = symbol_rank(*symbol);
            (rank, 0, index, 0)
        }
        Node::Unary(Unary::Exp | Unary::Abs | Unary::Signum, _) => class(11),
        Node::Unary(function, x) => {
            let (rank, index) = match graph.node(*x) {
                Node::Symbol(symbol) => symbol_rank(*symbol),
                _ => (u8::MAX, x.index().try_into().unwrap_or(u32::MAX)),
            };
            (15, rank, index, *function as u8)
        }
        Node::Binary(crate::Binary::Power, ..) => class(13),
        Node::Binary(..) | Node::Application(..) => class(11),
        Node::Sum(_) | Node::Product(_) | Node::Opaque(_) => {
            let contents = graph.contents(base);
            class(if !contents.varies() {
                3
            } else if contents.has_velocity() || contents.has_acceleration() {
                12
            } else {
                7
            })
        }
    }
}
