//! A = L D Lᵀ of the inertia of the ignorable coordinates, in the order in which the pivots cost least.

use crate::{Expression, Graph, Rational};

/// The factors of A.
#[derive(Clone, Debug, Default)]
pub(super) struct Elimination {
    /// The positions, in the order of elimination.
    order: Vec<usize>,
    /// The pivots, by position.
    pivots: Vec<Expression>,
    /// lᵢₖ in row i and column k; zero unless i comes after k.
    lower: Vec<Vec<Expression>>,
}

impl Elimination {
    /// The factors of a symmetric matrix; a position without a pivot if it is singular.
    pub(super) fn of(graph: &mut Graph, mut rest: Vec<Vec<Expression>>) -> Result<Self, usize> {
        let n = rest.len();
        let mut found = Self {
            order: Vec::new(),
            pivots: vec![graph.zero(); n],
            lower: vec![vec![graph.zero(); n]; n],
        };
        let mut left: Vec<usize> = (0..n).collect();
        while let Some(first) = left.first().copied() {
            let regular = left
                .iter()
                .copied()
                .filter(|k| !graph.vanishes(&[rest[*k][*k]]));
            let Some(k) = regular.min_by_key(|k| graph.cost(&[rest[*k][*k]])) else {
                return Err(first);
            };
            let pivot = rest[k][k];
            left.retain(|i| *i != k);
            for i in &left {
                found.lower[*i][k] = graph.divide(rest[*i][k], pivot);
            }
            for i in &left {
                for j in left.iter().filter(|j| *j <= i) {
                    let change = graph.multiply(found.lower[*i][k], rest[k][*j]);
                    let entry = graph.subtract(rest[*i][*j], change);
                    let entry = graph.simplest(entry);
                    rest[*i][*j] = entry;
                    rest[*j][*i] = entry;
                }
            }
            found.pivots[k] = pivot;
            found.order.push(k);
        }
        Ok(found)
    }

    /// y = L⁻¹ x.
    pub(super) fn forward(&self, graph: &mut Graph, mut x: Vec<Expression>) -> Vec<Expression> {
        for k in &self.order {
            for i in 0..x.len() {
                let change = graph.multiply(self.lower[i][*k], x[*k]);
                x[i] = graph.subtract(x[i], change);
            }
        }
        x
    }

    /// L⁻ᵀ D⁻¹ y.
    pub(super) fn backward(&self, graph: &mut Graph, y: &[Expression]) -> Vec<Expression> {
        let mut x = vec![graph.zero(); y.len()];
        for k in self.order.iter().rev() {
            let mut terms = vec![(graph.divide(y[*k], self.pivots[*k]), Rational::ONE)];
            for (i, solved) in x.iter().enumerate() {
                terms.push((
                    graph.multiply(self.lower[i][*k], *solved),
                    Rational::MINUS_ONE,
                ));
            }
            x[*k] = graph.sum(terms);
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
        let mut terms = Vec::new();
        for k in &self.order {
            let product = graph.multiply(y[*k], z[*k]);
            terms.push((graph.divide(product, self.pivots[*k]), Rational::ONE));
        }
        graph.sum(terms)
    }
}
