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

/// x + y, entry by entry.
pub(crate) fn sums(graph: &mut Graph, x: &[Expression], y: &[Expression]) -> Vec<Expression> {
    let pairs = x.iter().zip(y);
    pairs.map(|(x, y)| graph.add(*x, *y)).collect()
}

/// x − y, entry by entry.
pub(crate) fn differences(
    graph: &mut Graph,
    x: &[Expression],
    y: &[Expression],
) -> Vec<Expression> {
    let pairs = x.iter().zip(y);
    pairs.map(|(x, y)| graph.subtract(*x, *y)).collect()
}

/// Whether x and y are the same functions, entry by entry.
pub(crate) fn agree(graph: &mut Graph, x: &[Expression], y: &[Expression]) -> bool {
    let differences = differences(graph, x, y);
    graph.vanishes(&differences)
}
