//! The equations that an equilibrium or a steady motion satisfies, and the choice of their unknowns.

use super::balance::{Balance, Point, jacobian, residuals};
use super::jacobian_rows::{JacobianRows, Residuals, Variables};
use crate::integrate::SingleNumber;
use crate::scalar::Scalar;

/// The problem that a search solves, and the required accuracy.
#[derive(Debug)]
pub(super) struct EquilibriumProblem<B, S: Scalar, const N: usize, const U: usize> {
    pub(super) model: B,
    /// 1 for unknown variables, 0 for given ones.
    pub(super) unknown: Variables<S, N, U>,
    /// The prescribed momenta.
    pub(super) momenta: [Option<S>; N],
    /// The sizes in which steps are measured, if they are set.
    pub(super) sizes: Option<Variables<S, N, U>>,
    pub(super) tolerance: f64,
    pub(super) max_iterations: usize,
}

impl<B, S, const N: usize, const U: usize> EquilibriumProblem<B, S, N, U>
where
    B: Balance<S, N, U>,
    S: SingleNumber,
{
    /// Returns the sizes of the unknowns in a search from a point; 0 for given variables.
    pub(super) fn sizes(&self, start: &Point<S, N, U>) -> Variables<S, N, U> {
        let magnitudes = self.sizes.unwrap_or(Variables {
            positions: start.state.q,
            velocities: start.state.v,
            inputs: start.inputs,
        });
        magnitudes.zip_map(&self.unknown, |value, unknown| {
            let size = value.abs().largest();
            let size = if size > 0.0 { size } else { 1.0 };
            S::from_f64(size) * unknown
        })
    }

    /// Returns the residuals of the equations at a point.
    pub(super) fn residuals(&self, point: &Point<S, N, U>) -> Residuals<S, N> {
        residuals(&self.model, point, &self.momenta)
    }

    /// Returns the Jacobian at a point by the unknowns, in their sizes.
    pub(super) fn scaled_jacobian(
        &self,
        point: &Point<S, N, U>,
        sizes: &Variables<S, N, U>,
    ) -> JacobianRows<S, N, U> {
        let mut rows = jacobian(&self.model, point, &self.momenta);
        for row in rows.as_flattened_mut() {
            *row = row.zip_map(sizes, |slope, size| {
                if size.largest() > 0.0 {
                    slope * size
                } else {
                    S::zero()
                }
            });
        }
        JacobianRows::new(&rows)
    }
}
