//! The choice of independent coordinates and velocities of a constrained model.

use super::tangent_error::{IndependentVariables, TangentError};
use crate::model::DegreesOfFreedom;

/// What is chosen by the user; the rest is proposed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chosen<const N: usize> {
    pub(super) coordinates: Option<[bool; N]>,
    pub(super) velocities: Option<[bool; N]>,
    pub(super) left_out: [bool; N],
}

/// Which coordinates and velocities are independent, and which coordinates are left out.
#[derive(Clone, Copy)]
pub(super) struct Choice<const N: usize> {
    pub(super) coordinates: [bool; N],
    pub(super) velocities: [bool; N],
    pub(super) left_out: [bool; N],
}

impl<const N: usize> Chosen<N> {
    /// Returns the coordinates that are independent as far as the degrees of freedom allow.
    pub(super) fn kept(&self) -> [bool; N] {
        core::array::from_fn(|i| {
            self.left_out[i] || self.coordinates.is_some_and(|chosen| chosen[i])
        })
    }

    /// Returns the choice with what is proposed, if it has the right numbers of variables.
    pub(super) fn completed<const C: usize>(
        &self,
        freedom: &DegreesOfFreedom<N, C>,
    ) -> Result<Choice<N>, TangentError> {
        let [coordinates, velocities] = freedom.marks();
        let coordinates = self.coordinates.map_or(coordinates, |_| self.kept());
        let velocities = self.velocities.unwrap_or(velocities);
        let numbers = [freedom.coordinates, freedom.velocities];
        for (variables, marks) in [
            (IndependentVariables::Coordinates, &coordinates),
            (IndependentVariables::Velocities, &velocities),
        ] {
            let chosen = marks.iter().filter(|mark| **mark).count();
            let independent = variables.of(numbers);
            if chosen != independent {
                return Err(TangentError::Count {
                    variables,
                    chosen,
                    independent,
                });
            }
        }
        Ok(Choice {
            coordinates,
            velocities,
            left_out: self.left_out,
        })
    }
}
