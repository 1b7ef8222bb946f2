//! Symbolic factorization M = L D Lᵀ (Golub and Van Loan, Matrix Computations, 4th edition 2013, section 4.1) and the
//! solution of M q̈ = f, for few coupled coordinates.
//!
//! The order of pivots: those that do not depend on the coordinates first, then by minimum degree, which bounds
//! the fill-in (Markowitz, The elimination form of the inverse, 1957; Tinney and Walker, Direct solutions of sparse
//! network equations by optimally ordered triangular factorization, 1967). Cancellation is exact: a Schur complement
//! such as I sin²θ + Iₛ cos²θ − (Iₛ cos θ)²/Iₛ is I sin²θ, with no digits lost near θ = 0. M is not inverted; the
//! solution is straight-line code with one division for each pivot.

pub(crate) mod stability;

use crate::limits::MAX_TRANSPARENT_ELIMINATION;
use crate::matrix::elimination_order::EliminationOrder;
use crate::matrix::rows::sums;
use crate::matrix::symmetric_elimination::{PivotRow, SymmetricElimination};
use crate::{Expression, Graph, Rational};

/// A symbolically factored symmetric matrix.
#[derive(Clone, Debug)]
pub struct Ldlt {
    /// The pivots, the entries of D, by coordinate. Where all are positive, M is positive definite and
    /// the solution is stable.
    pub pivots: Vec<Expression>,
    /// For a saddle point problem: further expressions that are positive where the solution is stable.
    pub(crate) conditions: Vec<Expression>,
    /// For a saddle point problem: the rows whose residuals refine a solution. These are the constraints if all coordinates are
    /// eliminated first, and otherwise all rows.
    refined: Vec<(usize, Vec<Expression>)>,
    /// The rows in the order of elimination, and the entries of each in the same order.
    rows: Vec<PivotRow<usize>>,
}

impl Ldlt {
    /// Factors M, unless there is no nonzero pivot, or a pivot row has more than `limit` other entries.
    pub fn factor(graph: &mut Graph, mass: &[Vec<Expression>], limit: usize) -> Option<Self> {
        let rewrite = rewriting(mass.len());
        let mut matrix = SymmetricElimination::new(graph, mass, |i| i);
        let mut pivots = vec![graph.zero(); mass.len()];
        let mut position = vec![0; mass.len()];
        let mut rows = Vec::with_capacity(mass.len());
        // Pivots come to vanish where the matrix is indefinite.
        let is_indefinite = (0..mass.len()).any(|i| graph.is_zero(mass[i][i]));
        for _ in mass {
            let mut best = best_pivot(graph, &matrix)?;
            while is_indefinite && graph.vanishes(&[matrix.pivot(best)?]) {
                matrix.remove_pivot(best);
                best = best_pivot(graph, &matrix)?;
            }
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
        Some(Self {
            pivots,
            conditions: Vec::new(),
            refined: Vec::new(),
            rows,
        })
    }

    /// Factors the matrix of a saddle point problem in the order that its [pattern](EliminationOrder) of zeros gives. None
    /// where it is not sparse, and where a pivot vanishes everywhere.
    pub(crate) fn factor_by_pattern(
        graph: &mut Graph,
        mass: &[Vec<Expression>],
        coordinates: usize,
    ) -> Option<Self> {
        let order = EliminationOrder::of(graph, mass, coordinates)?;
        let mut matrix = SymmetricElimination::new(graph, mass, |i| i);
        let mut pivots = vec![graph.zero(); mass.len()];
        let mut rows = Vec::with_capacity(mass.len());
        for (unknown, neighbours) in order.unknowns.into_iter().zip(order.neighbours) {
            let mut row = matrix.take(graph, unknown);
            // What cancels by an identity of functions is seen at a random point, and not by the graph.
            let is_coupled = |(i, _): &(usize, Expression)| neighbours.binary_search(i).is_ok();
            let (coupled, others): (Vec<_>, Vec<_>) = row.others.into_iter().partition(is_coupled);
            let others: Vec<_> = others.into_iter().map(|(_, entry)| entry).collect();
            if !others.is_empty() && !graph.vanishes(&others) {
                return None;
            }
            row.others = coupled;
            row.is_opaque = true;
            row.pivot = graph.opaque(row.pivot);
            for (_, entry) in &mut row.others {
                *entry = graph.opaque(*entry);
            }
            matrix.reduce(graph, &row, |_, entry| entry);
            pivots[unknown] = row.pivot;
            rows.push(row);
        }
        let is_regular = rows.iter().all(|row| !graph.is_zero(row.pivot));
        is_regular.then_some(Self {
            pivots,
            conditions: Vec::new(),
            refined: Vec::new(),
            rows,
        })
    }

    /// x in M x = `right`; of a saddle point problem, refined once (Higham, Accuracy and Stability of Numerical Algorithms, 2nd
    /// edition 2002, chapter 12), for the reason that the numerical factorization in `runtime/src/linalg/saddle_point.rs` has.
    pub fn solve(&self, graph: &mut Graph, right: &[Expression]) -> Vec<Expression> {
        let solution = self.eliminate(graph, right);
        if self.refined.is_empty() {
            return solution;
        }
        let rounded: Vec<_> = solution.iter().map(|x| graph.opaque(*x)).collect();
        let mut residuals = vec![graph.zero(); right.len()];
        for (i, row) in &self.refined {
            let mut terms = vec![(right[*i], Rational::ONE)];
            for (entry, x) in row.iter().zip(&rounded) {
                terms.push((graph.multiply(*entry, *x), Rational::MINUS_ONE));
            }
            let residual = graph.sum(terms);
            residuals[*i] = graph.opaque(residual);
        }
        let corrections = self.eliminate(graph, &residuals);
        sums(graph, &solution, &corrections)
    }

    /// x in M x = `right`, by the factors alone.
    fn eliminate(&self, graph: &mut Graph, right: &[Expression]) -> Vec<Expression> {
        let rewrite = rewriting(self.rows.len());
        // Opaque rows make what they use opaque, and what is added up until then is one sum.
        let is_opaque = self.rows.iter().any(|row| row.is_opaque);
        let rewrite_right = |graph: &mut Graph, entry| {
            if is_opaque {
                entry
            } else {
                rewrite(graph, entry)
            }
        };
        let mut right = right.iter().copied().enumerate().collect();
        for row in &self.rows {
            row.reduce_right(graph, &mut right, rewrite_right);
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
