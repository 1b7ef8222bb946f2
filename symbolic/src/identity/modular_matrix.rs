//! Determinants and inverses of matrices modulo a prime, by Gaussian elimination with row exchanges (Golub
//! and Van Loan, Matrix Computations, 4th edition 2013, section 3.4).

use crate::identity::residue;

/// The determinant modulo the prime p.
pub(crate) fn determinant(mut rows: Vec<Vec<u64>>, p: u64) -> Option<u64> {
    let mut determinant = 1;
    for k in 0..rows.len() {
        let Some(pivot) = (k..rows.len()).find(|i| rows[*i][k] != 0) else {
            return Some(0);
        };
        if pivot != k {
            rows.swap(pivot, k);
            determinant = residue::negate(determinant, p);
        }
        determinant = residue::multiply(determinant, rows[k][k], p);
        let inverse = residue::reciprocal(rows[k][k], p)?;
        let (upper, lower) = rows.split_at_mut(k + 1);
        for row in lower {
            let factor = residue::negate(residue::multiply(row[k], inverse, p), p);
            for (entry, above) in row.iter_mut().zip(&upper[k]).skip(k) {
                *entry = residue::add(*entry, residue::multiply(factor, *above, p), p);
            }
        }
    }
    Some(determinant)
}

/// The inverse modulo the prime p; none of a singular matrix.
pub(crate) fn inverse(matrix: Vec<Vec<u64>>, p: u64) -> Option<Vec<Vec<u64>>> {
    let n = matrix.len();
    let mut rows: Vec<Vec<u64>> = matrix
        .into_iter()
        .enumerate()
        .map(|(k, row)| {
            let unit = (0..n).map(|i| u64::from(i == k));
            row.into_iter().chain(unit).collect()
        })
        .collect();
    for k in 0..n {
        let pivot = (k..n).find(|i| rows[*i][k] != 0)?;
        rows.swap(k, pivot);
        let scale = residue::reciprocal(rows[k][k], p)?;
        for entry in &mut rows[k] {
            *entry = residue::multiply(*entry, scale, p);
        }
        let pivot_row = rows[k].clone();
        for (i, row) in rows.iter_mut().enumerate() {
            let factor = residue::negate(row[k], p);
            if i != k {
                for (entry, above) in row.iter_mut().zip(&pivot_row) {
                    *entry = residue::add(*entry, residue::multiply(factor, *above, p), p);
                }
            }
        }
    }
    Some(rows.into_iter().map(|row| row[n..].to_vec()).collect())
}
