//! A choice of well-conditioned columns of a matrix: orthogonalization with column pivoting (P. A. Businger & G. H. Golub,
//! *Linear least squares solutions by Householder transformations*, Numer. Math. **7** (1965) 269–276; Å. Björck,
//! *Numerical Methods for Least Squares Problems* (1996), 2.4 and 2.7).

use nalgebra::{SMatrix, SVector};

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
    /// several.
    pub(crate) fn choose_longest(&mut self, kept: &[bool; N]) {
        let mut longest: Option<(usize, f64)> = None;
        for i in (0..N).filter(|i| !kept[*i]) {
            let square = self.rest.column(i).norm_squared();
            let is_longer = longest.is_none_or(|(_, other)| square > other);
            if !self.is_chosen[i] && is_longer {
                longest = Some((i, square));
            }
        }
        if let Some((column, _)) = longest {
            self.choose(column);
        }
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
