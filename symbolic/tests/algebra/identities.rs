//! Decisions at random points: what vanishes identically, and what does not.

use lagrangian_symbolic::{Binary, Expression, Graph, ModularPoint, Rational, Symbol, Unary};

/// Writes one expression of x and y.
type Write = fn(&mut Graph, Expression, Expression) -> Expression;

fn start() -> (Graph, Expression, Expression) {
    let mut graph = Graph::new();
    let x = graph.symbol(Symbol::Coordinate(0));
    let y = graph.symbol(Symbol::Velocity(3));
    (graph, x, y)
}

/// The values at points that have them, of the first twenty.
fn values(write: Write) -> Vec<u64> {
    let (mut graph, x, y) = start();
    let root = write(&mut graph, x, y);
    (0..20)
        .filter_map(|seed| ModularPoint::new(seed).evaluate(&graph, &[root]))
        .map(|values| values[0])
        .collect()
}

fn call(graph: &mut Graph, function: Unary, x: Expression) -> Expression {
    graph.unary(function, x)
}

/// f(x)² + sign·g(x)² − 1.
fn squares(graph: &mut Graph, f: Unary, sign: i64, g: Unary, x: Expression) -> Expression {
    let (f, g) = (call(graph, f, x), call(graph, g, x));
    let (f, g) = (graph.square(f), graph.square(g));
    let one = graph.one();
    graph.sum([
        (f, Rational::ONE),
        (g, Rational::integer(sign)),
        (one, Rational::MINUS_ONE),
    ])
}

/// f(x + y) − (f(x) g(y) + sign·g(x) f(y)).
fn addition(graph: &mut Graph, f: Unary, g: Unary, x: Expression, y: Expression) -> Expression {
    let sum = graph.add(x, y);
    let whole = call(graph, f, sum);
    let [fx, fy, gx, gy] = [(f, x), (f, y), (g, x), (g, y)].map(|(f, x)| call(graph, f, x));
    let (first, second) = (graph.multiply(fx, gy), graph.multiply(gx, fy));
    let expanded = graph.add(first, second);
    graph.subtract(whole, expanded)
}

/// f(2x) − 1 + sign·2 g(x)².
fn doubled(graph: &mut Graph, f: Unary, sign: i64, g: Unary, x: Expression) -> Expression {
    let twice = graph.scale(x, &Rational::integer(2));
    let (f, g) = (call(graph, f, twice), call(graph, g, x));
    let g = graph.square(g);
    let one = graph.one();
    graph.sum([
        (f, Rational::ONE),
        (one, Rational::MINUS_ONE),
        (g, Rational::integer(2 * sign)),
    ])
}

/// q(x) − f(x)/g(x).
fn quotient(graph: &mut Graph, q: Unary, f: Unary, g: Unary, x: Expression) -> Expression {
    let [q, f, g] = [q, f, g].map(|function| call(graph, function, x));
    let quotient = graph.divide(f, g);
    graph.subtract(q, quotient)
}

/// x + y and x² y, whose roots and sizes do not simplify.
fn compound(graph: &mut Graph, x: Expression, y: Expression) -> Expression {
    let square = graph.square(x);
    let product = graph.multiply(square, y);
    let sum = graph.add(x, y);
    graph.add(product, sum)
}

const VANISHING: [(&str, Write); 17] = [
    ("sin² + cos² − 1", |g, x, _| {
        squares(g, Unary::Sin, 1, Unary::Cos, x)
    }),
    ("sin² + cos² − 1 of x² y + x + y", |g, x, y| {
        let z = compound(g, x, y);
        squares(g, Unary::Sin, 1, Unary::Cos, z)
    }),
    ("cosh² − sinh² − 1", |g, x, _| {
        squares(g, Unary::Cosh, -1, Unary::Sinh, x)
    }),
    ("sin(x + y)", |g, x, y| {
        addition(g, Unary::Sin, Unary::Cos, x, y)
    }),
    ("sinh(x + y)", |g, x, y| {
        addition(g, Unary::Sinh, Unary::Cosh, x, y)
    }),
    ("sin 2x", |g, x, _| {
        addition(g, Unary::Sin, Unary::Cos, x, x)
    }),
    ("cos 2x = 1 − 2 sin²", |g, x, _| {
        doubled(g, Unary::Cos, 1, Unary::Sin, x)
    }),
    ("cosh 2x = 1 + 2 sinh²", |g, x, _| {
        doubled(g, Unary::Cosh, -1, Unary::Sinh, x)
    }),
    ("cos x = 1 − 2 sin² x/2", |g, x, _| {
        let half = g.scale(x, &Rational::HALF);
        doubled(g, Unary::Cos, 1, Unary::Sin, half)
    }),
    ("tan = sin/cos", |g, x, _| {
        quotient(g, Unary::Tan, Unary::Sin, Unary::Cos, x)
    }),
    ("tanh = sinh/cosh", |g, x, _| {
        quotient(g, Unary::Tanh, Unary::Sinh, Unary::Cosh, x)
    }),
    ("exp x exp y = exp(x + y)", |g, x, y| {
        let [a, b] = [x, y].map(|x| call(g, Unary::Exp, x));
        let product = g.multiply(a, b);
        let sum = g.add(x, y);
        let exp = call(g, Unary::Exp, sum);
        g.subtract(product, exp)
    }),
    ("cosh + sinh = exp", |g, x, _| {
        let [a, b, c] = [Unary::Cosh, Unary::Sinh, Unary::Exp].map(|f| call(g, f, x));
        let sum = g.add(a, b);
        g.subtract(sum, c)
    }),
    ("(√z)² = z", |g, x, y| {
        let z = compound(g, x, y);
        let root = g.square_root(z);
        let rooted = g.multiply(root, y);
        let square = g.square(rooted);
        let y2 = g.square(y);
        let direct = g.multiply(z, y2);
        g.subtract(square, direct)
    }),
    ("|z|² = z² through factors", |g, x, y| {
        let sum = g.add(x, y);
        let [size, minus] = [call(g, Unary::Abs, sum), g.negate(sum)];
        // (|z| − z)(|z| + z), expanded by the values only.
        let (below, above) = (g.add(size, minus), g.add(size, sum));
        g.multiply(below, above)
    }),
    ("max + min = x + y", |g, x, y| {
        let [a, b] = [Binary::Max, Binary::Min].map(|f| g.binary(f, x, y));
        g.sum([
            (a, Rational::ONE),
            (b, Rational::ONE),
            (x, Rational::MINUS_ONE),
            (y, Rational::MINUS_ONE),
        ])
    }),
    ("(x + y)² = x² + 2xy + y²", |g, x, y| {
        let sum = g.add(x, y);
        let square = g.square(sum);
        let (x2, y2, xy) = (g.square(x), g.square(y), g.multiply(x, y));
        let expanded = g.sum([
            (x2, Rational::ONE),
            (xy, Rational::integer(2)),
            (y2, Rational::ONE),
        ]);
        g.subtract(square, expanded)
    }),
];

const DIFFERENT: [(&str, Write); 12] = [
    ("cosh − cos", |g, x, _| {
        difference(g, Unary::Cosh, Unary::Cos, x)
    }),
    ("exp − cos", |g, x, _| {
        difference(g, Unary::Exp, Unary::Cos, x)
    }),
    ("sinh − sin", |g, x, _| {
        difference(g, Unary::Sinh, Unary::Sin, x)
    }),
    ("tan − tanh", |g, x, _| {
        difference(g, Unary::Tan, Unary::Tanh, x)
    }),
    ("asin − atan", |g, x, _| {
        difference(g, Unary::Asin, Unary::Atan, x)
    }),
    ("sin x − x", |g, x, _| {
        let sin = call(g, Unary::Sin, x);
        g.subtract(sin, x)
    }),
    ("sin² − cos² − 1", |g, x, _| {
        squares(g, Unary::Sin, -1, Unary::Cos, x)
    }),
    ("cos 2x = 1 + 2 sin²", |g, x, _| {
        doubled(g, Unary::Cos, -1, Unary::Sin, x)
    }),
    ("sin 1 − 1", |g, _, _| {
        let one = g.one();
        let sin = call(g, Unary::Sin, one);
        g.subtract(sin, one)
    }),
    ("√x − x", |g, x, _| {
        let root = g.square_root(x);
        g.subtract(root, x)
    }),
    ("x^⅓ − x^⅕", |g, x, _| {
        let [a, b] = [3, 5].map(|n| g.power(x, &Rational::new(1, n).unwrap()));
        g.subtract(a, b)
    }),
    ("x − y", Graph::subtract),
];

fn difference(graph: &mut Graph, f: Unary, g: Unary, x: Expression) -> Expression {
    let (f, g) = (call(graph, f, x), call(graph, g, x));
    graph.subtract(f, g)
}

#[test]
fn identities_vanish_at_every_point() {
    for (what, write) in VANISHING {
        let values = values(write);
        assert!(values.len() >= 5, "{what} has few values");
        assert!(values.iter().all(|value| *value == 0), "{what}: {values:?}");
    }
}

#[test]
fn what_is_no_identity_vanishes_nowhere() {
    for (what, write) in DIFFERENT {
        let values = values(write);
        assert!(values.len() >= 5, "{what} has few values");
        assert!(!values.contains(&0), "{what} vanishes");
    }
}

#[test]
fn what_cannot_vanish_by_itself_is_not_decided_by_the_constructors() {
    // Else the tests above would say nothing about points.
    let decided = VANISHING.iter().filter(|(_, write)| {
        let (mut graph, x, y) = start();
        write(&mut graph, x, y) == graph.zero()
    });
    let decided: Vec<_> = decided.map(|(what, _)| *what).collect();
    assert_eq!(
        decided,
        [
            "sin² + cos² − 1",
            "sin² + cos² − 1 of x² y + x + y",
            "tanh = sinh/cosh",
            "(√z)² = z"
        ]
    );
}

#[test]
fn a_moved_symbol_moves_only_what_contains_it() {
    let (mut graph, x, y) = start();
    let sin = graph.unary(Unary::Sin, x);
    let point = ModularPoint::new(7);
    let moved = point.moving(Symbol::Coordinate(0));
    let (before, after) = (
        point.evaluate(&graph, &[sin, y]),
        moved.evaluate(&graph, &[sin, y]),
    );
    let (before, after) = (before.unwrap(), after.unwrap());
    assert_ne!(before[0], after[0]);
    assert_eq!(before[1], after[1]);
}
