//! Quantities of a model at one state or at many, as arrays.

use lagrangian::quantities::InvalidNumbers;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::{Numbers, array};
use crate::errors::value_error;
use crate::evaluator::Quantity;
use crate::fields;
use crate::model::{Any, Maybe, Model};
use crate::states::States;

impl Model {
    /// The numbers of a quantity at all states, one state after the other, while other threads of Python run; `None` if the model
    /// does not have it.
    pub(crate) fn evaluate(
        &self,
        py: Python<'_>,
        quantity: Quantity,
        states: &States,
        given: impl Fn(usize) -> Vec<f64> + Sync,
    ) -> PyResult<Option<Vec<f64>>> {
        let evaluated = py.detach(|| {
            let mut numbers = Vec::new();
            for index in 0..states.len() {
                let instant = states.instant(index);
                let given = given(index);
                let found = match states.inputs(index) {
                    None => self
                        .evaluator
                        .evaluate(quantity, instant, &given, &mut numbers),
                    Some(inputs) => {
                        let under = (self.description.build)(&self.under(inputs))?;
                        under.evaluate(quantity, instant, &given, &mut numbers)
                    }
                };
                if !found {
                    return Ok(None);
                }
            }
            Ok(Some(numbers))
        });
        evaluated.map_err(|error: InvalidNumbers| value_error(format!("{error:?}")))
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
        let numbers = self.evaluate(py, quantity, &states, |_| Vec::new())?;
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
        let numbers = self.evaluate(py, quantity, &states, |_| Vec::new())?;
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

#[pymethods]
impl Model {
    /// The accelerations, of shape (n,).
    #[pyo3(signature = (q, v, t=None, *, u=None))]
    fn accelerations<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.quantity((Quantity::Accelerations, &[self.dimension()]), [q, v], t, u)
    }

    /// The mass matrix, of shape (n, n).
    #[pyo3(signature = (q, v, t=None, *, u=None))]
    fn mass_matrix<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.quantity((Quantity::MassMatrix, &[self.dimension(); 2]), [q, v], t, u)
    }

    /// The forcing f in M q̈ = f, of shape (n,).
    #[pyo3(signature = (q, v, t=None, *, u=None))]
    fn forcing<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.quantity((Quantity::Forcing, &[self.dimension()]), [q, v], t, u)
    }

    /// The generalized forces of forces and dissipation, of shape (n,).
    #[pyo3(signature = (q, v, t=None, *, u=None))]
    fn generalized_forces<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.quantity(
            (Quantity::GeneralizedForces, &[self.dimension()]),
            [q, v],
            t,
            u,
        )
    }

    /// The generalized momenta, of shape (n,).
    #[pyo3(signature = (q, v, t=None, *, u=None))]
    fn momenta<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.quantity((Quantity::Momenta, &[self.dimension()]), [q, v], t, u)
    }

    /// The energy function Σ p q̇ − L.
    #[pyo3(signature = (q, v, t=None, *, u=None))]
    fn energy<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.quantity((Quantity::Energy, &[]), [q, v], t, u)
    }

    /// The kinetic energy.
    #[pyo3(signature = (q, v, t=None, *, u=None))]
    fn kinetic_energy<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.quantity((Quantity::KineticEnergy, &[]), [q, v], t, u)
    }

    /// The potential energy.
    #[pyo3(signature = (q, v, t=None, *, u=None))]
    fn potential_energy<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.quantity((Quantity::PotentialEnergy, &[]), [q, v], t, u)
    }

    /// The generalized forces M q̈ − f that accelerations `a` of the shape of q need in addition, of shape (n,).
    #[pyo3(signature = (q, v, a, t=None, *, u=None))]
    fn inverse_dynamics<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        a: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let states = States::read(self.description, [q, v], t, u)?;
        let (n, all) = (self.dimension(), states.shape(&[self.dimension()]));
        let accelerations = Numbers::read("a", a)?.of_shape("a", &all)?;
        let of_one = |index: usize| {
            accelerations
                .iter()
                .skip(index * n)
                .take(n)
                .copied()
                .collect()
        };
        let forces = self.evaluate(q.py(), Quantity::InverseDynamics, &states, of_one)?;
        array(q.py(), forces.unwrap_or_default(), &all)
    }

    /// The outputs by their names, each with its shape.
    #[pyo3(signature = (q, v, t=None, *, u=None))]
    fn outputs<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let outputs = self.description.outputs.iter();
        let parts: Vec<_> = outputs
            .map(|output| (output.name, output.lengths))
            .collect();
        self.named(Quantity::Outputs, &parts, [q, v], t, u)
    }

    /// The values of the event functions by the names of the events.
    #[pyo3(signature = (q, v, t=None, *, u=None))]
    fn event_functions<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let parts: Vec<_> = self
            .description
            .events
            .iter()
            .map(|name| (*name, &[][..]))
            .collect();
        self.named(Quantity::EventFunctions, &parts, [q, v], t, u)
    }

    /// The multipliers of the constraints, of shape (constraints,).
    #[pyo3(signature = (q, v, t=None, *, u=None))]
    fn multipliers<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let count = self.description.constraints.len();
        self.quantity((Quantity::Multipliers, &[count]), [q, v], t, u)
    }

    /// The matrices A, of shape (2n, 2n), and B, of shape (2n, inputs), of ẋ = A x + B u for deviations x = (q, v) and u. Without
    /// inputs B has no columns.
    #[pyo3(signature = (q, v, t=None, *, u=None))]
    fn linearize<'py>(
        &self,
        q: Any<'_, 'py>,
        v: Any<'_, 'py>,
        t: Maybe<'_, 'py>,
        u: Maybe<'_, 'py>,
    ) -> PyResult<[Bound<'py, PyAny>; 2]> {
        let (rows, inputs) = (2 * self.dimension(), self.description.inputs.len());
        let a = self.quantity((Quantity::StateMatrix, &[rows, rows]), [q, v], t, u)?;
        if inputs == 0 {
            let states = States::read(self.description, [q, v], t, u)?;
            return Ok([a, array(q.py(), Vec::new(), &states.shape(&[rows, 0]))?]);
        }
        Ok([
            a,
            self.quantity((Quantity::InputMatrix, &[rows, inputs]), [q, v], t, u)?,
        ])
    }
}
