//! Groups of coupled variables of a linear system: the connected components of the pattern of its matrices.
//!
//! Components are treated separately, so that a stiff component does not cost a soft one its accuracy.

use nalgebra::SMatrix;

use crate::scalar::Scalar;

/// Returns, for each variable, the least index among the variables coupled to it by nonzero entries, directly or
/// through others.
pub(super) fn components<S: Scalar, const N: usize>(matrices: &[&SMatrix<S, N, N>]) -> [usize; N] {
    let mut labels = core::array::from_fn(|i| i);
    // A label travels along at least one entry in each round.
    for _ in 0..N {
        let mut changed = false;
        for i in 0..N {
            for j in 0..N {
                let couples = |matrix: &&SMatrix<S, N, N>| {
                    let size = matrix[(i, j)].abs().largest();
                    size.is_nan() || size > 0.0
                };
                if labels[i] != labels[j] && matrices.iter().any(couples) {
                    let least: usize = labels[i].min(labels[j]);
                    labels[i] = least;
                    labels[j] = least;
                    changed = true;
                }
            }
        }
        if !changed {
            break;
        }
    }
    labels
}
