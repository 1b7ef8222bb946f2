//! What models evaluate to beside the references.

use std::fs;

use serde_json::Value;

use crate::{
    MODELS,
    at::{At, numbers},
};

/// One quantity of one model at one state.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The identifier of the model.
    pub model: String,
    /// Which of its states.
    pub state: usize,
    /// The quantity, by the name that the data have for it.
    pub quantity: &'static str,
    /// Its entries row by row.
    pub found: Vec<f64>,
    /// Those of the reference.
    pub expected: Vec<f64>,
    /// The greatest distance that any entry may have.
    pub tolerance: f64,
}

impl Comparison {
    /// The greatest distance between two entries; infinite where one is not finite.
    ///
    /// # Panics
    ///
    /// If there are more entries than in the reference, or fewer.
    #[must_use]
    pub fn error(&self) -> f64 {
        assert_eq!(self.found.len(), self.expected.len(), "lengths differ");
        let pairs = self.found.iter().zip(&self.expected);
        let distance = |(found, expected): (&f64, &f64)| {
            let distance = (found - expected).abs();
            if distance.is_finite() {
                distance
            } else {
                f64::INFINITY
            }
        };
        pairs.map(distance).fold(0.0, f64::max)
    }

    /// Whether no entry is farther off than it may be.
    ///
    /// # Panics
    ///
    /// As [`error`](Self::error).
    #[must_use]
    pub fn is_within(&self) -> bool {
        self.error() <= self.tolerance
    }
}

/// Evaluates every model at its states, and compares all quantities.
///
/// # Panics
///
/// If the data cannot be read, or have no value for a quantity.
#[must_use]
pub fn compare() -> Vec<Comparison> {
    let text = fs::read_to_string(env!("MODELS")).expect("the file of models can be read");
    let document: Value = serde_json::from_str(&text).expect("the file of models is JSON");
    let models = document["models"].as_array().expect("a list of models");
    assert_eq!(models.len(), MODELS.len());
    let mut comparisons = Vec::new();
    for (model, (id, evaluate)) in models.iter().zip(MODELS) {
        assert_eq!(model["id"], *id);
        let states = model["states"].as_array().expect("a list of states");
        for (index, state) in states.iter().enumerate() {
            for (quantity, found) in evaluate(&At::new(state)) {
                comparisons.push(Comparison {
                    model: (*id).to_owned(),
                    state: index,
                    quantity,
                    found,
                    expected: numbers(&state["values"][quantity]),
                    tolerance: numbers(&state["tolerances"][quantity])[0],
                });
            }
        }
    }
    comparisons
}
