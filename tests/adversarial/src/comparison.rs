//! What models evaluate to beside the references.

use std::path::PathBuf;
use std::sync::mpsc;
use std::time::Duration;
use std::{env, fs, thread};

use serde_json::Value;

use crate::{
    Entries, Evaluate, Found, MODELS,
    at::{At, numbers},
    conditioning::Conditioning,
};

/// One quantity of one model at one state.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The identifier of the model.
    pub model: String,
    /// Which of its states.
    pub state: usize,
    /// The quantity, by the name that the data have for it.
    pub quantity: String,
    /// Its entries row by row, or why there are none.
    pub found: Entries,
    /// Those of the reference.
    pub expected: Vec<f64>,
    /// The greatest distance that any entry may have.
    pub tolerance: f64,
    /// Of the accelerations and multipliers of a model with constraints.
    pub conditioning: Option<Conditioning>,
}

impl Comparison {
    /// The greatest distance between two entries; infinite where one is not finite, and where there are none or not as many
    /// as in the reference.
    #[must_use]
    pub fn error(&self) -> f64 {
        let Ok(found) = &self.found else {
            return f64::INFINITY;
        };
        if found.len() != self.expected.len() {
            return f64::INFINITY;
        }
        let pairs = found.iter().zip(&self.expected);
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
    #[must_use]
    pub fn is_within(&self) -> bool {
        self.error() <= self.tolerance
    }
}

/// The models of a file.
fn read(path: PathBuf) -> Vec<Value> {
    let text = fs::read_to_string(path).expect("the file of models can be read");
    let mut document: Value = serde_json::from_str(&text).expect("the file of models is JSON");
    match document["models"].take() {
        Value::Array(models) => models,
        other => panic!("expected a list of models, found {other}"),
    }
}

/// What a model evaluates to at a state; that there is no end of it, for every quantity, if it takes too long.
fn evaluated(evaluate: Evaluate, state: &Value) -> Vec<(String, Entries)> {
    let at = At::new(state);
    let (sender, receiver) = mpsc::channel();
    // A thread that does not end goes on until the process ends.
    thread::spawn(move || sender.send(evaluate(&at)));
    let name = |(quantity, found): Found| (quantity.to_owned(), found);
    match receiver.recv_timeout(LONGEST) {
        Ok(found) => found.into_iter().map(name).collect(),
        Err(error) => {
            let quantities = state["values"].as_object().expect("values by quantity");
            let none = |quantity: &String| (quantity.clone(), Err(format!("no value: {error}")));
            quantities.keys().map(none).collect()
        }
    }
}

/// The longest time for a state.
const LONGEST: Duration = Duration::from_secs(60);

/// Evaluates every model at its states, and compares all quantities.
///
/// # Panics
///
/// If the data cannot be read, or have no value for a quantity.
#[must_use]
pub fn compare() -> Vec<Comparison> {
    let mut comparisons = Vec::new();
    compare_each(|comparison| comparisons.push(comparison));
    comparisons
}

/// Hands over each comparison as soon as it is made.
///
/// # Panics
///
/// As [`compare`].
pub fn compare_each(mut hand_over: impl FnMut(Comparison)) {
    let models: Vec<Value> = env::split_paths(env!("MODELS")).flat_map(read).collect();
    assert_eq!(models.len(), MODELS.len());
    for (model, (id, evaluate)) in models.iter().zip(MODELS) {
        assert_eq!(model["id"], *id);
        let states = model["states"].as_array().expect("a list of states");
        for (index, state) in states.iter().enumerate() {
            let mut found = evaluated(*evaluate, state);
            let expected = state["values"].as_object().expect("values by quantity");
            let missing = expected
                .keys()
                .filter(|name| !found.iter().any(|(of, _)| of == *name));
            let missing: Vec<_> = missing
                .map(|name| (name.clone(), Err("is not evaluated".to_owned())))
                .collect();
            found.extend(missing);
            for (quantity, found) in found {
                hand_over(Comparison {
                    model: (*id).to_owned(),
                    state: index,
                    expected: numbers(&state["values"][&quantity]),
                    tolerance: numbers(&state["tolerances"][&quantity])[0],
                    conditioning: Conditioning::of(state, &quantity),
                    quantity,
                    found,
                });
            }
        }
    }
}
