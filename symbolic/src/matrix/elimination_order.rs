//! An order in which a sparse saddle point problem is eliminated, found from its pattern of zeros.
//!
//! Of the unknowns that are ready, the one is next whose elimination makes the fewest new entries (Tinney and Walker, Direct
//! solutions of sparse network equations by optimally ordered triangular factorization, 1967, scheme 3; Rose, A
//! graph-theoretic study of the numerical solution of sparse positive definite systems of linear equations, 1972). Loops that
//! are coupled to a few others each then take a fixed number of products, however many they are.
//!
//! A constraint is ready when the coordinates that it restricts are eliminated, except those without mass. Its pivot is then
//! the square of its gradient's distance from the span of the gradients before it, in the metric of the inverse inertia, and
//! no other zero is divided by: what is eliminated so far is the saddle point problem of these coordinates alone, which is
//! quasidefinite (Vanderbei, Symmetric quasidefinite matrices, 1995).

use std::collections::BTreeSet;

use crate::limits::{MAX_ELIMINATION_PRODUCTS, MAX_PIVOT_NEIGHBOURS, MIN_SPARSITY};
use crate::{Expression, Graph};

/// An order of elimination, and what it takes.
pub(crate) struct EliminationOrder {
    /// The unknowns.
    pub(crate) unknowns: Vec<usize>,
    /// How many others each of them is coupled to when it is eliminated.
    neighbours: Vec<usize>,
}

impl EliminationOrder {
    /// Whether elimination as straight-line code is worth it: the rows of pivots are short, or it takes a small part of the
    /// products of a dense numerical factorization.
    pub(crate) fn is_sparse(&self) -> bool {
        let size = self.neighbours.len();
        let products = |neighbours: usize| neighbours * (neighbours + 1) / 2 + 3 * neighbours;
        let sparse: usize = self.neighbours.iter().map(|count| products(*count)).sum();
        let dense: usize = (0..size).map(products).sum();
        let are_short = || {
            self.neighbours
                .iter()
                .all(|count| *count <= MAX_PIVOT_NEIGHBOURS)
        };
        sparse <= MAX_ELIMINATION_PRODUCTS && (MIN_SPARSITY * sparse <= dense || are_short())
    }
}

/// The pattern of what is left of a symmetric matrix in the course of elimination.
struct Pattern {
    /// The other entries of each row.
    neighbours: Vec<BTreeSet<usize>>,
    has_pivot: Vec<bool>,
    /// For each constraint: how many of its coordinates with mass are not eliminated.
    awaited: Vec<usize>,
    /// For each coordinate with mass: the constraints that restrict it.
    restricted_by: Vec<Vec<usize>>,
}

/// The order of the unknowns of a saddle point problem whose first unknowns are as many `coordinates`. None where the pattern
/// leaves no pivot, as where a coordinate without mass is held by no constraint.
pub(crate) fn elimination_order(
    graph: &Graph,
    matrix: &[Vec<Expression>],
    coordinates: usize,
) -> Option<EliminationOrder> {
    let mut pattern = Pattern::new(graph, matrix, coordinates);
    let mut left: BTreeSet<_> = (0..matrix.len()).collect();
    let mut order = EliminationOrder {
        unknowns: Vec::with_capacity(matrix.len()),
        neighbours: Vec::with_capacity(matrix.len()),
    };
    while !left.is_empty() {
        let ready = left.iter().copied().filter(|i| pattern.is_ready(*i));
        let best = ready.min_by_key(|i| (pattern.fill(*i), pattern.neighbours[*i].len(), *i))?;
        left.remove(&best);
        order.unknowns.push(best);
        order.neighbours.push(pattern.neighbours[best].len());
        pattern.eliminate(best);
    }
    Some(order)
}

impl Pattern {
    fn new(graph: &Graph, matrix: &[Vec<Expression>], coordinates: usize) -> Self {
        let is_entry = |i: usize, j: usize| !graph.is_zero(matrix[i][j]);
        let size = matrix.len();
        let has_pivot: Vec<_> = (0..size).map(|i| is_entry(i, i)).collect();
        let neighbours =
            (0..size).map(|i| (0..size).filter(|j| *j != i && is_entry(i, *j)).collect());
        let mut awaited = vec![0; size];
        let mut restricted_by = vec![Vec::new(); size];
        for constraint in coordinates..size {
            for coordinate in 0..coordinates {
                if has_pivot[coordinate] && is_entry(constraint, coordinate) {
                    awaited[constraint] += 1;
                    restricted_by[coordinate].push(constraint);
                }
            }
        }
        Self {
            neighbours: neighbours.collect(),
            has_pivot,
            awaited,
            restricted_by,
        }
    }

    fn is_ready(&self, unknown: usize) -> bool {
        self.has_pivot[unknown] && self.awaited[unknown] == 0
    }

    /// How many entries the elimination of an unknown adds.
    fn fill(&self, unknown: usize) -> usize {
        let neighbours = &self.neighbours[unknown];
        let missing = neighbours.iter().enumerate().map(|(position, i)| {
            let coupled = &self.neighbours[*i];
            let others = neighbours.iter().skip(position + 1);
            others.filter(|j| !coupled.contains(j)).count()
        });
        missing.sum()
    }

    fn eliminate(&mut self, unknown: usize) {
        let neighbours = std::mem::take(&mut self.neighbours[unknown]);
        for i in &neighbours {
            self.has_pivot[*i] = true;
            let row = &mut self.neighbours[*i];
            row.extend(neighbours.iter().filter(|j| *j != i));
            row.remove(&unknown);
        }
        for constraint in std::mem::take(&mut self.restricted_by[unknown]) {
            self.awaited[constraint] -= 1;
        }
    }
}
