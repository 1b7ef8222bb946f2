//! Printed formulas, read back by a parser that knows nothing of the printer.

use lagrangian_symbolic::{Graph, Letters, Names, Symbol, Unary};
use lagrangian_symbolic_testing::bounded::Bounded;
use lagrangian_symbolic_testing::evaluate;
use lagrangian_symbolic_testing::reader::Reader;
use lagrangian_symbolic_testing::tree::{at, points, trees};
use proptest::prelude::*;

fn names() -> Names {
    let list = |names: [&str; 2]| names.map(String::from).into();
    Names {
        coordinates: list(["x", "theta2"]),
        parameters: list(["a", "mass"]),
        ..Names::default()
    }
}

/// The symbol that a printed name means.
fn symbol(name: &str) -> Symbol {
    match name {
        "x" => Symbol::Coordinate(0),
        "θ₂" | "\\theta_2" => Symbol::Coordinate(1),
        "x\u{307}" | "dot x" => Symbol::Velocity(0),
        "θ\u{308}₂" | "ddot \\theta_2" => Symbol::Acceleration(1),
        "a" => Symbol::Parameter(0),
        "mass" => Symbol::Parameter(1),
        _ => panic!("{name:?} is no name"),
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn what_is_printed_means_what_it_should(tree in trees(), point in points()) {
        let mut graph = Graph::new();
        let root = tree.build(&mut graph);
        let value = |symbol| Bounded::exact(at(&point, symbol));
        let expected = evaluate(&graph, root, value);
        let names = names();
        let unicode = graph.display(root, &names).to_string();
        let latex = graph.latex(root, &names).to_string();
        let letters = Letters::new(&names);
        let mut texts = vec![unicode, latex];
        for arranged in [
            graph.arranged(root, &letters),
            graph.arranged_by_velocities(root, &letters),
        ] {
            let formula = graph.display_in(arranged, &letters);
            texts.extend([formula.to_string(), formula.in_latex().to_string()]);
        }
        for text in texts {
            let plain = text.replace("\\mathrm{mass}", "mass");
            let read = Reader::read(&plain, &|name| value(symbol(name)));
            if expected.is_reliable() {
                prop_assert!(!read.value.is_nan(), "{text}");
                prop_assert!(read.agrees(expected), "{text}: {read:?} for {expected:?}");
            }
        }
    }
}

#[test]
fn bars_within_bars_are_read() {
    let mut graph = Graph::new();
    let [x, y] = [0, 1].map(|index| graph.symbol(Symbol::Coordinate(index)));
    // |x + |x + y||·|y|
    let sum = graph.add(x, y);
    let inner = graph.unary(Unary::Abs, sum);
    let sum = graph.add(x, inner);
    let outer = graph.unary(Unary::Abs, sum);
    let size = graph.unary(Unary::Abs, y);
    let product = graph.multiply(outer, size);
    let names = names();
    for text in [
        graph.display(product, &names).to_string(),
        graph.latex(product, &names).to_string(),
    ] {
        let value = |name: &str| match symbol(name) {
            Symbol::Coordinate(0) => -3.0,
            _ => 5.0,
        };
        let read = Reader::read(&text, &|name| Bounded::exact(value(name)));
        assert!(read.agrees(Bounded::exact(5.0)), "{text}: {read:?}");
    }
}
