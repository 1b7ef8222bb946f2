//! The states at which the members of an ensemble begin.

use std::f64::consts::TAU;

use crate::model::Model;

/// So many members.
const MEMBERS: u32 = 10_000;

/// Returns the starts of a model: coordinates and then velocities, which oscillate about the starts in `peers/trajectories.json`,
/// each with another number of periods, from the first member to the last.
pub(super) fn of(model: Model) -> Result<Vec<Vec<f64>>, String> {
    let (middle, spread): (&[f64], &[f64]) = match model {
        Model::SymmetricTop => (
            &[0.0, 0.5, 0.0, 0.3, 0.0, 20.0],
            &[0.0, 0.2, 0.0, 0.2, 0.2, 4.0],
        ),
        Model::GeneralTop => (
            &[0.0, 0.8, 0.2, 0.3, 0.1, 20.0],
            &[0.0, 0.2, 0.2, 0.2, 0.1, 4.0],
        ),
        // Below these angles the motions are regular; at rest above one radian they are chaotic.
        Model::Pendulum(2) => (&[0.4, 0.2, 0.0, 0.0], &[0.2, 0.2, 0.3, 0.3]),
        other => return Err(format!("there is no ensemble of {other}")),
    };
    let start = |member: u32| {
        let part = f64::from(member) / f64::from(MEMBERS);
        let mut periods = 1.0;
        let components = middle.iter().zip(spread);
        let moved = components.map(|(middle, spread)| {
            periods += 2.0;
            middle + spread * f64::sin(TAU * periods * part)
        });
        moved.collect()
    };
    Ok((0..MEMBERS).map(start).collect())
}
