//! Matrices as lists of rows.

use crate::{Expression, Graph, Rational};

/// The transpose of a matrix.
pub(crate) fn transposed(matrix: &[Vec<Expression>]) -> Vec<Vec<Expression>> {
    let columns = matrix.first().map_or(0, Vec::len);
    (0..columns)
        .map(|j| matrix.iter().map(|row| row[j]).collect())
        .collect()
}

/// A x.
pub(crate) fn product(
    graph: &mut Graph,
    matrix: &[Vec<Expression>],
    values: &[Expression],
) -> Vec<Expression> {
    let mut products = Vec::with_capacity(matrix.len());
    for row in matrix {
        let mut terms = Vec::new();
        for (entry, value) in row.iter().zip(values) {
            if !graph.is_zero(*entry) {
                terms.push((graph.multiply(*entry, *value), Rational::ONE));
            }
        }
        products.push(graph.sum(terms));
    }
    products
}
