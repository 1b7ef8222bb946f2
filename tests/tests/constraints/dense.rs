//! The accelerations and multipliers of a model beside a dense factorization of its saddle point problem, with complete pivoting.

use lagrangian::prelude::*;
use lagrangian::quantities::Constraints;
use nalgebra::{DMatrix, DVector};

/// Returns q̈ and λ as the model computes them, and as the factorization does.
pub(crate) fn solutions<M, const N: usize, const C: usize>(
    model: &M,
    state: &State<f64, N>,
) -> [Vec<f64>; 2]
where
    M: Constraints<N, C>,
{
    let (inputs, prepared) = (model.inputs(), model.prepare());
    let (accelerations, multipliers) =
        Constraints::accelerations_and_multipliers(model, state, &inputs, &prepared);
    let found = accelerations.iter().chain(&multipliers).copied();
    let mass = model.mass_matrix(state, &prepared);
    let jacobian = model.constraint_jacobian(state, &prepared);
    let matrix = DMatrix::from_fn(N + C, N + C, |i, j| match (i < N, j < N) {
        (true, true) => mass[(i, j)],
        (true, false) => -jacobian[(j - N, i)],
        (false, true) => -jacobian[(i - N, j)],
        (false, false) => 0.0,
    });
    let forcing = model.forcing(state, &inputs, &prepared);
    let rates = model.constraint_rates(state, &prepared);
    let right = forcing.iter().chain(&rates).copied();
    let right = DVector::from_iterator(N + C, right);
    let solution = matrix.full_piv_lu().solve(&right);
    let solution = solution.expect("a regular matrix");
    [found.collect(), solution.iter().copied().collect()]
}
