//! Circular functions at multiples of π, and their inverses.

use lagrangian_symbolic::{Binary, Expression, Graph, Node, Rational, Symbol, Unary};

const X: Symbol = Symbol::Coordinate(0);

/// sin kπ/12 for k from 0 to 6, to more digits than binary64 has; by mpmath.
#[allow(clippy::approx_constant, clippy::excessive_precision)] // A table of them.
const SINES: [f64; 7] = [
    0.0,
    0.258_819_045_102_520_762_348_9,
    0.5,
    0.707_106_781_186_547_524_400_8,
    0.866_025_403_784_438_646_763_7,
    0.965_925_826_289_068_286_749_7,
    1.0,
];

/// sin kπ/12, by the symmetries of the sine alone.
fn sine(k: i64) -> f64 {
    match k.rem_euclid(24) {
        k @ 0..=6 => SINES[usize::try_from(k).unwrap()],
        k @ 7..=12 => sine(12 - k),
        k => -sine(k - 12),
    }
}

/// kπ/n.
fn angle(graph: &mut Graph, k: i64, n: i64) -> Expression {
    let pi = graph.pi();
    graph.scale(pi, &Rational::new(k, n).unwrap())
}

fn value(graph: &Graph, root: Expression) -> f64 {
    graph.evaluate(&[root], |_| f64::NAN)[0]
}

#[track_caller]
fn assert_rounded(found: f64, expected: f64, what: &str) {
    let error = (found - expected).abs();
    assert!(
        error <= 4e-16 * expected.abs().max(0.25),
        "{what}: {found} for {expected}"
    );
}

/// Whether an expression is made of numbers and their roots.
fn is_radical(graph: &Graph, root: Expression) -> bool {
    graph.descendants(&[root]).into_iter().all(|expression| {
        matches!(
            graph.node(expression),
            Node::Constant(_) | Node::Sum(_) | Node::Product(_)
        )
    })
}

#[test]
fn multiples_of_a_twelfth_of_pi() {
    let mut graph = Graph::new();
    for k in -60..=60 {
        let x = angle(&mut graph, k, 12);
        let [sin, cos, tan] =
            [Unary::Sin, Unary::Cos, Unary::Tan].map(|function| graph.unary(function, x));
        assert_rounded(value(&graph, sin), sine(k), &format!("sin {k}π/12"));
        assert_rounded(value(&graph, cos), sine(k + 6), &format!("cos {k}π/12"));
        let known = k % 2 == 0 || k % 3 == 0;
        for value in [sin, cos] {
            assert_eq!(is_radical(&graph, value), known, "{k}");
        }
        let pole = (k + 6) % 12 == 0;
        assert_eq!(is_radical(&graph, tan), known && !pole, "{k}");
        if !pole {
            let expected = sine(k) / sine(k + 6);
            let error = (value(&graph, tan) - expected).abs();
            assert!(error <= 1e-15 * expected.abs(), "tan {k}π/12");
        }
        // The squares add up, without a function that is computed.
        let (sin, cos) = (graph.square(sin), graph.square(cos));
        assert_eq!(graph.add(sin, cos), graph.one(), "{k}");
    }
}

#[test]
fn other_multiples_are_those_of_the_first_octant() {
    let mut graph = Graph::new();
    for (k, n) in [(1, 5), (2, 5), (-3, 7), (19, 7), (1_000_001, 100), (7, 9)] {
        let x = angle(&mut graph, k, n);
        for function in [Unary::Sin, Unary::Cos, Unary::Tan] {
            let found = graph.unary(function, x);
            // π is rounded, and so is its multiple.
            let expected = function.value(value(&graph, x));
            let slope = if function == Unary::Tan { 10.0 } else { 1.0 };
            let error = (value(&graph, found) - expected).abs();
            let tolerance = slope * f64::EPSILON * value(&graph, x).abs().max(1.0);
            assert!(error <= tolerance, "{function:?} {k}π/{n}");
        }
    }
    let [near, far] = [(1, 5), (3, 10)].map(|(k, n)| angle(&mut graph, k, n));
    assert_eq!(graph.unary(Unary::Sin, far), graph.unary(Unary::Cos, near));
}

#[test]
fn quarter_turns_exchange_sine_and_cosine() {
    let mut graph = Graph::new();
    let x = graph.symbol(X);
    let double = graph.scale(x, &Rational::integer(-2));
    for inner in [x, double] {
        let [sin, cos, tan] =
            [Unary::Sin, Unary::Cos, Unary::Tan].map(|function| graph.unary(function, inner));
        let [minus_sin, minus_cos] = [sin, cos].map(|value| graph.negate(value));
        let sines = [sin, cos, minus_sin, minus_cos];
        for k in -9_i64..=9 {
            let quarters = angle(&mut graph, k, 2);
            let shifted = graph.add(inner, quarters);
            let position = usize::try_from(k.rem_euclid(4)).unwrap();
            assert_eq!(graph.unary(Unary::Sin, shifted), sines[position], "{k}");
            let cosine = graph.unary(Unary::Cos, shifted);
            assert_eq!(cosine, sines[(position + 1) % 4], "{k}");
            let at = |root| graph.evaluate(&[root], |_| 0.3)[0];
            assert!((at(sines[position]) - at(shifted).sin()).abs() < 1e-14);
            assert!((at(cosine) - at(shifted).cos()).abs() < 1e-14);
            let found = graph.unary(Unary::Tan, shifted);
            assert_eq!(found == tan, k % 2 == 0);
        }
        let third = angle(&mut graph, 1, 3);
        let shifted = graph.add(inner, third);
        let found = graph.unary(Unary::Sin, shifted);
        assert!(
            (graph.evaluate(&[found], |_| 0.3)[0] - graph.evaluate(&[shifted], |_| 0.3)[0].sin())
                .abs()
                < 1e-15
        );
    }
}

#[test]
fn inverses_have_their_principal_values() {
    let mut graph = Graph::new();
    for k in -24_i64..=24 {
        if k % 2 != 0 && k % 3 != 0 {
            continue;
        }
        let x = angle(&mut graph, k, 12);
        let pairs = [
            (Unary::Asin, Unary::Sin, -6..=6),
            (Unary::Acos, Unary::Cos, 0..=12),
            (Unary::Atan, Unary::Tan, -5..=5),
        ];
        for (inverse, function, branch) in pairs {
            if function == Unary::Tan && (k + 6) % 12 == 0 {
                continue;
            }
            let inner = graph.unary(function, x);
            let found = graph.unary(inverse, inner);
            assert!(!matches!(graph.node(found), Node::Unary(..)), "{k}");
            let expected = inverse.value(value(&graph, inner));
            // Near ±1 the slope of the inverse is infinite.
            let error = (value(&graph, found) - expected).abs();
            assert!(error < 3e-8, "{inverse:?} {function:?} {k}π/12");
            assert_eq!(found == x, branch.contains(&k), "{inverse:?} {k}");
        }
    }
}

#[test]
fn roots_are_known_however_they_are_written() {
    let mut graph = Graph::new();
    let root = |graph: &mut Graph, n: i64, d: i64, k: i64| {
        let number = graph.constant(&Rational::new(n, d).unwrap());
        graph.power(number, &Rational::new(k, 2).unwrap())
    };
    // √(1/2) = 1/√2 and √(3/4); 1/√3 and √(1/3).
    let quarter = angle(&mut graph, 1, 4);
    for (n, d, k) in [(1, 2, 1), (2, 1, -1)] {
        let x = root(&mut graph, n, d, k);
        assert_eq!(graph.unary(Unary::Asin, x), quarter);
        assert_eq!(graph.unary(Unary::Acos, x), quarter);
    }
    let x = root(&mut graph, 3, 4, 1);
    assert_eq!(graph.unary(Unary::Asin, x), angle(&mut graph, 1, 3));
    for (n, d, k) in [(1, 3, 1), (3, 1, -1)] {
        let x = root(&mut graph, n, d, k);
        assert_eq!(graph.unary(Unary::Atan, x), angle(&mut graph, 1, 6));
    }
}

#[test]
fn angles_of_points() {
    let mut graph = Graph::new();
    for k in (-11_i64..=12).filter(|k| k % 2 == 0 || k % 3 == 0) {
        let x = angle(&mut graph, k, 12);
        let direction = [Unary::Sin, Unary::Cos].map(|function| graph.unary(function, x));
        for length in [Rational::ONE, Rational::new(3, 7).unwrap()] {
            let [y, x_] = direction.map(|value| graph.scale(value, &length));
            let found = graph.binary(Binary::Atan2, y, x_);
            assert_eq!(found, x, "{k}");
            let expected = value(&graph, y).atan2(value(&graph, x_));
            assert_rounded(value(&graph, found), expected, "atan2");
        }
    }
}

#[test]
fn what_is_not_known_stays() {
    let mut graph = Graph::new();
    let (zero, two) = (graph.zero(), graph.integer(2));
    let third = graph.constant(&Rational::new(1, 3).unwrap());
    let minus = graph.integer(-3);
    let root = graph.square_root(minus);
    for (function, x) in [
        (Unary::Asin, two),
        (Unary::Asin, third),
        (Unary::Acos, two),
        (Unary::Atan, third),
        (Unary::Atan, root),
        (Unary::Asin, root),
    ] {
        let found = graph.unary(function, x);
        assert!(matches!(graph.node(found), Node::Unary(..)), "{function:?}");
    }
    for (y, x) in [(zero, zero), (two, third), (root, root)] {
        let found = graph.binary(Binary::Atan2, y, x);
        assert!(matches!(graph.node(found), Node::Binary(..)));
    }
    let pole = angle(&mut graph, 1, 2);
    let found = graph.unary(Unary::Tan, pole);
    assert!(matches!(graph.node(found), Node::Unary(Unary::Tan, x) if *x == pole));
}

#[test]
fn functions_of_their_inverses_are_algebraic() {
    let mut graph = Graph::new();
    let x = graph.symbol(X);
    let minus = graph.negate(x);
    let product = graph.multiply(x, x);
    for u in [x, minus, product] {
        let [asin, acos, atan] =
            [Unary::Asin, Unary::Acos, Unary::Atan].map(|function| graph.unary(function, u));
        assert_eq!(graph.unary(Unary::Sin, asin), u);
        assert_eq!(graph.unary(Unary::Cos, acos), u);
        assert_eq!(graph.unary(Unary::Tan, atan), u);
        let root = graph.unary(Unary::Cos, asin);
        assert_eq!(graph.unary(Unary::Sin, acos), root);
        // The other leg of the triangle, with its digits also next to ±1, where it is near 0: with 1 ∓ u = d,
        // √(d (2 − d)).
        for d in [1.0, 0.7, 1e-3, 1e-9, f64::EPSILON] {
            for sign in [-1.0, 1.0] {
                let at = sign * (1.0 - d);
                let u = graph.evaluate(&[u], |_| at)[0].abs();
                let expected = ((1.0 - u) * 2.0 - (1.0 - u) * (1.0 - u)).sqrt();
                let found = graph.evaluate(&[root], |_| at)[0];
                assert!(
                    (found - expected).abs() <= 4e-16 * expected,
                    "{at}: {found}"
                );
            }
        }
        assert!(graph.evaluate(&[root], |_| 1.5)[0].is_nan());
    }
    // The sine takes every value twice in a turn, so that its inverse is another angle.
    let sine = graph.unary(Unary::Sin, x);
    let angle = graph.unary(Unary::Asin, sine);
    assert!(matches!(graph.node(angle), Node::Unary(Unary::Asin, _)));
    // At the origin there is an angle, and no direction.
    let y = graph.symbol(Symbol::Coordinate(1));
    let angle = graph.binary(Binary::Atan2, y, x);
    let cosine = graph.unary(Unary::Cos, angle);
    assert!(matches!(graph.node(cosine), Node::Unary(Unary::Cos, _)));
    assert_eq!(graph.evaluate(&[cosine], |_| 0.0), [1.0]);
}
