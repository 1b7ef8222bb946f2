//! The derivatives of elementary functions.

use crate::{Binary, Expression, Graph, Rational, Unary};

impl Unary {
    /// The derivative f′(x) (Abramowitz and Stegun, Handbook of Mathematical Functions, 1964, chapter 4).
    ///
    /// The forms are chosen to avoid cancellation: 1 − x² is (1 − x)(1 + x), and tanh′ is cosh⁻². They are
    /// finite wherever the derivative is, and so are their own derivatives.
    pub fn derivative(self, graph: &mut Graph, x: Expression) -> Expression {
        match self {
            Self::Sin => graph.unary(Self::Cos, x),
            Self::Cos => {
                let sin = graph.unary(Self::Sin, x);
                graph.negate(sin)
            }
            Self::Tan => {
                let tan = graph.unary(Self::Tan, x);
                plus_square(graph, tan)
            }
            Self::Asin => {
                let product = unit_difference(graph, x);
                graph.power(product, &-&Rational::HALF)
            }
            Self::Acos => {
                let product = unit_difference(graph, x);
                let asin = graph.power(product, &-&Rational::HALF);
                graph.negate(asin)
            }
            Self::Atan => {
                let sum = plus_square(graph, x);
                graph.power(sum, &Rational::MINUS_ONE)
            }
            Self::Sinh => graph.unary(Self::Cosh, x),
            Self::Cosh => graph.unary(Self::Sinh, x),
            Self::Tanh => {
                let cosh = graph.unary(Self::Cosh, x);
                graph.power(cosh, &Rational::integer(-2))
            }
            Self::Sech => {
                let sech = graph.unary(Self::Sech, x);
                let tanh = graph.unary(Self::Tanh, x);
                let product = graph.multiply(sech, tanh);
                graph.negate(product)
            }
            Self::Asinh => {
                let sum = plus_square(graph, x);
                graph.power(sum, &-&Rational::HALF)
            }
            Self::Acosh => {
                let minus_half = -&Rational::HALF;
                let (below, above) = around_one(graph, x);
                graph.product([(below, minus_half.clone()), (above, minus_half)])
            }
            Self::Atanh => {
                let product = unit_difference(graph, x);
                // Opaque: the derivatives of two factors would cancel at 0.
                let product = graph.opaque(product);
                graph.power(product, &Rational::MINUS_ONE)
            }
            Self::Exp => graph.unary(Self::Exp, x),
            Self::Ln => graph.power(x, &Rational::MINUS_ONE),
            Self::Logistic => {
                let logistic = graph.unary(Self::Logistic, x);
                let complement = graph.logistic_complement(x);
                graph.multiply(logistic, complement)
            }
            Self::Softplus => graph.unary(Self::Logistic, x),
            Self::LogCosh => graph.unary(Self::Tanh, x),
            Self::Abs => graph.unary(Self::Signum, x),
            Self::Signum => graph.zero(),
        }
    }
}

impl Binary {
    /// The partial derivatives with respect to both arguments. Where x = y, `min` and `max` have the mean of both sides.
    ///
    /// The derivatives of `atan2` are written x/(x² + y²) and −y/(x² + y²) because they cancel with an r² = x² + y², which a form
    /// without squares, such as cos φ/r, would not. Where they do not, programs scale them, so that the squares
    /// neither underflow nor overflow (`program/angle_slopes.rs`).
    pub fn derivatives(self, graph: &mut Graph, x: Expression, y: Expression) -> [Expression; 2] {
        match self {
            Self::Atan2 => {
                let (x2, y2) = (graph.square(x), graph.square(y));
                let sum = graph.add(x2, y2);
                graph.note_squared_distance(sum);
                let over_x = graph.divide(y, sum);
                let over_y = graph.divide(x, sum);
                [over_x, graph.negate(over_y)]
            }
            Self::Min => {
                let [greater, lesser] = shares(graph, x, y);
                [lesser, greater]
            }
            Self::Max => shares(graph, x, y),
            Self::Power => {
                // Where y is 0, the derivative by x is 0, at x = 0, too, where x⁻¹ would be infinite.
                let guard = graph.guard(y);
                let less = graph.add_constant(y, &Rational::MINUS_ONE);
                let less = graph.add(less, guard);
                let lower = graph.binary(Self::Power, x, less);
                let power = graph.binary(Self::Power, x, y);
                let ln = logarithm_or_zero(graph, x);
                [graph.multiply(y, lower), graph.multiply(power, ln)]
            }
            Self::Scale => [graph.zero(); 2],
        }
    }
}

/// 1 + x².
fn plus_square(graph: &mut Graph, x: Expression) -> Expression {
    let square = graph.square(x);
    graph.add_constant(square, &Rational::ONE)
}

/// ln x, and 0 for x = 0, where x^y ln x is 0: ln(x + (1 − signum² x)).
fn logarithm_or_zero(graph: &mut Graph, x: Expression) -> Expression {
    let guard = graph.guard(x);
    let guarded = graph.add(x, guard);
    graph.unary(Unary::Ln, guarded)
}

/// x − 1 and x + 1.
fn around_one(graph: &mut Graph, x: Expression) -> (Expression, Expression) {
    let below = graph.add_constant(x, &Rational::MINUS_ONE);
    let above = graph.add_constant(x, &Rational::ONE);
    (below, above)
}

/// (1 − x)(1 + x).
pub(super) fn unit_difference(graph: &mut Graph, x: Expression) -> Expression {
    let (below, above) = around_one(graph, x);
    let below = graph.negate(below);
    graph.multiply(below, above)
}

/// The shares ½(1 ± signum(x − y)) of both arguments in the greater one.
fn shares(graph: &mut Graph, x: Expression, y: Expression) -> [Expression; 2] {
    let difference = graph.subtract(x, y);
    let sign = graph.unary(Unary::Signum, difference);
    let one = graph.one();
    let half = Rational::HALF;
    let first = graph.sum([(one, half.clone()), (sign, half.clone())]);
    let second = graph.sum([(one, half.clone()), (sign, -&half)]);
    [first, second]
}
