//! Quantities of a model at one state or at many, as arrays.

use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors::value_error;
use crate::evaluator::Quantity;
use crate::fields;
use crate::model::{Any, Maybe, Model};
use crate::states::States;

impl Model {
    /// The numbers of a quantity at all states, one state after the other; `None` if the model does not have it.
    pub(crate) fn evaluate(
        &self,
        quantity: Quantity,
        states: &States,
        given: impl Fn(usize) -> Vec<f64>,
    ) -> PyResult<Option<Vec<f64>>> {
        let mut numbers = Vec::new();
        for index in 0..states.len() {
            let instant = states.instant(index);
            let found = match states.inputs(index) {
                None => self
                    .evaluator
                    .evaluate(quantity, instant, &given(index), &mut numbers),
                Some(inputs) => {
                    let under = self.under(inputs);
                    let under = (self.description.build)(&under);
                    let under = under.map_err(|error| value_error(format!("{error:?}")))?;
                    under.evaluate(quantity, instant, &given(index), &mut numbers)
                }
            };
            if !found {
                return Ok(None);
            }
        }
        Ok(Some(numbers))
    }

    /// The numbers of the fields under other inputs.
    fn under(&self, inputs: &[f64]) -> Vec<f64> {
        let mut numbers = self.numbers.clone();
        let mut inputs = inputs.iter();
        let mut first = 0;
        for field in self.description.fields {
            let behind = first + field.count();
            if field.is_input
                && let Some(part) = numbers.get_mut(first..behind)
            {
                for (number, input) in part.iter_mut().zip(&mut inputs) {
                    *number = *input;
                }
            }
            first = behind;
        }
        numbers
    }

    /// A quantity of this shape at each state.
    pub(crate) fn quantity<'py>(
        &self,
        (quantity, of_one): (Quantity, &[usize]),
        state: [Any<'_, 'py>; 2],
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let py = state[0].py();
        let states = States::read(self.description, state, t, u)?;
        let numbers = self.evaluate(quantity, &states, |_| Vec::new())?;
        let numbers = numbers.ok_or_else(|| self.has_no(quantity))?;
        fields::number_or_array(py, &numbers, &states.shape(of_one))
    }

    /// Several quantities with names, which stand one after the other in the numbers of each state.
    pub(crate) fn named<'py>(
        &self,
        quantity: Quantity,
        parts: &[(&'static str, &[usize])],
        state: [Any<'_, 'py>; 2],
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let py = state[0].py();
        let states = States::read(self.description, state, t, u)?;
        let numbers = self.evaluate(quantity, &states, |_| Vec::new())?;
        let numbers = numbers.ok_or_else(|| self.has_no(quantity))?;
        let length: usize = parts
            .iter()
            .map(|(_, shape)| shape.iter().product::<usize>())
            .sum();
        let named = PyDict::new(py);
        let mut first = 0;
        for (name, shape) in parts {
            let behind = first + shape.iter().product::<usize>();
            let of_states = numbers.chunks(length.max(1));
            let part: Vec<f64> = of_states
                .flat_map(|of_one| of_one.get(first..behind).unwrap_or_default())
                .copied()
                .collect();
            named.set_item(
                name,
                fields::number_or_array(py, &part, &states.shape(shape))?,
            )?;
            first = behind;
        }
        Ok(named)
    }

    fn has_no(&self, quantity: Quantity) -> PyErr {
        let name = self.description.name;
        value_error(match quantity {
            Quantity::KineticEnergy | Quantity::PotentialEnergy => {
                format!(
                    "{name} is declared by its Lagrangian, without a kinetic and a potential energy"
                )
            }
            Quantity::StateMatrix => format!(
                "{name} has constraints, so that its coordinates and velocities do not change independently"
            ),
            Quantity::InputMatrix => format!("{name} has no inputs"),
            _ => format!("{name} has no events"),
        })
    }
}
