//! Symbolic factorization M = L D Lᵀ (Golub and Van Loan, Matrix Computations, 4th edition 2013, section 4.1) and the
//! solution of M q̈ = f, for few coupled coordinates.
//!
//! The order of pivots: those that do not depend on the coordinates first, then by minimum degree, which bounds
//! the fill-in (Markowitz, The elimination form of the inverse, 1957; Tinney and Walker, Direct solutions of sparse
//! network equations by optimally ordered triangular factorization, 1967). Cancellation is exact: a Schur complement
//! such as I sin²θ + Iₛ cos²θ − (Iₛ cos θ)²/Iₛ is I sin²θ, with no digits lost near θ = 0. M is not inverted; the
//! solution is straight-line code with one division for each pivot.

use crate::limits::LARGEST_TRANSPARENT_ELIMINATION;
use crate::{Expression, Graph, Rational, Symbol};

/// A symbolically factored symmetric matrix.
#[derive(Clone, Debug)]
pub struct Ldlt {
    /// The pivots, the entries of D, by coordinate. Where all are positive, M is positive definite and
    /// the solution is stable.
    pub pivots: Vec<Expression>,
    /// Each row at the time when it was the pivot row.
    rows: Vec<Vec<Expression>>,
    order: Vec<usize>,
}

impl Ldlt {
    /// Factors M, unless there is no nonzero pivot, or a pivot row has more than `limit` other entries.
    pub fn factor(graph: &mut Graph, mass: &[Vec<Expression>], limit: usize) -> Option<Self> {
        let mut partial = PartialFactorization {
            graph,
            matrix: mass.to_vec(),
        };
        let mut waiting: Vec<usize> = (0..mass.len()).collect();
        let mut order = Vec::new();
        while !waiting.is_empty() {
            let pivot = partial.best_pivot(&waiting)?;
            waiting.retain(|row| *row != pivot);
            let others = waiting.iter();
            let coupled = others.filter(|i| !partial.graph.is_zero(partial.matrix[pivot][**i]));
            if coupled.count() > limit {
                return None;
            }
            partial.eliminate(pivot, &waiting);
            order.push(pivot);
        }
        let rows = partial.matrix;
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
                if self.rows.len() > LARGEST_TRANSPARENT_ELIMINATION {
                    right[*i] = graph.opaque(right[*i]);
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
            if self.rows.len() > LARGEST_TRANSPARENT_ELIMINATION {
                solution[*pivot] = graph.opaque(solution[*pivot]);
            }
        }
        solution
    }
}

/// A symmetric matrix in the course of elimination. The row of a pivot keeps its values.
struct PartialFactorization<'a> {
    graph: &'a mut Graph,
    matrix: Vec<Vec<Expression>>,
}

impl PartialFactorization<'_> {
    /// The row of the next pivot: free of coordinates, then of minimum degree, then with the shortest pivot.
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
                if self.matrix.len() > LARGEST_TRANSPARENT_ELIMINATION {
                    entry = self.graph.opaque(entry);
                }
                self.matrix[*i][*j] = entry;
                self.matrix[*j][*i] = entry;
            }
        }
    }
}
