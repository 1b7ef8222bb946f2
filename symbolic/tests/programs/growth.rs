//! What is derived grows as what is declared, counted in expressions and operations.

use std::ops::Mul;

use lagrangian_symbolic::{
    Equations, Expression, Graph, Kinetics, Model, Program, Rational, Symbol,
};
use lagrangian_symbolic_testing::{Draft, Quantity};

const X: Symbol = Symbol::Coordinate(0);

/// The length of the graph, and the operations of the accelerations and of the derivatives of M q̈ − f.
fn lengths(mut model: Model) -> [usize; 3] {
    let equations = Equations::derive(&mut model).unwrap();
    let kinetics = Kinetics::cheapest(&mut model, &equations);
    let solution = kinetics.solution.unwrap();
    let roots = [&*solution.pivots, &solution.accelerations];
    let accelerations = Program::schedule(&model.graph, &roots);
    let symbols = model.coordinate_symbols();
    let slopes = model.graph.jacobian(&kinetics.inverse_dynamics, &symbols);
    let slopes = Program::schedule(&model.graph, &[&slopes.concat()]);
    let operations = |program: &Program| program.count().cost();
    [
        model.graph.len(),
        operations(&accelerations),
        operations(&slopes),
    ]
}

/// Four times as much takes four times as long, but for what does not grow.
fn assert_linear(model: impl Fn(u32) -> Model, size: u32) {
    let [small, large] = [size, 4 * size].map(|size| lengths(model(size)));
    for (small, large) in small.into_iter().zip(large) {
        assert!(2 * large <= 9 * small, "{small} for {size}, then {large}");
    }
}

/// x + k y + i for i < n.
fn factors(draft: &Draft, n: u32) -> impl Iterator<Item = Quantity<'_>> {
    let (x, y, k) = (draft.q(0), draft.q(1), draft.p(0));
    let sum = x + k * y;
    (0..n).map(move |i| sum + i64::from(i))
}

/// ½ (ẋ² + ẏ²).
fn plane(draft: &Draft) -> Quantity<'_> {
    let [x, y] = draft.vs();
    (x.squared() + y.squared()) / 2
}

#[test]
fn a_potential_of_many_factors_is_linear_in_their_number() {
    let model = |n: u32| {
        let draft = Draft::new(2);
        draft.natural(plane(&draft), draft.product(factors(&draft, n)))
    };
    assert_linear(model, 8);
}

#[test]
fn so_is_a_mass_of_many_factors_however_they_are_multiplied() {
    for one_by_one in [false, true] {
        let model = |n: u32| {
            let draft = Draft::new(2);
            let factors = factors(&draft, n);
            let kinetic = if one_by_one {
                factors.fold(plane(&draft), Mul::mul)
            } else {
                plane(&draft) * draft.product(factors)
            };
            draft.natural(kinetic, draft.zero())
        };
        assert_linear(model, 80);
    }
}

#[test]
fn so_is_what_divides_by_many_factors() {
    let model = |n: u32| {
        let draft = Draft::new(2);
        let below = factors(&draft, n).map(|x| (x.expression(), Rational::MINUS_ONE));
        let below: Vec<_> = below.collect();
        let potential = draft.make(|graph| graph.product(below));
        draft.natural(plane(&draft), potential)
    };
    assert_linear(model, 8);
}

#[test]
fn so_are_functions_of_functions() {
    // uᵢ = sin uᵢ₋₁ + k uᵢ₋₁, whose derivative is a product that grows with i.
    let model = |n: u32| {
        let draft = Draft::new(1);
        let (q, k) = (draft.q(0), draft.p(0));
        let u = (0..n).fold(q, |u, _| u.sin() + k * u);
        draft.natural(q.dot().squared() / 2, u)
    };
    assert_linear(model, 40);
}

/// Π (x + i/7)^kᵢ with k = 1, 2 and −1 in turn.
fn product(graph: &mut Graph, n: u32) -> Expression {
    let x = graph.symbol(X);
    let mut factors = Vec::new();
    for i in 0..n {
        let base = graph.add_constant(x, &Rational::new(i.into(), 7).unwrap());
        factors.push((base, Rational::integer(exponent(i))));
    }
    graph.product(factors)
}

fn exponent(i: u32) -> i64 {
    [1, 2, -1][i as usize % 3]
}

#[test]
fn derivatives_of_many_factors_are_those_of_the_logarithm() {
    // With P = Π fᵢ^kᵢ and L = Σ kᵢ/fᵢ: P′ = P L and P″ = P (L² − Σ kᵢ/fᵢ²).
    for n in [9, 12, 17, 33, 50] {
        let mut graph = Graph::new();
        let product = product(&mut graph, n);
        let first = graph.derivative(product, X);
        let second = graph.derivative(first, X);
        let x = 0.3_f64;
        let terms = (0..n).map(|i| (x + f64::from(i) / 7.0, exponent(i)));
        let (mut value, mut slope, mut change) = (1.0, 0.0, 0.0);
        for (f, k) in terms {
            let k = i32::try_from(k).unwrap();
            value *= f.powi(k);
            slope += f64::from(k) / f;
            change -= f64::from(k) / f.powi(2);
        }
        let expected = [value, value * slope, value * (slope.powi(2) + change)];
        let found = graph.evaluate(&[product, first, second], |_| x);
        for (found, expected) in found.into_iter().zip(expected) {
            // Some hundred operations of terms that are all but for a few of one sign.
            let error = (found / expected - 1.0).abs();
            assert!(error < 1e-12, "{n} factors: {found} for {expected}");
        }
    }
}

#[test]
fn no_derivative_divides_by_a_factor() {
    // At x = 0 the factor x vanishes: P′ = Π i for i from 1 to n − 1, exactly.
    let mut graph = Graph::new();
    let x = graph.symbol(X);
    let factors: Vec<_> = (0..18)
        .map(|i| (graph.add_constant(x, &Rational::integer(i)), Rational::ONE))
        .collect();
    let product = graph.product(factors);
    let slope = graph.derivative(product, X);
    let expected = (1..18).map(f64::from).product::<f64>();
    let found = graph.evaluate(&[slope], |_| 0.0);
    assert!((found[0] - expected).abs() < 1e-15 * expected, "{found:?}");
}
