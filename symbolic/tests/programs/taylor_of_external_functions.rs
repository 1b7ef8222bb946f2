//! Taylor series of external functions, from their declared derivatives.

use lagrangian_symbolic::{
    Expression, ExternalFunction, Graph, NoSeries, Program, Rational, SeriesOutputs, Symbol,
    TaylorProgram, Unary, ValueSeriesCheck,
};
use lagrangian_symbolic_testing::bounded::Bounded;
use lagrangian_symbolic_testing::mutation::wrong_series;
use lagrangian_symbolic_testing::{external, machine};

const ORDERS: usize = 9;

/// The Taylor series of one value, and the program that it is of.
fn series(graph: &Graph, value: Expression) -> Result<(Program, TaylorProgram), NoSeries> {
    let program = Program::schedule(graph, &[&[value]]);
    let outputs = SeriesOutputs::Values(&program.groups[0].outputs);
    let taylor = TaylorProgram::of(graph, &program, outputs)?;
    Ok((program, taylor))
}

/// The coefficients of the coordinates along some motion.
fn motion(symbol: Symbol, order: usize) -> f64 {
    let index = match symbol {
        Symbol::Coordinate(i) => f64::from(i),
        _ => panic!("{symbol:?} has no series here"),
    };
    let decay = (0..order).fold(1.0, |product, _| -0.6 * product);
    (0.4 + 0.3 * index) * decay + 0.1 * f64::from(u8::from(order == 1))
}

/// The coefficients of a series by its recurrence.
#[allow(clippy::cast_precision_loss)] // Orders are small.
fn coefficients(taylor: &TaylorProgram) -> Vec<f64> {
    let exact = |x: f64| Bounded::exact(x);
    let initial = machine::run(&taylor.initial, |symbol| exact(motion(symbol, 0)));
    let invariants = initial.last().unwrap().clone();
    let mut found = vec![initial[0][0].value];
    let mut factors: Vec<Vec<f64>> = vec![Vec::new()];
    for k in 1..ORDERS {
        let read = |symbol| match symbol {
            Symbol::Order => exact(k as f64),
            Symbol::ReciprocalOrder => exact(1.0 / k as f64),
            Symbol::Invariant(i) => invariants[i as usize],
            Symbol::Convolution(i) => {
                let pair = &taylor.convolutions[i as usize];
                let terms = (1..k).map(|j| factors[j][pair.0] * factors[k - j][pair.1]);
                exact(terms.sum())
            }
            other => exact(motion(other, k)),
        };
        let terms = machine::run(&taylor.recurrence, read);
        found.push(terms[0][0].value);
        factors.push(terms[1].iter().map(|factor| factor.value).collect());
    }
    found
}

/// Expressions of the coordinates, with external functions and with the formulas of these.
fn values(graph: &mut Graph, is_external: bool) -> Vec<(&'static str, Expression)> {
    let functions = external::functions(graph);
    let [x, y] = [0, 1].map(|i| graph.symbol(Symbol::Coordinate(i)));
    let apply = |graph: &mut Graph, function: usize, arguments: &[Expression]| {
        if is_external {
            return graph.apply(functions[function], arguments);
        }
        let last = arguments[arguments.len() - 1];
        let angle = graph.scale(last, &Rational::integer(2));
        let trigonometric = if function == external::SLOPE {
            Unary::Cos
        } else {
            Unary::Sin
        };
        let wave = graph.unary(trigonometric, angle);
        if function != external::PRODUCT {
            return wave;
        }
        let square = graph.square(arguments[0]);
        graph.multiply(square, wave)
    };
    let wave = apply(graph, external::WAVE, &[x]);
    let of_square = graph.square(y);
    let of_square = apply(graph, external::SLOPE, &[of_square]);
    let nested = apply(graph, external::WAVE, &[of_square]);
    let product = apply(graph, external::PRODUCT, &[x, y]);
    let same = apply(graph, external::PRODUCT, &[wave, x]);
    let two = graph.integer(2);
    let constant = apply(graph, external::PRODUCT, &[x, two]);
    let sum = graph.add(product, wave);
    let quotient = graph.divide(sum, nested);
    vec![
        ("wave", wave),
        ("nested", nested),
        ("product", product),
        ("an argument that contains the function", same),
        ("a constant argument", constant),
        ("quotient", quotient),
    ]
}

#[test]
fn coefficients_are_those_of_the_formulas() {
    let (mut of_functions, mut of_formulas) = (Graph::new(), Graph::new());
    let written = values(&mut of_functions, true);
    let formulas = values(&mut of_formulas, false);
    for ((what, function), (_, formula)) in written.into_iter().zip(formulas) {
        let found = coefficients(&series(&of_functions, function).unwrap().1);
        let expected = coefficients(&series(&of_formulas, formula).unwrap().1);
        for (k, (found, expected)) in found.iter().zip(&expected).enumerate() {
            let difference = (found - expected).abs();
            assert!(
                difference <= 1e-13 * expected.abs().max(1e-3),
                "{what}: {k}"
            );
        }
    }
}

/// A sine that is external takes as many convolutions as the sine.
#[test]
fn functions_that_are_each_others_derivatives_close() {
    let mut graph = Graph::new();
    let values = values(&mut graph, true);
    let (_, taylor) = series(&graph, values[0].1).unwrap();
    assert_eq!((taylor.convolutions.len(), taylor.factors()), (2, 3));
}

/// Every instruction and every convolution counts in the check.
#[test]
fn series_with_an_error_anywhere_are_found_out() {
    let mut graph = Graph::new();
    for (what, value) in values(&mut graph, true) {
        let (program, right) = series(&graph, value).unwrap();
        let agrees = |taylor: &TaylorProgram| {
            let check = ValueSeriesCheck::new(&graph, &program, taylor);
            check.agrees()
        };
        assert!(agrees(&right), "{what}");
        for (error, wrong) in wrong_series(&right, &[0, 1]) {
            assert!(!agrees(&wrong), "{what}: {error}");
        }
    }
}

/// A function of one argument with a derivative, which gets the function and its argument.
fn with_derivative(
    derivative: impl FnOnce(&mut Graph, ExternalFunction, Expression) -> Expression,
) -> (Graph, ExternalFunction, Expression) {
    let mut graph = Graph::new();
    let function = graph.declare_function("f", &["x"]);
    let argument = graph.symbol(Symbol::Argument(0));
    let derivative = derivative(&mut graph, function, argument);
    graph.declare_derivative(function, 0, derivative);
    let x = graph.symbol(Symbol::Coordinate(0));
    let value = graph.apply(function, &[x]);
    (graph, function, value)
}

/// f′ = 1 − f², as the hyperbolic tangent, with as many convolutions as that takes.
#[test]
fn a_function_that_satisfies_a_differential_equation_closes() {
    let (mut graph, _, value) = with_derivative(|graph, function, argument| {
        let value = graph.apply(function, &[argument]);
        let square = graph.square(value);
        let one = graph.one();
        graph.subtract(one, square)
    });
    let (program, taylor) = series(&graph, value).unwrap();
    assert!(ValueSeriesCheck::new(&graph, &program, &taylor).agrees());
    let x = graph.symbol(Symbol::Coordinate(0));
    let hyperbolic = graph.unary(Unary::Tanh, x);
    let (_, built_in) = series(&graph, hyperbolic).unwrap();
    assert_eq!(taylor.convolutions.len(), built_in.convolutions.len());
}

/// A derivative that is constant piece by piece, and one that is the argument.
#[test]
fn derivatives_without_functions_close() {
    let (graph, _, value) = with_derivative(|graph, _, argument| {
        let sign = graph.unary(Unary::Signum, argument);
        graph.scale(sign, &Rational::integer(3))
    });
    let (program, taylor) = series(&graph, value).unwrap();
    assert!(ValueSeriesCheck::new(&graph, &program, &taylor).agrees());
    assert_eq!(taylor.convolutions.len(), 0);
    let (graph, _, value) = with_derivative(|_, _, argument| argument);
    let (program, taylor) = series(&graph, value).unwrap();
    assert!(ValueSeriesCheck::new(&graph, &program, &taylor).agrees());
    assert_eq!((taylor.convolutions.len(), taylor.factors()), (1, 2));
}

#[test]
fn what_is_not_declared_is_named() {
    let mut table = None;
    let (graph, function, value) = with_derivative(|graph, _, argument| {
        let slope = graph.declare_function("slope", &["y", "x"]);
        table = Some(slope);
        let one = graph.one();
        graph.apply(slope, &[one, argument])
    });
    // The first argument does not vary.
    let expected = NoSeries {
        function,
        undeclared: Some((table.unwrap(), 1)),
    };
    assert_eq!(series(&graph, value).unwrap_err(), expected);
}

/// f′(x) = f(x/2) + f(x/3).
#[test]
fn derivatives_at_ever_further_arguments_have_no_end() {
    let (graph, function, value) = with_derivative(|graph, function, argument| {
        let terms = [2, 3].map(|divisor| {
            let part = Rational::integer(divisor).power(-1).unwrap();
            let scaled = graph.scale(argument, &part);
            graph.apply(function, &[scaled])
        });
        graph.add(terms[0], terms[1])
    });
    let expected = NoSeries {
        function,
        undeclared: None,
    };
    assert_eq!(series(&graph, value).unwrap_err(), expected);
}
