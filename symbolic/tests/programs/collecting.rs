//! Sums that are computed anyway are found again among the multiples of a factor, where that saves work.

use lagrangian_symbolic::{Expression, Graph, Program, Rational, Symbol, Unary};

/// Additions and multiplications of the program that computes the roots, which is verified.
#[track_caller]
fn operations(graph: &Graph, roots: &[Expression]) -> [usize; 2] {
    let program = Program::schedule(graph, &[roots]);
    assert_eq!(program.verify(graph, &[roots]), Ok(()));
    let count = program.count();
    [count.additions, count.multiplications]
}

fn start<const N: usize>() -> (Graph, [Expression; N]) {
    let mut graph = Graph::new();
    let symbols: Vec<_> = (0..).map(Symbol::Coordinate).take(N).collect();
    let letters: Vec<_> = symbols.into_iter().map(|x| graph.symbol(x)).collect();
    (graph, core::array::from_fn(|i| letters[i]))
}

fn sum(graph: &mut Graph, terms: &[(Expression, i64)]) -> Expression {
    graph.sum(terms.iter().map(|(x, c)| (*x, Rational::integer(*c))))
}

#[test]
fn rates_of_angular_velocities_contain_angular_velocities() {
    // (4.4): ẇ₁ = φ̇ θ̇ cos θ sin ψ + ψ̇ w₂ + …, ẇ₂ = φ̇ θ̇ cos θ cos ψ − ψ̇ w₁ + …
    let mut graph = Graph::new();
    let [theta, psi] = [1, 2].map(|i| graph.symbol(Symbol::Coordinate(i)));
    let [vphi, vtheta] = [0, 1].map(|i| graph.symbol(Symbol::Velocity(i)));
    let vpsi = graph.symbol(Symbol::Velocity(2));
    let [sin, cos] = [Unary::Sin, Unary::Cos];
    let sine = graph.unary(sin, theta);
    let [sp, cp] = [sin, cos].map(|function| graph.unary(function, psi));
    let around = graph.multiply(vphi, sine);
    let forms = [(sp, cp, 1), (cp, sp, -1)].map(|(first, second, sign)| {
        let (a, b) = (
            graph.multiply(around, first),
            graph.multiply(vtheta, second),
        );
        sum(&mut graph, &[(a, 1), (b, sign)])
    });
    assert_eq!(operations(&graph, &forms), [2, 5]);
    let direction = [(theta, vtheta), (psi, vpsi)].map(|(x, rate)| {
        let index = if x == theta { 1 } else { 2 };
        (Symbol::Coordinate(index), rate)
    });
    let rates = graph.directional_derivatives(&forms, &direction.into());
    // The rates add φ̇ cos θ, its products with θ̇ sin ψ and θ̇ cos ψ, those of ψ̇, and two sums.
    let all = [&forms[..], &rates].concat();
    assert_eq!(operations(&graph, &all), [4, 10]);
}

#[test]
fn a_multiple_of_a_known_sum_is_one_product() {
    let (mut graph, [x, y, z, f]) = start();
    // s = x + 2 y, and −3 f x − 6 f y + z = z − 3 f s.
    let known = sum(&mut graph, &[(x, 1), (y, 2)]);
    let [fx, fy] = [x, y].map(|x| graph.multiply(f, x));
    let multiple = sum(&mut graph, &[(fx, -3), (fy, -6), (z, 1)]);
    assert_eq!(operations(&graph, &[known, multiple]), [2, 3]);
    // Other ratios are another sum: f (−3 x + 6 y) + z.
    let other = sum(&mut graph, &[(fx, -3), (fy, 6), (z, 1)]);
    let alone = operations(&graph, &[other]);
    let [additions, multiplications] = operations(&graph, &[known, other]);
    assert_eq!(alone, [2, 3]);
    assert_eq!([additions, multiplications], [3, 4]);
}

#[test]
fn a_sum_of_which_a_part_is_missing_is_not_taken() {
    let (mut graph, [x, y, z, f]) = start();
    let known = sum(&mut graph, &[(x, 1), (y, 1), (z, 1)]);
    let [fx, fy] = [x, y].map(|x| graph.multiply(f, x));
    let part = graph.add(fx, fy);
    // f (x + y), and x + y + z shares its beginning.
    assert_eq!(operations(&graph, &[known, part]), [2, 1]);
}

#[test]
fn what_saves_nothing_is_left() {
    // f x and f y are computed anyway: their sum is one addition, f (x + y) would be one product.
    let (mut graph, [x, y, f]) = start();
    let known = graph.add(x, y);
    let [fx, fy] = [x, y].map(|x| graph.multiply(f, x));
    let total = graph.add(fx, fy);
    assert_eq!(operations(&graph, &[known, fx, fy, total]), [2, 2]);
    // With one of them f (x + y) saves f y and an addition.
    assert_eq!(operations(&graph, &[known, fx, total]), [1, 2]);
    assert_eq!(operations(&graph, &[known, total]), [1, 1]);
}

#[test]
fn a_sum_is_collected_whichever_was_written_first() {
    // A sum is looked for among earlier values only, so that none waits for itself; what comes later is
    // found when factors are taken out.
    let (mut graph, [x, y, f]) = start();
    let [fx, fy] = [x, y].map(|x| graph.multiply(f, x));
    let total = graph.add(fx, fy);
    let known = graph.add(x, y);
    assert!(total < known);
    assert_eq!(operations(&graph, &[total, known]), [1, 1]);
    // Two sums that are each other's multiples: f x + f y and f g x + f g y, with x + y.
    let (mut graph, [x, y, f, g]) = start();
    let products = [f, g].map(|f| [x, y].map(|x| graph.multiply(f, x)));
    let [first, second] = products.map(|[x, y]| graph.add(x, y));
    let longer = [x, y].map(|x| {
        let both = graph.multiply(f, g);
        graph.multiply(both, x)
    });
    let third = graph.add(longer[0], longer[1]);
    let [_, multiplications] = operations(&graph, &[third, first, second]);
    assert!(multiplications <= 4, "{multiplications}");
}
