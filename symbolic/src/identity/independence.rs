//! Of which symbols a function of several expressions is independent.
//!
//! Where images have derivatives, those by all symbols are accumulated at once: a function is independent of a symbol
//! whose derivative vanishes identically, by the bound of `identity_testing.rs`. Else each symbol is moved in turn, which
//! takes an evaluation for each of what depends on it.

use std::collections::BTreeMap;

use crate::algebra::dependence::Dependence;
use crate::identity::gradient;
use crate::identity::identity_testing::IdentityTest;
use crate::identity::incremental_evaluation::IncrementalEvaluation;
use crate::identity::tested_value::TestedValue;
use crate::{Expression, Graph, Node, Symbol};

impl IdentityTest {
    /// Of which of several symbols `value`, a function of the roots' values at a point, is independent; by the
    /// same criteria as for claims, all symbols at the same points.
    pub(crate) fn independent(
        self,
        graph: &Graph,
        roots: &[Expression],
        symbols: &[Symbol],
        value: TestedValue,
    ) -> Vec<bool> {
        let descendants = graph.descendants(roots);
        if gradient::exists(graph, &descendants) {
            self.independent_by_gradient(graph, (roots, &descendants), symbols, value)
        } else {
            self.independent_by_moving(graph, roots, symbols, value)
        }
    }

    /// The same by the derivatives at a point, where there are such.
    fn independent_by_gradient(
        self,
        graph: &Graph,
        (roots, descendants): (&[Expression], &[Expression]),
        symbols: &[Symbol],
        value: TestedValue,
    ) -> Vec<bool> {
        let mut occurring = BTreeMap::new();
        for expression in descendants {
            if let Node::Symbol(symbol) = graph.node(*expression) {
                occurring.insert(*symbol, expression.index());
            }
        }
        let places = symbols.iter().map(|symbol| occurring.get(symbol).copied());
        let places: Vec<Option<usize>> = places.collect();
        // No other criterion applies, since there are no branches.
        let Some(criterion) = self.criteria().next() else {
            return vec![false; symbols.len()];
        };
        let mut dependent = vec![false; symbols.len()];
        let mut agreements = 0;
        for point in criterion.points() {
            let evaluation =
                IncrementalEvaluation::of_descendants(graph, roots, descendants, point);
            let slopes = evaluation.and_then(|evaluation| {
                let weights = value.slopes(&evaluation.values(), point.p())?;
                let weights: Vec<_> = roots.iter().copied().zip(weights).collect();
                gradient::accumulated(graph, point, descendants, evaluation.images(), &weights)
            });
            let Some(slopes) = slopes else {
                continue;
            };
            let mut undecided = false;
            for (place, dependent) in places.iter().zip(&mut dependent) {
                *dependent |= place.is_some_and(|place| slopes[place] != 0);
                undecided |= place.is_some() && !*dependent;
            }
            agreements += 1;
            if !undecided || agreements == criterion.agreements {
                return dependent.into_iter().map(|dependent| !dependent).collect();
            }
        }
        // Outside of the domain everywhere: only what does not occur is known to be without effect.
        places.iter().map(Option::is_none).collect()
    }

    /// The same by moving each symbol.
    fn independent_by_moving(
        self,
        graph: &Graph,
        roots: &[Expression],
        symbols: &[Symbol],
        value: TestedValue,
    ) -> Vec<bool> {
        let mut tests = DependenceTest::new(graph, roots, symbols);
        for criterion in self.criteria() {
            tests.restart();
            for point in criterion.points() {
                if tests.are_decided() {
                    break;
                }
                if let Some(mut evaluation) = IncrementalEvaluation::new(graph, roots, point) {
                    tests.test_at(&mut evaluation, value, point.p(), criterion.agreements);
                }
            }
        }
        let answers = tests.answers.into_iter();
        answers.map(|answer| answer == Some(true)).collect()
    }
}

/// Of which of several symbols a value is independent, by its values where one of them has moved.
struct DependenceTest<'a> {
    symbols: &'a [Symbol],
    dependence: Dependence,
    answers: Vec<Option<bool>>,
    /// At how many points the value has stayed the same.
    agreements: Vec<usize>,
}

impl<'a> DependenceTest<'a> {
    fn new(graph: &Graph, roots: &[Expression], symbols: &'a [Symbol]) -> Self {
        let dependence = Dependence::of(graph, roots, symbols);
        let absent = |position| dependence.on(position).is_empty();
        Self {
            symbols,
            answers: (0..symbols.len())
                .map(|position| absent(position).then_some(true))
                .collect(),
            agreements: vec![0; symbols.len()],
            dependence,
        }
    }

    /// Tests again the symbols that were not found to be independent.
    fn restart(&mut self) {
        self.agreements.fill(0);
        for answer in &mut self.answers {
            *answer = answer.filter(|fixed| *fixed);
        }
    }

    fn are_decided(&self) -> bool {
        self.answers.iter().all(Option::is_some)
    }

    /// Evaluates at one point, and records what that decides.
    fn test_at(
        &mut self,
        evaluation: &mut IncrementalEvaluation<'_>,
        value: TestedValue,
        p: u64,
        enough: usize,
    ) {
        let Some(before) = value.of(&evaluation.values(), p) else {
            return;
        };
        for (position, symbol) in self.symbols.iter().enumerate() {
            if self.answers[position].is_some() {
                continue;
            }
            let values = evaluation.moving(*symbol, self.dependence.on(position));
            if let Some(after) = values.and_then(|values| value.of(&values, p)) {
                self.agreements[position] += 1;
                let decided = after != before || self.agreements[position] == enough;
                self.answers[position] = decided.then_some(after == before);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Rational, Unary};

    #[test]
    fn derivatives_and_moved_symbols_agree() {
        let mut graph = Graph::new();
        let [x, y, z] = [0, 1, 2].map(|i| graph.symbol(Symbol::Coordinate(i)));
        let two = Rational::integer(2);
        let [sine, cosine] = [Unary::Sin, Unary::Cos].map(|function| {
            let value = graph.unary(function, y);
            graph.power(value, &two)
        });
        // (1 + z) (sin² y + cos² y) + x, spelt so that no rule sees it; the determinant of a turned diagonal.
        let more = graph.add_constant(z, &Rational::ONE);
        let parts = [sine, cosine].map(|square| graph.multiply(square, more));
        let written = graph.sum(parts.into_iter().chain([x]).map(|x| (x, Rational::ONE)));
        let [a, b] = [x, z].map(|x| graph.square(x));
        let (c, s) = (graph.unary(Unary::Cos, y), graph.unary(Unary::Sin, y));
        let difference = graph.subtract(a, b);
        let mut off = graph.multiply(c, s);
        off = graph.multiply(off, difference);
        let entry = |graph: &mut Graph, first, second| {
            let terms = [(first, cosine), (second, sine)];
            let terms = terms.map(|(x, y)| (graph.multiply(x, y), Rational::ONE));
            graph.sum(terms)
        };
        let [first, last] = [entry(&mut graph, a, b), entry(&mut graph, b, a)];
        let symbols = [0, 1, 2, 3].map(Symbol::Coordinate);
        let cases = [
            (
                vec![written],
                TestedValue::First,
                [false, true, false, true],
            ),
            (vec![a], TestedValue::First, [false, true, true, true]),
            (
                vec![first, off, off, last],
                TestedValue::Determinant,
                [false, true, false, true],
            ),
        ];
        for (roots, value, expected) in cases {
            let test = IdentityTest::of(&graph, &roots);
            let descendants = graph.descendants(&roots);
            assert!(gradient::exists(&graph, &descendants));
            let by_gradient =
                test.independent_by_gradient(&graph, (&roots, &descendants), &symbols, value);
            let by_moving = test.independent_by_moving(&graph, &roots, &symbols, value);
            assert_eq!(by_gradient, expected);
            assert_eq!(by_moving, expected);
        }
    }
}
