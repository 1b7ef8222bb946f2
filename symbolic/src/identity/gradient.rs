//! Derivatives of expressions at a modular point by all symbols at once, by reverse accumulation (Linnainmaa, Taylor
//! expansion of the accumulated rounding error, 1976; Griewank and Walther, Evaluating Derivatives, 2nd edition 2008,
//! section 3.2).
//!
//! The image of the derivative of an expression is the derivative that is accumulated from images, since sums, products,
//! sines and cosines keep their rules of differentiation modulo p. Of functions whose images are drawn at random there are
//! no such derivatives.

use crate::identity::homomorphic_image::{Images, KnownImages};
use crate::identity::modular_point::{ModularPoint, reduce};
use crate::identity::residue;
use crate::{Expression, Graph, Node, Rational, Unary};

/// Whether the images of all `expressions` have derivatives.
pub(crate) fn exists(graph: &Graph, expressions: &[Expression]) -> bool {
    let mut expressions = expressions.iter();
    expressions.all(|expression| match graph.node(*expression) {
        Node::Constant(_)
        | Node::Pi
        | Node::Symbol(_)
        | Node::Sum(_)
        | Node::Opaque(_)
        | Node::Unary(Unary::Sin | Unary::Cos, _) => true,
        Node::Product(factors) => factors.iter().all(|(_, k)| k.is_integer()),
        Node::Unary(..) | Node::Binary(..) | Node::Application(..) => false,
    })
}

/// The derivatives of Σ wᵢ·rootᵢ by each of the expressions of which the roots are made, by position in the graph.
///
/// `descendants` are those expressions, children before parents, and `images` their images at the point. None where
/// an exponent has no residue.
pub(crate) fn accumulated(
    graph: &Graph,
    point: ModularPoint,
    descendants: &[Expression],
    images: &Images,
    weights: &[(Expression, u64)],
) -> Option<Vec<u64>> {
    let length = descendants.last().map_or(0, |last| last.index() + 1);
    let mut sweep = Sweep {
        point,
        p: point.p(),
        images,
        slopes: vec![0; length],
        powers: Vec::new(),
        behind: Vec::new(),
    };
    for (root, weight) in weights {
        sweep.add(*root, *weight);
    }
    for expression in descendants.iter().rev() {
        let slope = sweep.slopes[expression.index()];
        if slope != 0 {
            sweep.pass_on(graph.node(*expression), slope)?;
        }
    }
    Some(sweep.slopes)
}

/// Derivatives on their way from the roots to the symbols.
struct Sweep<'a> {
    point: ModularPoint,
    p: u64,
    images: &'a Images,
    slopes: Vec<u64>,
    /// Of the product at hand: its powers.
    powers: Vec<u64>,
    /// The products of the powers behind each factor, the last factor first.
    behind: Vec<u64>,
}

impl Sweep<'_> {
    fn add(&mut self, expression: Expression, slope: u64) {
        let sum = &mut self.slopes[expression.index()];
        *sum = residue::add(*sum, slope, self.p);
    }

    /// Adds what a node passes on to its operands, where `slope` is the derivative by the node itself.
    fn pass_on(&mut self, node: &Node, slope: u64) -> Option<()> {
        let p = self.p;
        match node {
            Node::Sum(terms) => {
                for (x, c) in terms {
                    let part = match c.to_fraction() {
                        Some((1, 1)) => slope,
                        Some((-1, 1)) => residue::negate(slope, p),
                        _ => residue::multiply(slope, reduce(c, p)?, p),
                    };
                    self.add(*x, part);
                }
            }
            Node::Product(factors) => self.pass_on_by_factors(factors, slope)?,
            Node::Opaque(x) => self.add(*x, slope),
            Node::Unary(Unary::Sin, x) => {
                let cosine = self.point.unary(Unary::Cos, self.images.get(*x))?;
                self.add(*x, residue::multiply(slope, cosine, p));
            }
            Node::Unary(Unary::Cos, x) => {
                let sine = self.point.unary(Unary::Sin, self.images.get(*x))?;
                let part = residue::multiply(slope, sine, p);
                self.add(*x, residue::negate(part, p));
            }
            _ => {}
        }
        Some(())
    }

    /// kⱼ xⱼ^(kⱼ−1) Π_{i≠j} xᵢ^kᵢ for each factor.
    fn pass_on_by_factors(&mut self, factors: &[(Expression, Rational)], slope: u64) -> Option<()> {
        let p = self.p;
        self.powers.clear();
        for (x, k) in factors {
            let value = self.images.get(*x).value;
            self.powers.push(if k.is_one() {
                value
            } else {
                self.point.power(value, k)?
            });
        }
        self.behind.clear();
        let mut behind = 1;
        for power in self.powers.iter().rev() {
            self.behind.push(behind);
            behind = residue::multiply(behind, *power, p);
        }
        let last = factors.len() - 1;
        let mut before = slope;
        for (j, (x, k)) in factors.iter().enumerate() {
            let mut part = residue::multiply(before, self.behind[last - j], p);
            if !k.is_one() {
                let less = k - &Rational::ONE;
                let power = self.point.power(self.images.get(*x).value, &less)?;
                part = residue::multiply(part, power, p);
                part = residue::multiply(part, reduce(k, p)?, p);
            }
            self.add(*x, part);
            before = residue::multiply(before, self.powers[j], p);
        }
        Some(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Symbol;
    use crate::identity::incremental_evaluation::IncrementalEvaluation;

    /// Expressions of x, y and z in which all rules occur.
    fn samples(graph: &mut Graph) -> Vec<Expression> {
        let [x, y] = [0, 1].map(|i| graph.symbol(Symbol::Coordinate(i)));
        let z = graph.symbol(Symbol::Parameter(0));
        let sum = graph.sum([(x, Rational::integer(3)), (y, Rational::MINUS_ONE)]);
        let [sine, cosine] = [Unary::Sin, Unary::Cos].map(|function| graph.unary(function, sum));
        let square = graph.power(sine, &Rational::integer(3));
        let quotient = graph.divide(square, x);
        let product = graph.product([
            (quotient, Rational::ONE),
            (cosine, Rational::integer(-2)),
            (z, Rational::ONE),
        ]);
        let sum = graph.sum([(product, Rational::HALF), (cosine, Rational::ONE)]);
        let opaque = graph.opaque(sum);
        let whole = graph.multiply(opaque, y);
        vec![product, whole]
    }

    #[test]
    fn accumulated_derivatives_are_images_of_symbolic_ones() {
        let mut graph = Graph::new();
        let roots = samples(&mut graph);
        let symbols = [
            Symbol::Coordinate(0),
            Symbol::Coordinate(1),
            Symbol::Parameter(0),
        ];
        let weights = [5, 7];
        let descendants = graph.descendants(&roots);
        assert!(exists(&graph, &descendants));
        for symbol in symbols {
            let derivatives = graph.derivatives(&roots, symbol);
            let variable = graph.symbol(symbol);
            for point in (0..24).map(ModularPoint::new) {
                let p = point.p();
                let expected = point.evaluate(&graph, &derivatives).unwrap();
                let evaluation =
                    IncrementalEvaluation::of_descendants(&graph, &roots, &descendants, point);
                let evaluation = evaluation.unwrap();
                let weighted = [(roots[0], weights[0]), (roots[1], weights[1])];
                let found =
                    accumulated(&graph, point, &descendants, evaluation.images(), &weighted);
                let [first, second] = [0, 1].map(|i| residue::multiply(weights[i], expected[i], p));
                let expected = residue::add(first, second, p);
                assert_eq!(found.unwrap()[variable.index()], expected, "by {symbol:?}");
            }
        }
    }

    #[test]
    fn functions_that_are_drawn_at_random_have_none() {
        let mut graph = Graph::new();
        let x = graph.symbol(Symbol::Coordinate(0));
        let root = graph.square_root(x);
        let others = [Unary::Abs, Unary::Ln, Unary::Atan].map(|f| graph.unary(f, x));
        for expression in others.into_iter().chain([root]) {
            assert!(!exists(&graph, &graph.descendants(&[expression])));
        }
    }
}
