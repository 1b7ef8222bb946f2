//! Sines and cosines of differences and sums of angles (Abramowitz and Stegun, Handbook of Mathematical Functions, 1964,
//! 4.3.16 and 4.3.17).
//!
//! cos x cos y + sin x sin y costs less than cos (x − y) where the sines and cosines of x and y are known. Its Taylor series
//! costs more: there each product is a sum over all lower orders, and a sine and a cosine take two together.

use crate::algebra::expansion::Polynomial;
use crate::{Expression, Graph, Node, Rational, Unary};

impl Graph {
    /// `expression` expanded, with functions of sums and differences of angles for the sums of products that they are; none
    /// if there are none, or too many terms.
    pub(crate) fn with_angle_differences(&mut self, expression: Expression) -> Option<Expression> {
        let mut terms = self.monomials(expression)?;
        let mut combined = Vec::new();
        while let Some((pair, term)) = self.next_pair(&terms) {
            for monomial in pair {
                terms.remove(&monomial);
            }
            combined.push(term);
        }
        if combined.is_empty() {
            return None;
        }
        combined.extend(terms);
        Some(self.sum(combined))
    }

    /// Two monomials, and the term that is the sum of both.
    fn next_pair(
        &mut self,
        terms: &Polynomial,
    ) -> Option<([Expression; 2], (Expression, Rational))> {
        for (monomial, coefficient) in terms {
            let functions = self.circular_factors(*monomial);
            for (i, first) in functions.iter().enumerate() {
                for second in &functions[i + 1..] {
                    let partner = self.exchanged(*monomial, [*first, *second]);
                    let Some(other) = terms.get(&partner) else {
                        continue;
                    };
                    let is_same = other == coefficient;
                    if partner == *monomial || !is_same && *other != -coefficient {
                        continue;
                    }
                    let term = self.sum_of_pair(*monomial, [*first, *second], is_same);
                    let sign = Rational::integer(if term.1 { -1 } else { 1 });
                    return Some(([*monomial, partner], (term.0, &sign * coefficient)));
                }
            }
        }
        None
    }

    /// The sines and cosines that are factors of a monomial, with their arguments.
    fn circular_factors(&self, monomial: Expression) -> Vec<(Unary, Expression)> {
        let Node::Product(factors) = self.node(monomial) else {
            return Vec::new();
        };
        let functions = factors.iter().filter_map(|(base, exponent)| {
            let Node::Unary(function @ (Unary::Sin | Unary::Cos), x) = self.node(*base) else {
                return None;
            };
            exponent.is_one().then_some((*function, *x))
        });
        functions.collect()
    }

    /// A monomial with the cosine for the sine of two arguments, and the sine for the cosine.
    fn exchanged(
        &mut self,
        monomial: Expression,
        functions: [(Unary, Expression); 2],
    ) -> Expression {
        let others = functions.map(|(function, x)| (self.unary(other(function), x), Rational::ONE));
        let rest = self.without(monomial, functions);
        let [first, second] = others;
        self.product([(rest, Rational::ONE), first, second])
    }

    /// A monomial over two of its factors.
    fn without(&mut self, monomial: Expression, functions: [(Unary, Expression); 2]) -> Expression {
        let inverse = functions.map(|(function, x)| (self.unary(function, x), -&Rational::ONE));
        let [first, second] = inverse;
        self.product([(monomial, Rational::ONE), first, second])
    }

    /// The sum of a monomial and what is [exchanged](Self::exchanged) for it, or their difference, and whether the sign
    /// changes.
    fn sum_of_pair(
        &mut self,
        monomial: Expression,
        functions: [(Unary, Expression); 2],
        is_sum: bool,
    ) -> (Expression, bool) {
        let rest = self.without(monomial, functions);
        let [(first, x), (second, y)] = functions;
        // sin x cos y + cos x sin y = sin (x + y), and cos x cos y + sin x sin y = cos (x − y).
        let is_mixed = first != second;
        let angle = if is_mixed == is_sum {
            self.add(x, y)
        } else {
            self.subtract(x, y)
        };
        let function = if is_mixed { Unary::Sin } else { Unary::Cos };
        // cos x sin y − sin x cos y = −sin (x − y), and sin x sin y − cos x cos y = −cos (x + y).
        let changes_sign = second == Unary::Sin && !is_sum;
        let value = self.unary(function, angle);
        (self.multiply(rest, value), changes_sign)
    }
}

fn other(function: Unary) -> Unary {
    if function == Unary::Sin {
        Unary::Cos
    } else {
        Unary::Sin
    }
}

#[cfg(test)]
mod tests {
    use crate::{Expression, Graph, Rational, Symbol, Unary};

    /// What a sum becomes, and what is expected.
    fn check(sum: impl Fn(&mut Graph, [Expression; 4]) -> [Expression; 2]) {
        let mut graph = Graph::new();
        let [x, y] = [0, 1].map(|i| graph.symbol(Symbol::Coordinate(i)));
        let pairs = [x, y].map(|x| [graph.unary(Unary::Sin, x), graph.unary(Unary::Cos, x)]);
        let functions = [pairs[0][0], pairs[0][1], pairs[1][0], pairs[1][1]];
        let [sum, expected] = sum(&mut graph, functions);
        let mass = graph.symbol(Symbol::Parameter(0));
        let [sum, expected] = [sum, expected].map(|factor| {
            let product = graph.multiply(mass, factor);
            graph.add(product, x)
        });
        assert_eq!(graph.with_angle_differences(sum), Some(expected));
    }

    #[test]
    fn sums_of_products_are_functions_of_sums_and_differences() {
        let angle = |graph: &mut Graph, is_sum| {
            let [x, y] = [0, 1].map(|i| graph.symbol(Symbol::Coordinate(i)));
            if is_sum {
                graph.add(x, y)
            } else {
                graph.subtract(x, y)
            }
        };
        // Whichever product is built first, and so met first.
        let products = |graph: &mut Graph, is_reversed, pairs: [[Expression; 2]; 2]| {
            // Further products of the same factors are built in the order of these.
            let [first, second] = pairs;
            let order = if is_reversed {
                [second, first]
            } else {
                [first, second]
            };
            for [x, y] in order {
                let product = graph.multiply(x, y);
                let mass = graph.symbol(Symbol::Parameter(0));
                graph.multiply(mass, product);
            }
            pairs.map(|[x, y]| graph.multiply(x, y))
        };
        for (is_sum, is_reversed) in [(true, false), (true, true), (false, false), (false, true)] {
            check(|graph, [sin_x, cos_x, sin_y, cos_y]| {
                let pairs = [[cos_x, cos_y], [sin_x, sin_y]];
                let [first, second] = products(graph, is_reversed, pairs);
                let angle = angle(graph, is_sum);
                let cosine = graph.unary(Unary::Cos, angle);
                if is_sum {
                    [graph.subtract(first, second), cosine]
                } else {
                    [graph.add(first, second), cosine]
                }
            });
            check(|graph, [sin_x, cos_x, sin_y, cos_y]| {
                let pairs = [[sin_x, cos_y], [cos_x, sin_y]];
                let [first, second] = products(graph, is_reversed, pairs);
                let angle = angle(graph, is_sum);
                let sine = graph.unary(Unary::Sin, angle);
                if is_sum {
                    [graph.add(first, second), sine]
                } else {
                    [graph.subtract(first, second), sine]
                }
            });
        }
    }

    #[test]
    fn other_sums_stay_as_they_are() {
        let mut graph = Graph::new();
        let [x, y] = [0, 1].map(|i| graph.symbol(Symbol::Coordinate(i)));
        let (sine, cosine) = (graph.unary(Unary::Sin, x), graph.unary(Unary::Cos, y));
        let (other_sine, other_cosine) = (graph.unary(Unary::Sin, y), graph.unary(Unary::Cos, x));
        let first = graph.multiply(sine, cosine);
        let second = graph.multiply(other_sine, other_cosine);
        let twice = graph.scale(second, &Rational::integer(2));
        let sum = graph.add(first, twice);
        assert_eq!(graph.with_angle_differences(sum), None);
        assert_eq!(graph.with_angle_differences(first), None);
    }
}
