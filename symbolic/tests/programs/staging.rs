//! Invariants, which depend on parameters alone, are hoisted, and nothing else is.

use lagrangian_symbolic::{Expression, Graph, OperationCount, Program, Rational, Staged, Symbol};

/// Parameters a, b, c and coordinates x, y. The coordinates come first, so that in normal form they stand
/// before the parameters and nothing is gathered by chance.
fn start() -> (Graph, [Expression; 5]) {
    let mut graph = Graph::new();
    let letters = [
        Symbol::Coordinate(0),
        Symbol::Coordinate(1),
        Symbol::Parameter(0),
        Symbol::Parameter(1),
        Symbol::Parameter(2),
    ];
    let [x, y, a, b, c] = letters.map(|symbol| graph.symbol(symbol));
    (graph, [a, b, c, x, y])
}

fn value(symbol: Symbol) -> f64 {
    match symbol {
        Symbol::Parameter(i) => 1.1 + 0.3 * f64::from(i),
        Symbol::Coordinate(i) => 0.7 - 0.2 * f64::from(i),
        _ => panic!("{symbol:?} has no value here"),
    }
}

/// The two parts of a program, after their values have been compared with those of the roots.
fn parts(graph: &Graph, roots: &[Expression]) -> Staged {
    let program = Program::schedule_for_staging(graph, &[roots]);
    assert_eq!(program.verify(graph, &[roots]), Ok(()));
    let parts = program.hoist_invariants();
    let of_parameters = |symbol| match symbol {
        Symbol::Parameter(_) => value(symbol),
        _ => panic!("{symbol:?} varies"),
    };
    let invariants = parts.setup.evaluate(of_parameters).concat();
    let found = parts.kernel.evaluate(|symbol| match symbol {
        Symbol::Invariant(index) => invariants[index as usize],
        _ => value(symbol),
    });
    for (found, expected) in found.concat().into_iter().zip(graph.evaluate(roots, value)) {
        let error = (found - expected).abs();
        assert!(error <= 1e-14 * expected.abs(), "{found} is not {expected}");
    }
    parts
}

/// Additions, multiplications and divisions.
fn operations(program: &Program) -> [usize; 3] {
    let OperationCount {
        additions,
        multiplications,
        divisions,
        ..
    } = program.count();
    [additions, multiplications, divisions]
}

#[track_caller]
fn assert_parts(graph: &Graph, roots: &[Expression], before: [usize; 3], after: [usize; 3]) {
    let parts = parts(graph, roots);
    assert_eq!(operations(&parts.setup), before, "before");
    assert_eq!(operations(&parts.kernel), after, "after");
}

#[test]
fn constant_factors_are_gathered() {
    let (mut graph, [a, b, c, x, y]) = start();
    let one = Rational::ONE;
    let first = graph.product([a, x, b, y].map(|x| (x, one.clone())));
    assert_parts(&graph, &[first], [0, 1, 0], [0, 2, 0]);
    // a b (1/c) is one value for both.
    let quotient = graph.divide(first, c);
    let second = graph.product([a, b, x].map(|x| (x, one.clone())));
    let second = graph.divide(second, c);
    assert_parts(&graph, &[quotient, second], [0, 2, 1], [0, 2, 0]);
}

#[test]
fn numbers_in_front_of_terms_join_their_constant_factors() {
    let (mut graph, [a, _, _, x, y]) = start();
    let product = graph.multiply(a, x);
    let sum = graph.sum([(product, Rational::HALF), (y, Rational::MINUS_ONE)]);
    assert_parts(&graph, &[sum], [0, 1, 0], [1, 1, 0]);
    // What is used elsewhere without the number is computed once, and multiplied.
    assert_parts(&graph, &[sum, product], [0, 0, 0], [1, 2, 0]);
    // Nor is there anything to join where all factors vary.
    let varying = graph.multiply(x, y);
    let sum = graph.sum([(varying, Rational::HALF), (y, Rational::ONE)]);
    assert_parts(&graph, &[sum], [0, 0, 0], [1, 2, 0]);
}

#[test]
fn a_division_by_an_invariant_is_hoisted_as_a_multiplication() {
    let (mut graph, [a, _, _, x, y]) = start();
    let by_parameter = graph.divide(x, a);
    assert_parts(&graph, &[by_parameter], [0, 0, 1], [0, 1, 0]);
    // Where nothing is hoisted it stays a division, which rounds once.
    let program = Program::schedule(&graph, &[&[by_parameter]]);
    assert_eq!(operations(&program), [0, 0, 1]);
    // What varies divides still.
    let by_coordinate = graph.divide(x, y);
    assert_parts(&graph, &[by_coordinate], [0, 0, 0], [0, 0, 1]);
    let inverse = graph.divide(a, y);
    assert_parts(&graph, &[inverse], [0, 0, 0], [0, 0, 1]);
}

#[test]
fn constant_terms_are_gathered() {
    let (mut graph, [a, b, _, x, y]) = start();
    let one = Rational::ONE;
    let sum = graph.sum([a, x, b, y].map(|x| (x, one.clone())));
    assert_parts(&graph, &[sum], [1, 0, 0], [2, 0, 0]);
    // Numbers in front do not keep them apart: a + 2 b, and x + 2 y.
    let two = Rational::integer(2);
    let terms = [
        (x, one.clone()),
        (y, two.clone()),
        (a, one.clone()),
        (b, two),
    ];
    let sum = graph.sum(terms);
    assert_parts(&graph, &[sum], [1, 1, 0], [2, 1, 0]);
    // A multiple of one parameter is hoisted; a parameter or a number by itself is not.
    let multiple = graph.sum([(a, Rational::integer(2)), (x, one.clone())]);
    assert_parts(&graph, &[multiple], [0, 1, 0], [1, 0, 0]);
    let opposite = graph.subtract(x, a);
    assert_parts(&graph, &[opposite], [0, 0, 0], [1, 0, 0]);
    let number = graph.add_constant(x, &Rational::HALF);
    assert_parts(&graph, &[number], [0, 0, 0], [1, 0, 0]);
}

#[test]
fn what_varies_is_not_hoisted() {
    for symbol in [
        Symbol::Time,
        Symbol::Coordinate(0),
        Symbol::Velocity(0),
        Symbol::Acceleration(0),
        Symbol::Input(0),
    ] {
        let mut graph = Graph::new();
        let varying = graph.symbol(symbol);
        let [a, b] = [0, 1].map(|i| graph.symbol(Symbol::Parameter(i)));
        let product = graph.multiply(a, varying);
        // In a product with two parameters it is those that are gathered.
        let longer = graph.multiply(product, b);
        let parts = Program::schedule_for_staging(&graph, &[&[longer]]).hoist_invariants();
        assert_eq!(operations(&parts.setup), [0, 1, 0], "{symbol:?}");
        assert_eq!(operations(&parts.kernel), [0, 1, 0], "{symbol:?}");
        let program = Program::schedule_for_staging(&graph, &[&[product, a]]);
        let parts = program.hoist_invariants();
        assert_eq!(parts.setup.instructions().count(), 0, "{symbol:?}");
        let read = parts.kernel.symbols();
        assert_eq!(read.len(), 2, "{read:?}");
        assert!(!read.contains(&Symbol::Invariant(0)), "{read:?}");
    }
}

#[test]
fn each_invariant_is_hoisted_once_and_only_if_it_is_used() {
    let (mut graph, [a, b, c, x, y]) = start();
    // √(a² + b²) stands in both; c in neither part's arithmetic.
    let (a2, b2) = (graph.square(a), graph.square(b));
    let sum = graph.add(a2, b2);
    let root = graph.square_root(sum);
    let (first, second) = (graph.multiply(root, x), graph.multiply(root, y));
    let parts = parts(&graph, &[first, second, root, c]);
    assert_eq!(parts.setup.count().square_roots, 1);
    assert_eq!(parts.setup.groups[0].outputs.len(), 1);
    let read = [
        Symbol::Coordinate(0),
        Symbol::Coordinate(1),
        Symbol::Parameter(2),
        Symbol::Invariant(0),
    ];
    assert_eq!(parts.kernel.symbols(), read);
    assert_eq!(operations(&parts.kernel), [0, 2, 0]);
}
