//! Inputs: forces, torques and other quantities that a controller sets.

use nalgebra::{SMatrix, SVector};

use super::driven_by::DrivenBy;
use super::generalized_coordinates::GeneralizedCoordinates;
use super::lagrangian::Lagrangian;
use super::linearization::Linearization;
use super::linearization::below_zeros;
use super::signals::Signals;
use super::state::State;
use crate::linalg::IntoVector;
use crate::scalar::Scalar;

/// A system with `U` inputs: the fields that its declaration marks `#[lagrangian(input)]`.
///
/// The methods of [`Lagrangian`] use the values of the fields. These take the inputs as an
/// argument, so that they can vary in time and be of any scalar.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a model with {N} coordinates and {U} inputs",
    note = "inputs are the fields that are marked `#[lagrangian(input)]`; the linearization of a model without inputs is \
            `StateSpace::free(&model, &state)`"
)]
pub trait Inputs<const N: usize, const U: usize, S: Scalar = f64>: Lagrangian<N, S> {
    /// The names of the inputs, in order.
    const INPUTS: [&'static str; U];

    /// The values of the fields.
    fn inputs(&self) -> SVector<S, U>;

    /// The Lagrangian function L under these inputs.
    fn lagrangian_with(&self, state: &State<S, N>, inputs: &SVector<S, U>) -> S;

    /// The energy function Σ pᵢ q̇ᵢ − L under these inputs.
    fn energy_with(&self, state: &State<S, N>, inputs: &SVector<S, U>) -> S;

    /// The forcing f in M q̈ = f under these inputs.
    fn forcing_with(&self, state: &State<S, N>, inputs: &SVector<S, U>) -> SVector<S, N>;

    /// The generalized forces Q under these inputs.
    fn generalized_forces_with(&self, state: &State<S, N>, inputs: &SVector<S, U>)
    -> SVector<S, N>;

    /// The accelerations q̈ under these inputs.
    fn accelerations_with(&self, state: &State<S, N>, inputs: &SVector<S, U>) -> SVector<S, N>;

    /// The accelerations q̈ under these inputs, given the result of [`prepare`](Lagrangian::prepare) for the
    /// same parameters.
    fn accelerations_prepared_with(
        &self,
        state: &State<S, N>,
        inputs: &SVector<S, U>,
        _prepared: &Self::Prepared,
    ) -> SVector<S, N> {
        self.accelerations_with(state, inputs)
    }

    /// M q̈ − f under these inputs.
    fn inverse_dynamics_with(
        &self,
        state: &State<S, N>,
        inputs: &SVector<S, U>,
        accelerations: &SVector<S, N>,
    ) -> SVector<S, N>;

    /// M q̈ − f under these inputs, given the result of [`prepare`](Lagrangian::prepare) for the same parameters.
    fn inverse_dynamics_prepared_with(
        &self,
        state: &State<S, N>,
        inputs: &SVector<S, U>,
        accelerations: &SVector<S, N>,
        _prepared: &Self::Prepared,
    ) -> SVector<S, N> {
        self.inverse_dynamics_with(state, inputs, accelerations)
    }

    /// The derivatives of the accelerations with respect to q, q̇ and t, at constant inputs.
    fn linearize_with(&self, state: &State<S, N>, inputs: &SVector<S, U>) -> Linearization<S, N>;

    /// The derivatives ∂q̈ᵢ/∂uⱼ in row i, column j.
    fn input_jacobian_with(&self, state: &State<S, N>, inputs: &SVector<S, U>) -> SMatrix<S, N, U>;

    /// The derivatives ∂q̈ᵢ/∂uⱼ at the inputs of the fields.
    fn input_jacobian(&self, state: &State<S, N>) -> SMatrix<S, N, U> {
        self.input_jacobian_with(state, &self.inputs())
    }

    /// The input matrix B = (0; ∂q̈/∂u) in ẋ = A x + B u, where x = (q, q̇) and u are deviations from this
    /// state and these inputs. It has `D` = 2 `N` rows.
    ///
    /// A is the [`state_matrix`](Linearization::state_matrix) of
    /// [`linearize_with`](Self::linearize_with), where both are shown.
    fn input_matrix_with<const D: usize>(
        &self,
        state: &State<S, N>,
        inputs: &SVector<S, U>,
    ) -> SMatrix<S, D, U> {
        below_zeros(&self.input_jacobian_with(state, inputs))
    }

    /// The input matrix B at the inputs of the fields.
    fn input_matrix<const D: usize>(&self, state: &State<S, N>) -> SMatrix<S, D, U> {
        below_zeros(&self.input_jacobian(state))
    }

    /// The same system under other, constant inputs.
    fn with_inputs(&self, inputs: impl IntoVector<S, U>) -> WithInputs<'_, Self, S, U> {
        WithInputs {
            model: self,
            inputs: inputs.into_vector(),
        }
    }

    /// The same system under inputs that are functions of time, one [`Signal`](crate::Signal) for each: an array of signals
    /// of one type, or a tuple of different ones. [`Taylor`](crate::Taylor) integrates it, since signals have Taylor series;
    /// so do all other methods.
    ///
    /// ```
    /// use lagrangian::prelude::*;
    /// use lagrangian::{Constant, Sinusoid, Sum};
    ///
    /// #[derive(Lagrangian)]
    /// #[lagrangian(
    ///     taylor,
    ///     coordinates(x),
    ///     kinetic = 0.5 * m * dot(x).powi(2),
    ///     potential = 0.5 * k * (x - shift).powi(2),
    ///     force(x = push),
    /// )]
    /// struct Oscillator {
    ///     m: f64,
    ///     k: f64,
    ///     #[lagrangian(input)]
    ///     push: f64,
    ///     #[lagrangian(input)]
    ///     shift: f64,
    /// }
    ///
    /// let oscillator = Oscillator { m: 1.0, k: 4.0, push: 0.0, shift: 0.0 };
    /// let push = Sinusoid { amplitude: 3.0, angular_frequency: 1.0, phase: 0.0 };
    /// let driven = oscillator.driven_by((push, Constant(0.5)));
    /// let start = State::new(0.0, [0.5], [1.0]);
    /// let end = Problem::new(&driven, start).solve(20.0, Taylor::new())?;
    /// // ẍ = −4 (x − ½) + 3 sin t.
    /// assert!((end.q[0] - 0.5 - 20.0_f64.sin()).abs() < 1e-13);
    /// # Ok::<(), IntegrationError>(())
    /// ```
    fn driven_by<I: Signals<S, U>>(&self, signals: I) -> DrivenBy<'_, Self, I, S, N, U> {
        DrivenBy::new(self, signals)
    }
}

/// A model under constant inputs; see [`Inputs::with_inputs`].
#[derive(Debug)]
pub struct WithInputs<'a, M: ?Sized, S: Scalar, const U: usize> {
    pub(super) model: &'a M,
    pub(super) inputs: SVector<S, U>,
}

impl<M, S, const N: usize, const U: usize> GeneralizedCoordinates<N> for WithInputs<'_, M, S, U>
where
    M: Inputs<N, U, S> + ?Sized,
    S: Scalar,
{
    const COORDINATES: [&'static str; N] = M::COORDINATES;
    const ANGLES: [bool; N] = M::ANGLES;
    const PERIODS: [u32; N] = M::PERIODS;
    const IGNORABLE: [bool; N] = M::IGNORABLE;
    const SINGULARITIES: [&'static [usize]; N] = M::SINGULARITIES;
    const STAYS_REGULAR: bool = M::STAYS_REGULAR;
    const POLES: &'static [usize] = M::POLES;
}

impl<M, S, const N: usize, const U: usize> Lagrangian<N, S> for WithInputs<'_, M, S, U>
where
    M: Inputs<N, U, S> + ?Sized,
    S: Scalar,
{
    type Prepared = M::Prepared;

    fn lagrangian(&self, state: &State<S, N>) -> S {
        self.model.lagrangian_with(state, &self.inputs)
    }

    fn energy(&self, state: &State<S, N>) -> S {
        self.model.energy_with(state, &self.inputs)
    }

    fn momenta(&self, state: &State<S, N>) -> SVector<S, N> {
        self.model.momenta(state)
    }

    fn mass_matrix(&self, state: &State<S, N>) -> SMatrix<S, N, N> {
        self.model.mass_matrix(state)
    }

    fn forcing(&self, state: &State<S, N>) -> SVector<S, N> {
        self.model.forcing_with(state, &self.inputs)
    }

    fn generalized_forces(&self, state: &State<S, N>) -> SVector<S, N> {
        self.model.generalized_forces_with(state, &self.inputs)
    }

    fn accelerations(&self, state: &State<S, N>) -> SVector<S, N> {
        self.model.accelerations_with(state, &self.inputs)
    }

    fn prepare(&self) -> Self::Prepared {
        self.model.prepare()
    }

    fn accelerations_prepared(
        &self,
        state: &State<S, N>,
        prepared: &Self::Prepared,
    ) -> SVector<S, N> {
        self.model
            .accelerations_prepared_with(state, &self.inputs, prepared)
    }

    fn inverse_dynamics(
        &self,
        state: &State<S, N>,
        accelerations: &SVector<S, N>,
    ) -> SVector<S, N> {
        self.model
            .inverse_dynamics_with(state, &self.inputs, accelerations)
    }

    fn inverse_dynamics_prepared(
        &self,
        state: &State<S, N>,
        accelerations: &SVector<S, N>,
        prepared: &Self::Prepared,
    ) -> SVector<S, N> {
        self.model
            .inverse_dynamics_prepared_with(state, &self.inputs, accelerations, prepared)
    }

    fn linearize(&self, state: &State<S, N>) -> Linearization<S, N> {
        self.model.linearize_with(state, &self.inputs)
    }

    fn relative_pivots(&self, state: &State<S, N>) -> SVector<S, N> {
        self.model.relative_pivots(state)
    }
}
