//! What accelerations are divided by, and which divisors can come to vanish.

use lagrangian_symbolic::{
    Binary, Equations, Expression, Graph, Kinetics, Model, Rational, Symbol, Unary,
};
use lagrangian_symbolic_testing::systems::rigid_body;

/// An angle q, its sine and cosine, and a parameter.
struct Example {
    graph: Graph,
    sine: Expression,
    cosine: Expression,
    parameter: Expression,
}

fn example() -> Example {
    let mut graph = Graph::new();
    let angle = graph.symbol(Symbol::Coordinate(0));
    let parameter = graph.symbol(Symbol::Parameter(0));
    let [sine, cosine] = [Unary::Sin, Unary::Cos].map(|function| graph.unary(function, angle));
    Example {
        graph,
        sine,
        cosine,
        parameter,
    }
}

fn number(graph: &mut Graph, numerator: i64, denominator: i64) -> Expression {
    graph.constant(&Rational::new(numerator, denominator).unwrap())
}

#[test]
fn sums_that_keep_away_from_zero_never_vanish() {
    let Example {
        mut graph,
        sine,
        cosine,
        parameter,
    } = example();
    let two = number(&mut graph, 2, 1);
    let square = graph.multiply(cosine, cosine);
    let remainder = graph.subtract(two, square);
    assert!(graph.never_comes_to_vanish(remainder));
    let opposite = graph.negate(remainder);
    assert!(graph.never_comes_to_vanish(opposite));
    let quotient = graph.divide(parameter, remainder);
    assert!(graph.never_comes_to_vanish(quotient));
    let opaque = graph.opaque(remainder);
    assert!(graph.never_comes_to_vanish(opaque));
    // 3 + 2 sin q, and a parameter, which a motion does not change.
    let wave = graph.sum([
        (sine, Rational::integer(2)),
        (two, Rational::new(3, 2).unwrap()),
    ]);
    assert!(graph.never_comes_to_vanish(wave));
    assert!(graph.never_comes_to_vanish(parameter));
    let larger = graph.binary(Binary::Max, sine, two);
    assert!(graph.never_comes_to_vanish(larger));
}

#[test]
fn what_may_vanish_is_not_taken_for_regular() {
    let Example {
        mut graph,
        sine,
        cosine,
        parameter,
    } = example();
    let one = graph.one();
    let square = graph.multiply(cosine, cosine);
    assert!(!graph.never_comes_to_vanish(sine));
    assert!(!graph.never_comes_to_vanish(square));
    let scaled = graph.multiply(parameter, sine);
    assert!(!graph.never_comes_to_vanish(scaled));
    // 1 + p cos² q: the parameter may be −1.
    let product = graph.multiply(parameter, square);
    let sum = graph.add(one, product);
    assert!(!graph.never_comes_to_vanish(sum));
    // p² + cos² q: both may be zero.
    let size = graph.multiply(parameter, parameter);
    let sum = graph.add(size, square);
    assert!(!graph.never_comes_to_vanish(sum));
    // 1 + 10⁻⁵ − cos q is never zero, but loses five digits.
    let almost = number(&mut graph, 100_001, 100_000);
    let small = graph.subtract(almost, cosine);
    assert!(!graph.never_comes_to_vanish(small));
    let coordinate = graph.symbol(Symbol::Coordinate(1));
    let smaller = graph.binary(Binary::Min, coordinate, one);
    assert!(!graph.never_comes_to_vanish(smaller));
}

#[test]
fn bounds_hold_on_a_grid() {
    // Powers, products and quotients of both signs: where a claim is made, the sign is the same on a grid
    // (without q = 0, where one of the divisors vanishes).
    let Example {
        mut graph,
        sine,
        cosine,
        ..
    } = example();
    let three = number(&mut graph, 3, 1);
    let shifted = [(sine, 1), (sine, -1), (cosine, 2), (cosine, -3)]
        .map(|(x, factor)| graph.sum([(x, Rational::integer(factor)), (three, Rational::ONE)]));
    let mut claims = 0;
    for a in shifted {
        for b in shifted {
            for [first, second] in [[1, 1], [2, -1], [-3, 2], [-1, -2]] {
                let exponents = [first, second].map(Rational::integer);
                let [p, q] = exponents;
                let product = graph.product([(a, p), (b, q)]);
                for offset in [-20, -1, 0, 1, 20] {
                    let offset = number(&mut graph, offset, 1);
                    let sum = graph.add(product, offset);
                    if !graph.never_comes_to_vanish(sum) {
                        continue;
                    }
                    claims += 1;
                    let values = (1..100).map(|i| {
                        let angle = f64::from(i) * 0.063;
                        graph.evaluate(&[sum], |_| angle)[0]
                    });
                    let signs: Vec<bool> = values.map(|value| value > 0.0).collect();
                    assert!(
                        signs.iter().all(|sign| *sign == signs[0]),
                        "{a:?} {b:?} {first} {second}"
                    );
                }
            }
        }
    }
    assert!(claims > 20, "{claims}");
}

#[test]
fn a_rigid_body_is_divided_by_the_sine_of_its_nutation_and_by_its_moments() {
    let mut model = rigid_body();
    let equations = Equations::derive(&mut model).unwrap();
    let kinetics = Kinetics::cheapest(&mut model, &equations);
    let solution = kinetics.solution.unwrap();
    assert!(!solution.eliminates_mass_matrix());
    let divisors = solution.divisors(&model.graph);
    let theta = Symbol::Coordinate(1);
    let varying: Vec<_> = divisors
        .iter()
        .filter(|pivot| !model.graph.never_comes_to_vanish(pivot.value))
        .collect();
    assert_eq!(varying.len(), 1);
    assert_eq!(model.graph.symbols(&[varying[0].value]), [theta].into());
    assert_eq!(divisors.len(), 4);
    determinant_is_their_product(&mut model, &equations);
}

/// det M = (det E)² det W.
fn determinant_is_their_product(model: &mut Model, equations: &Equations) {
    let kinetics = Kinetics::cheapest(model, equations);
    let divisors = kinetics.solution.unwrap().divisors(&model.graph);
    let mut roots: Vec<_> = divisors.iter().map(|pivot| pivot.value).collect();
    roots.extend(equations.mass.concat());
    let values = model.graph.evaluate(&roots, |symbol| match symbol {
        Symbol::Coordinate(i) => 0.3 + 0.4 * f64::from(i),
        Symbol::Parameter(i) => 1.0 + 0.1 * f64::from(i),
        _ => 0.0,
    });
    let (divisors, m) = values.split_at(values.len() - 9);
    let determinant = m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6])
        + m[2] * (m[3] * m[7] - m[4] * m[6]);
    let product: f64 = divisors.iter().product();
    let sine = (0.7_f64).sin();
    assert!((product.abs() * sine / determinant - 1.0).abs() < 1e-12);
}
