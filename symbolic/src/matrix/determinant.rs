//! Symbolic determinants by expansion in minors (Gentleman and Johnson, Analysis of algorithms, a case study:
//! determinants of matrices with polynomial entries, 1976): sums of products, without a division.

use crate::{Expression, Graph, Rational};

/// The minor of some rows and as many columns of the matrix with these entries, expanded along the first row.
pub(crate) fn determinant(
    graph: &mut Graph,
    entry: &impl Fn(usize, usize) -> Expression,
    rows: &[usize],
    columns: &[usize],
) -> Expression {
    let Some((first, others)) = rows.split_first() else {
        return graph.one();
    };
    let mut terms = Vec::with_capacity(columns.len());
    for (position, column) in columns.iter().enumerate() {
        let element = entry(*first, *column);
        if graph.is_zero(element) {
            continue;
        }
        // As deep as the matrix has rows, of which there are few.
        let minor = determinant(graph, entry, others, &without(columns, position));
        terms.push((graph.multiply(element, minor), sign(position)));
    }
    graph.sum(terms)
}

/// The sign (−1)^position of a cofactor.
pub(crate) fn sign(position: usize) -> Rational {
    if position.is_multiple_of(2) {
        Rational::ONE
    } else {
        Rational::MINUS_ONE
    }
}

/// Indices without the one at `position`.
pub(crate) fn without(indices: &[usize], position: usize) -> Vec<usize> {
    let mut rest = indices.to_vec();
    rest.remove(position);
    rest
}
