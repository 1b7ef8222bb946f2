//! What is computed of the values of several expressions at a modular point, and tested.

use crate::identity::modular_matrix;
use crate::identity::residue;

/// A function of the values of several expressions.
#[derive(Clone, Copy, Debug)]
pub(crate) enum TestedValue {
    /// The value of the first.
    First,
    /// The determinant of a square matrix, row by row.
    Determinant,
}

impl TestedValue {
    /// The function modulo the prime p.
    pub(crate) fn of(self, values: &[u64], p: u64) -> Option<u64> {
        match self {
            Self::First => values.first().copied(),
            Self::Determinant => modular_matrix::determinant(rows(values), p),
        }
    }

    /// Its derivatives by the values: of a determinant these are its cofactors (Jacobi, De formatione et proprietatibus
    /// determinantium, 1841). None of a singular matrix.
    pub(crate) fn slopes(self, values: &[u64], p: u64) -> Option<Vec<u64>> {
        let mut slopes = vec![0; values.len()];
        match self {
            Self::First => *slopes.first_mut()? = 1,
            Self::Determinant => {
                let determinant = modular_matrix::determinant(rows(values), p)?;
                let inverse = modular_matrix::inverse(rows(values), p)?;
                let n = inverse.len();
                for (position, slope) in slopes.iter_mut().enumerate() {
                    let entry = inverse[position % n][position / n];
                    *slope = residue::multiply(determinant, entry, p);
                }
            }
        }
        Some(slopes)
    }
}

/// A square matrix by rows.
fn rows(values: &[u64]) -> Vec<Vec<u64>> {
    let rows = values.chunks(values.len().isqrt().max(1));
    rows.map(<[u64]>::to_vec).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::identity::residue::Field;

    #[test]
    fn the_slopes_of_a_determinant_are_its_differences() {
        // A determinant is linear in each entry, so that its difference by one is its derivative.
        let p = Field::of(3).p;
        let values: Vec<u64> = (0..16).map(|k| residue::mix(9, k) % p).collect();
        let slopes = TestedValue::Determinant.slopes(&values, p).unwrap();
        let before = TestedValue::Determinant.of(&values, p).unwrap();
        for (position, slope) in slopes.iter().enumerate() {
            let mut moved = values.clone();
            moved[position] = residue::add(moved[position], 1, p);
            let after = TestedValue::Determinant.of(&moved, p).unwrap();
            assert_eq!(residue::add(before, *slope, p), after);
        }
    }
}
