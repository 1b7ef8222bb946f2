//! What programs cost: common factors, shared parts, powers, quotients, paired sines and cosines.

use lagrangian_symbolic::{Expression, Graph, OperationCount, Program, Rational, Symbol, Unary};

fn parameters<const N: usize>(graph: &mut Graph) -> [Expression; N] {
    core::array::from_fn(|i| graph.symbol(Symbol::Parameter(u32::try_from(i).unwrap())))
}

/// The count of a program that is checked against its roots.
fn count(graph: &Graph, roots: &[Expression]) -> OperationCount {
    let program = Program::schedule(graph, &[roots]);
    assert_eq!(program.verify(graph, &[roots]), Ok(()));
    let value = |symbol: Symbol| match symbol {
        Symbol::Parameter(i) => 1.1 + 0.3 * f64::from(i),
        _ => f64::NAN,
    };
    let expected = graph.evaluate(roots, value);
    for (found, expected) in program.evaluate(value)[0].iter().zip(expected) {
        assert!(
            (found - expected).abs() <= 1e-14 * expected.abs(),
            "{found} is not {expected}"
        );
    }
    program.count()
}

#[track_caller]
fn assert_costs(count: OperationCount, additions: usize, multiplications: usize, divisions: usize) {
    let found = (count.additions, count.multiplications, count.divisions);
    assert_eq!(found, (additions, multiplications, divisions));
}

fn products(graph: &mut Graph, factors: &[&[Expression]]) -> Vec<Expression> {
    let product = |list: &&[Expression]| graph.product(list.iter().map(|x| (*x, Rational::ONE)));
    factors.iter().map(product).collect()
}

fn total(graph: &mut Graph, terms: &[Expression]) -> Expression {
    graph.sum(terms.iter().map(|x| (*x, Rational::ONE)))
}

#[test]
fn common_factors_are_multiplied_once() {
    let mut graph = Graph::new();
    let [a, b, c, d, x] = parameters(&mut graph);
    // x a + x b + x c + d = x (a + b + c) + d.
    let mut terms = products(&mut graph, &[&[x, a], &[x, b], &[x, c]]);
    terms.push(d);
    let sum = total(&mut graph, &terms);
    assert_costs(count(&graph, &[sum]), 3, 1, 0);
}

#[test]
fn what_is_shared_is_not_taken_apart() {
    let mut graph = Graph::new();
    let [a, b, x] = parameters(&mut graph);
    // x a is wanted by itself: x a + x b costs one more product, and (a + b) x would, too.
    let terms = products(&mut graph, &[&[x, a], &[x, b]]);
    let sum = total(&mut graph, &terms);
    assert_costs(count(&graph, &[terms[0], sum]), 1, 2, 0);
}

#[test]
fn products_share_their_common_part() {
    let mut graph = Graph::new();
    let [a, b, c, d] = parameters(&mut graph);
    let roots = products(&mut graph, &[&[a, b, c], &[a, b, d], &[a, b]]);
    assert_costs(count(&graph, &roots), 0, 3, 0);
}

#[test]
fn sums_share_their_common_part_up_to_a_multiple() {
    let mut graph = Graph::new();
    let [a, b, c, d] = parameters(&mut graph);
    let two = Rational::integer(2);
    let first = graph.sum([
        (a, Rational::ONE),
        (b, Rational::MINUS_ONE),
        (c, Rational::ONE),
    ]);
    let second = graph.sum([(a, two.clone()), (b, -&two), (d, Rational::ONE)]);
    // s = a − b; s + c; 2 s + d.
    assert_costs(count(&graph, &[first, second]), 3, 1, 0);
}

#[test]
fn powers_are_built_from_squares() {
    let mut graph = Graph::new();
    let [x] = parameters(&mut graph);
    let power = |graph: &mut Graph, k| graph.power(x, &Rational::integer(k));
    let fourth = power(&mut graph, 4);
    assert_costs(count(&graph, &[fourth]), 0, 2, 0);
    let hundredth = power(&mut graph, 100);
    assert_costs(count(&graph, &[hundredth]), 0, 8, 0);
    let half = graph.power(x, &Rational::new(3, 2).unwrap());
    let found = count(&graph, &[half]);
    assert_eq!(
        (found.square_roots, found.multiplications, found.functions),
        (1, 1, 0)
    );
}

#[test]
fn a_divisor_that_serves_twice_is_inverted_once() {
    let mut graph = Graph::new();
    let [a, b, x] = parameters(&mut graph);
    let (first, second) = (graph.divide(a, x), graph.divide(b, x));
    assert_costs(count(&graph, &[first]), 0, 0, 1);
    assert_costs(count(&graph, &[first, second]), 0, 2, 1);
}

#[test]
fn sine_and_cosine_of_one_angle_are_one_operation() {
    let mut graph = Graph::new();
    let [x, y] = parameters(&mut graph);
    let roots = [(Unary::Sin, x), (Unary::Cos, x), (Unary::Sin, y)]
        .map(|(function, angle)| graph.unary(function, angle));
    assert_eq!(count(&graph, &roots).sines_and_cosines, 2);
}

#[test]
fn programs_are_the_same_each_time() {
    let build = || {
        let mut graph = Graph::new();
        let [a, b, c, d] = parameters(&mut graph);
        let lists: [&[_]; 4] = [&[a, b, c], &[b, c, d], &[a, c, d], &[a, b, d]];
        let terms = products(&mut graph, &lists);
        let sum = total(&mut graph, &terms);
        let roots = [terms, vec![sum]].concat();
        format!("{:?}", Program::schedule(&graph, &[&roots]))
    };
    assert_eq!(build(), build());
}

#[test]
fn an_expression_and_its_opaque_node_are_one_value() {
    let mut graph = Graph::new();
    let [a, b, f, x] = parameters(&mut graph);
    let product = graph.multiply(a, b);
    let opaque = graph.opaque(product);
    // 2 a b + x, and f a b + f x, which is no multiple of it.
    let doubled = total(&mut graph, &[product, opaque, x]);
    let terms = products(&mut graph, &[&[f, product], &[f, x]]);
    let other = total(&mut graph, &terms);
    assert_costs(count(&graph, &[doubled, other]), 2, 3, 0);
}

#[test]
fn what_is_shared_is_added_to_what_is_there_already() {
    let mut graph = Graph::new();
    let [a, b, x] = parameters(&mut graph);
    let sum = graph.add(a, b);
    let opaque = graph.opaque(sum);
    let two = Rational::integer(2);
    // With s = a + b, the first is 3 s + x, and s + x is no part of it.
    let first = graph.sum([
        (a, Rational::ONE),
        (b, Rational::ONE),
        (opaque, two),
        (x, Rational::ONE),
    ]);
    let second = graph.add(opaque, x);
    assert_costs(count(&graph, &[first, second]), 3, 1, 0);
}
