//! Both forms against the quotients that they are written from.

use super::*;
use HalfAngleForm::{PartialFractions, Squares};

const X: Symbol = Symbol::Coordinate(0);

/// (a − b cos x + d cos² x), sin x and cos x.
fn parts(graph: &mut Graph, degree: usize) -> [Expression; 3] {
    let x = graph.symbol(X);
    let [sine, cosine] = [Unary::Sin, Unary::Cos].map(|f| graph.unary(f, x));
    let square = graph.square(cosine);
    let [a, b, d] = [0, 1, 2].map(|i| graph.symbol(Symbol::Parameter(i)));
    let terms = [
        (a, Rational::ONE),
        (graph.multiply(b, cosine), Rational::MINUS_ONE),
        (graph.multiply(d, square), Rational::ONE),
    ];
    [graph.sum(terms.into_iter().take(degree + 1)), sine, cosine]
}

/// Multiples of products of powers of P, sin x and cos x.
fn expression(graph: &mut Graph, degree: usize, terms: &[(i64, [i64; 3])]) -> Expression {
    let bases = parts(graph, degree);
    let mut sum = Vec::new();
    for (number, powers) in terms {
        let factors = bases.into_iter().zip(powers.map(Rational::integer));
        sum.push((graph.product(factors), Rational::integer(*number)));
    }
    graph.sum(sum)
}

fn value(graph: &Graph, root: Expression, x: f64, [a, b, d]: [f64; 3]) -> f64 {
    let values = graph.evaluate(&[root], |symbol| match symbol {
        Symbol::Parameter(0) => a,
        Symbol::Parameter(1) => b,
        Symbol::Parameter(2) => d,
        _ => x,
    });
    values[0]
}

/// The degree of P, and terms: a number, and the exponents of P, sin x and cos x.
type Quotient = (usize, &'static [(i64, [i64; 3])]);

const QUOTIENTS: [Quotient; 9] = [
    (1, &[(3, [2, -2, 0])]),
    (2, &[(-1, [2, -2, 0])]),
    (1, &[(1, [4, -2, 0]), (2, [2, -2, 2])]),
    (1, &[(2, [0, -2, 2]), (5, [0, 1, 1])]),
    (1, &[(1, [2, -2, 0]), (2, [0, -2, 0])]),
    // Of other signs, and no squares.
    (1, &[(1, [2, -2, 0]), (-2, [2, -2, 2])]),
    (2, &[(2, [1, -2, 0]), (1, [2, -2, 0])]),
    (1, &[(2, [1, -2, 1]), (1, [0, 0, 1])]),
    (2, &[(-2, [1, -2, 3])]),
];

#[test]
fn both_forms_are_equal() {
    for ((degree, terms), form) in QUOTIENTS
        .into_iter()
        .flat_map(|quotient| [(quotient, PartialFractions), (quotient, Squares)])
    {
        let mut graph = Graph::new();
        let direct = expression(&mut graph, degree, terms);
        let mut written = [direct];
        let found = graph.write_in_half_angles(&mut written, X, form);
        assert!(found, "{terms:?} {form:?}");
        for x in [-3.0, -1.2, 0.4, 1.9, 4.4] {
            for constants in [[1.3, 0.7, 0.4], [-0.2, 2.1, 0.0], [0.6, 0.6, -1.1]] {
                let [found, expected] =
                    [written[0], direct].map(|root| value(&graph, root, x, constants));
                let error = (found - expected).abs() / (1.0 + expected.abs());
                assert!(error < 1e-12, "{terms:?} {form:?} {x}: {found} {expected}");
            }
        }
    }
}

/// (a − b cos x)²/sin² x is a² tan² ½x at a = b, and a² cot² ½x at a = −b; otherwise it has a pole.
#[test]
fn squares_have_values_at_removable_poles() {
    let mut graph = Graph::new();
    let mut written = [expression(&mut graph, 1, &[(1, [2, -2, 0])])];
    graph.write_in_half_angles(&mut written, X, Squares);
    let pi = core::f64::consts::PI;
    for x in [0.0, -pi, pi, 1e-9, 3.0, -2.0, 2.0 * pi, 3.0 * pi] {
        let tangent = (0.5 * x).tan();
        for (constants, expected) in [
            ([3.0, 3.0, 0.0], 9.0 * tangent.powi(2)),
            ([3.0, -3.0, 0.0], 9.0 * tangent.powi(-2)),
        ] {
            let found = value(&graph, written[0], x, constants);
            let error = (found - expected).abs() / (1.0 + expected);
            assert!(error < 1e-12 || expected > 1e30, "{x}: {found} {expected}");
        }
    }
    assert!(value(&graph, written[0], 0.0, [3.0, 1.0, 0.0]).is_infinite());
}

/// Where a = b cos x all digits are kept, which partial fractions lose.
#[test]
fn a_square_is_small_where_its_root_is() {
    let mut graph = Graph::new();
    let direct = expression(&mut graph, 1, &[(1, [2, -2, 0])]);
    let largest = |graph: &Graph, root| {
        let errors = (1..300).map(|k| {
            let x = 0.01 * f64::from(k);
            value(graph, root, x, [x.cos(), 1.0, 0.0]).abs()
        });
        errors.fold(0.0, f64::max)
    };
    let [lost, kept] = [PartialFractions, Squares].map(|form| {
        let mut written = [direct];
        graph.write_in_half_angles(&mut written, X, form);
        largest(&graph, written[0])
    });
    assert!(lost > 1e-16 && kept < 1e-26, "{lost:e} {kept:e}");
}
