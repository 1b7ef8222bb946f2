//! Where the integrations begin and where they end.

use std::collections::HashMap;
use std::fs;

use serde::Deserialize;

use crate::folders::Folders;
use crate::model::Model;

/// The time of all ends.
pub(crate) const END: f64 = 1000.0;

/// Coordinates and velocities at both ends; the file says where they come from.
#[derive(Clone, Debug, Deserialize)]
pub(crate) struct Trajectory {
    pub(crate) start: Vec<f64>,
    /// By the equations by hand, whose constants are folded in doubles.
    pub(crate) end: Vec<f64>,
    /// By the declared model, whose parameters are doubles.
    pub(crate) declared_end: Vec<f64>,
}

#[derive(Deserialize)]
struct File {
    trajectories: HashMap<String, Trajectory>,
}

impl Trajectory {
    pub(crate) fn of(folders: &Folders, model: Model) -> Result<Self, String> {
        let path = folders.peers.join("trajectories.json");
        let text = fs::read_to_string(&path).map_err(|error| error.to_string())?;
        let mut file: File = serde_json::from_str(&text).map_err(|error| error.to_string())?;
        let trajectory = file.trajectories.remove(&model.to_string());
        let components = 2 * model.degrees();
        trajectory
            .filter(|trajectory| {
                let Self {
                    start,
                    end,
                    declared_end,
                } = trajectory;
                [start, end, declared_end]
                    .iter()
                    .all(|state| state.len() == components)
            })
            .ok_or_else(|| format!("{model} has no reference trajectory"))
    }

    /// So many starts beside each other: the second coordinate grows by a thousandth from one to the next.
    pub(crate) fn starts(&self, count: u32) -> Vec<Vec<f64>> {
        let moved = |index| {
            let mut start = self.start.clone();
            start[1] += 1e-3 * f64::from(index);
            start
        };
        (0..count).map(moved).collect()
    }
}

/// The largest difference of a component, relative to the reference where that is greater than 1.
pub(crate) fn error(state: &[f64], reference: &[f64]) -> f64 {
    let pairs = state.iter().zip(reference);
    pairs.fold(0.0, |largest: f64, (x, reference)| {
        largest.max((x - reference).abs() / reference.abs().max(1.0))
    })
}
