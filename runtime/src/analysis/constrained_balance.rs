//! The equations satisfied by equilibria and steady motions of constrained models.
//!
//! The independent accelerations under constraints vanish, and so do the corrections that take a state onto its constraints: those of
//! coordinates are the smallest in the metric of M, and dependent velocities follow from the independent ones. Points of the search are
//! corrected before they are evaluated.

use nalgebra::{SMatrix, SVector};

use super::balance::{Balance, quantities_of_model};
use super::steady_motion::SteadyMotion;
use super::tangent_error::TangentError;
use crate::integrate::SingleNumber;
use crate::linalg::{DependentColumns, column_widths, kept};
use crate::model::{
    Assembly, DegreesOfFreedom, DirectionalDerivatives, Linearization, Quantities, State,
};
use crate::scalar::Scalar;

/// A constrained model, whose inputs keep their values or are unknowns of the search.
#[derive(Debug)]
pub struct OnConstraints<'a, M: ?Sized, I, S: Scalar, const C: usize, const U: usize> {
    pub(super) model: &'a M,
    /// The inputs that are held.
    pub(super) held: I,
    /// The inputs that may be unknown.
    pub(super) inputs: SVector<S, U>,
    /// Returns the inputs of the model from those that may be unknown and those that are held.
    pub(super) choose: fn(&SVector<S, U>, &I) -> I,
}

impl<M, S, const N: usize, const C: usize, const U: usize> Balance<S, N, U>
    for OnConstraints<'_, M, <M as Quantities<N, S>>::Inputs, S, C, U>
where
    S: SingleNumber,
    M: DirectionalDerivatives<N, C, S> + ?Sized,
{
    quantities_of_model! { self: self.model, U, |inputs| (self.choose)(inputs, &self.held) }

    const CONSTRAINED: bool = true;

    fn inputs(&self) -> SVector<S, U> {
        self.inputs
    }

    fn linearize(&self, state: &State<S, N>, inputs: &SVector<S, U>) -> Linearization<S, N> {
        let inputs = (self.choose)(inputs, &self.held);
        let along = |index: usize| {
            let direction = change(index);
            self.model
                .derivatives_along(state, &inputs, &direction)
                .accelerations
        };
        let columns = |first: usize| {
            let columns: [SVector<S, N>; N] = core::array::from_fn(|j| along(first + j));
            SMatrix::from_columns(&columns)
        };
        Linearization {
            position: columns(0),
            velocity: columns(N),
            time: along(2 * N),
        }
    }

    fn input_jacobian(&self, state: &State<S, N>, inputs: &SVector<S, U>) -> SMatrix<S, N, U> {
        let inputs = (self.choose)(inputs, &self.held);
        let mut jacobian = SMatrix::<S, N, U>::zeros();
        for j in 0..U {
            let column = self.model.derivatives_by_input(state, &inputs, j);
            jacobian.set_column(j, &column.accelerations);
        }
        jacobian
    }

    /// The reduced mass matrix times the independent accelerations.
    fn forcing(
        &self,
        state: &State<S, N>,
        inputs: &SVector<S, U>,
        independent: &[bool; N],
    ) -> SVector<S, N> {
        let accelerations = Balance::accelerations(self, state, inputs);
        let accelerations = kept(&accelerations, |i, _| independent[i]);
        let Some(dependent) = self.dependent_velocities(state, independent) else {
            return Balance::mass_matrix(self, state) * accelerations;
        };
        let completed = |x: &SVector<S, N>| dependent.completed(x, &SVector::zeros());
        let forces = Balance::mass_matrix(self, state) * completed(&accelerations);
        SVector::from_fn(|i, _| {
            if independent[i] {
                completed(&unit(i)).dot(&forces)
            } else {
                S::zero()
            }
        })
    }

    fn independent(&self, state: &State<S, N>, [moving, velocities]: [&[bool; N]; 2]) -> [bool; N] {
        let kept = [moving, velocities];
        DegreesOfFreedom::<N, C>::of(self.model, state, kept).marks()[1]
    }

    fn corrections(&self, state: &State<S, N>, independent: &[bool; N]) -> [SVector<S, N>; 2] {
        let prepared = self.model.prepare();
        let positions = self.model.constraint_positions(state, &prepared);
        let velocities = self.model.constraint_velocities(state, &prepared);
        let dependent = self.dependent_velocities(state, independent);
        [
            self.response(state, &positions),
            completed(dependent.as_ref(), &velocities),
        ]
    }

    fn correction_slopes(
        &self,
        state: &State<S, N>,
        independent: &[bool; N],
    ) -> [[SMatrix<S, N, N>; 2]; 2] {
        let jacobian = self.model.constraint_jacobian(state, &self.model.prepare());
        let dependent = self.dependent_velocities(state, independent);
        let of_velocities = |index: usize| {
            let direction = change(index);
            let along = self.model.derivatives_along(state, &self.held, &direction);
            completed(dependent.as_ref(), &along.constraint_velocities)
        };
        let holonomic = kept(&jacobian, |i, _| i < M::HOLONOMIC);
        let of_positions =
            |index: usize| self.response(state, &holonomic.column(index).into_owned());
        let columns = |column: &dyn Fn(usize) -> SVector<S, N>| {
            let columns: [SVector<S, N>; N] = core::array::from_fn(column);
            SMatrix::from_columns(&columns)
        };
        [
            [columns(&of_positions), SMatrix::zeros()],
            [columns(&of_velocities), columns(&|j| of_velocities(N + j))],
        ]
    }

    fn unsteady(
        &self,
        state: &State<S, N>,
        inputs: &SVector<S, U>,
        independent: &[bool; N],
    ) -> Option<TangentError> {
        let motion = SteadyMotion {
            model: self.model,
            state,
            inputs: &(self.choose)(inputs, &self.held),
            independent,
        };
        motion.check().err()
    }

    fn corrected(
        &self,
        state: State<S, N>,
        [held, held_velocities]: [[bool; N]; 2],
    ) -> Option<State<S, N>> {
        let marked = |marks: [bool; N]| (0..N).filter(move |i| marks[*i]);
        let search = Assembly::new(self.model, state)
            .hold(marked(held))
            .hold_velocities(marked(held_velocities));
        search.solve().ok().map(|found| found.state)
    }

    fn violated(&self, state: &State<S, N>) -> Option<(&'static str, f64)> {
        let (constraint, residual) = self
            .model
            .violated_constraint(state, &self.model.prepare())?;
        let name = <M as Quantities<N, S>>::CONSTRAINTS.get(constraint);
        Some((name.copied().unwrap_or("?"), residual.largest()))
    }
}

impl<M, I, S, const C: usize, const U: usize> OnConstraints<'_, M, I, S, C, U>
where
    S: SingleNumber,
    M: ?Sized,
{
    /// Returns the smallest change of coordinates that takes residuals of the constraints away, with opposite sign.
    fn response<const N: usize>(
        &self,
        state: &State<S, N>,
        residuals: &SVector<S, C>,
    ) -> SVector<S, N>
    where
        M: DirectionalDerivatives<N, C, S>,
    {
        let (prepared, nothing) = (self.model.prepare(), SVector::zeros());
        let right = (&nothing, residuals);
        let held = [false; N];
        -self
            .model
            .constrained_response(state, &prepared, right, &held, M::HOLONOMIC)
    }

    /// Returns the dependent velocities as functions of the independent ones, which there are not at singular configurations.
    fn dependent_velocities<const N: usize>(
        &self,
        state: &State<S, N>,
        independent: &[bool; N],
    ) -> Option<DependentColumns<S, C, N>>
    where
        M: DirectionalDerivatives<N, C, S>,
    {
        let prepared = self.model.prepare();
        let jacobian = self.model.constraint_jacobian(state, &prepared);
        let mass = self.model.mass_matrix(state, &prepared).diagonal();
        let widths = column_widths(&jacobian, &mass);
        DependentColumns::of(&jacobian, &widths, independent).ok()
    }
}

/// Returns the changes of dependent velocities that change the residuals of the constraints by `right`.
fn completed<S: SingleNumber, const N: usize, const C: usize>(
    dependent: Option<&DependentColumns<S, C, N>>,
    right: &SVector<S, C>,
) -> SVector<S, N> {
    let nothing = SVector::zeros();
    dependent.map_or(nothing, |dependent| dependent.completed(&nothing, right))
}

fn unit<S: SingleNumber, const N: usize>(index: usize) -> SVector<S, N> {
    SVector::from_fn(|i, _| if i == index { S::one() } else { S::zero() })
}

/// Returns the change of one coordinate, then of one velocity, then of the time.
fn change<S: SingleNumber, const N: usize>(index: usize) -> State<S, N> {
    let time = if index == 2 * N { S::one() } else { S::zero() };
    State::new(time, unit(index), unit(index.wrapping_sub(N)))
}
