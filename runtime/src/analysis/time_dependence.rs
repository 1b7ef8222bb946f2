//! A test for equations of motion that depend on time, whose linearization at one time says nothing about later times.

use crate::integrate::SingleNumber;
use crate::limits::analysis::OTHER_TIMES;
use crate::model::{Lagrangian, Linearization, State, StateJacobian};

/// Returns whether the linearized equations about a state change with time.
///
/// If a model does not depend on time, its numbers at different times agree to the last bit.
pub(super) fn contains_time<S, M, const N: usize>(
    model: &M,
    state: &State<S, N>,
    slopes: &Linearization<S, N>,
) -> bool
where
    S: SingleNumber,
    M: Lagrangian<N, S, Model: StateJacobian<N, S>> + ?Sized,
{
    // NaN differs from itself.
    let differs = |x: &S, y: &S| (*x - *y).abs().largest() != 0.0;
    let zero = S::zero();
    if slopes.time.iter().any(|slope| differs(slope, &zero)) {
        return true;
    }
    let accelerations = model.accelerations(state);
    let mass = model.mass_matrix(state);
    OTHER_TIMES.iter().any(|after| {
        let mut later = *state;
        later.t += S::from_f64(*after);
        let there = model.linearize(&later);
        let matrices = [
            (&slopes.position, &there.position),
            (&slopes.velocity, &there.velocity),
            (&mass, &model.mass_matrix(&later)),
        ];
        let vectors = [
            (&accelerations, &model.accelerations(&later)),
            (&slopes.time, &there.time),
        ];
        matrices
            .iter()
            .any(|(x, y)| x.iter().zip(y.iter()).any(|(x, y)| differs(x, y)))
            || vectors
                .iter()
                .any(|(x, y)| x.iter().zip(y.iter()).any(|(x, y)| differs(x, y)))
    })
}
