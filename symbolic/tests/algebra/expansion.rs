//! Multiplying out and taking out: done where it makes an expression cheaper, and nowhere else.

use lagrangian_symbolic::{Expression, Graph, Rational, Symbol, Unary};

/// A graph with as many parameters.
fn start<const N: usize>() -> (Graph, [Expression; N]) {
    let mut graph = Graph::new();
    let symbols = (0..).map(Symbol::Parameter);
    let letters: Vec<_> = symbols.take(N).map(|x| graph.symbol(x)).collect();
    (graph, core::array::from_fn(|i| letters[i]))
}

fn product(graph: &mut Graph, factors: &[Expression]) -> Expression {
    graph.product(factors.iter().map(|x| (*x, Rational::ONE)))
}

/// Σ cᵢ·xᵢ.
fn sum(graph: &mut Graph, terms: &[(Expression, i64)]) -> Expression {
    graph.sum(terms.iter().map(|(x, c)| (*x, Rational::integer(*c))))
}

/// sin and cos of an angle, squared.
fn squares(graph: &mut Graph, angle: Expression) -> [Expression; 2] {
    [Unary::Sin, Unary::Cos].map(|function| {
        let value = graph.unary(function, angle);
        graph.square(value)
    })
}

#[test]
fn what_cancels_in_expanded_form_cancels() {
    // (a + b)² − (a − b)² = 4 a b.
    let (mut graph, [a, b]) = start();
    let (plus, minus) = (graph.add(a, b), graph.subtract(a, b));
    let (plus, minus) = (graph.square(plus), graph.square(minus));
    let difference = graph.subtract(plus, minus);
    let expected = product(&mut graph, &[a, b]);
    let expected = graph.scale(expected, &Rational::integer(4));
    assert_eq!(graph.simplest(difference), expected);
}

#[test]
fn powers_up_to_the_fourth_are_expanded() {
    let (mut graph, [a, b]) = start();
    let binomials: [&[i64]; 4] = [&[2], &[3, 3], &[4, 6, 4], &[5, 10, 10, 5]];
    for (exponent, coefficients) in (2..).zip(binomials) {
        // (a + b)ⁿ less the terms in between.
        let base = graph.add(a, b);
        let power = graph.power(base, &Rational::integer(exponent));
        let mut terms = vec![(power, 1)];
        for (k, coefficient) in (1..).zip(coefficients) {
            let powers = [(a, k), (b, exponent - k)];
            let term = graph.product(powers.map(|(x, k)| (x, Rational::integer(k))));
            terms.push((term, -coefficient));
        }
        let rest = sum(&mut graph, &terms);
        let [x, y] = [a, b].map(|x| graph.power(x, &Rational::integer(exponent)));
        let is_found = graph.simplest(rest) == graph.add(x, y);
        assert_eq!(is_found, exponent <= 4, "{exponent}");
    }
}

#[test]
fn squares_of_sine_and_cosine_meet_across_products() {
    // (a sin²x + b) + (a + b) cos²x − b cos²x = a + b.
    let (mut graph, [a, b, x]) = start();
    let [sine, cosine] = squares(&mut graph, x);
    let first = product(&mut graph, &[a, sine]);
    let both = graph.add(a, b);
    let second = product(&mut graph, &[both, cosine]);
    let third = product(&mut graph, &[b, cosine]);
    let mixed = sum(&mut graph, &[(first, 1), (b, 1), (second, 1), (third, -1)]);
    assert_eq!(graph.simplest(mixed), both);
}

#[test]
fn common_factors_are_taken_out() {
    let (mut graph, [a, b, c, x]) = start();
    let terms = [a, b, c].map(|y| (product(&mut graph, &[x, y]), 1));
    let expanded = sum(&mut graph, &terms);
    let inner = sum(&mut graph, &[(a, 1), (b, 1), (c, 1)]);
    let expected = product(&mut graph, &[x, inner]);
    assert_eq!(graph.factored(expanded), expected);
    assert_eq!(graph.simplest(expanded), expected);
    // Without multiplying out, where that costs more: x (a + b)² + x c = x ((a + b)² + c).
    let both = graph.add(a, b);
    let square = graph.square(both);
    let (first, second) = (graph.multiply(x, square), graph.multiply(x, c));
    let written = graph.add(first, second);
    let within = graph.add(square, c);
    assert_eq!(graph.simplest(written), graph.multiply(x, within));
    // Where nothing is common, nothing is done.
    assert_eq!(graph.factored(inner), inner);
    let with_more = graph.add(expanded, a);
    assert_eq!(graph.factored(with_more), with_more);
}

#[test]
fn what_is_cheaper_as_it_stands_stays() {
    let (mut graph, [a, b, c, x]) = start();
    let (first, second) = (graph.add(a, b), graph.add(c, x));
    let square = graph.square(first);
    let both = product(&mut graph, &[first, second]);
    let [sine, _] = squares(&mut graph, x);
    for written in [a, first, square, both, sine] {
        assert_eq!(graph.simplest(written), written);
    }
    // A sum of positive terms does not become a difference: a sin²x is never a − a cos²x.
    let term = product(&mut graph, &[a, sine]);
    let written = graph.add(term, b);
    assert_eq!(graph.simplest(written), written);
}

#[test]
fn nothing_is_expanded_beyond_a_count_of_terms() {
    // Π (xᵢ + 1)² over four letters has 81 terms, and over five 243.
    let mut graph = Graph::new();
    let letters: Vec<_> = (0..5).map(Symbol::Parameter).collect();
    for (count, is_small) in [(4, true), (5, false)] {
        let mut factors = Vec::new();
        for letter in &letters[..count] {
            let x = graph.symbol(*letter);
            let shifted = graph.add_constant(x, &Rational::ONE);
            factors.push((shifted, Rational::integer(2)));
        }
        let power = graph.product(factors.clone());
        // Less itself but for one, expanded: Π − Π (1 − 1) …, which cancels if it is opened.
        let (last, _) = factors.pop().unwrap();
        let others = graph.product(factors);
        let x = graph.symbol(letters[count - 1]);
        let square = graph.square(x);
        let opened = sum(&mut graph, &[(square, 1), (x, 2)]);
        let opened = graph.add_constant(opened, &Rational::ONE);
        assert_ne!(opened, graph.square(last));
        let other = product(&mut graph, &[others, opened]);
        let difference = graph.subtract(power, other);
        let found = graph.simplest(difference);
        assert_eq!(graph.is_zero(found), is_small, "{count} letters");
    }
}

#[test]
fn an_opaque_node_is_a_term_and_a_factor_of_its_own() {
    let (mut graph, [a, b, x]) = start();
    let inner = graph.add(a, b);
    let opaque = graph.opaque(inner);
    assert_ne!(opaque, inner);
    // Sums and products neither merge it nor cancel it, and multiplying out stops at it.
    let difference = graph.subtract(inner, opaque);
    assert!(!graph.is_zero(difference));
    let quotient = graph.divide(inner, opaque);
    assert_ne!(quotient, graph.one());
    let multiple = product(&mut graph, &[x, opaque]);
    assert_eq!(graph.simplest(multiple), multiple);
    let (first, second) = (graph.multiply(x, a), graph.multiply(x, b));
    let difference = sum(&mut graph, &[(multiple, 1), (first, -1), (second, -1)]);
    let simplest = graph.simplest(difference);
    assert!(!graph.is_zero(simplest));
    // An opaque node of an opaque node is itself, and a symbol needs none.
    assert_eq!(graph.opaque(opaque), opaque);
    let one = graph.one();
    let sine = graph.unary(Unary::Sin, x);
    for atom in [x, one, sine] {
        assert_eq!(graph.opaque(atom), atom);
    }
    // It costs and it varies as what it keeps.
    assert_eq!(graph.cost(&[opaque]), graph.cost(&[inner]));
    let symbol = Symbol::Parameter(0);
    assert_eq!(graph.derivative(opaque, symbol), graph.one());
    let with_square = [(symbol, graph.square(b))].into();
    let substituted = graph.substitute(&[opaque], &with_square)[0];
    let square = graph.square(b);
    let expected = graph.add(square, b);
    assert_eq!(substituted, graph.opaque(expected));
}
