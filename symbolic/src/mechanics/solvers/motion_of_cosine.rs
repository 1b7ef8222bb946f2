//! The motion of one angle by its cosine (Goldstein, Poole and Safko, Classical Mechanics, 3rd edition 2002, section 5.7:
//! u̇² = f(u) for the heavy symmetric top).
//!
//! Where h = ½ m q̇² + V(q) is constant, m too, and sin² q V is a polynomial N in u = cos q, as an effective potential (4.10)
//! often is,
//!
//! u̇² = sin² q q̇² = (2/m) ((1 − u²) h − N(u)), and so ü = −(1/m) (2 h u + N′(u)),
//!
//! a polynomial, of which the series takes fewer sums than that of q̈, which has sin³ q in a denominator. With w = u̇ and
//! s = sin q the equations are q̇ = −w/s, ẇ = ü, u̇ = w, ṡ = u q̇.

use std::collections::BTreeMap;

use super::first_order_equations::FirstOrderEquations;
use crate::algebra::half_angles::HalfAngle;
use crate::{Equations, Expression, Graph, Model, Rational, Symbol};

const COORDINATE: Symbol = Symbol::Coordinate(0);
const VELOCITY: Symbol = Symbol::Velocity(0);

/// The equations of motion in q, w = u̇, h, u and s; none for other models.
pub(crate) fn equations(model: &mut Model, equations: &Equations) -> Option<FirstOrderEquations> {
    if model.coordinates != 1 || !equations.conservation.energy {
        return None;
    }
    let graph = &mut model.graph;
    let inertia = equations.mass[0][0];
    if graph.contains(&[inertia], is_variable) {
        return None;
    }
    let energy = equations.energy;
    let zero = graph.zero();
    let potential = graph.at_zero(&[energy], &[VELOCITY])[0];
    let velocity = graph.symbol(VELOCITY);
    let kinetic = kinetic_energy(graph, inertia, velocity);
    let sum = graph.add(kinetic, potential);
    let rest = graph.subtract(energy, sum);
    if !graph.vanishes(&[rest]) || graph.contains(&[potential], |symbol| symbol == Symbol::Time) {
        return None;
    }
    // Constant terms of V, such as energies of a spin, would cancel in ü, and leave rounding errors there.
    let potential = without_constants(graph, potential);
    let energy = graph.add(kinetic, potential);
    let angle = HalfAngle::of(graph, COORDINATE);
    let numerator = numerator(graph, &angle, potential)?;
    let [w, h, u, s] = [0, 1, 2, 3].map(|i| graph.symbol(Symbol::QuasiVelocity(i)));
    let rate = slope(graph, numerator, (h, u), inertia);
    let quotient = graph.divide(w, s);
    let q_dot = graph.negate(quotient);
    let product = graph.multiply(velocity, angle.sine);
    Some(FirstOrderEquations {
        values: vec![graph.negate(product), energy, angle.cosine, angle.sine],
        velocities: vec![q_dot],
        rates: vec![rate, zero, w, graph.multiply(u, q_dot)],
    })
}

fn is_variable(symbol: Symbol) -> bool {
    matches!(symbol, COORDINATE | VELOCITY | Symbol::Time)
}

/// The terms of a sum that contain the coordinate.
fn without_constants(graph: &mut Graph, potential: Expression) -> Expression {
    let terms = graph.terms(potential).into_iter();
    let terms = terms.filter(|(term, _)| graph.contains(&[*term], is_variable));
    let terms: Vec<_> = terms.collect();
    graph.sum(terms)
}

/// ½ m q̇².
fn kinetic_energy(graph: &mut Graph, inertia: Expression, velocity: Expression) -> Expression {
    let square = graph.square(velocity);
    let product = graph.multiply(inertia, square);
    graph.scale(product, &Rational::HALF)
}

/// The coefficients of N = sin² q V, by powers of cos q; none if N is no polynomial in it or V has no pole.
fn numerator(
    graph: &mut Graph,
    angle: &HalfAngle,
    potential: Expression,
) -> Option<BTreeMap<i64, Expression>> {
    let (mut with_pole, mut without) = (Vec::new(), Vec::new());
    for (term, coefficient) in graph.terms(potential) {
        match angle.numerator(graph, term) {
            Some(numerator) => with_pole.push((numerator, coefficient)),
            None => without.push((term, coefficient)),
        }
    }
    if with_pole.is_empty() {
        return None;
    }
    let [with_pole, without] = [with_pole, without].map(|terms| graph.sum(terms));
    let mut by_power: BTreeMap<i64, Vec<(Expression, Rational)>> = BTreeMap::new();
    for (power, coefficient) in angle.powers_of_cosine(graph, with_pole)? {
        by_power
            .entry(power)
            .or_default()
            .push((coefficient, Rational::ONE));
    }
    for (power, coefficient) in angle.powers_of_cosine(graph, without)? {
        by_power
            .entry(power)
            .or_default()
            .push((coefficient, Rational::ONE));
        by_power
            .entry(power + 2)
            .or_default()
            .push((coefficient, Rational::MINUS_ONE));
    }
    let sums = by_power.into_iter();
    Some(
        sums.map(|(power, terms)| (power, graph.sum(terms)))
            .collect(),
    )
}

/// −(1/m) (2 h u + N′(u)).
fn slope(
    graph: &mut Graph,
    numerator: BTreeMap<i64, Expression>,
    (h, u): (Expression, Expression),
    inertia: Expression,
) -> Expression {
    let product = graph.multiply(h, u);
    let mut terms = vec![(product, Rational::integer(2))];
    for (power, coefficient) in numerator {
        if power > 0 {
            let lower = graph.power(u, &Rational::integer(power - 1));
            let product = graph.multiply(coefficient, lower);
            terms.push((product, Rational::integer(power)));
        }
    }
    let terms = terms
        .into_iter()
        .map(|(term, number)| (graph.divide(term, inertia), -&number));
    let terms: Vec<_> = terms.collect();
    graph.sum(terms)
}
