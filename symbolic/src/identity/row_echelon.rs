//! The reduced row echelon form of a matrix modulo a prime, row by row (Golub and Van Loan, Matrix Computations, 4th
//! edition 2013, section 3.4): the first columns that are linearly independent, and the others in terms of them.

use crate::identity::residue;

/// The row space of the rows so far.
pub(crate) struct RowEchelon {
    p: u64,
    /// Rows with a leading 1, in the order of their pivots.
    rows: Vec<(usize, Vec<u64>)>,
}

impl RowEchelon {
    /// Without rows, modulo the prime p.
    pub(crate) const fn new(p: u64) -> Self {
        Self {
            p,
            rows: Vec::new(),
        }
    }

    /// Adds a row, and says whether it is independent of those before.
    pub(crate) fn add(&mut self, mut row: Vec<u64>) -> bool {
        for (pivot, above) in &self.rows {
            self.eliminate(&mut row, *pivot, above);
        }
        let Some(pivot) = row.iter().position(|entry| *entry != 0) else {
            return false;
        };
        let Some(scale) = residue::reciprocal(row[pivot], self.p) else {
            return false;
        };
        for entry in &mut row {
            *entry = residue::multiply(*entry, scale, self.p);
        }
        let place = self.rows.partition_point(|(other, _)| *other < pivot);
        self.rows.insert(place, (pivot, row));
        true
    }

    /// `row −= row[pivot] · above`.
    fn eliminate(&self, row: &mut [u64], pivot: usize, above: &[u64]) {
        if row[pivot] == 0 {
            return;
        }
        let factor = residue::negate(row[pivot], self.p);
        for (entry, above) in row.iter_mut().zip(above).skip(pivot) {
            if *above != 0 {
                let product = residue::multiply(factor, *above, self.p);
                *entry = residue::add(*entry, product, self.p);
            }
        }
    }

    /// The columns of the pivots, and the rows in which all other entries of these columns are 0.
    pub(crate) fn reduced(mut self) -> Vec<(usize, Vec<u64>)> {
        for k in (0..self.rows.len()).rev() {
            let (pivot, below) = self.rows[k].clone();
            let mut above: Vec<_> = self.rows.drain(..k).collect();
            for (_, row) in &mut above {
                self.eliminate(row, pivot, &below);
            }
            self.rows.splice(0..0, above);
        }
        self.rows
    }

    /// The number of independent rows.
    pub(crate) fn rank(&self) -> usize {
        self.rows.len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dependent_columns_are_multiples_of_those_before() {
        let p = 2_305_843_009_213_693_951;
        let mut echelon = RowEchelon::new(p);
        // The second column is twice the first one, the fourth the sum of the first and the third.
        assert!(echelon.add(vec![1, 2, 5, 6]));
        assert!(echelon.add(vec![3, 6, 7, 10]));
        assert!(!echelon.add(vec![4, 8, 12, 16]));
        assert_eq!(echelon.rank(), 2);
        let rows = echelon.reduced();
        assert_eq!(rows, [(0, vec![1, 2, 0, 1]), (2, vec![0, 0, 1, 1])]);
    }
}
