//! A = L D Lᵀ of the inertia of the ignorable coordinates, in the order in which the pivots cost least.

use crate::matrix::symmetric_elimination::{PivotRow, SymmetricElimination};
use crate::{Expression, Graph, Rational};

/// The factors of A: the rows in the order of elimination.
#[derive(Clone, Debug, Default)]
pub(super) struct Elimination(Vec<PivotRow<usize>>);

impl Elimination {
    /// The factors of a symmetric matrix; a position without a pivot if it is singular.
    pub(super) fn of(graph: &mut Graph, matrix: &[Vec<Expression>]) -> Result<Self, usize> {
        let mut rest = SymmetricElimination::new(graph, matrix, |i| i);
        let mut rows = Vec::with_capacity(matrix.len());
        for _ in matrix {
            let regular = rest.pivots().filter(|x| !graph.vanishes(&[x.1]));
            let best = regular.min_by_key(|x| graph.cost(&[x.1])).map(|x| x.0);
            let first = rest.unknowns().next().unwrap_or(0);
            let unknown = best.ok_or(first)?;
            let row = rest.take(graph, unknown);
            rest.reduce(graph, &row, Graph::simplest);
            rows.push(row);
        }
        Ok(Self(rows))
    }

    /// y = L⁻¹ x.
    pub(super) fn forward(&self, graph: &mut Graph, x: Vec<Expression>) -> Vec<Expression> {
        let mut x = x.into_iter().enumerate().collect();
        for row in &self.0 {
            row.reduce_right(graph, &mut x, |_, entry| entry);
        }
        x.into_values().collect()
    }

    /// L⁻ᵀ D⁻¹ y.
    pub(super) fn backward(&self, graph: &mut Graph, y: &[Expression]) -> Vec<Expression> {
        let mut x = vec![graph.zero(); y.len()];
        for row in self.0.iter().rev() {
            let mut terms = vec![(graph.divide(y[row.unknown], row.pivot), Rational::ONE)];
            for (i, entry) in &row.others {
                let factor = row.factor(graph, *entry);
                terms.push((graph.multiply(factor, x[*i]), Rational::MINUS_ONE));
            }
            x[row.unknown] = graph.sum(terms);
        }
        x
    }

    /// yᵀ D⁻¹ z: the product xᵀ A⁻¹ w where y = L⁻¹ x and z = L⁻¹ w.
    pub(super) fn product(
        &self,
        graph: &mut Graph,
        y: &[Expression],
        z: &[Expression],
    ) -> Expression {
        let mut terms = Vec::with_capacity(self.0.len());
        for row in &self.0 {
            let product = graph.multiply(y[row.unknown], z[row.unknown]);
            terms.push((graph.divide(product, row.pivot), Rational::ONE));
        }
        graph.sum(terms)
    }
}
