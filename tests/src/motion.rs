//! Motions of the reference values, beside which others are put.

use lagrangian::{Dop853, Dynamics, Phase, Problem, State};
use serde_json::Value;

use crate::{Figures, array, list, number, numbers, references, relative_error, rows};

/// A motion of the reference values.
#[derive(Clone, Debug)]
pub struct Motion {
    /// The system, with its parameters, its initial state and its samples.
    pub system: Value,
}

/// The motions of one system: all its scenarios.
///
/// # Panics
///
/// If there are none.
#[must_use]
pub fn motions(id: &str) -> Vec<Motion> {
    let document = references();
    let systems = list(&document["references"]).iter();
    let motions: Vec<Motion> = systems
        .filter(|system| system["id"] == id)
        .map(|system| Motion {
            system: system.clone(),
        })
        .collect();
    assert!(!motions.is_empty(), "there are no motions of {id}");
    motions
}

impl Motion {
    /// The value of a parameter.
    #[must_use]
    pub fn parameter(&self, name: &str) -> f64 {
        number(&self.system["params"][name])
    }

    /// The values of several parameters.
    #[must_use]
    pub fn parameters<const K: usize>(&self, names: [&str; K]) -> [f64; K] {
        names.map(|name| self.parameter(name))
    }

    /// Takes note of how far a motion from the same initial state is from this one: the greatest
    /// difference of coordinates and velocities at each sample, relative to the greatest of them or 1.
    ///
    /// # Panics
    ///
    /// If it does not arrive at the last sample.
    pub fn compare<const N: usize>(
        &self,
        name: &'static str,
        dynamics: &dyn Dynamics<State = Phase<f64, N>>,
        tolerance: f64,
        figures: &mut Figures,
    ) {
        let samples = list(&self.system["samples"]);
        let times: Vec<f64> = samples.iter().map(|sample| number(&sample["t"])).collect();
        let init = &self.system["init"];
        let start: State<f64, N> = State::new(times[0], array(&init["q"]), array(&init["qd"]));
        let method = Dop853::new()
            .relative_tolerance(1e-13)
            .absolute_tolerance(1e-13);
        let end = *times.last().expect("there are samples");
        let motion = Problem::new(dynamics, start).save(times).solve(end, method);
        let motion = motion.unwrap_or_else(|interrupted| panic!("{name}: {interrupted}"));
        for (state, sample) in motion.samples().iter().zip(samples) {
            let found = [rows(&state.q), rows(&state.v)].concat();
            let expected = [numbers(&sample["q"]), numbers(&sample["qd"])].concat();
            let at = format!("scenario {}, t = {}", self.system["scenario"], state.t);
            let error = relative_error(&found, &expected, 1.0);
            figures.record(name, &at, error, tolerance);
        }
    }
}
