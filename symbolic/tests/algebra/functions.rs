//! External functions, known by their names and derivatives alone.

use lagrangian_symbolic::{
    Equations, Expression, ExternalFunction, Graph, Kinetics, Model, ModularPoint, Node, Operation,
    Program, Rational, Symbol, Unary,
};
use lagrangian_symbolic_testing::bounded::Bounded;
use lagrangian_symbolic_testing::dual::Dual;
use lagrangian_symbolic_testing::machine::run;
use lagrangian_symbolic_testing::tree::{SYMBOLS, applications, at, points};
use lagrangian_symbolic_testing::{Draft, Quantity, assert_close, value};
use lagrangian_symbolic_testing::{evaluate, external};
use proptest::prelude::*;

const X: Symbol = Symbol::Coordinate(0);
const Y: Symbol = Symbol::Coordinate(1);

/// The functions of [`external`], and the coordinates x and y.
fn start() -> (Graph, [ExternalFunction; 3], [Expression; 2]) {
    let mut graph = Graph::new();
    let functions = external::functions(&mut graph);
    let letters = [X, Y].map(|symbol| graph.symbol(symbol));
    (graph, functions, letters)
}

/// The value of an external function.
fn known(function: ExternalFunction, arguments: &[f64]) -> f64 {
    let arguments: Vec<_> = arguments.iter().map(|x| Bounded::exact(*x)).collect();
    external::value(function, &arguments).value
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn values_are_those_of_what_was_written(tree in applications(), point in points()) {
        let value = |symbol| Bounded::exact(at(&point, symbol));
        let written = tree.evaluate(&value);
        let mut graph = Graph::new();
        let root = tree.build(&mut graph);
        let normal = evaluate(&graph, root, value);
        let program = Program::schedule_for_staging(&graph, &[&[root]]);
        let run = run(&program, value)[0][0];
        if written.is_reliable() {
            prop_assert!(normal.agrees(written), "{normal:?} for {written:?}");
            prop_assert!(run.agrees(written), "{run:?} for {written:?}");
        }
    }

    #[test]
    fn derivatives_are_those_of_dual_numbers(tree in applications(), point in points(), which in 0..SYMBOLS.len()) {
        let symbol = SYMBOLS[which];
        let dual = tree.evaluate(&|name| Dual::variable(at(&point, name), name == symbol));
        let mut graph = Graph::new();
        let root = tree.build(&mut graph);
        let derivative = graph.derivative(root, symbol);
        let symbolic = evaluate(&graph, derivative, |name| Bounded::exact(at(&point, name)));
        if dual.slope.is_reliable() && dual.value.is_reliable() {
            prop_assert!(symbolic.agrees(dual.slope), "{symbolic:?} for {:?}", dual.slope);
        }
    }
}

#[test]
fn derivatives_follow_the_chain_rule() {
    let (mut graph, [wave, slope, product], [x, y]) = start();
    let one = || Rational::ONE;
    // d w(x²)/dx = 2 s(x²) · 2 x.
    let square = graph.square(x);
    let root = graph.apply(wave, &[square]);
    let inner = graph.apply(slope, &[square]);
    let expected = graph.product([(inner, one()), (x, one())]);
    let expected = graph.scale(expected, &Rational::integer(4));
    assert_eq!(graph.derivative(root, X), expected);
    assert_eq!(graph.derivative(root, Y), graph.zero());
    // w″ = −4 w.
    let root = graph.apply(wave, &[x]);
    let first = graph.derivative(root, X);
    let minus_four = Rational::integer(-4);
    assert_eq!(graph.derivative(first, X), graph.scale(root, &minus_four));
    // d p(y, x)/dx is ∂p/∂y at (y, x): 2 y² s(x); the arguments are put in place all at once.
    let root = graph.apply(product, &[y, x]);
    let (square, slope) = (graph.square(y), graph.apply(slope, &[x]));
    let across = graph.product([(square, one()), (slope, one())]);
    assert_eq!(
        graph.derivative(root, X),
        graph.scale(across, &Rational::integer(2))
    );
    // Along x = y both arguments change: 2 x w(x) + 2 x² s(x).
    let root = graph.apply(product, &[x, x]);
    let derivative = graph.derivative(root, X);
    let value = graph.evaluate_with(&[derivative], |_| 0.7, known)[0];
    assert_close(value, 1.4 * 1.4_f64.sin() + 0.98 * 1.4_f64.cos());
}

#[test]
fn what_is_not_declared_is_a_function_of_its_own() {
    let mut graph = Graph::new();
    let lift = graph.declare_function("lift", &["alpha", "mach"]);
    let [x, y] = [X, Y].map(|symbol| graph.symbol(symbol));
    let constant = graph.constant(&Rational::HALF);
    graph.declare_derivative(lift, 0, constant);
    let root = graph.apply(lift, &[x, y]);
    assert_eq!(graph.derivative(root, X), constant);
    let unknown = graph.derivative(root, Y);
    let Node::Application(function, arguments) = graph.node(unknown).clone() else {
        panic!("{:?} is no application", graph.node(unknown));
    };
    assert_eq!(*arguments, [x, y]);
    assert_eq!(graph.undeclared(lift), None);
    assert_eq!(graph.declared_derivative(lift, 0), Some(constant));
    assert_eq!(graph.declared_derivative(lift, 1), None);
    assert_eq!(graph.undeclared(function), Some((lift, 1)));
    assert_eq!(graph.function_name(function), "∂lift/∂mach");
    // It is the same wherever it is needed, and has derivatives as any other.
    let elsewhere = graph.apply(lift, &[x, x]);
    let change = graph.derivative(elsewhere, X);
    let at_x = graph.apply(function, &[x, x]);
    assert_eq!(change, graph.add(constant, at_x));
    let second = graph.derivative(unknown, Y);
    let Node::Application(second, _) = *graph.node(second) else {
        panic!("the second derivative is no application");
    };
    assert_eq!(graph.undeclared(second), Some((function, 1)));
    assert_eq!(graph.function_name(second), "∂(∂lift/∂mach)/∂mach");
    // Which are needed is a matter of programs.
    let program = Program::schedule(&graph, &[&[root, change]]);
    assert_eq!(program.functions(), [lift, function]);
    // Without arguments there is nothing to differentiate by.
    let density = graph.declare_function("density", &[]);
    let root = graph.apply(density, &[]);
    assert_eq!(graph.derivative(root, X), graph.zero());
    // What is no argument has no derivative to declare.
    let zero = graph.zero();
    graph.declare_derivative(lift, 2, zero);
    let root = graph.apply(lift, &[y, x]);
    assert_eq!(graph.derivative(root, Y), constant);
}

#[test]
fn equal_arguments_have_equal_values_and_nothing_else_is_known() {
    let (mut graph, [wave, slope, product], [x, y]) = start();
    // (x + 1)² and x² + 2 x + 1 are different expressions of one value.
    let square = graph.square(x);
    let next = graph.add_constant(x, &Rational::ONE);
    let shut = graph.square(next);
    let open = [
        (square, Rational::ONE),
        (x, Rational::integer(2)),
        (graph.one(), Rational::ONE),
    ];
    let open = graph.sum(open);
    let mut of = |function, arguments: &[Expression]| graph.apply(function, arguments);
    let same = [of(wave, &[shut]), of(wave, &[open])];
    let others = [
        [of(wave, &[x]), of(slope, &[x])],
        [of(wave, &[x]), of(wave, &[y])],
        [of(product, &[x, y]), of(product, &[y, x])],
        [of(product, &[x, x]), of(product, &[x, y])],
        [of(product, &[x, y]), of(wave, &[x])],
    ];
    assert_ne!(same[0], same[1]);
    let values = |graph: &Graph, roots: [Expression; 2]| {
        [0, 1, 2].map(|seed| ModularPoint::new(seed).evaluate(graph, &roots).unwrap())
    };
    assert!(
        values(&graph, same)
            .iter()
            .all(|values| values[0] == values[1])
    );
    for roots in others {
        assert_ne!(roots[0], roots[1]);
        assert!(
            values(&graph, roots)
                .iter()
                .all(|values| values[0] != values[1])
        );
    }
}

#[test]
fn programs_apply_functions_once_and_in_order() {
    let (mut graph, [wave, _, product], [x, y]) = start();
    let a = graph.symbol(Symbol::Parameter(0));
    let inner = graph.apply(wave, &[x]);
    let constant = graph.apply(wave, &[a]);
    let shifted = graph.add(inner, constant);
    let outer = graph.apply(product, &[constant, shifted]);
    let roots = [graph.multiply(outer, inner), graph.add(outer, y), outer];
    let program = Program::schedule_for_staging(&graph, &[&roots]);
    assert_eq!(program.verify(&graph, &[&roots]), Ok(()));
    assert_eq!(program.count().functions, 3);
    assert_eq!(program.functions(), [wave, product]);
    let found = program.evaluate_with(value, known).concat();
    let expected = graph.evaluate_with(&roots, value, known);
    for (found, expected) in found.into_iter().zip(expected.clone()) {
        assert_close(found, expected);
    }
    assert!(
        program.evaluate(value)[0]
            .iter()
            .all(|value| value.is_nan())
    );
    assert_eq!(program.expand(&mut graph), [roots]);
    // What is applied to parameters alone is known before anything moves.
    let parts = program.hoist_invariants();
    assert_eq!(parts.setup.functions(), [wave]);
    assert_eq!(parts.setup.count().functions, 1);
    assert_eq!(parts.kernel.count().functions, 2);
    let invariants = parts.setup.evaluate_with(value, known).concat();
    let symbol = |symbol| match symbol {
        Symbol::Invariant(index) => invariants[index as usize],
        _ => value(symbol),
    };
    let found = parts.kernel.evaluate_with(symbol, known).concat();
    assert_eq!(found.len(), roots.len());
    for (found, expected) in found.into_iter().zip(expected) {
        assert_close(found, expected);
    }
    // A wrong argument is found out.
    let mut wrong = program;
    let instruction = wrong.groups[0].instructions.iter_mut().find(|instruction| {
        let operands = instruction.operation.operands();
        operands.count() == 2 && instruction.expression == Some(outer)
    });
    let instruction = instruction.unwrap();
    instruction.operation = match instruction.operation.clone() {
        Operation::Application(function, mut arguments) => {
            arguments.reverse();
            Operation::Application(function, arguments)
        }
        other => other,
    };
    assert!(wrong.verify(&graph, &[&roots]).is_err());
}

#[test]
fn a_function_is_not_taken_for_free() {
    let (mut graph, [wave, ..], [x, _]) = start();
    let root = graph.apply(wave, &[x]);
    let program = Program::schedule(&graph, &[&[root]]);
    assert_eq!(graph.cost(&[root]), program.count().cost());
    assert!(graph.cost(&[root]) >= Unary::Tanh.cost());
}

#[test]
fn contents_are_those_of_the_arguments() {
    let (mut graph, [wave, _, product], [x, _]) = start();
    let [v, a, u] = [Symbol::Velocity(0), Symbol::Parameter(0), Symbol::Input(0)]
        .map(|symbol| graph.symbol(symbol));
    let constant = graph.apply(wave, &[a]);
    assert!(!graph.contents(constant).varies());
    let moving = graph.apply(product, &[a, v]);
    assert!(graph.contents(moving).varies() && graph.contents(moving).has_velocity());
    let driven = graph.apply(product, &[u, x]);
    assert!(graph.contents(driven).has_input() && !graph.contents(driven).has_velocity());
}

#[test]
fn an_angle_within_an_external_function_is_none() {
    let properties = |of_sine: bool| {
        let draft = Draft::new(1);
        let [wave, ..] = external::functions(&mut draft.graph());
        let q = draft.q(0);
        let argument = if of_sine { (q / 3).sin() } else { q };
        let mut model = draft.natural(q.dot().squared() / 2, argument.through(wave));
        Equations::derive(&mut model).unwrap().coordinate_properties
    };
    assert_eq!(properties(true).angles, [true]);
    assert_eq!(properties(false).angles, [false]);
    assert_eq!(properties(true).periods, [3]);
    assert_eq!(properties(false).periods, [0]);
}

/// w(x), and sin 2x if w is not external.
fn wave_of(x: Quantity<'_>, wave: Option<ExternalFunction>) -> Quantity<'_> {
    wave.map_or_else(|| (2 * x).sin(), |wave| x.through(wave))
}

/// A particle on the curve (r, w(r)) beside one coupled to it, under a potential and a force, where w is
/// external or is sin 2x.
fn on_a_curve(is_external: bool) -> Model {
    let draft = Draft::new(2);
    let [wave, _, product] = external::functions(&mut draft.graph());
    let wave = is_external.then_some(wave);
    let ([x, y], [m, k]) = (draft.qs(), draft.ps());
    let height = wave_of(x, wave);
    let speeds = [x, height, y].map(|x| x.dot().squared());
    let potential = if is_external {
        let arguments = [x - y, height].map(Quantity::expression);
        draft.make(|graph| graph.apply(product, &arguments))
    } else {
        (x - y).squared() * wave_of(height, wave)
    };
    let drag = (-wave_of(y.dot(), wave)).expression();
    let mut model = draft.natural(m * draft.sum(speeds) / 2, k * potential);
    model.forces[1] = drag;
    model
}

#[test]
fn equations_with_functions_are_those_with_their_formulas() {
    let [found, expected] = [true, false].map(|is_external| {
        let mut model = on_a_curve(is_external);
        let equations = Equations::derive(&mut model).unwrap();
        let kinetics = Kinetics::cheapest(&mut model, &equations);
        let solution = kinetics.solution.as_ref().unwrap();
        assert!(solution.holds(&model.graph, &equations));
        let mut roots = solution.accelerations.clone();
        let symbols = [
            Symbol::Coordinate(0),
            Symbol::Coordinate(1),
            Symbol::Velocity(0),
            Symbol::Velocity(1),
        ];
        roots.extend(
            kinetics
                .acceleration_derivatives(&mut model.graph, &symbols)
                .unwrap(),
        );
        roots.push(equations.energy);
        let program = Program::schedule_for_staging(&model.graph, &[&roots]);
        assert_eq!(program.verify(&model.graph, &[&roots]), Ok(()));
        program.evaluate_with(value, known).concat()
    });
    assert!(found.iter().any(|value| value.abs() > 0.1));
    for (found, expected) in found.into_iter().zip(expected) {
        assert_close(found, expected);
    }
}

#[test]
fn a_function_of_a_velocity_is_no_polynomial() {
    // T = ½ (ẋ² + ẏ²) + w(ẏ): what is added to the squares is not linear.
    let draft = Draft::new(2);
    let [wave, ..] = external::functions(&mut draft.graph());
    let (y, [vx, vy]) = (draft.q(1), draft.vs());
    let kinetic = (vx.squared() + vy.squared()) / 2 + vy.through(wave);
    let mut model = draft.natural(kinetic, y);
    let equations = Equations::derive(&mut model).unwrap();
    let kinetics = Kinetics::cheapest(&mut model, &equations);
    let solution = kinetics.solution.unwrap();
    assert!(solution.holds(&model.graph, &equations));
}

#[test]
fn mixed_derivatives_that_are_declared_twice_are_no_contradiction() {
    // The height h(x, y) of a surface, whose mixed derivatives have different names: no way to q̈ takes
    // them for the same.
    let mut graph = Graph::new();
    let names = ["x", "y"];
    let height = graph.declare_function("h", &names);
    let slopes = ["hx", "hy"].map(|name| graph.declare_function(name, &names));
    let arguments = [0, 1].map(|i| graph.symbol(Symbol::Argument(i)));
    for (position, slope) in slopes.into_iter().enumerate() {
        let slope = graph.apply(slope, &arguments);
        graph.declare_derivative(height, position, slope);
    }
    let draft = Draft::of(graph, 2);
    let [x, y] = draft.qs();
    let arguments = [x, y].map(Quantity::expression);
    let z = draft.make(|graph| graph.apply(height, &arguments));
    let kinetic = draft.sum([x, y, z].map(|x| x.dot().squared())) / 2;
    let mut model = draft.natural(kinetic, z);
    let equations = Equations::derive(&mut model).unwrap();
    let kinetics = Kinetics::cheapest(&mut model, &equations);
    assert!(kinetics.solution.unwrap().holds(&model.graph, &equations));
}
