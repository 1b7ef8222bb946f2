//! Symmetric elimination (Golub and Van Loan, Matrix Computations, 4th edition 2013, section 4.1): the row of a pivot is
//! taken out of the matrix, and multiples of it are subtracted from the rows it is coupled to. What is left is the
//! Schur complement of the pivot.
//!
//! Rows are sparse, by unknown. In which order they are taken out, and how entries are rewritten as they grow, is up
//! to those who eliminate.

use std::collections::BTreeMap;

use crate::{Expression, Graph, Rational};

/// A symmetric matrix in the course of elimination: both triangles, without zeros.
#[derive(Clone)]
pub(crate) struct SymmetricElimination<U> {
    rows: BTreeMap<U, BTreeMap<U, Expression>>,
}

/// A row that was taken out: D x = h − Σ others·x.
#[derive(Clone, Debug)]
pub(crate) struct PivotRow<U> {
    pub(crate) unknown: U,
    /// The diagonal entry D.
    pub(crate) pivot: Expression,
    /// The other entries; zeros may be among them.
    pub(crate) others: Vec<(U, Expression)>,
    /// Whether its entries over the pivot, and its right-hand sides, are opaque: each is one value wherever it is used.
    pub(crate) is_opaque: bool,
}

impl<U> Default for SymmetricElimination<U> {
    fn default() -> Self {
        let rows = BTreeMap::new();
        Self { rows }
    }
}

impl<U: Copy + Ord> SymmetricElimination<U> {
    /// A matrix of the unknowns `unknown(0)`, `unknown(1)` and so on.
    pub(crate) fn new(graph: &Graph, matrix: &[Vec<Expression>], unknown: fn(usize) -> U) -> Self {
        let mut rows = BTreeMap::new();
        for (i, row) in matrix.iter().enumerate() {
            let entries = row.iter().enumerate();
            let entries = entries.filter(|(_, entry)| !graph.is_zero(**entry));
            let entries = entries.map(|(j, entry)| (unknown(j), *entry));
            rows.insert(unknown(i), entries.collect());
        }
        Self { rows }
    }

    /// The unknowns whose rows have not been taken out.
    pub(crate) fn unknowns(&self) -> impl Iterator<Item = U> {
        self.rows.keys().copied()
    }

    /// The pivots that do not vanish, each with its unknown and the number of other entries.
    pub(crate) fn pivots(&self) -> impl Iterator<Item = (U, Expression, usize)> {
        let rows = self.rows.iter();
        rows.filter_map(|(u, row)| Some((*u, *row.get(u)?, row.len() - 1)))
    }

    /// The diagonal entry of an unknown, unless it is zero.
    pub(crate) fn pivot(&self, unknown: U) -> Option<Expression> {
        self.rows.get(&unknown)?.get(&unknown).copied()
    }

    /// Makes the diagonal entry of an unknown zero.
    pub(crate) fn remove_pivot(&mut self, unknown: U) {
        if let Some(row) = self.rows.get_mut(&unknown) {
            row.remove(&unknown);
        }
    }

    /// The rows that have not been taken out.
    pub(crate) fn rows(&self) -> impl Iterator<Item = (&U, &BTreeMap<U, Expression>)> {
        self.rows.iter()
    }

    /// The row of an unknown.
    pub(crate) fn row(&self, unknown: U) -> BTreeMap<U, Expression> {
        self.rows.get(&unknown).cloned().unwrap_or_default()
    }

    /// The matrix of some of its unknowns, which may have other names there.
    pub(crate) fn renamed(&self, name: impl Fn(U) -> Option<U>) -> Self {
        let renamed = self.rows.iter().filter_map(|(u, row)| {
            let row = row.iter().filter_map(|(v, x)| Some((name(*v)?, *x)));
            Some((name(*u)?, row.collect()))
        });
        Self {
            rows: renamed.collect(),
        }
    }

    /// Whether the matrix vanishes.
    pub(crate) fn is_zero(&self) -> bool {
        self.rows.values().all(BTreeMap::is_empty)
    }

    /// Takes the row and the column of an unknown out.
    pub(crate) fn take(&mut self, graph: &Graph, unknown: U) -> PivotRow<U> {
        let mut row = self.rows.remove(&unknown).unwrap_or_default();
        let pivot = row.remove(&unknown).unwrap_or(graph.zero());
        for other in row.keys() {
            if let Some(entries) = self.rows.get_mut(other) {
                entries.remove(&unknown);
            }
        }
        PivotRow {
            unknown,
            pivot,
            others: row.into_iter().collect(),
            is_opaque: false,
        }
    }

    /// Subtracts multiples of a row that was taken out from the rows it is coupled to.
    pub(crate) fn reduce(
        &mut self,
        graph: &mut Graph,
        row: &PivotRow<U>,
        rewrite: impl Fn(&mut Graph, Expression) -> Expression,
    ) {
        for (position, (u, entry)) in row.others.iter().enumerate() {
            if graph.is_zero(*entry) {
                continue;
            }
            let factor = row.factor(graph, *entry);
            for (v, other) in &row.others[..=position] {
                let change = graph.multiply(factor, *other);
                let after = graph.subtract(self.entry(graph, *u, *v), change);
                let after = rewrite(graph, after);
                self.set(graph, *u, *v, after);
            }
        }
    }

    /// Adds to an entry, on both sides of the diagonal.
    pub(crate) fn add(&mut self, graph: &mut Graph, u: U, v: U, change: Expression) {
        let after = graph.add(self.entry(graph, u, v), change);
        self.set(graph, u, v, after);
    }

    /// An entry, zero where there is none.
    pub(crate) fn entry(&self, graph: &Graph, u: U, v: U) -> Expression {
        let entry = self.rows.get(&u).and_then(|row| row.get(&v));
        entry.copied().unwrap_or(graph.zero())
    }

    /// Sets an entry, on both sides of the diagonal.
    pub(crate) fn set(&mut self, graph: &Graph, u: U, v: U, value: Expression) {
        for (x, y) in [(u, v), (v, u)] {
            let row = self.rows.entry(x).or_default();
            if graph.is_zero(value) {
                row.remove(&y);
            } else {
                row.insert(y, value);
            }
        }
    }
}

impl<U: Copy + Ord> PivotRow<U> {
    /// Its entry in the column of an unknown.
    pub(crate) fn entry(&self, unknown: U) -> Option<Expression> {
        let mut entries = self.others.iter();
        let entry = entries.find(|(u, _)| *u == unknown);
        entry.map(|(_, entry)| *entry)
    }

    /// One of its entries over the pivot.
    pub(crate) fn factor(&self, graph: &mut Graph, entry: Expression) -> Expression {
        let factor = graph.divide(entry, self.pivot);
        self.rewritten(graph, factor)
    }

    fn rewritten(&self, graph: &mut Graph, value: Expression) -> Expression {
        if self.is_opaque {
            graph.opaque(value)
        } else {
            value
        }
    }

    /// Subtracts the same multiples of its right-hand side from the others.
    pub(crate) fn reduce_right(
        &self,
        graph: &mut Graph,
        right: &mut BTreeMap<U, Expression>,
        rewrite: impl Fn(&mut Graph, Expression) -> Expression,
    ) {
        let zero = graph.zero();
        let own = right.get(&self.unknown).copied().unwrap_or(zero);
        let own = self.rewritten(graph, own);
        for (u, entry) in &self.others {
            let factor = self.factor(graph, *entry);
            let change = graph.multiply(factor, own);
            let before = right.get(u).copied().unwrap_or(zero);
            let after = graph.subtract(before, change);
            right.insert(*u, rewrite(graph, after));
        }
    }

    /// Its unknown, from the right-hand sides and the values of the others.
    pub(crate) fn solve(
        &self,
        graph: &mut Graph,
        right: &BTreeMap<U, Expression>,
        mut value: impl FnMut(&mut Graph, U) -> Expression,
    ) -> Expression {
        let own = right.get(&self.unknown).copied().unwrap_or(graph.zero());
        let own = self.rewritten(graph, own);
        let mut terms = vec![(own, Rational::ONE)];
        for (u, entry) in &self.others {
            let value = value(graph, *u);
            terms.push((graph.multiply(*entry, value), Rational::MINUS_ONE));
        }
        let rest = graph.sum(terms);
        graph.divide(rest, self.pivot)
    }
}
