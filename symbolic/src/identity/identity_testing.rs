//! Polynomial identity testing at random points (Schwartz, Fast probabilistic algorithms for verification of
//! polynomial identities, 1980; Zippel, Probabilistic algorithms for sparse polynomials, 1979), extended to
//! elementary functions by homomorphic images (Gonnet, Determining equivalence of expressions in random polynomial
//! time, 1984).
//!
//! The answer is yes only if the claim holds for every choice of branches of √u, |u|, signum, min and max, which is
//! stronger than on the real branch; where that is not known, the answer is no, and nothing may be rewritten.
//! There are two criteria for yes:
//!
//! - the claim holds with those functions uninterpreted, as arbitrary functions up to their symmetries. A false claim
//!   passes at a point with a probability of about its degree over 2·10¹⁵, the order of the group in which exponentials
//!   lie, and three points must agree;
//! - at most [`MAX_BRANCHES`] of them occur, k, and the claim holds at 24·2ᵏ points with branches drawn at
//!   random. A claim that fails for one choice of k signs passes with a probability below (1 − 2⁻ᵏ)^(24·2ᵏ) < e⁻²⁴.

use std::collections::BTreeSet;

use crate::identity::modular_point::ModularPoint;
use crate::limits::{
    AGREEMENTS, AGREEMENTS_PER_CHOICE, ATTEMPTS_PER_AGREEMENT, MAX_BRANCHES, MODULAR_ATTEMPTS,
};
use crate::{Binary, Expression, Graph, Node, Unary};

/// A test of claims about some expressions.
#[derive(Clone, Copy)]
pub(crate) struct IdentityTest {
    /// The number of roots, signs and absolute values that the expressions contain.
    branches: u32,
}

/// How functions with branches are interpreted, and at how many points a claim must hold.
#[derive(Clone, Copy)]
pub(super) struct Criterion {
    uninterpreted: bool,
    pub(super) agreements: usize,
}

impl Criterion {
    pub(super) fn points(self) -> impl Iterator<Item = ModularPoint> {
        let attempts = (self.agreements * ATTEMPTS_PER_AGREEMENT) as u64;
        (0..attempts.max(MODULAR_ATTEMPTS)).map(move |seed| {
            let point = ModularPoint::new(seed);
            if self.uninterpreted {
                point.uninterpreted()
            } else {
                point
            }
        })
    }
}

impl IdentityTest {
    pub(crate) fn of(graph: &Graph, roots: &[Expression]) -> Self {
        Self::of_parts(graph, graph.descendants(roots).into_iter())
    }

    /// The test of claims about what is made of these expressions.
    pub(crate) fn of_parts(graph: &Graph, parts: impl Iterator<Item = Expression>) -> Self {
        let mut branching = BTreeSet::new();
        for expression in parts {
            match graph.node(expression) {
                Node::Unary(Unary::Abs | Unary::Signum, x) => {
                    branching.insert((*x, *x));
                }
                Node::Binary(Binary::Min | Binary::Max, x, y) => {
                    branching.insert((*x, *y));
                }
                Node::Product(factors) => {
                    let roots = factors.iter().filter(|(_, k)| !k.is_integer());
                    // The root of x and its absolute value have branches of their own.
                    branching.extend(roots.map(|(x, _)| (graph.zero(), *x)));
                }
                _ => {}
            }
        }
        Self {
            branches: u32::try_from(branching.len()).unwrap_or(u32::MAX),
        }
    }

    /// The criteria for yes, in order.
    pub(super) fn criteria(self) -> impl Iterator<Item = Criterion> {
        let uninterpreted = Criterion {
            uninterpreted: true,
            agreements: AGREEMENTS,
        };
        let by_branches = (1..=MAX_BRANCHES)
            .contains(&self.branches)
            .then(|| Criterion {
                uninterpreted: false,
                agreements: AGREEMENTS_PER_CHOICE << self.branches,
            });
        core::iter::once(uninterpreted).chain(by_branches)
    }

    /// Whether a claim holds for every choice of branches, wherever it is defined. `claim` is `None` at a
    /// point that is outside of the domain.
    pub(crate) fn holds(self, claim: impl Fn(ModularPoint) -> Option<bool>) -> bool {
        let value = |point: ModularPoint| claim(point).map(|holds| holds.then_some(()));
        self.constant(value).is_some()
    }

    /// The value that is the same for every choice of branches, wherever it is defined. `value` is `None`
    /// at a point that is outside of the domain, and `Some(None)` where there is none.
    pub(crate) fn constant<T: PartialEq>(
        self,
        value: impl Fn(ModularPoint) -> Option<Option<T>>,
    ) -> Option<T> {
        self.criteria().find_map(|criterion| {
            let mut agreed = None;
            let mut values = criterion.points().filter_map(&value);
            for _ in 0..criterion.agreements {
                let found = values.next()??;
                if agreed.as_ref().is_some_and(|known| *known != found) {
                    return None;
                }
                agreed = Some(found);
            }
            agreed
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::identity::tested_value::TestedValue;
    use crate::{Rational, Symbol};

    /// Writes an expression of x and y.
    type Write = fn(&mut Graph, Expression, Expression) -> Expression;

    fn call(graph: &mut Graph, function: Unary, x: Expression) -> Expression {
        graph.unary(function, x)
    }

    /// √(2 (1 + cos y)) + sign·2 cos ½y.
    fn half_angle(graph: &mut Graph, y: Expression, sign: i64) -> Expression {
        let cos = call(graph, Unary::Cos, y);
        let sum = graph.add_constant(cos, &Rational::ONE);
        let twice = graph.scale(sum, &Rational::integer(2));
        let root = graph.square_root(twice);
        let half = graph.scale(y, &Rational::HALF);
        let cos = call(graph, Unary::Cos, half);
        graph.sum([(root, Rational::ONE), (cos, Rational::integer(2 * sign))])
    }

    /// √(x² − 12x + 36) + sign·(x − 6).
    fn root_of_square(graph: &mut Graph, x: Expression, sign: i64) -> Expression {
        let (one, square) = (graph.one(), graph.square(x));
        let terms = [(square, 1), (x, -12), (one, 36)];
        let sum = graph.sum(terms.map(|(x, c)| (x, Rational::integer(c))));
        let root = graph.square_root(sum);
        let distance = graph.add_constant(x, &Rational::integer(-6));
        graph.sum([(root, Rational::ONE), (distance, Rational::integer(sign))])
    }

    fn vanishes(write: Write) -> bool {
        let mut graph = Graph::new();
        let [x, y] = [0, 1].map(|i| graph.symbol(Symbol::Coordinate(i)));
        let root = write(&mut graph, x, y);
        graph.vanishes(&[root])
    }

    #[test]
    fn what_holds_for_every_choice_of_branches_is_an_identity() {
        let identities: [(&str, Write); 5] = [
            (
                "(√S + 2 cos)(√S − 2 cos), S = 4 cos²",
                |graph, _, y| {
                    let [plus, minus] = [1, -1].map(|sign| half_angle(graph, y, sign));
                    graph.multiply(plus, minus)
                },
            ),
            ("max + min − x − y", |graph, x, y| {
                let [max, min] =
                    [Binary::Max, Binary::Min].map(|function| graph.binary(function, x, y));
                let terms = [(max, 1), (min, 1), (x, -1), (y, -1)];
                graph.sum(terms.map(|(x, c)| (x, Rational::integer(c))))
            }),
            ("|x| signum x − x", |graph, x, _| {
                let [size, sign] =
                    [Unary::Abs, Unary::Signum].map(|function| call(graph, function, x));
                let product = graph.multiply(size, sign);
                graph.subtract(product, x)
            }),
            ("|x − y| − |y − x|", |graph, x, y| {
                let there = graph.subtract(x, y);
                let back = graph.subtract(y, x);
                let [there, back] = [there, back].map(|x| call(graph, Unary::Abs, x));
                graph.subtract(there, back)
            }),
            (
                "(√x + √y)² − x − y − 2√x√y",
                |graph, x, y| {
                    let [a, b] = [x, y].map(|x| graph.square_root(x));
                    let sum = graph.add(a, b);
                    let square = graph.square(sum);
                    let product = graph.multiply(a, b);
                    let terms = [(square, 1), (x, -1), (y, -1), (product, -2)];
                    graph.sum(terms.map(|(x, c)| (x, Rational::integer(c))))
                },
            ),
        ];
        for (what, write) in identities {
            assert!(vanishes(write), "{what}");
        }
    }

    #[test]
    fn what_holds_on_some_branches_is_none() {
        let others: [(&str, Write); 8] = [
            ("√S + 2 cos", |graph, _, y| half_angle(graph, y, 1)),
            ("√S − 2 cos", |graph, _, y| half_angle(graph, y, -1)),
            ("√(x − 6)² + x − 6", |graph, x, _| {
                root_of_square(graph, x, 1)
            }),
            ("√(x − 6)² − x + 6", |graph, x, _| {
                root_of_square(graph, x, -1)
            }),
            ("|x| + x", |graph, x, _| {
                let size = call(graph, Unary::Abs, x);
                graph.add(size, x)
            }),
            ("max − x", |graph, x, y| {
                let max = graph.binary(Binary::Max, x, y);
                graph.subtract(max, x)
            }),
            ("signum − 1", |graph, x, _| {
                let sign = call(graph, Unary::Signum, x);
                graph.add_constant(sign, &Rational::MINUS_ONE)
            }),
            // False for only one of sixteen choices.
            ("Π (1 + signum (x + k y))", |graph, x, y| {
                let mut factors = Vec::new();
                for k in 1..=4 {
                    let y = graph.scale(y, &Rational::integer(k));
                    let sum = graph.add(x, y);
                    let sign = call(graph, Unary::Signum, sum);
                    factors.push((graph.add_constant(sign, &Rational::ONE), Rational::ONE));
                }
                graph.product(factors)
            }),
        ];
        for (what, write) in others {
            assert!(!vanishes(write), "{what}");
        }
    }

    #[test]
    fn a_value_that_changes_its_sign_with_a_branch_is_no_constant() {
        let mut graph = Graph::new();
        let x = graph.symbol(Symbol::Coordinate(0));
        let sign = graph.unary(Unary::Signum, x);
        let square = graph.square(sign);
        let constant = |root: Expression| {
            IdentityTest::of(&graph, &[root])
                .constant(|point| Some(Some(point.evaluate(&graph, &[root])?[0])))
        };
        assert_eq!(constant(sign), None);
        assert_eq!(constant(square), Some(1));
        assert!(
            !IdentityTest::of(&graph, &[sign]).independent(
                &graph,
                &[sign],
                &[Symbol::Coordinate(0)],
                TestedValue::First
            )[0]
        );
    }
}
