//! Claims about expressions, tried at random points until they are taken for true.

use crate::algebra::dependence::Dependence;
use crate::decision::evaluation::Evaluation;
use crate::decision::point::Point;
use crate::{Binary, Expression, Graph, Node, Symbol, Unary};

/// Points to try until enough of them are in the domain: each square root halves their number.
const ATTEMPTS: u64 = 512;
/// Points at which a claim must hold to be taken for true. Where it is false, it is false at a random
/// point nearly always, but for corners: `min` and `max` are one of their arguments half of the time.
const AGREEMENTS: usize = 3;
const AGREEMENTS_WITH_CORNERS: usize = 64;

/// How often a claim about expressions is tried.
#[derive(Clone, Copy)]
pub(crate) struct Trial {
    agreements: usize,
}

impl Trial {
    pub(crate) fn of(graph: &Graph, roots: &[Expression]) -> Self {
        let corner = |node: &Node| {
            matches!(
                node,
                Node::Unary(Unary::Abs | Unary::Signum, _)
                    | Node::Binary(Binary::Min | Binary::Max, ..)
            )
        };
        let corners = graph
            .descendants(roots)
            .into_iter()
            .any(|expression| corner(graph.node(expression)));
        Self {
            agreements: if corners {
                AGREEMENTS_WITH_CORNERS
            } else {
                AGREEMENTS
            },
        }
    }

    /// Whether a claim holds wherever it makes sense. Where too many square roots leave no point, they
    /// are taken for arbitrary functions; where nothing can be said, the answer is no.
    pub(crate) fn holds(self, claim: impl Fn(Point) -> Option<bool>) -> bool {
        for points in [points, points_with_invented_roots] {
            let mut agreements = 0;
            for holds in points().filter_map(&claim) {
                agreements += 1;
                if !holds || agreements == self.agreements {
                    return holds;
                }
            }
        }
        false
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
        for points in [points, points_with_invented_roots] {
            questions.agreements.fill(0);
            for point in points() {
                if questions.are_answered() {
                    break;
                }
                if let Some(mut evaluation) = Evaluation::new(graph, roots, point) {
                    let value = |values: &[u64]| value(values, point);
                    questions.ask(&mut evaluation, value, self.agreements);
                }
            }
        }
        let answers = questions.answers.into_iter();
        answers.map(|answer| answer.unwrap_or(false)).collect()
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

type Points = core::iter::Map<core::ops::Range<u64>, fn(u64) -> Point>;

fn points() -> Points {
    (0..ATTEMPTS).map(Point::new)
}

fn points_with_invented_roots() -> Points {
    (0..ATTEMPTS).map(|seed| Point::new(seed).with_invented_roots())
}
