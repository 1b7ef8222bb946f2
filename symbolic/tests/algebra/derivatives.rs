//! Derivatives against dual numbers and against differences of values.

use lagrangian_symbolic::{Binary, Direction, Expression, Graph, Rational, Symbol, Unary};
use lagrangian_symbolic_testing::bounded::Bounded;
use lagrangian_symbolic_testing::dual::Dual;
use lagrangian_symbolic_testing::evaluate;
use lagrangian_symbolic_testing::tree::{SYMBOLS, at, points, trees};
use proptest::prelude::*;

const X: Symbol = Symbol::Coordinate(0);
const Y: Symbol = Symbol::Coordinate(1);

/// Points within the domain of a function, away from its jumps.
fn domain(function: Unary) -> &'static [f64] {
    match function {
        Unary::Asin | Unary::Acos | Unary::Atanh => &[-0.9, -0.3, 0.2, 0.75],
        Unary::Acosh => &[1.1, 2.0, 7.5],
        Unary::Ln => &[0.01, 0.5, 1.5, 40.0],
        _ => &[-2.3, -0.7, 0.4, 1.2],
    }
}

/// The derivatives of `root` with respect to `symbol` up to the second, from values alone.
fn differences(value: impl Fn(f64) -> f64, x: f64) -> [f64; 2] {
    // Steps at which rounding and truncation are equal: errors of about 1e-9 and 1e-6.
    let (h, k) = (1e-5, 1e-4);
    let first = (value(x + h) - value(x - h)) / (2.0 * h);
    let second = (value(x + k) - 2.0 * value(x) + value(x - k)) / (k * k);
    [first, second]
}

#[track_caller]
fn assert_close(value: f64, expected: f64, tolerance: f64, what: &str) {
    let error = (value - expected).abs() / (1.0 + expected.abs());
    assert!(error <= tolerance, "{what}: {value} for {expected}");
}

#[test]
#[should_panic(expected = "too far")]
fn closeness_can_fail() {
    assert_close(1.0, 1.1, 1e-3, "too far");
}

/// Compares first and second derivatives with duals of duals and with differences.
fn check(graph: &mut Graph, root: Expression, symbol: Symbol, point: [f64; 2], what: &str) {
    let first = graph.derivative(root, symbol);
    let second = graph.derivative(first, symbol);
    let value = |name: Symbol| if name == X { point[0] } else { point[1] };
    let symbolic = graph.evaluate(&[first, second], value);
    let dual = evaluate(graph, root, |name| {
        let inner = Dual::variable(value(name), name == symbol);
        let slope = f64::from(u8::from(name == symbol));
        let slope = Dual::variable(slope, false);
        Dual {
            value: inner,
            slope,
        }
    });
    assert_close(symbolic[0], dual.slope.value.value, 1e-13, what);
    assert_close(symbolic[1], dual.slope.slope.value, 1e-12, what);
    let along =
        |x: f64| graph.evaluate(&[root], |name| if name == symbol { x } else { value(name) })[0];
    let differences = differences(along, value(symbol));
    // Third and fourth derivatives of up to 1e4 near the ends of the domains.
    assert_close(symbolic[0], differences[0], 1e-6, what);
    assert_close(symbolic[1], differences[1], 1e-3, what);
}

#[test]
fn every_function_of_one_argument() {
    for function in Unary::ALL {
        for point in domain(function) {
            let mut graph = Graph::new();
            let x = graph.symbol(X);
            let root = graph.unary(function, x);
            check(&mut graph, root, X, [*point, 0.0], function.name());
            // The chain rule: the same through 2x/3 + 1/10, within the domain still.
            let terms = [
                (x, Rational::new(2, 3).unwrap()),
                (graph.one(), Rational::new(1, 10).unwrap()),
            ];
            let inner = graph.sum(terms);
            let root = graph.unary(function, inner);
            check(
                &mut graph,
                root,
                X,
                [(point - 0.1) * 1.5, 0.0],
                function.name(),
            );
        }
    }
}

#[test]
fn every_function_of_two_arguments() {
    for function in Binary::ALL {
        for point in [[0.7, 1.3], [1.9, -0.4], [3.1, 0.2], [0.3, -2.2]] {
            for symbol in [X, Y] {
                let mut graph = Graph::new();
                let (x, y) = (graph.symbol(X), graph.symbol(Y));
                let root = graph.binary(function, x, y);
                check(&mut graph, root, symbol, point, function.name());
                // Both arguments vary at once.
                let y = graph.multiply(x, y);
                let root = graph.binary(function, x, y);
                check(&mut graph, root, symbol, point, function.name());
            }
        }
    }
}

#[test]
fn closed_under_differentiation_where_it_jumps() {
    let mut graph = Graph::new();
    let x = graph.symbol(X);
    let size = graph.unary(Unary::Abs, x);
    let sign = graph.derivative(size, X);
    assert_eq!(sign, graph.unary(Unary::Signum, x));
    assert_eq!(graph.evaluate(&[sign], |_| 0.0), [0.0]);
    assert_eq!(graph.derivative(sign, X), graph.zero());
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn derivatives_are_those_of_dual_numbers(tree in trees(), point in points(), which in 0..SYMBOLS.len()) {
        let symbol = SYMBOLS[which];
        let dual = tree.evaluate(&|name| Dual::variable(at(&point, name), name == symbol));
        let mut graph = Graph::new();
        let root = tree.build(&mut graph);
        let derivative = graph.derivative(root, symbol);
        let symbolic = evaluate(&graph, derivative, |name| Bounded::exact(at(&point, name)));
        if dual.slope.is_reliable() && dual.value.is_reliable() {
            prop_assert!(!symbolic.value.is_nan());
            prop_assert!(symbolic.agrees(dual.slope), "{symbolic:?} for {:?}", dual.slope);
        }
    }

    #[test]
    fn rules_of_differentiation(trees in [trees(), trees()], point in points(), rates in points()) {
        let mut graph = Graph::new();
        let [x, y] = trees.map(|tree| tree.build(&mut graph));
        let value = |graph: &Graph, root| evaluate(graph, root, |name| Bounded::exact(at(&point, name)));
        let [dx, dy] = [x, y].map(|root| graph.derivative(root, X));
        let product = graph.multiply(x, y);
        let direct = graph.derivative(product, X);
        let (first, second) = (graph.multiply(dx, y), graph.multiply(x, dy));
        let rule = graph.add(first, second);
        let (direct, rule) = (value(&graph, direct), value(&graph, rule));
        if rule.is_reliable() && direct.error.is_finite() {
            prop_assert!(direct.agrees(rule), "product rule: {direct:?} for {rule:?}");
        }
        // Along a direction, the derivative is the sum of the partial ones.
        let mut direction = Direction::new();
        let mut terms = Vec::new();
        for symbol in SYMBOLS {
            let rate = Rational::from_decimal(&format!("{:.6}", at(&rates, symbol).abs())).unwrap();
            direction.insert(symbol, graph.constant(&rate));
            terms.push((graph.derivative(x, symbol), rate));
        }
        let along = graph.directional_derivatives(&[x], &direction)[0];
        let partial = graph.sum(terms);
        let (along, partial) = (value(&graph, along), value(&graph, partial));
        if partial.is_reliable() && along.error.is_finite() {
            prop_assert!(along.agrees(partial), "direction: {along:?} for {partial:?}");
        }
    }

    #[test]
    fn substitution_and_evaluation_commute(trees in [trees(), trees()], point in points()) {
        let mut graph = Graph::new();
        let [root, inner] = trees.map(|tree| tree.build(&mut graph));
        let substituted = graph.substitute(&[root], &[(X, inner)].into())[0];
        let value = |symbol| Bounded::exact(at(&point, symbol));
        let x = evaluate(&graph, inner, value);
        let outer = evaluate(&graph, root, |symbol| if symbol == X { x } else { value(symbol) });
        let substituted = evaluate(&graph, substituted, value);
        if outer.is_reliable() && x.is_reliable() && substituted.error.is_finite() {
            prop_assert!(substituted.agrees(outer), "{substituted:?} for {outer:?}");
        }
    }
}

/// d/dt along the motion: q̇ for q, q̈ for q̇, 1 for t.
#[test]
fn total_time_derivative() {
    let mut graph = Graph::new();
    let [t, x, v, a] = [
        Symbol::Time,
        X,
        Symbol::Velocity(0),
        Symbol::Acceleration(0),
    ]
    .map(|symbol| graph.symbol(symbol));
    let direction = Direction::from([
        (Symbol::Time, graph.one()),
        (X, v),
        (Symbol::Velocity(0), a),
    ]);
    // d/dt (t x² ẋ) = x² ẋ + 2 t x ẋ² + t x² ẍ
    let two = Rational::integer(2);
    let one = || Rational::ONE;
    let root = graph.product([(t, one()), (x, two.clone()), (v, one())]);
    let total = graph.directional_derivatives(&[root], &direction)[0];
    let first = graph.product([(x, two.clone()), (v, one())]);
    let second = graph.product([(t, one()), (x, one()), (v, two.clone())]);
    let third = graph.product([(t, one()), (x, two.clone()), (a, one())]);
    let expected = graph.sum([(first, one()), (second, two), (third, one())]);
    assert_eq!(total, expected);
}
