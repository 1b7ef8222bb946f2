//! The constructors: laws that hold as equality of handles, and values that they keep.

use lagrangian_symbolic::{Binary, Expression, Graph, Node, Rational, Symbol, Symmetry, Unary};
use lagrangian_symbolic_testing::bounded::Bounded;
use lagrangian_symbolic_testing::evaluate;
use lagrangian_symbolic_testing::tree::{at, points, trees};
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn normal_forms_keep_values(tree in trees(), point in points()) {
        let value = |symbol| Bounded::exact(at(&point, symbol));
        let written = tree.evaluate(&value);
        let mut graph = Graph::new();
        let root = tree.build(&mut graph);
        let normal = evaluate(&graph, root, value);
        if written.is_reliable() {
            prop_assert!(!normal.value.is_nan(), "{written:?} was lost: {:?}", graph.node(root));
            // Out of reach only if the bounds say so.
            prop_assert!(
                written.agrees(normal),
                "{written:?} became {normal:?}: {:?}", graph.node(root)
            );
        }
    }

    #[test]
    fn arithmetic_obeys_its_laws(trees in [trees(), trees(), trees()]) {
        let mut graph = Graph::new();
        let [x, y, z] = trees.map(|tree| tree.build(&mut graph));
        let (xy, yx) = (graph.add(x, y), graph.add(y, x));
        prop_assert_eq!(xy, yx);
        let (xy, yx) = (graph.multiply(x, y), graph.multiply(y, x));
        prop_assert_eq!(xy, yx);
        let difference = graph.subtract(x, x);
        prop_assert_eq!(difference, graph.zero());
        let yz = graph.multiply(y, z);
        // Long products are not merged.
        prop_assume!([xy, yz].iter().all(|product| operands(&graph, *product) <= 16));
        let (left, right) = (graph.multiply(xy, z), graph.multiply(x, yz));
        let names = lagrangian_symbolic::Names::default();
        prop_assert!(left == right, "{} and {}", graph.display(left, &names), graph.display(right, &names));
    }
}

/// How many operands an expression has, a multiple being what it is a multiple of.
fn operands(graph: &Graph, expression: Expression) -> usize {
    match graph.node(expression) {
        Node::Sum(terms) if terms.len() == 1 => operands(graph, terms[0].0),
        Node::Sum(parts) | Node::Product(parts) => parts.len(),
        _ => 1,
    }
}

/// A graph with x and y, and exact numbers by their literals.
fn start() -> (Graph, Expression, Expression) {
    let mut graph = Graph::new();
    let x = graph.symbol(Symbol::Coordinate(0));
    let y = graph.symbol(Symbol::Coordinate(1));
    (graph, x, y)
}

fn ratio(numerator: i64, denominator: i64) -> Rational {
    Rational::new(numerator, denominator).unwrap()
}

#[test]
fn sums_collect_and_products_too() {
    let (mut graph, x, y) = start();
    let two = Rational::integer(2);
    let sum = graph.add(x, y);
    let scaled = graph.scale(sum, &two);
    assert_eq!(scaled, graph.sum([(x, two.clone()), (y, two.clone())]));
    let square = graph.square(scaled);
    let other = graph.square(sum);
    assert_eq!(square, graph.scale(other, &Rational::integer(4)));
    let quotient = graph.divide(scaled, sum);
    assert_eq!(quotient, graph.constant(&two));
    let (difference, opposite) = (graph.subtract(x, y), graph.subtract(y, x));
    assert_eq!(graph.negate(difference), opposite);
    let ratio = graph.divide(difference, opposite);
    assert_eq!(ratio, graph.constant(&Rational::MINUS_ONE));
}

#[test]
fn roots_keep_their_domain() {
    let (mut graph, x, y) = start();
    let root = graph.square_root(x);
    assert_eq!(graph.square(root), x);
    let square = graph.square(x);
    let size = graph.unary(Unary::Abs, x);
    assert_eq!(graph.square_root(square), size);
    assert_eq!(graph.square(size), square);
    // (x⁴)^¼ = |x|, (x⁶)^½ = |x|³, (√x)^⅓ = x^⅙.
    let fourth = graph.power(x, &Rational::integer(4));
    assert_eq!(graph.power(fourth, &ratio(1, 4)), size);
    let sixth = graph.power(x, &Rational::integer(6));
    let cube = graph.power(size, &Rational::integer(3));
    assert_eq!(graph.square_root(sixth), cube);
    let third = graph.power(root, &ratio(1, 3));
    assert_eq!(third, graph.power(x, &ratio(1, 6)));
    // (xy)^½ is not √x √y: both may be negative.
    let product = graph.multiply(x, y);
    let together = graph.square_root(product);
    let other = graph.square_root(y);
    assert_ne!(together, graph.multiply(root, other));
    assert_eq!(graph.square(together), product);
}

#[test]
fn constants_fold_where_they_are_exact() {
    let (mut graph, x, _) = start();
    let two = graph.integer(2);
    let root = graph.square_root(two);
    assert!(graph.as_constant(root).is_none());
    assert_eq!(graph.multiply(root, root), two);
    let nine_quarters = graph.constant(&ratio(9, 4));
    let root = graph.square_root(nine_quarters);
    assert_eq!(graph.as_constant(root), Some(&ratio(3, 2)));
    let minus_eight = graph.integer(-8);
    let no_value = graph.power(minus_eight, &ratio(1, 3));
    assert!(graph.evaluate(&[no_value], |_| 0.0)[0].is_nan());
    assert_eq!(graph.power(x, &Rational::ZERO), graph.one());
    assert_eq!(graph.power(x, &Rational::ONE), x);
}

#[test]
fn what_divides_by_zero_keeps_no_value() {
    let (mut graph, x, _) = start();
    let (zero, one) = (graph.zero(), graph.one());
    let minus_half = -&Rational::HALF;
    for without in [
        graph.divide(one, zero),
        graph.divide(x, zero),
        graph.divide(zero, zero),
        graph.power(zero, &minus_half),
        graph.power(zero, &Rational::integer(-3)),
    ] {
        let product = graph.multiply(zero, without);
        let sum = graph.add(x, without);
        let values = graph.evaluate(&[without, product, sum], |_| 0.5);
        assert!(!values.iter().any(|value| value.is_finite()), "{values:?}");
        let _ = graph.derivative(sum, Symbol::Coordinate(0));
    }
}

#[test]
fn signs_come_out_of_functions() {
    let (mut graph, x, y) = start();
    let minus_x = graph.negate(x);
    let (difference, opposite) = (graph.subtract(x, y), graph.subtract(y, x));
    for function in Unary::ALL {
        for (positive, negative) in [(x, minus_x), (difference, opposite), (opposite, difference)] {
            let f = graph.unary(function, positive);
            let g = graph.unary(function, negative);
            match function.symmetry() {
                Symmetry::Even => assert_eq!(g, f),
                Symmetry::Odd => assert_eq!(g, graph.negate(f)),
                Symmetry::None => assert_ne!(g, f),
            }
        }
    }
    let zero = graph.zero();
    assert_eq!(graph.unary(Unary::Signum, zero), zero);
    let scaled = graph.scale(x, &Rational::integer(-3));
    let size = graph.unary(Unary::Abs, x);
    assert_eq!(
        graph.unary(Unary::Abs, scaled),
        graph.scale(size, &Rational::integer(3))
    );
    let sign = graph.unary(Unary::Signum, x);
    assert_eq!(graph.unary(Unary::Signum, scaled), graph.negate(sign));
}

#[test]
fn inverse_functions_undo_one_another() {
    let (mut graph, x, y) = start();
    let ln = graph.unary(Unary::Ln, x);
    assert_eq!(graph.unary(Unary::Exp, ln), x);
    let exp = graph.unary(Unary::Exp, x);
    assert_eq!(graph.unary(Unary::Ln, exp), x);
    for function in [Binary::Min, Binary::Max] {
        assert_eq!(graph.binary(function, x, x), x);
        assert_eq!(graph.binary(function, x, y), graph.binary(function, y, x));
        let (two, three) = (graph.integer(2), graph.integer(3));
        let expected = if function == Binary::Min { two } else { three };
        assert_eq!(graph.binary(function, two, three), expected);
        assert_eq!(graph.binary(function, three, two), expected);
    }
    let half = graph.constant(&Rational::HALF);
    assert_eq!(graph.binary(Binary::Power, x, half), graph.square_root(x));
}

#[test]
fn numbers_and_common_factors_come_out_of_integer_powers() {
    let (mut graph, x, y) = start();
    // (2x + 4y)³ = 8 (x + 2y)³, and (x y + x)² = x² (y + 1)².
    let rest = graph.sum([(x, Rational::ONE), (y, Rational::integer(2))]);
    let twice = graph.scale(rest, &Rational::integer(2));
    let three = Rational::integer(3);
    let cube = graph.power(rest, &three);
    assert_eq!(
        graph.power(twice, &three),
        graph.scale(cube, &Rational::integer(8))
    );
    let product = graph.multiply(x, y);
    let sum = graph.add(product, x);
    let shifted = graph.add_constant(y, &Rational::ONE);
    let two = Rational::integer(2);
    let expected = graph.product([(x, two.clone()), (shifted, two)]);
    assert_eq!(graph.square(sum), expected);
    // Of roots nothing comes out: of x (y + 1) both may be negative.
    let root = graph.square_root(sum);
    assert!(matches!(graph.node(root), Node::Product(factors) if factors.len() == 1));
    // A sum with a number that is not common keeps it.
    let with_number = graph.add_constant(twice, &Rational::ONE);
    let square = graph.square(with_number);
    assert!(matches!(graph.node(square), Node::Product(factors) if factors.len() == 1));
}

#[test]
fn integer_powers_are_distributed_over_products_and_no_others() {
    let (mut graph, x, y) = start();
    let product = graph.multiply(x, y);
    let minus_two = Rational::integer(-2);
    let expected = graph.product([(x, minus_two.clone()), (y, minus_two.clone())]);
    assert_eq!(graph.power(product, &minus_two), expected);
    // (x³)^⅓ = x, as x³ has a real root; (x²)^⅓ = |x|^⅔; (x y)^⅓ stays, and (x y²)^½ too.
    let third = ratio(1, 3);
    let [square, cube] = [2, 3].map(|k| graph.power(x, &Rational::integer(k)));
    assert_eq!(graph.power(cube, &third), x);
    let size = graph.unary(Unary::Abs, x);
    let expected = graph.power(size, &ratio(2, 3));
    assert_eq!(graph.power(square, &third), expected);
    let y2 = graph.square(y);
    let mixed = graph.multiply(x, y2);
    for (base, exponent) in [(product, third), (mixed, Rational::HALF)] {
        let power = graph.power(base, &exponent);
        assert!(
            matches!(graph.node(power), Node::Product(factors) if **factors == [(base, exponent)])
        );
    }
    // √(4 x² y²) = 2 |x| |y|, (9 x⁻²)^(3/2) = 27 |x|⁻³, and √(2 x²) = √2 |x|.
    let squares = graph.multiply(square, y2);
    let squares = graph.scale(squares, &Rational::integer(4));
    let size_y = graph.unary(Unary::Abs, y);
    let expected = graph.multiply(size, size_y);
    let root = graph.square_root(squares);
    assert_eq!(root, graph.scale(expected, &Rational::integer(2)));
    let inverse = graph.power(x, &minus_two);
    let inverse = graph.scale(inverse, &Rational::integer(9));
    let expected = graph.power(size, &Rational::integer(-3));
    let power = graph.power(inverse, &ratio(3, 2));
    assert_eq!(power, graph.scale(expected, &Rational::integer(27)));
    let double = graph.scale(square, &Rational::integer(2));
    let two = graph.integer(2);
    let root_of_two = graph.square_root(two);
    let expected = graph.multiply(root_of_two, size);
    assert_eq!(graph.square_root(double), expected);
    // Of −4 x² there is no root.
    let negative = graph.scale(square, &Rational::integer(-4));
    let root = graph.square_root(negative);
    assert!(matches!(graph.node(root), Node::Product(factors) if factors[0].0 == negative));
    // |x|³ is not x³, and (−x)^½ is no multiple of √x.
    let cubed = graph.power(size, &Rational::integer(3));
    assert_ne!(cubed, cube);
    let minus = graph.negate(x);
    let root = graph.square_root(minus);
    assert!(matches!(graph.node(root), Node::Product(factors) if factors[0].0 == minus));
    assert_eq!(graph.multiply(size, size), square);
}

#[test]
fn short_sums_and_products_merge_and_long_ones_stay() {
    let mut graph = Graph::new();
    let letters: Vec<_> = (0..20).map(Symbol::Parameter).collect();
    let letters: Vec<_> = letters.into_iter().map(|x| graph.symbol(x)).collect();
    let mut counts = |length: usize| {
        let one = Rational::ONE;
        let first = letters[..length].iter().map(|x| (*x, one.clone()));
        let (sum, product) = (graph.sum(first.clone()), graph.product(first));
        let last = letters[19];
        let (sum, product) = (graph.add(sum, last), graph.multiply(product, last));
        [operands(&graph, sum), operands(&graph, product)]
    };
    assert_eq!(counts(8), [9, 9]);
    assert_eq!(counts(9), [2, 10]);
    assert_eq!(counts(16), [2, 17]);
    assert_eq!(counts(17), [2, 2]);
}

#[test]
fn inverse_functions_undo_one_another_only_where_that_is_true_everywhere() {
    let (mut graph, x, y) = start();
    let call = |graph: &mut Graph, f, g| {
        let inner = graph.unary(g, x);
        graph.unary(f, inner)
    };
    for (f, g) in [
        (Unary::Asin, Unary::Sin),
        (Unary::Acos, Unary::Cos),
        (Unary::Atan, Unary::Tan),
        (Unary::Acosh, Unary::Cosh),
    ] {
        assert_ne!(call(&mut graph, f, g), x, "{f:?} {g:?}");
    }
    // ln x² is not 2 ln x, and exp(2 ln x) has no value for negative x.
    let square = graph.square(x);
    let ln = graph.unary(Unary::Ln, x);
    let of_square = graph.unary(Unary::Ln, square);
    assert_ne!(of_square, graph.scale(ln, &Rational::integer(2)));
    let double = graph.scale(ln, &Rational::integer(2));
    assert_ne!(graph.unary(Unary::Exp, double), square);
    // ‖x‖ = |x|; the sign of a sign is not looked for; atan2 has an order.
    let size = graph.unary(Unary::Abs, x);
    assert_eq!(graph.unary(Unary::Abs, size), size);
    let angle = graph.binary(Binary::Atan2, x, y);
    assert_ne!(angle, graph.binary(Binary::Atan2, y, x));
    let mixed = graph.binary(Binary::Min, x, y);
    assert_ne!(mixed, graph.binary(Binary::Max, x, y));
    // x^y with an y that is no number stays a power of real numbers.
    let power = graph.binary(Binary::Power, x, y);
    assert!(matches!(graph.node(power), Node::Binary(Binary::Power, ..)));
}

/// √(cosh²x − 1) − sinh x and its derivative are zero for x > 0, which the normal form does not see: what both are factors of
/// is divided by neither.
#[test]
fn factors_that_vanish_unseen_divide_nothing() {
    let (mut graph, x, y) = start();
    let cosh = graph.unary(Unary::Cosh, x);
    let sinh = graph.unary(Unary::Sinh, x);
    let square = graph.square(cosh);
    let below = graph.add_constant(square, &Rational::MINUS_ONE);
    let root = graph.power(below, &ratio(1, 2));
    let zero = graph.subtract(root, sinh);
    let slope = graph.derivative(zero, Symbol::Coordinate(0));
    let product = graph.multiply(zero, slope);
    let [first, second] = [graph.multiply(product, y), graph.multiply(slope, x)];
    let sum = graph.add(first, second);
    let quotient = graph.divide(sum, y);
    let found = evaluate(&graph, quotient, |symbol| {
        Bounded::exact(if symbol == Symbol::Coordinate(0) {
            1.072_600_324_179_924_2
        } else {
            0.7
        })
    });
    assert!(
        !found.value.is_nan(),
        "{}",
        graph.display(quotient, &lagrangian_symbolic::Names::default())
    );
}
