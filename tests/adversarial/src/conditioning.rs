//! Errors of accelerations and multipliers beside the condition of the equations that they solve.

use serde_json::Value;

use crate::at::numbers;
use crate::comparison::Comparison;

/// The scales D in which the rows and columns of the matrix A of q̈ and λ have equal greatest entries, and the condition number of D A D.
#[derive(Clone, Debug)]
pub struct Conditioning {
    /// The condition number.
    pub condition: f64,
    /// The number of coordinates and constraints.
    pub unknowns: u32,
    /// D for the entries of the quantity that is compared.
    scales: Vec<f64>,
    /// The greatest entry of D⁻¹ x, of all unknowns x.
    size: f64,
}

impl Conditioning {
    /// The conditioning at a state of the data, for the accelerations and the multipliers; nothing for other quantities, and without
    /// constraints.
    ///
    /// # Panics
    ///
    /// If a state with scales lacks a condition number, accelerations or multipliers.
    #[must_use]
    pub fn of(state: &Value, quantity: &str) -> Option<Self> {
        let all = numbers(state.get("scales")?);
        let [accelerations, multipliers] =
            ["qdd", "lambda"].map(|name| numbers(&state["values"][name]));
        let scales = match quantity {
            "qdd" => all[..accelerations.len()].to_vec(),
            "lambda" => all[accelerations.len()..].to_vec(),
            _ => return None,
        };
        let unknowns = accelerations.iter().chain(&multipliers);
        let scaled = unknowns.zip(&all).map(|(x, d)| (x / d).abs());
        Some(Self {
            condition: numbers(&state["condition"])[0],
            unknowns: u32::try_from(all.len()).unwrap_or(u32::MAX),
            scales,
            size: scaled.fold(0.0, f64::max),
        })
    }

    /// |D⁻¹ δx| / |D⁻¹ x| with the greatest entries as norms; infinite where there is no value.
    #[must_use]
    pub fn relative_error(&self, comparison: &Comparison) -> f64 {
        if !comparison.error().is_finite() {
            return f64::INFINITY;
        }
        let found = comparison.found.as_deref().unwrap_or_default();
        let pairs = found.iter().zip(&comparison.expected);
        let scaled = pairs.zip(&self.scales).map(|((x, y), d)| (x - y).abs() / d);
        let error = scaled.fold(0.0, f64::max);
        if error > 0.0 { error / self.size } else { 0.0 }
    }
}
