//! Solving M q̈ = f before any number is known, for few coordinates.
//!
//! Symmetric elimination, M = L D Lᵀ, in an order of our choosing: pivots that do not depend on the
//! coordinates first, then those that fill least. What cancels is cancelled exactly: a Schur complement
//! such as I sin²θ + Iₛ cos²θ − (Iₛ cos θ)²/Iₛ is I sin²θ, with nothing lost near θ = 0. M is not
//! inverted; the solution is straight-line code with one division for each pivot.

use crate::{Binary, Expression, Graph, Node, Rational, Symbol, Unary};

/// A matrix factored before any number is known.
#[derive(Clone, Debug)]
pub struct Elimination {
    /// The pivots, the entries of D, by coordinate. Where all are positive, M is positive definite and
    /// the solution is stable.
    pub pivots: Vec<Expression>,
    /// Each row as it was when it was the pivot's.
    rows: Vec<Vec<Expression>>,
    order: Vec<usize>,
}

/// Entries of larger systems are kept whole: they would grow with each step.
const MOST_MERGED: usize = 4;

impl Elimination {
    /// Factors M, unless there is no pivot to begin with, or a pivot would meet more than `limit` others.
    pub fn factor(graph: &mut Graph, mass: &[Vec<Expression>], limit: usize) -> Option<Self> {
        let mut system = System {
            graph,
            matrix: mass.to_vec(),
        };
        let mut waiting: Vec<usize> = (0..mass.len()).collect();
        let mut order = Vec::new();
        while !waiting.is_empty() {
            let pivot = system.best_pivot(&waiting)?;
            waiting.retain(|row| *row != pivot);
            let others = waiting.iter();
            let coupled = others.filter(|i| !system.graph.is_zero(system.matrix[pivot][**i]));
            if coupled.count() > limit {
                return None;
            }
            system.eliminate(pivot, &waiting);
            order.push(pivot);
        }
        let rows = system.matrix;
        Some(Self {
            pivots: (0..rows.len()).map(|i| rows[i][i]).collect(),
            rows,
            order,
        })
    }

    /// x in M x = `right`.
    pub fn solve(&self, graph: &mut Graph, right: &[Expression]) -> Vec<Expression> {
        let mut right = right.to_vec();
        for (position, pivot) in self.order.iter().enumerate() {
            for i in &self.order[position + 1..] {
                let entry = self.rows[*pivot][*i];
                let factor = graph.divide(entry, self.rows[*pivot][*pivot]);
                let change = graph.multiply(factor, right[*pivot]);
                right[*i] = graph.subtract(right[*i], change);
                if self.rows.len() > MOST_MERGED {
                    right[*i] = graph.whole(right[*i]);
                }
            }
        }
        let mut solution = vec![graph.zero(); right.len()];
        for (position, pivot) in self.order.iter().enumerate().rev() {
            let mut terms = vec![(right[*pivot], Rational::ONE)];
            for later in &self.order[position + 1..] {
                let product = graph.multiply(self.rows[*pivot][*later], solution[*later]);
                terms.push((product, Rational::MINUS_ONE));
            }
            let rest = graph.sum(terms);
            solution[*pivot] = graph.divide(rest, self.rows[*pivot][*pivot]);
            if self.rows.len() > MOST_MERGED {
                solution[*pivot] = graph.whole(solution[*pivot]);
            }
        }
        solution
    }

    /// For each pivot Dᵢ, the sum of the magnitudes of its terms and of qⱼ ∂Dᵢ/∂qⱼ: what its rounding
    /// error is proportional to. An angle counts as 1 radian at most, since whole turns mean nothing;
    /// `angles` says which coordinates are angles.
    pub fn magnitudes(&self, graph: &mut Graph, angles: &[bool]) -> Vec<Expression> {
        let pivots = self.pivots.iter();
        pivots
            .map(|pivot| magnitude(graph, *pivot, angles))
            .collect()
    }
}

/// A symmetric system in the course of elimination. The row of a pivot keeps what it was.
struct System<'a> {
    graph: &'a mut Graph,
    matrix: Vec<Vec<Expression>>,
}

impl System<'_> {
    /// The row with the best pivot: free of coordinates, then with least to eliminate, then short.
    fn best_pivot(&self, waiting: &[usize]) -> Option<usize> {
        let candidates = waiting
            .iter()
            .filter(|i| !self.graph.is_zero(self.matrix[**i][**i]));
        candidates.copied().min_by_key(|i| {
            let pivot = self.matrix[*i][*i];
            let varies = self
                .graph
                .contains(&[pivot], |symbol| !matches!(symbol, Symbol::Parameter(_)));
            let others = waiting
                .iter()
                .filter(|j| *j != i && !self.graph.is_zero(self.matrix[*i][**j]));
            (
                varies,
                others.count(),
                self.graph.descendants(&[pivot]).len(),
                *i,
            )
        })
    }

    /// Subtracts multiples of the pivot's row from the others.
    fn eliminate(&mut self, pivot: usize, waiting: &[usize]) {
        for i in waiting {
            if self.graph.is_zero(self.matrix[*i][pivot]) {
                continue;
            }
            let factor = self
                .graph
                .divide(self.matrix[*i][pivot], self.matrix[pivot][pivot]);
            for j in waiting.iter().filter(|j| *j <= i) {
                let change = self.graph.multiply(factor, self.matrix[*j][pivot]);
                let mut entry = self.graph.subtract(self.matrix[*i][*j], change);
                if self.matrix.len() > MOST_MERGED {
                    entry = self.graph.whole(entry);
                }
                self.matrix[*i][*j] = entry;
                self.matrix[*j][*i] = entry;
            }
        }
    }
}

/// Σ |terms of D| + Σⱼ |qⱼ ∂D/∂qⱼ|.
fn magnitude(graph: &mut Graph, pivot: Expression, angles: &[bool]) -> Expression {
    let terms = match graph.node(pivot) {
        Node::Sum(terms) => terms.to_vec(),
        _ => vec![(pivot, Rational::ONE)],
    };
    let mut magnitudes: Vec<_> = terms
        .into_iter()
        .map(|(x, c)| (graph.unary(Unary::Abs, x), c.abs()))
        .collect();
    for (symbol, is_angle) in (0..).map(Symbol::Coordinate).zip(angles) {
        let slope = graph.derivative(pivot, symbol);
        let coordinate = graph.symbol(symbol);
        let [slope, mut size] = [slope, coordinate].map(|x| graph.unary(Unary::Abs, x));
        if *is_angle {
            let one = graph.one();
            size = graph.binary(Binary::Min, size, one);
        }
        magnitudes.push((graph.multiply(size, slope), Rational::ONE));
    }
    graph.sum(magnitudes)
}
