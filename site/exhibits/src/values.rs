//! The values of the sliders of an exhibit.

use crate::about::{About, Quantity};

/// The values of all sliders, by their names.
#[derive(Clone, Debug)]
pub struct Values {
    quantities: &'static [Quantity],
    values: Vec<f64>,
}

impl Values {
    /// The values in the order of the quantities; missing ones are those with which the exhibit opens.
    #[must_use]
    pub fn new(about: &About, values: &[f64]) -> Self {
        let given = values
            .iter()
            .copied()
            .map(Some)
            .chain(std::iter::repeat(None));
        let values = about.quantities.iter().zip(given);
        Self {
            quantities: about.quantities,
            values: values
                .map(|(quantity, given)| given.unwrap_or(quantity.value))
                .collect(),
        }
    }

    /// The value of this name, angles in radians; NaN if there is no such quantity.
    #[must_use]
    pub fn get(&self, name: &str) -> f64 {
        let found = self
            .quantities
            .iter()
            .zip(&self.values)
            .find(|(quantity, _)| quantity.name == name);
        found.map_or(f64::NAN, |(quantity, value)| {
            if quantity.unit.starts_with('°') {
                value.to_radians()
            } else {
                *value
            }
        })
    }

    /// Whether the switch of this name is on.
    #[must_use]
    pub fn is_on(&self, name: &str) -> bool {
        self.get(name) > 0.5
    }
}
