//! Incremental evaluation of expressions at a modular point: when one symbol changes, only the expressions that
//! contain it are evaluated again.

use crate::identity::homomorphic_image::{Images, KnownImages};
use crate::identity::modular_point::ModularPoint;
use crate::{Expression, Graph, Symbol};

impl ModularPoint {
    /// The values of the roots modulo p, or `None` where one has no value at this point.
    #[must_use]
    pub fn evaluate(self, graph: &Graph, roots: &[Expression]) -> Option<Vec<u64>> {
        Some(IncrementalEvaluation::new(graph, roots, self)?.values())
    }
}

/// The images of some roots and of all their subexpressions at one point.
pub(crate) struct IncrementalEvaluation<'a> {
    graph: &'a Graph,
    roots: &'a [Expression],
    point: ModularPoint,
    images: Images,
}

impl<'a> IncrementalEvaluation<'a> {
    /// The evaluation of `roots`, unless one of them has no value at this point.
    pub(crate) fn new(
        graph: &'a Graph,
        roots: &'a [Expression],
        point: ModularPoint,
    ) -> Option<Self> {
        Self::of_descendants(graph, roots, &graph.descendants(roots), point)
    }

    /// The same, where `descendants` are what the roots are made of, children before parents.
    pub(crate) fn of_descendants(
        graph: &'a Graph,
        roots: &'a [Expression],
        descendants: &[Expression],
        point: ModularPoint,
    ) -> Option<Self> {
        let length = descendants.last().map_or(0, |last| last.index() + 1);
        let mut evaluation = Self {
            graph,
            roots,
            point,
            images: Images::zeros(length),
        };
        evaluation.evaluate(point, descendants)?;
        Some(evaluation)
    }

    /// The images of all that was evaluated.
    pub(crate) fn images(&self) -> &Images {
        &self.images
    }

    /// The values of the roots.
    pub(crate) fn values(&self) -> Vec<u64> {
        let images = &self.images;
        let value = |root: &Expression| images.get(*root).value;
        self.roots.iter().map(value).collect()
    }

    /// The values of the roots where `symbol` has another one, if they all exist. `dependents` are the
    /// expressions that contain it, children before parents.
    pub(crate) fn moving(&mut self, symbol: Symbol, dependents: &[Expression]) -> Option<Vec<u64>> {
        let images = &self.images;
        let before: Vec<_> = dependents.iter().map(|x| images.get(*x)).collect();
        let moved = self.evaluate(self.point.moving(symbol), dependents);
        let values = moved.map(|()| self.values());
        for (expression, image) in dependents.iter().zip(before) {
            self.images.set(*expression, image);
        }
        values
    }

    fn evaluate(&mut self, point: ModularPoint, expressions: &[Expression]) -> Option<()> {
        for expression in expressions {
            let image = point.image(self.graph.node(*expression), &self.images)?;
            self.images.set(*expression, image);
        }
        Some(())
    }
}
