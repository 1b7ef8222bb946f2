//! Deep expressions: no pass recurses, and none grows faster than its input.

use std::collections::BTreeMap;
use std::thread;

use lagrangian_symbolic::{
    Binary, Expression, Graph, ModularPoint, Names, Rational, Symbol, Symmetry, Unary,
};
use lagrangian_symbolic_testing::bounded::Bounded;
use lagrangian_symbolic_testing::evaluate;

/// Deep enough: a frame of a hundred bytes a link would overflow the stack four times over.
const DEPTH: usize = 10_000;
/// Exact numbers that grow with every link cost more than nodes do.
const NUMBERS: usize = 200;
const MANY_NUMBERS: usize = 800;
const X: Symbol = Symbol::Coordinate(0);

/// Builds a chain, each link from the one before and x, and puts it through every pass.
fn survives(link: impl Fn(&mut Graph, Expression, Expression) -> Expression + Send + 'static) {
    survives_links(DEPTH, link);
}

fn survives_links(
    links: usize,
    link: impl Fn(&mut Graph, Expression, Expression) -> Expression + Send + 'static,
) {
    let small_stack = thread::Builder::new().stack_size(256 * 1024);
    let run = move || {
        let mut graph = Graph::new();
        let x = graph.symbol(X);
        let mut chain = x;
        for _ in 0..links {
            chain = link(&mut graph, chain, x);
        }
        let built = graph.len();
        assert!(built <= 6 * links, "{built} nodes");
        let derivative = graph.derivative(chain, X);
        let differentiated = graph.len();
        assert!(differentiated <= 40 * links, "{differentiated} nodes");
        let y = graph.symbol(Symbol::Parameter(0));
        graph.substitute(&[chain], &BTreeMap::from([(X, y)]));
        let _ = evaluate(&graph, derivative, |_| Bounded::exact(0.5));
        let _ = graph.evaluate(&[chain, derivative], |_| 0.5);
        let _ = ModularPoint::new(1).evaluate(&graph, &[chain, derivative]);
        let operands: usize = graph
            .nodes()
            .map(|(_, node)| {
                let mut count = 0;
                node.for_each_operand(|_| count += 1);
                count
            })
            .sum();
        assert!(operands <= 500 * links, "{operands} operands");
        let names = Names::default();
        for limit in [10, 4 * links] {
            let text = graph.display(chain, &names).limit(limit).to_string();
            assert!(text.chars().count() <= 3 * limit + 1);
            let text = graph.latex(chain, &names).limit(limit).to_string();
            assert_eq!(text.matches('{').count(), text.matches('}').count());
        }
    };
    small_stack.spawn(run).unwrap().join().unwrap();
}

#[test]
fn nested_functions() {
    survives(|graph, chain, _| graph.unary(Unary::Sin, chain));
}

#[test]
fn prefix_sums() {
    survives(|graph, chain, _| {
        let sin = graph.unary(Unary::Sin, chain);
        graph.add(chain, sin)
    });
}

#[test]
fn prefix_products() {
    survives(|graph, chain, x| {
        let next = graph.len().try_into().unwrap();
        let shifted = graph.add_constant(x, &Rational::integer(next));
        graph.multiply(chain, shifted)
    });
}

#[test]
fn products_with_functions() {
    survives(|graph, chain, _| {
        let cos = graph.unary(Unary::Cos, chain);
        graph.multiply(chain, cos)
    });
}

#[test]
fn powers() {
    survives(|graph, chain, _| {
        let square = graph.square(chain);
        graph.add_constant(square, &Rational::ONE)
    });
}

#[test]
fn squares() {
    survives(|graph, chain, _| graph.square(chain));
}

#[test]
fn roots() {
    survives(|graph, chain, _| graph.square_root(chain));
}

fn survives_multiples(links: usize) {
    survives_links(links, |graph, chain, _| {
        graph.scale(chain, &Rational::integer(9))
    });
}

fn survives_affine_maps(links: usize) {
    survives_links(links, |graph, chain, _| {
        let scaled = graph.scale(chain, &Rational::new(-7, 3).unwrap());
        graph.add_constant(scaled, &Rational::ONE)
    });
}

#[test]
fn multiples() {
    survives_multiples(NUMBERS);
}

#[test]
fn affine_maps() {
    survives_affine_maps(NUMBERS);
}

#[test]
#[ignore = "long chains; run with `--include-ignored`"]
fn many_multiples_and_affine_maps() {
    survives_multiples(MANY_NUMBERS);
    survives_affine_maps(MANY_NUMBERS);
}

#[test]
fn quotients() {
    survives(|graph, chain, x| {
        let below = graph.add_constant(chain, &Rational::ONE);
        graph.divide(x, below)
    });
}

#[test]
fn long_sums_with_a_minus_in_front() {
    survives(|graph, chain, x| {
        let sin = graph.unary(Unary::Sin, chain);
        let next = graph.multiply(sin, x);
        let difference = graph.subtract(next, chain);
        graph.unary(Unary::Abs, difference)
    });
}

#[test]
fn real_powers() {
    survives(|graph, chain, x| graph.binary(Binary::Power, x, chain));
}

/// What a chain prints to can be exactly said for nested functions.
#[test]
fn a_deep_formula_is_printed_completely() {
    let mut graph = Graph::new();
    let depth = 100_000;
    let mut chain = graph.symbol(X);
    for _ in 0..depth {
        chain = graph.unary(Unary::Sin, chain);
    }
    let text = graph
        .display(chain, &Names::default())
        .limit(usize::MAX)
        .to_string();
    let expected = format!(
        "{}sin q₁{}",
        "sin(".repeat(depth - 1),
        ")".repeat(depth - 1)
    );
    assert!(text == expected);
}

/// Sharing can be worth exponentially many characters.
#[test]
fn a_limit_breaks_off_what_is_shared_too_often() {
    let mut graph = Graph::new();
    let mut chain = graph.symbol(X);
    for _ in 0..200 {
        let (sin, cos) = (
            graph.unary(Unary::Sin, chain),
            graph.unary(Unary::Cos, chain),
        );
        chain = graph.multiply(sin, cos);
    }
    let text = graph
        .display(chain, &Names::default())
        .limit(60)
        .to_string();
    assert_eq!(text.matches('(').count(), text.matches(')').count());
    assert_eq!(text.matches('…').count(), 1);
    assert!(text.chars().count() < 120);
}

/// A long sum is no opposite of its negative, which has as many minus signs.
#[test]
fn signs_of_long_sums_settle() {
    let mut graph = Graph::new();
    let terms = (0..12).map(Symbol::Parameter);
    let terms: Vec<_> = terms.map(|symbol| graph.symbol(symbol)).collect();
    let sum = graph.sum(terms.into_iter().map(|x| (x, Rational::MINUS_ONE)));
    let negative = graph.negate(sum);
    for function in Unary::ALL {
        let (f, g) = (graph.unary(function, sum), graph.unary(function, negative));
        match function.symmetry() {
            Symmetry::Even => assert_eq!(f, g),
            Symmetry::Odd => assert_eq!(f, graph.negate(g)),
            Symmetry::None => assert_ne!(f, g),
        }
    }
}
