//! Whether something holds identically: polynomial identity testing at random points (Schwartz, Fast
//! probabilistic algorithms for verification of polynomial identities, 1980; Zippel, Probabilistic
//! algorithms for sparse polynomials, 1979), extended to elementary functions as homomorphisms.
//!
//! The answer yes means for every choice of branches of √u, |u|, signum, min and max, which is more than
//! on the real branch; where it is not known, the answer is no, and nothing may be rewritten. Two ways
//! lead to yes, and no third one:
//!
//! - the claim holds with those functions as arbitrary ones. False claims pass at a point with a
//!   probability of about their degree over 10¹⁸, and three points are asked;
//! - at most [`MOST_BRANCHES`] of them occur, k, and the claim holds at 24·2ᵏ points with branches drawn at
//!   random. A claim that fails for one choice of k signs passes with a probability below (1 − 2⁻ᵏ)^(24·2ᵏ) < e⁻²⁴.

use std::collections::BTreeSet;

use crate::algebra::dependence::Dependence;
use crate::decision::evaluation::Evaluation;
use crate::decision::point::Point;
use crate::{Binary, Expression, Graph, Node, Symbol, Unary};

/// Points at which a claim must hold where branches do not matter.
const AGREEMENTS: usize = 3;
/// Points at which it must hold for each choice of branches, on average.
const AGREEMENTS_PER_CHOICE: usize = 24;
/// Points to try for each one that must be in the domain: a square root exists modulo half of the primes.
const ATTEMPTS_PER_AGREEMENT: usize = 16;
/// With more branches the second way is not taken: 768 points are enough for expressions as long as the
/// mass matrix of a top whose declaration contains five roots, within some 10 ms.
const MOST_BRANCHES: u32 = 5;

/// How claims about some expressions are tested.
#[derive(Clone, Copy)]
pub(crate) struct IdentityTest {
    /// The number of roots, signs and absolute values that the expressions contain.
    branches: u32,
}

/// Points to be asked, and how many of them must agree.
#[derive(Clone, Copy)]
struct Sample {
    uninterpreted: bool,
    agreements: usize,
}

impl Sample {
    fn points(self) -> impl Iterator<Item = Point> {
        let attempts = (self.agreements * ATTEMPTS_PER_AGREEMENT).max(64);
        (0..attempts as u64).map(move |seed| {
            let point = Point::new(seed);
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
        let mut branching = BTreeSet::new();
        for expression in graph.descendants(roots) {
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

    /// The ways to a yes, in order.
    fn samples(self) -> impl Iterator<Item = Sample> {
        let uninterpreted = Sample {
            uninterpreted: true,
            agreements: AGREEMENTS,
        };
        let by_branches = (1..=MOST_BRANCHES).contains(&self.branches).then(|| Sample {
            uninterpreted: false,
            agreements: AGREEMENTS_PER_CHOICE << self.branches,
        });
        core::iter::once(uninterpreted).chain(by_branches)
    }

    /// Whether a claim holds for every choice of branches, wherever it makes sense. `claim` is `None` at a
    /// point that is outside of the domain.
    pub(crate) fn holds(self, claim: impl Fn(Point) -> Option<bool>) -> bool {
        let value = |point: Point| claim(point).map(|holds| holds.then_some(()));
        self.constant(value).is_some()
    }

    /// The value that is the same for every choice of branches, wherever it makes sense. `value` is `None`
    /// at a point that is outside of the domain, and `Some(None)` where there is none.
    pub(crate) fn constant<T: PartialEq>(
        self,
        value: impl Fn(Point) -> Option<Option<T>>,
    ) -> Option<T> {
        self.samples().find_map(|sample| {
            let mut agreed = None;
            let mut values = sample.points().filter_map(&value);
            for _ in 0..sample.agreements {
                let found = values.next()??;
                if agreed.as_ref().is_some_and(|known| *known != found) {
                    return None;
                }
                agreed = Some(found);
            }
            agreed
        })
    }

    /// Which of several symbols may change without a change of `value`, which is made of the roots'
    /// values at a point; by the same rules, all symbols at the same points.
    pub(crate) fn fixed(
        self,
        graph: &Graph,
        roots: &[Expression],
        symbols: &[Symbol],
        value: impl Fn(&[u64], Point) -> Option<u64>,
    ) -> Vec<bool> {
        let mut questions = Questions::new(graph, roots, symbols);
        for sample in self.samples() {
            questions.reopen();
            for point in sample.points() {
                if questions.are_answered() {
                    break;
                }
                if let Some(mut evaluation) = Evaluation::new(graph, roots, point) {
                    let value = |values: &[u64]| value(values, point);
                    questions.ask(&mut evaluation, value, sample.agreements);
                }
            }
        }
        let answers = questions.answers.into_iter();
        answers.map(|answer| answer == Some(true)).collect()
    }
}

/// Whether a value stays the same when each of several symbols changes.
struct Questions<'a> {
    symbols: &'a [Symbol],
    dependence: Dependence,
    answers: Vec<Option<bool>>,
    /// At how many points the value has stayed the same.
    agreements: Vec<usize>,
}

impl<'a> Questions<'a> {
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

    /// Asks again what was not answered by yes.
    fn reopen(&mut self) {
        self.agreements.fill(0);
        for answer in &mut self.answers {
            *answer = answer.filter(|fixed| *fixed);
        }
    }

    fn are_answered(&self) -> bool {
        self.answers.iter().all(Option::is_some)
    }

    /// Looks at one point, and answers what that decides.
    fn ask(
        &mut self,
        evaluation: &mut Evaluation<'_>,
        value: impl Fn(&[u64]) -> Option<u64>,
        enough: usize,
    ) {
        let Some(before) = value(&evaluation.values()) else {
            return;
        };
        for (position, symbol) in self.symbols.iter().enumerate() {
            if self.answers[position].is_some() {
                continue;
            }
            let values = evaluation.moving(*symbol, self.dependence.on(position));
            if let Some(after) = values.and_then(|values| value(&values)) {
                self.agreements[position] += 1;
                let decided = after != before || self.agreements[position] == enough;
                self.answers[position] = decided.then_some(after == before);
            }
        }
    }
}
