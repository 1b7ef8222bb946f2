//! Functions that the library knows by their names and derivatives alone.

use lagrangian_symbolic::{ExternalFunction, Graph, Rational, Symbol, Unary};

use crate::Number;

/// w(x) = sin 2x, with w′ = 2 s(x).
pub const WAVE: usize = 0;
/// s(x) = cos 2x, with s′ = −2 w(x).
pub const SLOPE: usize = 1;
/// p(x, y) = x² w(y), with ∂p/∂x = 2 x w(y) and ∂p/∂y = 2 x² s(y).
pub const PRODUCT: usize = 2;
/// How many there are.
pub const COUNT: usize = 3;

/// How many arguments a function has.
pub fn arity(function: usize) -> usize {
    if function == PRODUCT { 2 } else { 1 }
}

/// The functions, declared with their derivatives in a graph that has no other.
pub fn functions(graph: &mut Graph) -> [ExternalFunction; COUNT] {
    if let Some(known) = graph.functions().collect::<Vec<_>>().first_chunk() {
        return *known;
    }
    let wave = graph.declare_function("wave", &["x"]);
    let slope = graph.declare_function("slope", &["x"]);
    let product = graph.declare_function("product", &["x", "y"]);
    let two = Rational::integer(2);
    let [x, y] = [0, 1].map(|i| graph.symbol(Symbol::Argument(i)));
    let [wave_of_x, wave_of_y] = [x, y].map(|argument| graph.apply(wave, &[argument]));
    let [slope_of_x, slope_of_y] = [x, y].map(|argument| graph.apply(slope, &[argument]));
    let rise = graph.scale(slope_of_x, &two);
    graph.declare_derivative(wave, 0, rise);
    let fall = graph.scale(wave_of_x, &-&two);
    graph.declare_derivative(slope, 0, fall);
    let linear = graph.multiply(x, wave_of_y);
    let along = graph.scale(linear, &two);
    graph.declare_derivative(product, 0, along);
    let square = graph.square(x);
    let across = graph.product([(square, Rational::ONE), (slope_of_y, Rational::ONE)]);
    let across = graph.scale(across, &two);
    graph.declare_derivative(product, 1, across);
    [wave, slope, product]
}

/// The value of a function of [`functions`].
pub fn value<N: Number>(function: ExternalFunction, arguments: &[N]) -> N {
    value_of(function.index(), arguments)
}

/// The value of the function of this number.
pub fn value_of<N: Number>(function: usize, arguments: &[N]) -> N {
    let wave = |x: N, of: Unary| x.multiply(N::rational(&Rational::integer(2))).unary(of);
    match (function, arguments) {
        (WAVE, [x]) => wave(*x, Unary::Sin),
        (SLOPE, [x]) => wave(*x, Unary::Cos),
        (PRODUCT, [x, y]) => x.multiply(*x).multiply(wave(*y, Unary::Sin)),
        _ => panic!(
            "there is no function {function} of {} arguments",
            arguments.len()
        ),
    }
}
