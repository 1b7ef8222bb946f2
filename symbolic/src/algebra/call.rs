//! The normal form of calls of elementary functions.

use crate::algebra::function::Symmetry;
use crate::algebra::function_derivatives::unit_difference;
use crate::{Binary, Expression, Graph, Node, Rational, Unary};

impl Graph {
    /// f(x): its exact value where that is known, else with the sign of x moved out where f allows it.
    pub fn unary(&mut self, function: Unary, x: Expression) -> Expression {
        if let Some(value) = self.as_constant(x).and_then(|x| function.exact(x)) {
            return self.constant(&value);
        }
        if let Some(value) = self.exact_circular(function, x) {
            return value;
        }
        if let Some(angle) = self.exact_inverse_circular(function, x) {
            return angle;
        }
        if self.has_minus(x) && function.symmetry() != Symmetry::None {
            let opposite = self.negate(x);
            let value = self.unary_of_positive(function, opposite);
            return match function.symmetry() {
                Symmetry::Odd => self.negate(value),
                Symmetry::Even | Symmetry::None => value,
            };
        }
        self.unary_of_positive(function, x)
    }

    fn unary_of_positive(&mut self, function: Unary, x: Expression) -> Expression {
        let stable = match function {
            Unary::Ln => self.logarithm_of_growing(x),
            Unary::Exp => self.exponential_of_softplus(x),
            Unary::Atan => self.angle_of_exponential(x),
            _ => None,
        };
        if let Some(stable) = stable {
            return stable;
        }
        match (function, self.node(x)) {
            // Where the inverse has a value; where it has none, neither has the call. Not atan2: at the origin it is 0, whose
            // cosine is 1, where x/√(x² + y²) has no value.
            (Unary::Exp, Node::Unary(Unary::Ln, y))
            | (Unary::Ln, Node::Unary(Unary::Exp, y))
            | (Unary::Sin, Node::Unary(Unary::Asin, y))
            | (Unary::Cos, Node::Unary(Unary::Acos, y))
            | (Unary::Tan, Node::Unary(Unary::Atan, y)) => *y,
            (Unary::Cos, Node::Unary(Unary::Asin, y))
            | (Unary::Sin, Node::Unary(Unary::Acos, y)) => {
                // Both inverses end where this vanishes; 1 − y² would lose its digits there.
                let y = *y;
                let product = unit_difference(self, y);
                self.square_root(product)
            }
            (Unary::Abs, Node::Unary(Unary::Abs, _)) => x,
            (Unary::Abs | Unary::Signum, Node::Sum(terms)) if terms.len() == 1 => {
                // |c·x| = |c|·|x|, and signum(c·x) = signum(c)·signum(x).
                let (y, factor) = terms[0].clone();
                let value = self.unary(function, y);
                match function {
                    Unary::Abs => self.scale(value, &factor.abs()),
                    _ if factor.is_negative() => self.negate(value),
                    _ => value,
                }
            }
            _ => {
                self.has_hyperbolic |= matches!(
                    function,
                    Unary::Sinh | Unary::Cosh | Unary::Tanh | Unary::Sech | Unary::LogCosh
                );
                self.has_exponential |=
                    matches!(function, Unary::Exp | Unary::Logistic | Unary::Softplus);
                self.intern(Node::Unary(function, x))
            }
        }
    }

    /// f(x, y).
    pub fn binary(&mut self, function: Binary, x: Expression, y: Expression) -> Expression {
        match function {
            Binary::Power => return self.real_power(x, y),
            Binary::Min | Binary::Max if x == y => return x,
            Binary::Min | Binary::Max => {
                if let (Some(a), Some(b)) = (self.as_constant(x), self.as_constant(y)) {
                    return if (a < b) == (function == Binary::Min) {
                        x
                    } else {
                        y
                    };
                }
                // Both are symmetric: one order stands for both.
                let (x, y) = (x.min(y), x.max(y));
                return self.intern(Node::Binary(function, x, y));
            }
            Binary::Scale => {}
            Binary::Atan2 => {
                if let Some(angle) = self.exact_atan2(x, y) {
                    return angle;
                }
            }
        }
        self.intern(Node::Binary(function, x, y))
    }

    /// x^y: an exact power if y is a number, else one of real numbers.
    fn real_power(&mut self, x: Expression, y: Expression) -> Expression {
        if let Some(exponent) = self.as_constant(y) {
            let exponent: Rational = exponent.clone();
            return self.power(x, &exponent);
        }
        if let Some(power) = self.power_of_growing(x, y) {
            return power;
        }
        self.intern(Node::Binary(Binary::Power, x, y))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Symbol;

    #[test]
    fn the_sign_of_a_long_factor_is_kept() {
        let mut graph = Graph::new();
        let x = graph.symbol(Symbol::Coordinate(0));
        let long = Rational::from_decimal(&format!("0.{}1", "3".repeat(2000))).unwrap();
        let scaled = graph.scale(x, &-&long);
        let sign = graph.unary(Unary::Signum, scaled);
        let size = graph.unary(Unary::Abs, scaled);
        let values = graph.evaluate(&[sign, size], |_| 2.0);
        assert!((values[0] + 1.0).abs() < 1e-15, "{values:?}");
        assert!((values[1] - 2.0 / 3.0).abs() < 1e-15, "{values:?}");
    }
}
