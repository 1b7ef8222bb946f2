//! Hamilton's equations of a model, in the form that an integrator uses.

use nalgebra::SVector;

use super::canonical_phase::CanonicalPhase;
use super::hamiltonian::{Hamiltonian, NoVelocities};
use super::legendre;
use super::poles::pole_between;
use super::state::State;
use crate::integrate::{At, ComponentName, Dynamics, Singularity};
use crate::linalg::{ErrorTolerance, VectorSpace};
use crate::scalar::Scalar;

/// Hamilton's equations q̇ = ∂H/∂p, ṗ = −∂H/∂q + Q of a model, constructed by
/// [`canonical_equations`](crate::Lagrangian::canonical_equations).
///
/// Every method that needs only derivatives integrates them. Where no velocities belong to the momenta, the derivatives
/// are NaN, and the integration ends with an error.
#[derive(Debug)]
pub struct CanonicalEquations<'a, M, S, const N: usize>
where
    M: Hamiltonian<N, S>,
    S: Scalar,
{
    model: &'a M,
    inputs: M::Inputs,
    prepared: M::Prepared,
}

impl<'a, M, S, const N: usize> CanonicalEquations<'a, M, S, N>
where
    M: Hamiltonian<N, S>,
    S: Scalar,
{
    pub(super) fn new(model: &'a M, inputs: M::Inputs) -> Self {
        Self {
            model,
            inputs,
            prepared: model.prepare(),
        }
    }

    /// Returns the coordinates and momenta of a state, at its time: an initial value.
    pub fn canonical(&self, state: &State<S, N>) -> At<f64, CanonicalPhase<S, N>> {
        let p = self.model.momenta(state, &self.prepared);
        let x = CanonicalPhase { q: state.q, p };
        At { t: state.t, x }.at_one_time()
    }

    /// Returns the state with the velocities that belong to the momenta.
    ///
    /// # Errors
    ///
    /// [`NoVelocities`], if there are no such velocities.
    pub fn state(&self, t: f64, phase: &CanonicalPhase<S, N>) -> Result<State<S, N>, NoVelocities> {
        let t = S::from_f64(t);
        let v = legendre::velocities(self.model, &self.prepared, t, phase)?;
        Ok(State::new(t, phase.q, v))
    }
}

impl<M, S, const N: usize> Dynamics<S> for CanonicalEquations<'_, M, S, N>
where
    M: Hamiltonian<N, S>,
    S: Scalar,
{
    type State = CanonicalPhase<S, N>;

    fn derivative(&self, t: S, x: &Self::State) -> Self::State {
        let not_a_number = |_| SVector::repeat(S::from_f64(f64::NAN));
        let v = legendre::velocities(self.model, &self.prepared, t, x).unwrap_or_else(not_a_number);
        let state = State::new(t, x.q, v);
        CanonicalPhase {
            q: v,
            p: self
                .model
                .momentum_rates(&state, &self.inputs, &self.prepared),
        }
    }

    /// Returns the allowed errors; for an angle, the size is 1, since whole turns do not matter.
    fn allowed_error(&self, x: &Self::State, tolerance: &ErrorTolerance<S>) -> Self::State {
        let mut sizes = *x;
        for (size, is_angle) in sizes.q.iter_mut().zip(M::ANGLES) {
            if is_angle {
                *size = S::one();
            }
        }
        VectorSpace::allowed_error(&sizes, tolerance)
    }

    fn singularity_between(
        &self,
        before: &Self::State,
        (t, after): (S, &Self::State),
    ) -> Option<Singularity> {
        let after = State::new(t, after.q, SVector::zeros());
        pole_between::<M, S, N>(&before.q, &after)
    }

    fn component_name(&self, index: usize) -> ComponentName {
        match M::COORDINATES.get(index) {
            Some(name) => ComponentName::Coordinate(name),
            None => ComponentName::Index(index),
        }
    }
}
