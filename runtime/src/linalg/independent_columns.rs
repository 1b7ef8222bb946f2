//! A choice of well-conditioned columns of a matrix: orthogonalization with column pivoting (P. A. Businger & G. H. Golub,
//! *Linear least squares solutions by Householder transformations*, Numer. Math. **7** (1965) 269–276; Å. Björck,
//! *Numerical Methods for Least Squares Problems* (1996), 2.4 and 2.7).

use nalgebra::{SMatrix, SVector};

use crate::limits::{MIN_INDEPENDENT_SINE, PREFERRED_LENGTH};

/// Columns of a matrix, of which some have been chosen.
pub(crate) struct ColumnChoice<const C: usize, const N: usize> {
    /// What is left of each column without the directions of those that are chosen.
    rest: SMatrix<f64, C, N>,
    pub(crate) is_chosen: [bool; N],
}

impl<const C: usize, const N: usize> ColumnChoice<C, N> {
    pub(crate) fn new(matrix: SMatrix<f64, C, N>) -> Self {
        Self {
            rest: matrix,
            is_chosen: [false; N],
        }
    }

    /// Chooses of the columns that are not kept the one that is farthest from the span of those that are chosen, the first of
    /// several. Preferred columns come before others whose distance is at most ten times as large (threshold pivoting: I. S. Duff,
    /// A. M. Erisman & J. K. Reid, *Direct Methods for Sparse Matrices*, 2nd edition (2017), 5.2 and 7.8). One that is kept is chosen where
    /// all others are in that span.
    pub(crate) fn choose_longest(&mut self, kept: &[bool; N], preferred: &[bool; N]) {
        let is_independent =
            |(_, square): &(usize, f64)| *square > MIN_INDEPENDENT_SINE * MIN_INDEPENDENT_SINE;
        let longest = self.longest(|i| !kept[i]).filter(is_independent);
        let among = self.longest(|i| !kept[i] && preferred[i]);
        let among = among.filter(|_| longest.is_some());
        let longest = longest.or_else(|| self.longest(|_| true));
        let is_long = |(_, square): &(usize, f64)| {
            longest.is_none_or(|(_, other)| *square >= PREFERRED_LENGTH * PREFERRED_LENGTH * other)
        };
        if let Some((column, _)) = among.filter(is_long).or(longest) {
            self.choose(column);
        }
    }

    /// Returns the longest of some columns that are not chosen, with the square of its length, if some are left.
    fn longest(&self, is_open: impl Fn(usize) -> bool) -> Option<(usize, f64)> {
        let mut longest: Option<(usize, f64)> = None;
        for i in (0..N).filter(|i| is_open(*i) && !self.is_chosen[*i]) {
            let square = self.rest.column(i).norm_squared();
            if longest.is_none_or(|(_, other)| square > other) {
                longest = Some((i, square));
            }
        }
        longest
    }

    /// Chooses a column, and takes its direction out of the others.
    pub(crate) fn choose(&mut self, column: usize) {
        self.is_chosen[column] = true;
        let direction: SVector<f64, C> = self.rest.column(column).into_owned();
        let square = direction.norm_squared();
        if square > 0.0 {
            for i in 0..N {
                let part = self.rest.column(i).dot(&direction) / square;
                self.rest.column_mut(i).axpy(-part, &direction, 1.0);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The second column is the longest, the third is preferred, unless it is much shorter.
    #[test]
    fn preferred_columns_come_first_unless_they_are_short() {
        let chosen = |length: f64, kept: [bool; 3]| {
            let matrix = SMatrix::<f64, 2, 3>::new(1.0, 2.0, length, 1.0, 0.0, 0.0);
            let mut choice = ColumnChoice::new(matrix);
            choice.choose_longest(&kept, &[false, false, true]);
            choice.is_chosen
        };
        let none = [false; 3];
        assert_eq!(chosen(0.21, none), [false, false, true]);
        assert_eq!(chosen(0.19, none), [false, true, false]);
        assert_eq!(chosen(0.21, [false, false, true]), [false, true, false]);
        assert_eq!(chosen(0.19, [false, true, false]), [false, false, true]);
        assert_eq!(chosen(0.5, [true, true, false]), [false, false, true]);
        assert_eq!(chosen(0.0, [true, true, false]), [false, true, false]);
    }
}
