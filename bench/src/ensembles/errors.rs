//! The errors of the members of an ensemble.

use crate::trajectories::error;

/// The final states that all are compared with.
pub(super) struct Reference(pub(super) Vec<Vec<f64>>);

/// The errors of an ensemble: the 90th percentile over its members, and the largest.
#[derive(Clone, Copy, Debug)]
pub(super) struct Errors {
    pub(super) percentile: f64,
    pub(super) largest: f64,
}

impl Reference {
    /// Both are infinite if there are other numbers of members, or numbers that are none.
    pub(super) fn errors(&self, states: &[Vec<f64>]) -> Errors {
        let pairs = states.iter().zip(&self.0);
        let mut errors: Vec<f64> = pairs.map(|(state, end)| error(state, end)).collect();
        errors.sort_unstable_by(f64::total_cmp);
        let all_finite = states
            .iter()
            .flatten()
            .all(|component| component.is_finite());
        match (errors.get(errors.len() * 9 / 10), errors.last()) {
            (Some(&percentile), Some(&largest)) if all_finite && states.len() == self.0.len() => {
                Errors {
                    percentile,
                    largest,
                }
            }
            _ => Errors {
                percentile: f64::INFINITY,
                largest: f64::INFINITY,
            },
        }
    }
}
