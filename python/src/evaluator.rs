//! Models whose number of coordinates is not part of their type.

use lagrangian::quantities::Reflect;

use crate::ability::Abilities;
use crate::ensemble::{Ensemble, EnsembleMotions};
use crate::instant::Instant;
use crate::integrated::Integrated;
use crate::numbers::{rows, vector};
use crate::request::Request;

/// A quantity of a model at a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// The accelerations q̈.
    Accelerations,
    /// M q̈ − f for given accelerations.
    InverseDynamics,
    /// The mass matrix.
    MassMatrix,
    /// The forcing f in M q̈ = f.
    Forcing,
    /// The generalized momenta.
    Momenta,
    /// The generalized forces of forces and dissipation.
    GeneralizedForces,
    /// The energy function.
    Energy,
    /// The kinetic energy.
    KineticEnergy,
    /// The potential energy.
    PotentialEnergy,
    /// All outputs, one after the other.
    Outputs,
    /// The event functions.
    EventFunctions,
    /// The multipliers of the constraints.
    Multipliers,
    /// The state matrix A of ẋ = A x + B u.
    StateMatrix,
    /// The input matrix B.
    InputMatrix,
}

/// A model at its parameters and inputs.
pub trait Evaluator: Send + Sync {
    /// Appends the numbers of a quantity, row by row; false if the model does not have it.
    fn evaluate(
        &self,
        quantity: Quantity,
        at: Instant<'_>,
        given: &[f64],
        numbers: &mut Vec<f64>,
    ) -> bool;

    /// The coordinates and velocities that satisfy the constraints near a guess, or why there are none; `None` without constraints.
    fn assemble(&self, guess: Instant<'_>) -> Option<Result<[Vec<f64>; 2], String>>;

    /// Integrates a motion; `None` if the model does not have the method or the inputs for it.
    fn integrate(&self, request: &Request) -> Option<Integrated>;

    /// Integrates many motions; `None` if the model does not have the method.
    fn ensemble(&self, ensemble: &Ensemble) -> Option<Result<EnsembleMotions, String>>;
}

/// A model and what it can do.
pub struct Of<M, const N: usize> {
    /// The model.
    pub model: M,
    /// What only some models have.
    pub abilities: Abilities<M, N>,
}

impl<M, const N: usize> Evaluator for Of<M, N>
where
    M: Reflect<N> + Send + Sync,
{
    fn evaluate(
        &self,
        quantity: Quantity,
        at: Instant<'_>,
        given: &[f64],
        numbers: &mut Vec<f64>,
    ) -> bool {
        let (model, state) = (&self.model, at.state::<N>());
        let abilities = &self.abilities;
        match quantity {
            Quantity::Accelerations => rows(&model.accelerations(&state), numbers),
            Quantity::InverseDynamics => {
                rows(&model.inverse_dynamics(&state, &vector(given)), numbers);
            }
            Quantity::MassMatrix => rows(&model.mass_matrix(&state), numbers),
            Quantity::Forcing => rows(&model.forcing(&state), numbers),
            Quantity::Momenta => rows(&model.momenta(&state), numbers),
            Quantity::GeneralizedForces => rows(&model.generalized_forces(&state), numbers),
            Quantity::Energy => numbers.push(model.energy(&state)),
            Quantity::Outputs => model.output_numbers(&state, &mut |number| numbers.push(number)),
            Quantity::Multipliers => {
                model.multiplier_numbers(&state, &mut |number| numbers.push(number));
            }
            Quantity::KineticEnergy | Quantity::PotentialEnergy => {
                let Some(energies) = abilities.energies else {
                    return false;
                };
                let [kinetic, potential] = energies(model, &state);
                numbers.push(if quantity == Quantity::KineticEnergy {
                    kinetic
                } else {
                    potential
                });
            }
            Quantity::EventFunctions => {
                let Some(functions) = abilities.event_functions else {
                    return false;
                };
                functions(model, &state, numbers);
            }
            Quantity::StateMatrix => {
                let Some(state_matrix) = abilities.state_matrix else {
                    return false;
                };
                state_matrix(model, &state, numbers);
            }
            Quantity::InputMatrix => {
                let Some(input_matrix) = abilities.input_matrix else {
                    return false;
                };
                input_matrix(model, &state, numbers);
            }
        }
        true
    }

    fn assemble(&self, guess: Instant<'_>) -> Option<Result<[Vec<f64>; 2], String>> {
        let assemble = self.abilities.assemble?;
        Some(assemble(&self.model, guess.state()))
    }

    fn integrate(&self, request: &Request) -> Option<Integrated> {
        (self.abilities.integrate)(&self.model, request)
    }

    fn ensemble(&self, ensemble: &Ensemble) -> Option<Result<EnsembleMotions, String>> {
        (self.abilities.ensemble)(ensemble)
    }
}
