//! Powers whose exponent is a parameter, and their derivatives, where the base is 0.

#![allow(clippy::float_cmp)] // These are exact.

use lagrangian_symbolic::{Binary, Expression, Graph, Symbol, Unary};

/// The derivatives of xⁿ by x of order 0 to 4, at x = 0.
fn derivatives(exponent: impl Fn(&mut Graph) -> Expression, n: f64) -> [f64; 5] {
    let mut graph = Graph::new();
    let x = graph.symbol(Symbol::Coordinate(0));
    let exponent = exponent(&mut graph);
    let mut derivative = graph.binary(Binary::Power, x, exponent);
    core::array::from_fn(|order| {
        if order > 0 {
            derivative = graph.derivative(derivative, Symbol::Coordinate(0));
        }
        let value = |symbol| match symbol {
            Symbol::Parameter(_) => n,
            _ => 0.0,
        };
        graph.evaluate(&[derivative], value)[0]
    })
}

#[test]
fn the_derivatives_of_a_power_with_an_integer_exponent_exist_at_zero() {
    let parameter = |graph: &mut Graph| graph.symbol(Symbol::Parameter(0));
    // The parameter times cos 0.
    let written = |graph: &mut Graph| {
        let n = graph.symbol(Symbol::Parameter(0));
        let t = graph.symbol(Symbol::Time);
        let cosine = graph.unary(Unary::Cos, t);
        graph.multiply(n, cosine)
    };
    for (n, expected) in [
        (0.0, [1.0, 0.0, 0.0, 0.0, 0.0]),
        (1.0, [0.0, 1.0, 0.0, 0.0, 0.0]),
        (2.0, [0.0, 0.0, 2.0, 0.0, 0.0]),
        (3.0, [0.0, 0.0, 0.0, 6.0, 0.0]),
        (4.0, [0.0, 0.0, 0.0, 0.0, 24.0]),
    ] {
        assert_eq!(derivatives(parameter, n), expected, "{n}");
        assert_eq!(derivatives(written, n), expected, "{n}");
    }
    // Where there is none, there is no number.
    let [value, slope, ..] = derivatives(parameter, 0.5);
    assert_eq!(value, 0.0);
    assert!(slope.is_infinite());
    let [value, slope, curvature, third, _] = derivatives(parameter, 2.5);
    assert_eq!([value, slope, curvature], [0.0; 3]);
    assert!(third.is_infinite());
}
