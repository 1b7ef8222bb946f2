//! The quantities that the derive writes, each once.

use nalgebra::{SMatrix, SVector};

use super::generalized_coordinates::GeneralizedCoordinates;
use super::phase::Phase;
use super::state::State;
use crate::integrate::Projection;
use crate::linalg::Factorization;
use crate::scalar::Scalar;

/// The quantities of a model as functions of the state and of all that they depend on besides: the inputs, and what
/// [`prepare`](Self::prepare) computes of the parameters.
///
/// `#[derive(Lagrangian)]` implements it; a model can also be written by hand against it. The methods of
/// [`Lagrangian`](crate::Lagrangian), which programs call, evaluate them at the inputs of the model.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a model that is owned",
    note = "a model that changes belongs to the problem: write `Problem::new(model, start)` in place of \
            `Problem::new(&model, start)`, with a clone of the model if it is needed elsewhere"
)]
pub trait Quantities<const N: usize, S: Scalar = f64>: GeneralizedCoordinates<N> {
    /// The values of the inputs: an `SVector<S, U>`, which has no components for a model without inputs.
    type Inputs: Clone + core::fmt::Debug;

    /// One array of all that the methods of an integration's loop read beside the state and the inputs. The derive puts the
    /// parameters there that these methods read, in the order of the fields, and a vector or matrix column by column; behind
    /// them stand quantities that depend on parameters alone. `[S; 0]` for a model written by hand that reads its fields.
    type Prepared: AsRef<[S]> + AsMut<[S]> + Clone + core::fmt::Debug;

    /// The values of the fields that are inputs.
    fn inputs(&self) -> Self::Inputs;

    /// Computes what the methods of an integration's loop read: parameters, and quantities that depend on them alone. The
    /// methods that take the result get it for the same parameters.
    fn prepare(&self) -> Self::Prepared;

    /// [`Lagrangian::lagrangian`](crate::Lagrangian::lagrangian) under these inputs.
    fn lagrangian(
        &self,
        state: &State<S, N>,
        inputs: &Self::Inputs,
        prepared: &Self::Prepared,
    ) -> S;

    /// [`Lagrangian::energy`](crate::Lagrangian::energy) under these inputs.
    fn energy(&self, state: &State<S, N>, inputs: &Self::Inputs) -> S;

    /// [`Lagrangian::momenta`](crate::Lagrangian::momenta), on which no input acts.
    fn momenta(&self, state: &State<S, N>, prepared: &Self::Prepared) -> SVector<S, N>;

    /// [`Lagrangian::mass_matrix`](crate::Lagrangian::mass_matrix), on which no input acts.
    fn mass_matrix(&self, state: &State<S, N>, prepared: &Self::Prepared) -> SMatrix<S, N, N>;

    /// [`Lagrangian::forcing`](crate::Lagrangian::forcing) under these inputs.
    fn forcing(
        &self,
        state: &State<S, N>,
        inputs: &Self::Inputs,
        prepared: &Self::Prepared,
    ) -> SVector<S, N>;

    /// [`Lagrangian::generalized_forces`](crate::Lagrangian::generalized_forces) under these inputs; none by default.
    fn generalized_forces(&self, state: &State<S, N>, inputs: &Self::Inputs) -> SVector<S, N> {
        let _ = (state, inputs);
        SVector::from_element(S::zero())
    }

    /// [`Lagrangian::accelerations`](crate::Lagrangian::accelerations) under these inputs.
    fn accelerations(
        &self,
        state: &State<S, N>,
        inputs: &Self::Inputs,
        prepared: &Self::Prepared,
    ) -> SVector<S, N>;

    /// [`Lagrangian::inverse_dynamics`](crate::Lagrangian::inverse_dynamics) under these inputs.
    fn inverse_dynamics(
        &self,
        state: &State<S, N>,
        inputs: &Self::Inputs,
        accelerations: &SVector<S, N>,
        prepared: &Self::Prepared,
    ) -> SVector<S, N>;

    /// [`Lagrangian::relative_pivots`](crate::Lagrangian::relative_pivots).
    fn relative_pivots(&self, state: &State<S, N>, prepared: &Self::Prepared) -> SVector<S, N> {
        Factorization::new(self.mass_matrix(state, prepared)).relative_pivots()
    }

    /// The names of the constraints; none by default.
    const CONSTRAINTS: &'static [&'static str] = &[];

    /// Finds how many constraints are independent in the neighbourhood of a consistent state, and notes it for the methods
    /// that read `prepared`. A motion does so at its start; without it each evaluation decides at its own state. By default
    /// there are no constraints.
    #[inline]
    fn fix_rank(&self, state: &State<S, N>, prepared: &mut Self::Prepared) {
        let _ = (state, prepared);
    }

    /// Returns the state on the constraints that is nearest in the metric of M; by default `None`, since there are no
    /// constraints.
    #[inline]
    fn project(
        &self,
        state: &State<S, N>,
        prepared: &Self::Prepared,
    ) -> Option<Projection<S, Phase<S, N>>> {
        let _ = (state, prepared);
        None
    }

    /// Returns the largest component of each kind that coordinates and velocities of these sizes have in the metric of M at a
    /// state; by default `None`, since there are no constraints.
    #[inline]
    fn sizes_in_metric(
        &self,
        state: &State<S, N>,
        prepared: &Self::Prepared,
        sizes: &Phase<S, N>,
    ) -> Option<Phase<S, N>> {
        let _ = (state, prepared, sizes);
        None
    }

    /// Returns the index of the constraint that a state violates most, and its residual g, or the residual of its velocity ġ if
    /// the coordinates meet it. By default `None`, since there are no constraints.
    fn violated_constraint(
        &self,
        state: &State<S, N>,
        prepared: &Self::Prepared,
    ) -> Option<(usize, S)> {
        let _ = (state, prepared);
        None
    }

    /// Returns the smallest sine of the angle between the gradient of a constraint and the span of the gradients of others. A
    /// constraint that always depends on others does not count. By default `None`, since there are no constraints.
    fn constraint_sine(&self, state: &State<S, N>, prepared: &Self::Prepared) -> Option<S> {
        let _ = (state, prepared);
        None
    }

    /// Returns the index of a constraint whose [compliance](crate::quantities::Constraints::compliances) is not positive and
    /// finite, and the compliance. By default `None`, since none is declared.
    fn invalid_compliance(&self, prepared: &Self::Prepared) -> Option<(usize, f64)> {
        let _ = prepared;
        None
    }

    /// Returns the relative pivots of the coordinates, and the constraint that is nearest to depending on others, in any lane, with
    /// the sine of the angle between its gradient and the span of theirs. A constraint that always depends on others does
    /// not count. By default there are no constraints.
    #[inline]
    fn pivots(
        &self,
        state: &State<S, N>,
        prepared: &Self::Prepared,
    ) -> (SVector<S, N>, Option<(usize, f64)>) {
        (self.relative_pivots(state, prepared), None)
    }
}

/// The energies T and V of a model that is declared by them.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no kinetic and potential energy apart",
    note = "declare `kinetic = …` and `potential = …` in place of `lagrangian = …`"
)]
pub trait Energies<const N: usize, S: Scalar = f64>: Quantities<N, S> {
    /// [`Lagrangian::kinetic_energy`](crate::Lagrangian::kinetic_energy) under these inputs.
    fn kinetic_energy(&self, state: &State<S, N>, inputs: &Self::Inputs) -> S;

    /// [`Lagrangian::potential_energy`](crate::Lagrangian::potential_energy) under these inputs.
    fn potential_energy(&self, state: &State<S, N>, inputs: &Self::Inputs) -> S;
}
