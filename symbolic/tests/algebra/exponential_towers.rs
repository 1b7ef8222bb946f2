//! Exponentials of exponentials: derivatives up to the third are numbers wherever they are in the reals, and right.

use lagrangian_symbolic::{Expression, Graph, Program, Rational, Symbol, Unary};

const X: Symbol = Symbol::Coordinate(0);
const A: Symbol = Symbol::Parameter(0);

/// A function and its first three derivatives by x, as a program.
fn program(build: impl Fn(&mut Graph, Expression) -> Expression) -> Program {
    let mut graph = Graph::new();
    let x = graph.symbol(X);
    let mut roots = vec![build(&mut graph, x)];
    for order in 0..3 {
        let next = graph.derivative(roots[order], X);
        roots.push(next);
    }
    let program = Program::schedule_for_staging(&graph, &[&roots]);
    assert_eq!(program.verify(&graph, &[&roots]), Ok(()));
    program
}

fn values(program: &Program, x: f64) -> Vec<f64> {
    let values = program.evaluate(|symbol| if symbol == A { 1.5 } else { x });
    values.concat()
}

fn exponential(graph: &mut Graph, x: Expression, factor: i64) -> Expression {
    let exponent = graph.scale(x, &Rational::integer(factor));
    graph.unary(Unary::Exp, exponent)
}

fn negative_exponential(graph: &mut Graph, x: Expression) -> Expression {
    exponential(graph, x, -1)
}

type Function = fn(&mut Graph, Expression) -> Expression;

const TOWERS: [(&str, Function); 6] = [
    ("exp(-exp(-x))", |graph, x| {
        let inner = exponential(graph, x, -1);
        negative_exponential(graph, inner)
    }),
    ("exp(-exp(3 x))", |graph, x| {
        let inner = exponential(graph, x, 3);
        negative_exponential(graph, inner)
    }),
    ("exp(-a exp(-x))", |graph, x| {
        let a = graph.symbol(A);
        let inner = exponential(graph, x, -1);
        let inner = graph.multiply(a, inner);
        negative_exponential(graph, inner)
    }),
    ("x exp(-exp(-x))", |graph, x| {
        let inner = exponential(graph, x, -1);
        let outer = negative_exponential(graph, inner);
        graph.multiply(x, outer)
    }),
    ("exp(-x² exp(-x))", |graph, x| {
        let inner = exponential(graph, x, -1);
        let square = graph.square(x);
        let inner = graph.multiply(square, inner);
        negative_exponential(graph, inner)
    }),
    ("exp(2 x - exp(x))", |graph, x| {
        let inner = exponential(graph, x, 1);
        let twice = graph.scale(x, &Rational::integer(2));
        let exponent = graph.subtract(twice, inner);
        graph.unary(Unary::Exp, exponent)
    }),
];

#[test]
fn derivatives_of_towers_are_numbers() {
    for (name, build) in TOWERS {
        let program = program(build);
        for x in [
            -1e4, -1e3, -720.0, -700.0, -240.0, -40.0, -8.0, 0.0, 8.0, 40.0, 240.0, 720.0, 1e4,
        ] {
            let found = values(&program, x);
            let are_finite = found.iter().all(|x| x.is_finite());
            assert!(are_finite, "{name} at {x}: {found:?}");
        }
    }
}

#[test]
fn derivatives_of_towers_are_right() {
    for (name, build) in TOWERS {
        let program = program(build);
        for x in [-4.0, -2.5, -1.0, -0.25, 0.0, 0.75, 1.5, 3.0] {
            let found = values(&program, x);
            // Central differences of fourth order.
            let h = f64::powi(2.0, -10);
            let at = [-2.0, -1.0, 1.0, 2.0].map(|k| values(&program, x + k * h));
            for order in 0..3 {
                let [a, b, c, d] = at.each_ref().map(|values| values[order]);
                let difference = (8.0 * (c - b) - (d - a)) / (12.0 * h);
                let size = at
                    .iter()
                    .flatten()
                    .fold(1.0, |most: f64, x| most.max(x.abs()));
                let error = (found[order + 1] - difference).abs();
                assert!(
                    error <= 1e-7 * size,
                    "{name} at {x}, order {}: {} {difference}",
                    order + 1,
                    found[order + 1]
                );
            }
        }
    }
}
