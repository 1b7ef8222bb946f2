//! Whether the motion of a constrained model is steady.
//!
//! Some coordinates move at constant velocities, and nothing else changes, since nothing depends on them: a relative equilibrium (E. J.
//! Routh, *Advanced Rigid Dynamics*, 6th edition (1905), 111; J. E. Marsden, *Lectures on Mechanics* (1992), chapter 4).

use super::tangent_choice::Chosen;
use super::tangent_error::TangentError;
use super::tangents::Tangents;
use crate::integrate::SingleNumber;
use crate::limits::analysis::MOVING;
use crate::linalg::column_widths;
use crate::model::{DirectionalDerivatives, State};

/// A motion whose independent accelerations vanish.
pub(super) struct SteadyMotion<'a, M, S, const N: usize, const C: usize>
where
    M: DirectionalDerivatives<N, C, S> + ?Sized,
    S: SingleNumber,
{
    pub(super) model: &'a M,
    pub(super) state: &'a State<S, N>,
    pub(super) inputs: &'a M::Inputs,
    pub(super) independent: &'a [bool; N],
}

impl<M, S, const N: usize, const C: usize> SteadyMotion<'_, M, S, N, C>
where
    M: DirectionalDerivatives<N, C, S> + ?Sized,
    S: SingleNumber,
{
    /// Checks that what moves acts on nothing else. Besides it, coordinates are left out on which nothing depends: in a circle, both
    /// coordinates of a place change, though one of them may be at rest at the moment. An equilibrium is steady.
    pub(super) fn check(&self) -> Result<(), TangentError> {
        let moving = self.moving();
        if !moving.contains(&true) {
            return Ok(());
        }
        let mut left_out = core::array::from_fn(|i| moving[i] || M::IGNORABLE[i]);
        loop {
            let chosen = Chosen {
                coordinates: None,
                velocities: Some(*self.independent),
                left_out,
            };
            let tangents = Tangents::at(self.model, self.state, self.inputs.clone(), chosen)?;
            let largest = tangents.largest_slope();
            let acting = |i: usize| {
                let variables = tangents.all_variables();
                tangents.check_acts(i, variables, largest).err()
            };
            let others = (0..N).filter(|i| left_out[*i] && !moving[*i]);
            let mut fewer = left_out;
            others
                .filter(|i| acting(*i).is_some())
                .for_each(|i| fewer[i] = false);
            if fewer == left_out {
                let found = (0..N).filter(|i| moving[*i]).find_map(acting);
                return found.map_or(Ok(()), Err);
            }
            left_out = fewer;
        }
    }

    /// Returns the coordinates whose velocities are not rounding errors, compared in the metric of M.
    fn moving(&self) -> [bool; N] {
        let prepared = self.model.prepare();
        let jacobian = self.model.constraint_jacobian(self.state, &prepared);
        let mass = self.model.mass_matrix(self.state, &prepared).diagonal();
        let widths = column_widths(&jacobian, &mass);
        let sizes: [f64; N] =
            core::array::from_fn(|i| (self.state.v[i] * widths[i]).abs().largest());
        let largest = sizes.iter().copied().fold(0.0, f64::max);
        sizes.map(|size| size > MOVING * S::machine_epsilon() * largest)
    }
}
