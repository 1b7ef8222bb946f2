//! Symbolic factorization M = L D Lᵀ (Golub and Van Loan, Matrix Computations, 4th edition 2013, section 4.1) and the
//! solution of M q̈ = f, for few coupled coordinates.
//!
//! The order of pivots: those that do not depend on the coordinates first, then by minimum degree, which bounds
//! the fill-in (Markowitz, The elimination form of the inverse, 1957; Tinney and Walker, Direct solutions of sparse
//! network equations by optimally ordered triangular factorization, 1967). Cancellation is exact: a Schur complement
//! such as I sin²θ + Iₛ cos²θ − (Iₛ cos θ)²/Iₛ is I sin²θ, with no digits lost near θ = 0. M is not inverted; the
//! solution is straight-line code with one division for each pivot.

use crate::limits::{MAX_TRANSPARENT_ELIMINATION, MIN_CONSTRAINT_PIVOT};
use crate::matrix::symmetric_elimination::{PivotRow, SymmetricElimination};
use crate::{Expression, Graph, Rational};

/// A symbolically factored symmetric matrix.
#[derive(Clone, Debug)]
pub struct Ldlt {
    /// The pivots, the entries of D, by coordinate. Where all are positive, M is positive definite and
    /// the solution is stable.
    pub pivots: Vec<Expression>,
    /// The rows in the order of elimination, and the entries of each in the same order.
    rows: Vec<PivotRow<usize>>,
}

impl Ldlt {
    /// Factors M, unless there is no nonzero pivot, or a pivot row has more than `limit` other entries.
    pub fn factor(graph: &mut Graph, mass: &[Vec<Expression>], limit: usize) -> Option<Self> {
        Self::factor_by(graph, mass, limit, |graph, matrix| {
            best_pivot(graph, matrix)
        })
    }

    /// Factors the matrix of a saddle point problem, like M. The gradients of its constraints may depend on each other in the
    /// coordinates that are eliminated before them: their pivots then vanish identically until other coordinates are
    /// eliminated.
    pub(crate) fn factor_saddle_point(
        graph: &mut Graph,
        matrix: &[Vec<Expression>],
        limit: usize,
    ) -> Option<Self> {
        Self::factor_by(graph, matrix, limit, |graph, matrix| {
            loop {
                let best = best_pivot(graph, matrix)?;
                let pivot = matrix.diagonal(graph, best);
                if !graph.vanishes(&[pivot]) {
                    return Some(best);
                }
                matrix.clear_diagonal(best);
            }
        })
    }

    fn factor_by(
        graph: &mut Graph,
        mass: &[Vec<Expression>],
        limit: usize,
        best_pivot: impl Fn(&Graph, &mut SymmetricElimination<usize>) -> Option<usize>,
    ) -> Option<Self> {
        let rewrite = rewriting(mass.len());
        let mut matrix = SymmetricElimination::new(graph, mass, |i| i);
        let mut pivots = vec![graph.zero(); mass.len()];
        let mut position = vec![0; mass.len()];
        let mut rows = Vec::with_capacity(mass.len());
        for _ in mass {
            let best = best_pivot(graph, &mut matrix)?;
            let mut row = matrix.take(graph, best);
            if row.others.len() > limit {
                return None;
            }
            // Zeros are entries, too: what this row does not change is rewritten with the rest. Measured: without
            // them, of 34 models that change, 29 cost more and 5 less.
            let coupled = |i| row.others.iter().find(|(j, _)| i == *j);
            let entry = |i| coupled(i).map_or(graph.zero(), |(_, entry)| *entry);
            row.others = matrix.unknowns().map(|i| (i, entry(i))).collect();
            matrix.reduce(graph, &row, &rewrite);
            pivots[row.unknown] = row.pivot;
            position[row.unknown] = rows.len();
            rows.push(row);
        }
        for row in &mut rows {
            row.others.sort_by_key(|(i, _)| position[*i]);
        }
        Some(Self { pivots, rows })
    }

    /// Reverses the pivots of constraints, the rows of a saddle point problem from `coordinates` on, which are negative, and
    /// compares them with what the elimination of coordinates makes of them: the solution is stable where all pivots are
    /// positive.
    pub(crate) fn with_negative_pivots(mut self, graph: &mut Graph, coordinates: usize) -> Self {
        let (numerator, denominator) = MIN_CONSTRAINT_PIVOT;
        let least = Rational::new(-numerator, denominator).unwrap_or(Rational::ZERO);
        let count = self.pivots.len().saturating_sub(coordinates);
        let mut terms = vec![Vec::new(); count];
        let mut is_reduced = vec![false; count];
        for row in &self.rows {
            for (i, entry) in &row.others {
                let Some(constraint) = i.checked_sub(coordinates) else {
                    continue;
                };
                if graph.is_zero(*entry) {
                    continue;
                }
                if row.unknown < coordinates {
                    let factor = graph.divide(*entry, row.pivot);
                    let product = graph.multiply(factor, *entry);
                    terms[constraint].push((product, Rational::ONE));
                } else {
                    is_reduced[constraint] = true;
                }
            }
        }
        for ((pivot, terms), is_reduced) in self.pivots[coordinates..]
            .iter_mut()
            .zip(terms)
            .zip(is_reduced)
        {
            *pivot = graph.negate(*pivot);
            if is_reduced {
                let before = graph.sum(terms);
                *pivot = graph.sum([(*pivot, Rational::ONE), (before, least.clone())]);
            }
        }
        self
    }

    /// x in M x = `right`.
    pub fn solve(&self, graph: &mut Graph, right: &[Expression]) -> Vec<Expression> {
        let rewrite = rewriting(self.rows.len());
        let mut right = right.iter().copied().enumerate().collect();
        for row in &self.rows {
            row.reduce_right(graph, &mut right, &rewrite);
        }
        let mut solution = vec![graph.zero(); self.rows.len()];
        for row in self.rows.iter().rev() {
            let value = row.solve(graph, &right, |_, i| solution[i]);
            solution[row.unknown] = rewrite(graph, value);
        }
        solution
    }
}

/// How entries are rewritten: opaque, if the matrix is large.
fn rewriting(rows: usize) -> impl Fn(&mut Graph, Expression) -> Expression {
    move |graph, entry| {
        if rows > MAX_TRANSPARENT_ELIMINATION {
            graph.opaque(entry)
        } else {
            entry
        }
    }
}

/// The next pivot: free of coordinates, then of minimum degree, then the shortest.
fn best_pivot(graph: &Graph, matrix: &SymmetricElimination<usize>) -> Option<usize> {
    let best = matrix.pivots().min_by_key(|(i, pivot, degree)| {
        let varies = graph.contents(*pivot).varies();
        (varies, *degree, graph.descendants(&[*pivot]).len(), *i)
    });
    best.map(|(i, ..)| i)
}
