//! Gauss–Jordan elimination over the field of functions of the known parameters (Geddes, Czapor and Labahn, Algorithms
//! for Computer Algebra, 1992, section 9.2).
//!
//! Entries are expressions beside their values at one random modular point, which tell what is 0.

use crate::identity::residue;
use crate::{Expression, Graph, ModularPoint};

/// An expression with its value modulo p.
#[derive(Clone, Copy)]
struct Entry {
    expression: Expression,
    value: u64,
}

/// The rows of the reduced row echelon form, each with the column of its pivot; none where an entry has no value at any
/// point.
pub(crate) fn regroup(
    graph: &mut Graph,
    matrix: &[Vec<Expression>],
) -> Option<Vec<(usize, Vec<Expression>)>> {
    let entries = matrix.concat();
    let columns = matrix.first().map_or(0, Vec::len);
    let (values, p) = ModularPoint::attempts()
        .find_map(|point| Some((point.evaluate(graph, &entries)?, point.p())))?;
    let pairs = entries.into_iter().zip(values);
    let entries: Vec<_> = pairs
        .map(|(expression, value)| Entry { expression, value })
        .collect();
    let rows = entries.chunks(columns.max(1)).map(<[Entry]>::to_vec);
    let mut elimination = Elimination {
        graph,
        p,
        rows: rows.collect(),
    };
    let mut pivots = Vec::new();
    for column in 0..columns {
        if let Some(row) = elimination.pivot(pivots.len(), column) {
            elimination.rows.swap(pivots.len(), row);
            elimination.eliminate(pivots.len(), column)?;
            pivots.push(column);
        }
    }
    let rows = pivots.into_iter().zip(elimination.rows);
    Some(
        rows.map(|(pivot, row)| (pivot, row.iter().map(|x| x.expression).collect()))
            .collect(),
    )
}

struct Elimination<'a> {
    graph: &'a mut Graph,
    p: u64,
    rows: Vec<Vec<Entry>>,
}

impl Elimination<'_> {
    /// The row from `first` on whose entry in a column is the simplest that does not vanish.
    fn pivot(&self, first: usize, column: usize) -> Option<usize> {
        let candidates = (first..self.rows.len()).filter(|i| self.rows[*i][column].value != 0);
        candidates.min_by_key(|i| {
            let entries = self.rows[*i].iter().map(|entry| entry.expression);
            let pivot = self.rows[*i][column].expression;
            let is_number = self.graph.as_constant(pivot).is_some();
            (!is_number, self.graph.cost(&entries.collect::<Vec<_>>()))
        })
    }

    /// Makes the entry of a row in a column 1, and those of all other rows 0.
    fn eliminate(&mut self, row: usize, column: usize) -> Option<()> {
        let pivot = self.rows[row][column];
        let scale = residue::reciprocal(pivot.value, self.p)?;
        let mut scaled = self.rows[row].clone();
        for entry in &mut scaled {
            entry.expression = self.graph.divide(entry.expression, pivot.expression);
            entry.value = residue::multiply(entry.value, scale, self.p);
        }
        for other in 0..self.rows.len() {
            let factor = self.rows[other][column];
            if other == row || factor.value == 0 {
                continue;
            }
            for (j, above) in scaled.iter().enumerate() {
                let entry = self.rows[other][j];
                self.rows[other][j] = self.difference(entry, factor, *above);
            }
        }
        self.rows[row] = scaled;
        Some(())
    }

    /// entry − factor · above.
    fn difference(&mut self, entry: Entry, factor: Entry, above: Entry) -> Entry {
        let product = residue::multiply(factor.value, above.value, self.p);
        let value = residue::add(entry.value, residue::negate(product, self.p), self.p);
        if value == 0 {
            let expression = self.graph.zero();
            return Entry { expression, value };
        }
        if above.value == 0 {
            return entry;
        }
        let product = self.graph.multiply(factor.expression, above.expression);
        let difference = self.graph.subtract(entry.expression, product);
        Entry {
            expression: self.graph.simplest(difference),
            value,
        }
    }
}
