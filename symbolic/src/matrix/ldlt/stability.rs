//! Where the factors of a saddle point problem are stable without pivoting.
//!
//! Where all conditions and all pivots are positive, no entry loses or gains many digits:
//!
//! - A pivot is no small remainder of what it is subtracted from.
//! - A constraint that is eliminated before a coordinate k to which e couples it, with the pivot p, leaves k with e²/p more. This
//!   is no large multiple of what is left of Mₖₖ. Where k is without mass, e is no large multiple of the other components of the
//!   gradient, of which p is made; that depends on units, as all pivoting does.
//!
//! A constraint whose coordinates are all eliminated leaves no more than Mₖₖ: it raises the inertia of k, but only by what the
//! freedom of the coordinates before had taken from it.

use super::Ldlt;
use crate::limits::{MIN_ELIMINATED_GRADIENT, MIN_SADDLE_POINT_PIVOT};
use crate::matrix::symmetric_elimination::PivotRow;
use crate::{Expression, Graph, Node, Rational};

/// What constraints that are eliminated before a coordinate add to its diagonal entry.
#[derive(Clone, Default)]
struct Added {
    /// What is left of the entry before the first of them.
    inertia: Option<Expression>,
    terms: Vec<(Expression, Rational)>,
}

impl Ldlt {
    /// Reverses the pivots of constraints, the rows of a saddle point problem from `coordinates` on, which are negative, and adds
    /// the conditions for a stable solution. None where one of these never holds.
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
        for condition in self.stability(graph, mass, coordinates) {
            match graph.as_constant(condition) {
                Some(number) if *number > Rational::ZERO => {}
                Some(_) => return None,
                None if self.conditions.contains(&condition) => {}
                None => self.conditions.push(condition),
            }
        }
        Some(self)
    }

    /// The conditions, which are positive where the factors are stable.
    fn stability(
        &self,
        graph: &mut Graph,
        mass: &[Vec<Expression>],
        coordinates: usize,
    ) -> Vec<Expression> {
        let mut conditions = Vec::new();
        let mut added = vec![Added::default(); coordinates];
        for (position, row) in self.rows.iter().enumerate() {
            let (unknown, pivot) = (row.unknown, self.pivots[row.unknown]);
            if unknown < coordinates {
                let added = core::mem::take(&mut added[unknown]);
                conditions.extend(added.condition(graph));
                if has_difference(graph, pivot) {
                    let before = added.before(graph, mass[unknown][unknown]);
                    conditions.push(exceeds(graph, pivot, before, MIN_SADDLE_POINT_PIVOT));
                }
                continue;
            }
            if self.reduces_by_constraint(graph, unknown, position, coordinates) {
                let [before, _] = self.reductions(graph, unknown, position, coordinates);
                conditions.push(exceeds(graph, pivot, before, MIN_SADDLE_POINT_PIVOT));
            }
            if !self.is_complete(graph, &mass[unknown], position, coordinates) {
                for (k, entry) in &row.others {
                    if *k >= coordinates || graph.is_zero(*entry) {
                        continue;
                    }
                    let [reduction, _] = self.reductions(graph, *k, position, coordinates);
                    let inertia = graph.subtract(mass[*k][*k], reduction);
                    if row.is_opaque && !graph.is_zero(mass[*k][*k]) {
                        added[*k].add(graph, row, *entry, inertia);
                    } else {
                        let position = (position, coordinates);
                        let condition = self.growth(graph, position, (*entry, inertia));
                        conditions.push(condition);
                    }
                }
            }
        }
        conditions
    }

    /// The condition for what a constraint at a position, with so many coordinates, adds to a coordinate to which an entry couples
    /// it, where this is left of its inertia.
    fn growth(
        &self,
        graph: &mut Graph,
        (position, coordinates): (usize, usize),
        (entry, inertia): (Expression, Expression),
    ) -> Expression {
        let unknown = self.rows[position].unknown;
        let square = graph.multiply(entry, entry);
        if graph.vanishes(&[inertia]) {
            let [_, squares] = self.reductions(graph, unknown, position, coordinates);
            exceeds(graph, squares, square, MIN_ELIMINATED_GRADIENT)
        } else {
            let product = graph.multiply(self.pivots[unknown], inertia);
            exceeds(graph, product, square, MIN_SADDLE_POINT_PIVOT)
        }
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
}

impl Added {
    /// Adds what a constraint makes of the entry that couples the coordinate to it.
    fn add(
        &mut self,
        graph: &mut Graph,
        row: &PivotRow<usize>,
        entry: Expression,
        inertia: Expression,
    ) {
        self.inertia.get_or_insert(inertia);
        let quotient = graph.divide(entry, row.pivot);
        let quotient = graph.opaque(quotient);
        let term = graph.multiply(quotient, entry);
        self.terms.push((term, Rational::MINUS_ONE));
    }

    /// The condition that it is no large multiple of what is left.
    fn condition(&self, graph: &mut Graph) -> Option<Expression> {
        let inertia = self.inertia?;
        let added = graph.sum(self.terms.iter().cloned());
        Some(exceeds(graph, inertia, added, MIN_SADDLE_POINT_PIVOT))
    }

    /// The sum of the diagonal entry and what is added to it.
    fn before(&self, graph: &mut Graph, entry: Expression) -> Expression {
        let terms = self.terms.iter().cloned();
        graph.sum(terms.chain([(entry, Rational::ONE)]))
    }
}

/// What is positive where `x` exceeds this part of `y`.
pub(crate) fn exceeds(
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
