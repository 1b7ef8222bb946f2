//! A side of the comparison.

use nalgebra::SVector;

/// Something that computes accelerations through a call that cannot be looked through.
pub(crate) trait Evaluation<const N: usize> {
    /// How this side takes a state.
    type State;

    /// The state of a row of the request: coordinates, then velocities.
    fn state(row: &[f64]) -> Self::State;

    /// The state, moved by the same vector in coordinates and in velocities.
    fn moved(state: &Self::State, by: &SVector<f64, N>) -> Self::State;

    /// The accelerations.
    fn evaluate(&self, state: &Self::State, accelerations: &mut SVector<f64, N>);
}
