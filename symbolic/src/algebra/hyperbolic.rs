//! Products of hyperbolic functions of one argument, so that no quotient overflows.
//!
//! With sinh = tanh·cosh, a product sinhʲ tanhᵏ coshˡ is tanhᵃ coshᵇ for a = j + k and b = j + l. Where the
//! signs of a and b agree, as many of both as there are become sinh: sinh x stays, and sinh x/cosh x is tanh x.
//! Since |tanh| ≤ 1, what is left does not become ∞/∞: the second derivative of tanh x is −2 tanh x cosh⁻² x,
//! which is 0 where cosh x is too large for a number, and not sinh x cosh⁻³ x. A negative power of cosh x is one of
//! sech x, so that its Taylor series does not overflow either.

use crate::{Expression, Graph, Node, Rational, Unary};

/// Π xᵢ^kᵢ, as pairs (xᵢ, kᵢ).
type Factors = Vec<(Expression, Rational)>;

/// The functions in the order of [`Powers`].
const FUNCTIONS: [Unary; 3] = [Unary::Sinh, Unary::Cosh, Unary::Tanh];

/// The exponents of sinh, cosh and tanh.
type Powers = [Rational; 3];

impl Graph {
    /// Rewrites the first quotient of hyperbolic functions among sorted factors, if there is one: what it
    /// becomes is to be multiplied by the factors that are left.
    pub(crate) fn take_hyperbolic(&mut self, factors: &mut Factors) -> Factors {
        if !self.has_hyperbolic {
            return Vec::new();
        }
        for position in 0..factors.len() {
            let Some((_, x, _)) = self.hyperbolic(&factors[position]) else {
                continue;
            };
            let mut powers = [const { Rational::ZERO }; 3];
            let mut written = Factors::new();
            for factor in factors.iter() {
                if let Some((function, argument, exponent)) = self.hyperbolic(factor)
                    && argument == x
                {
                    powers[function] = &powers[function] + &exponent;
                    written.push(factor.clone());
                }
            }
            let Some(simpler) = rewritten(&powers) else {
                continue;
            };
            let mut found = self.hyperbolic_product(x, &simpler);
            found.sort_by_key(|(base, _)| *base);
            if found == written {
                continue;
            }
            factors.retain(|factor| {
                self.hyperbolic(factor)
                    .is_none_or(|(_, argument, _)| argument != x)
            });
            return found;
        }
        Vec::new()
    }

    /// The factors with these exponents of sinh x, cosh x and tanh x.
    fn hyperbolic_product(&mut self, x: Expression, powers: &Powers) -> Factors {
        let mut found = Factors::new();
        for (function, exponent) in FUNCTIONS.into_iter().zip(powers) {
            if exponent.is_zero() {
                continue;
            }
            let is_secant = function == Unary::Cosh && exponent.is_negative();
            found.push(if is_secant && !self.leaves_exponentials {
                (self.unary(Unary::Sech, x), -exponent)
            } else {
                (self.unary(function, x), exponent.clone())
            });
        }
        found
    }

    /// The position of a hyperbolic function, its argument and its exponent, if a factor is a power of one that can be
    /// combined with others: an integer power, or any power of cosh, which is positive.
    fn hyperbolic(
        &self,
        (base, exponent): &(Expression, Rational),
    ) -> Option<(usize, Expression, Rational)> {
        let Node::Unary(function, x) = self.node(*base) else {
            return None;
        };
        if *function == Unary::Sech {
            return Some((1, *x, -exponent));
        }
        let position = FUNCTIONS.iter().position(|f| f == function)?;
        let is_combined = exponent.is_integer() || *function == Unary::Cosh;
        is_combined.then(|| (position, *x, exponent.clone()))
    }
}

/// The same product with as few quotients as there can be, unless its exponents are too long.
fn rewritten([sinh, cosh, tanh]: &Powers) -> Option<Powers> {
    let (a, b) = (sinh + tanh, sinh + cosh);
    let (numerator, denominator) = b.to_fraction()?;
    // The integer part of b, towards zero.
    let integer_b = numerator / denominator;
    let integer_a = a.to_integer()?;
    let common = if (integer_b > 0) == (integer_a > 0) {
        integer_b.unsigned_abs().min(integer_a.unsigned_abs())
    } else {
        0
    };
    let common = i64::try_from(common).ok()? * integer_a.signum();
    let common = Rational::integer(common);
    Some([common.clone(), &b - &common, &a - &common])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Symbol;

    /// sinhʲ coshᵏ tanhˡ of a coordinate.
    fn product(graph: &mut Graph, exponents: [i64; 3]) -> Expression {
        let x = graph.symbol(Symbol::Coordinate(0));
        let factors = FUNCTIONS.into_iter().zip(exponents);
        let factors: Factors = factors
            .map(|(function, k)| (graph.unary(function, x), Rational::integer(k)))
            .collect();
        graph.product(factors)
    }

    #[test]
    fn quotients_become_tangents() {
        let mut graph = Graph::new();
        for (written, expected) in [
            ([1, -1, 0], [0, 0, 1]),
            ([1, -3, 0], [0, -2, 1]),
            ([-1, 1, 0], [0, 0, -1]),
            ([-2, 1, 0], [-1, 0, -1]),
            ([3, -1, 0], [2, 0, 1]),
            ([0, 1, 1], [1, 0, 0]),
            ([-1, 0, 1], [0, -1, 0]),
            ([1, 0, -1], [0, 1, 0]),
            ([2, -1, -1], [1, 0, 0]),
        ] {
            let found = product(&mut graph, written);
            assert_eq!(found, product(&mut graph, expected), "{written:?}");
            let value = graph.evaluate(&[found], |_| 0.7)[0];
            let factors = FUNCTIONS.into_iter().zip(written);
            let direct: f64 = factors
                .map(|(f, k)| f.value(0.7).powi(i32::try_from(k).unwrap()))
                .product();
            assert!((value / direct - 1.0).abs() < 1e-15, "{written:?}");
        }
        for stays in [[1, 0, 0], [1, 1, 0], [2, 1, 0], [0, -2, 1], [-1, 0, -1]] {
            let found = product(&mut graph, stays);
            let factors = graph.factors(found).len();
            let written = stays.iter().filter(|k| **k != 0).count();
            assert_eq!(factors, written, "{stays:?}");
        }
    }

    #[test]
    fn other_arguments_and_fractional_powers_are_kept_apart() {
        let mut graph = Graph::new();
        let [x, y] = [0, 1].map(|i| graph.symbol(Symbol::Coordinate(i)));
        let (sinh, other) = (graph.unary(Unary::Sinh, x), graph.unary(Unary::Cosh, y));
        let quotient = graph.divide(sinh, other);
        assert!(matches!(graph.node(quotient), Node::Product(factors) if factors.len() == 2));
        // √sinh x has no value for negative x, where √cosh x has one.
        let cosh = graph.unary(Unary::Cosh, x);
        let (root, half) = (graph.square_root(sinh), -&Rational::HALF);
        let mixed = graph.product([(root, Rational::ONE), (cosh, Rational::MINUS_ONE)]);
        assert!(matches!(graph.node(mixed), Node::Product(factors) if factors.len() == 2));
        let tanh = graph.unary(Unary::Tanh, x);
        let fractional = graph.product([(sinh, Rational::ONE), (cosh, &half - &Rational::ONE)]);
        let expected = graph.product([(tanh, Rational::ONE), (cosh, half)]);
        assert_eq!(fractional, expected);
    }

    #[test]
    fn derivatives_do_not_overflow() {
        let mut graph = Graph::new();
        for written in [[0, -1, 0], [-1, 0, 0], [0, 0, 1], [0, 0, -1]] {
            let mut root = product(&mut graph, written);
            for order in 1..5 {
                root = graph.derivative(root, Symbol::Coordinate(0));
                for x in [-800.0, 800.0] {
                    let value = graph.evaluate(&[root], |_| x)[0];
                    assert!(value.abs() == 0.0, "{written:?} {order}: {value}");
                }
            }
        }
    }
}
