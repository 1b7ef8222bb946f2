//! Symbolic factorization M = L D Lᵀ (Golub and Van Loan, Matrix Computations, 4th edition 2013, section 4.1) and the
//! solution of M q̈ = f, for few coupled coordinates.
//!
//! The order of pivots: those that do not depend on the coordinates first, then by minimum degree, which bounds
//! the fill-in (Markowitz, The elimination form of the inverse, 1957; Tinney and Walker, Direct solutions of sparse
//! network equations by optimally ordered triangular factorization, 1967). Cancellation is exact: a Schur complement
//! such as I sin²θ + Iₛ cos²θ − (Iₛ cos θ)²/Iₛ is I sin²θ, with no digits lost near θ = 0. M is not inverted; the
//! solution is straight-line code with one division for each pivot.

use crate::identity::modular_point::ModularPoint;
use crate::limits::{MAX_TRANSPARENT_ELIMINATION, MIN_ELIMINATED_GRADIENT, MIN_SADDLE_POINT_PIVOT};
use crate::matrix::elimination_order::elimination_order;
use crate::matrix::symmetric_elimination::{PivotRow, SymmetricElimination};
use crate::{Expression, Graph, Node, Rational};

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

    /// Factors the matrix of a saddle point problem in the order that its [pattern](elimination_order) of zeros gives. None
    /// where it is not sparse, and where a pivot vanishes everywhere.
    pub(crate) fn factor_by_pattern(
        graph: &mut Graph,
        mass: &[Vec<Expression>],
        coordinates: usize,
    ) -> Option<Self> {
        let order = elimination_order(graph, mass, coordinates)?;
        if !order.is_sparse() {
            return None;
        }
        let mut matrix = SymmetricElimination::new(graph, mass, |i| i);
        let mut pivots = vec![graph.zero(); mass.len()];
        let mut rows = Vec::with_capacity(mass.len());
        for unknown in order.unknowns {
            let mut row = matrix.take(graph, unknown);
            row.is_opaque = true;
            row.pivot = graph.opaque(row.pivot);
            for (_, entry) in &mut row.others {
                *entry = graph.opaque(*entry);
            }
            matrix.reduce(graph, &row, |_, entry| entry);
            pivots[unknown] = row.pivot;
            rows.push(row);
        }
        let is_regular =
            rows.iter().all(|row| !graph.is_zero(row.pivot)) && !vanishes_any(graph, &pivots);
        is_regular.then_some(Self {
            pivots,
            conditions: Vec::new(),
            refined: Vec::new(),
            rows,
        })
    }

    /// Reverses the pivots of constraints, the rows of a saddle point problem from `coordinates` on, which are negative, and adds
    /// the conditions for a stable solution: where these and all pivots are positive, no entry loses or gains many digits.
    ///
    /// - A pivot is no small remainder of what it is subtracted from.
    /// - The pivot p of a constraint that is eliminated before a coordinate k, to which e couples it, leaves k with e²/p more:
    ///   this is no large multiple of what is left of Mₖₖ. Where k is without mass, e is no large multiple of the other components
    ///   of the gradient, of which p is made; that depends on units, as all pivoting does. A constraint whose coordinates are all
    ///   eliminated leaves no more than Mₖₖ: constraints among the other coordinates raise the inertia of k, but only by what the
    ///   freedom of these had taken from it.
    pub(crate) fn with_negative_pivots(
        mut self,
        graph: &mut Graph,
        mass: &[Vec<Expression>],
        coordinates: usize,
    ) -> Option<Self> {
        if coordinates == mass.len() {
            return Some(self);
        }
        for pivot in &mut self.pivots[coordinates..] {
            *pivot = graph.negate(*pivot);
        }
        let are_first = self.rows[..coordinates]
            .iter()
            .all(|row| row.unknown < coordinates);
        let refined = mass.iter().cloned().enumerate();
        self.refined = refined
            .skip(if are_first { coordinates } else { 0 })
            .collect();
        let mut conditions = Vec::new();
        for (position, row) in self.rows.iter().enumerate() {
            let pivot = self.pivots[row.unknown];
            if row.unknown < coordinates {
                if has_difference(graph, pivot) {
                    let before = mass[row.unknown][row.unknown];
                    conditions.push(exceeds(graph, pivot, before, MIN_SADDLE_POINT_PIVOT));
                }
                continue;
            }
            let [before, squares] = self.reductions(graph, row.unknown, position, coordinates);
            if self.reduces_by_constraint(graph, row.unknown, position, coordinates) {
                conditions.push(exceeds(graph, pivot, before, MIN_SADDLE_POINT_PIVOT));
            }
            if self.is_complete(graph, &mass[row.unknown], position, coordinates) {
                continue;
            }
            for (k, entry) in &row.others {
                if *k >= coordinates || graph.is_zero(*entry) {
                    continue;
                }
                let square = graph.multiply(*entry, *entry);
                let [reduction, _] = self.reductions(graph, *k, position, coordinates);
                let inertia = graph.subtract(mass[*k][*k], reduction);
                conditions.push(if graph.vanishes(&[inertia]) {
                    exceeds(graph, squares, square, MIN_ELIMINATED_GRADIENT)
                } else {
                    let product = graph.multiply(pivot, inertia);
                    exceeds(graph, product, square, MIN_SADDLE_POINT_PIVOT)
                });
            }
        }
        for condition in conditions {
            match graph.as_constant(condition) {
                Some(number) if *number > Rational::ZERO => {}
                Some(_) => return None,
                None if self.conditions.contains(&condition) => {}
                None => self.conditions.push(condition),
            }
        }
        Some(self)
    }

    /// What the elimination of coordinates before a position makes of the diagonal entry of an unknown, Σ e²/p, and Σ e² of its
    /// entries e there.
    fn reductions(
        &self,
        graph: &mut Graph,
        unknown: usize,
        position: usize,
        coordinates: usize,
    ) -> [Expression; 2] {
        let (mut quotients, mut squares) = (Vec::new(), Vec::new());
        for row in &self.rows[..position] {
            if row.unknown < coordinates {
                let entry = row.entry(unknown).unwrap_or(graph.zero());
                let factor = graph.divide(entry, row.pivot);
                quotients.push((graph.multiply(factor, entry), Rational::ONE));
                squares.push((graph.multiply(entry, entry), Rational::ONE));
            }
        }
        [graph.sum(quotients), graph.sum(squares)]
    }

    /// Whether constraints that are eliminated before a position change the diagonal entry of an unknown.
    fn reduces_by_constraint(
        &self,
        graph: &Graph,
        unknown: usize,
        position: usize,
        coordinates: usize,
    ) -> bool {
        let constraints = self.rows[..position].iter();
        let mut constraints = constraints.filter(|row| row.unknown >= coordinates);
        constraints.any(|row| {
            row.entry(unknown)
                .is_some_and(|entry| !graph.is_zero(entry))
        })
    }

    /// Whether the coordinates with these coefficients in the row of a constraint are all eliminated before a position.
    fn is_complete(
        &self,
        graph: &Graph,
        row: &[Expression],
        position: usize,
        coordinates: usize,
    ) -> bool {
        let mut later = self.rows[position..].iter().map(|row| row.unknown);
        later.all(|k| k >= coordinates || graph.is_zero(row[k]))
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
        let pairs = solution.into_iter().zip(corrections);
        pairs
            .map(|(x, correction)| graph.add(x, correction))
            .collect()
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

/// Whether one of these expressions vanishes, as far as a random point in modular arithmetic tells; false where there is none.
fn vanishes_any(graph: &Graph, expressions: &[Expression]) -> bool {
    let mut found = ModularPoint::attempts().filter_map(|point| point.evaluate(graph, expressions));
    found.next().is_some_and(|values| values.contains(&0))
}

/// What is positive where `x` exceeds this part of `y`.
fn exceeds(
    graph: &mut Graph,
    x: Expression,
    y: Expression,
    (numerator, denominator): (i64, i64),
) -> Expression {
    let least = Rational::new(-numerator, denominator).unwrap_or(Rational::ZERO);
    graph.sum([(x, Rational::ONE), (y, least)])
}

/// Whether terms are subtracted in a pivot.
fn has_difference(graph: &Graph, pivot: Expression) -> bool {
    let mut pivot = pivot;
    while let Node::Opaque(operand) = graph.node(pivot) {
        pivot = *operand;
    }
    match graph.node(pivot) {
        Node::Sum(terms) => terms.iter().any(|(_, factor)| factor.is_negative()),
        _ => false,
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
