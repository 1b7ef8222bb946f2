//! The equations satisfied by equilibria and steady motions of constrained models.
//!
//! The independent accelerations under constraints vanish, and so do the corrections that take a state onto its constraints, the
//! smallest in the metric of M. Points of the search are corrected before they are evaluated.

use nalgebra::{SMatrix, SVector};

use super::balance::Balance;
use crate::integrate::SingleNumber;
use crate::model::{
    Assembly, DegreesOfFreedom, DirectionalDerivatives, Linearization, MotionDerivatives,
    Quantities, State,
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
    const COORDINATES: [&'static str; N] = M::COORDINATES;
    const IGNORABLE: [bool; N] = M::IGNORABLE;

    fn inputs(&self) -> SVector<S, U> {
        self.inputs
    }

    fn accelerations(&self, state: &State<S, N>, inputs: &SVector<S, U>) -> SVector<S, N> {
        let inputs = (self.choose)(inputs, &self.held);
        self.model
            .accelerations(state, &inputs, &self.model.prepare())
    }

    fn linearize(&self, state: &State<S, N>, inputs: &SVector<S, U>) -> Linearization<S, N> {
        let inputs = (self.choose)(inputs, &self.held);
        let along = |index: usize| {
            let direction = unit(index);
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

    fn momenta(&self, state: &State<S, N>) -> SVector<S, N> {
        self.model.momenta(state, &self.model.prepare())
    }

    fn mass_matrix(&self, state: &State<S, N>) -> SMatrix<S, N, N> {
        self.model.mass_matrix(state, &self.model.prepare())
    }

    /// With the forces of the constraints, M q̈.
    fn forcing(&self, state: &State<S, N>, inputs: &SVector<S, U>) -> SVector<S, N> {
        Balance::mass_matrix(self, state) * Balance::accelerations(self, state, inputs)
    }

    fn relative_pivots(&self, state: &State<S, N>) -> SVector<S, N> {
        self.model.relative_pivots(state, &self.model.prepare())
    }

    fn independent(&self, state: &State<S, N>) -> [bool; N] {
        let freedom = DegreesOfFreedom::<N, C>::of(self.model, state, &[false; N]);
        let mut independent = [false; N];
        freedom
            .independent_velocities()
            .for_each(|i| independent[i] = true);
        independent
    }

    fn corrections(&self, state: &State<S, N>) -> Option<SVector<S, N>> {
        let prepared = self.model.prepare();
        let (positions, velocities) = (
            self.model.constraint_positions(state, &prepared),
            self.model.constraint_velocities(state, &prepared),
        );
        Some(self.response(state, &of_each::<M, S, N, C>(&positions, &velocities)))
    }

    fn correction_slopes(&self, state: &State<S, N>) -> [SMatrix<S, N, N>; 2] {
        let jacobian = self.model.constraint_jacobian(state, &self.model.prepare());
        let column = |index: usize| {
            let MotionDerivatives {
                constraint_velocities,
                ..
            } = self
                .model
                .derivatives_along(state, &self.held, &unit(index));
            let of_positions = if index < N {
                jacobian.column(index).into_owned()
            } else {
                SVector::zeros()
            };
            self.response(
                state,
                &of_each::<M, S, N, C>(&of_positions, &constraint_velocities),
            )
        };
        [0, N].map(|first| {
            let columns: [SVector<S, N>; N] = core::array::from_fn(|j| column(first + j));
            SMatrix::from_columns(&columns)
        })
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
        -self
            .model
            .constrained_response(state, &prepared, right, &[false; N], C)
    }
}

/// Returns the residuals g of holonomic constraints, and w of nonholonomic ones.
fn of_each<M, S, const N: usize, const C: usize>(
    positions: &SVector<S, C>,
    velocities: &SVector<S, C>,
) -> SVector<S, C>
where
    M: DirectionalDerivatives<N, C, S> + ?Sized,
    S: SingleNumber,
{
    SVector::from_fn(|j, _| {
        if j < M::HOLONOMIC {
            positions[j]
        } else {
            velocities[j]
        }
    })
}

/// Returns the change of one coordinate, then of one velocity, then of the time.
fn unit<S: SingleNumber, const N: usize>(index: usize) -> State<S, N> {
    let mark = |number: usize| if number == index { S::one() } else { S::zero() };
    State::new(
        mark(2 * N),
        SVector::<S, N>::from_fn(|i, _| mark(i)),
        SVector::<S, N>::from_fn(|i, _| mark(N + i)),
    )
}
