//! The equations satisfied by equilibria and steady motions, with their exact Jacobian.

use nalgebra::{SMatrix, SVector};

use super::jacobian_rows::Variables;
use super::tangent_error::TangentError;
use crate::integrate::SingleNumber;
use crate::linalg::largest;
use crate::model::{Inputs, Lagrangian, Linearization, Quantities as _, State, StateJacobian};
use crate::scalar::Scalar;

/// The quantities of a model that a search evaluates, with `U` inputs that the search may change.
pub trait Balance<S: Scalar, const N: usize, const U: usize> {
    /// The names of the coordinates.
    const COORDINATES: [&'static str; N];
    /// Which coordinates are ignorable.
    const IGNORABLE: [bool; N];

    /// The values of the inputs.
    fn inputs(&self) -> SVector<S, U>;
    /// The accelerations q̈.
    fn accelerations(&self, state: &State<S, N>, inputs: &SVector<S, U>) -> SVector<S, N>;
    /// The derivatives of the accelerations.
    fn linearize(&self, state: &State<S, N>, inputs: &SVector<S, U>) -> Linearization<S, N>;
    /// The derivatives of the accelerations by the inputs.
    fn input_jacobian(&self, state: &State<S, N>, inputs: &SVector<S, U>) -> SMatrix<S, N, U>;
    /// The generalized momenta.
    fn momenta(&self, state: &State<S, N>) -> SVector<S, N>;
    /// The mass matrix.
    fn mass_matrix(&self, state: &State<S, N>) -> SMatrix<S, N, N>;
    /// The forcing f in M q̈ = f; under constraints, what of it acts on the independent velocities.
    fn forcing(
        &self,
        state: &State<S, N>,
        inputs: &SVector<S, U>,
        independent: &[bool; N],
    ) -> SVector<S, N>;
    /// The conditioning of M q̈ = f by coordinates, as defined by [`Lagrangian::relative_pivots`].
    fn relative_pivots(&self, state: &State<S, N>) -> SVector<S, N>;
    /// Whether the model has constraints.
    const CONSTRAINED: bool = false;
    /// The coordinates whose velocities and accelerations determine all others, where some coordinates move and some velocities should
    /// be independent; all coordinates without constraints.
    fn independent(&self, state: &State<S, N>, [moving, velocities]: [&[bool; N]; 2]) -> [bool; N] {
        let _ = (state, moving, velocities);
        [true; N]
    }
    /// What takes coordinates onto holonomic constraints, with opposite sign, and then what takes dependent velocities to those that
    /// follow from the independent ones; zero without constraints.
    fn corrections(&self, state: &State<S, N>, independent: &[bool; N]) -> [SVector<S, N>; 2] {
        let _ = (state, independent);
        [SVector::zeros(); 2]
    }
    /// The derivatives of both corrections by coordinates and by velocities, at a state that meets the constraints.
    fn correction_slopes(
        &self,
        state: &State<S, N>,
        independent: &[bool; N],
    ) -> [[SMatrix<S, N, N>; 2]; 2] {
        let _ = (state, independent);
        [[SMatrix::zeros(); 2]; 2]
    }
    /// The reason why a state in which all independent accelerations vanish is no steady motion, if there is one.
    fn unsteady(
        &self,
        state: &State<S, N>,
        inputs: &SVector<S, U>,
        independent: &[bool; N],
    ) -> Option<TangentError> {
        let _ = (state, inputs, independent);
        None
    }
    /// The state that meets the constraints near a state, without a change of coordinates and velocities that are held, if one is found.
    fn corrected(&self, state: State<S, N>, held: [[bool; N]; 2]) -> Option<State<S, N>> {
        let _ = held;
        Some(state)
    }
    /// The constraint that a state violates most, and its residual.
    fn violated(&self, state: &State<S, N>) -> Option<(&'static str, f64)> {
        let _ = state;
        None
    }
}

/// The quantities of a balance that a model has under given inputs.
macro_rules! quantities_of_model {
    ($self:ident: $model:expr, $number_of_inputs:tt, |$inputs:ident| $given:expr) => {
        const COORDINATES: [&'static str; N] = M::COORDINATES;
        const IGNORABLE: [bool; N] = M::IGNORABLE;

        fn accelerations(
            &$self,
            state: &State<S, N>,
            $inputs: &SVector<S, $number_of_inputs>,
        ) -> SVector<S, N> {
            let model = $model;
            model.accelerations(state, &$given, &model.prepare())
        }

        fn momenta(&$self, state: &State<S, N>) -> SVector<S, N> {
            let model = $model;
            model.momenta(state, &model.prepare())
        }

        fn mass_matrix(&$self, state: &State<S, N>) -> SMatrix<S, N, N> {
            let model = $model;
            model.mass_matrix(state, &model.prepare())
        }

        fn relative_pivots(&$self, state: &State<S, N>) -> SVector<S, N> {
            let model = $model;
            model.relative_pivots(state, &model.prepare())
        }
    };
}
pub(super) use quantities_of_model;

/// A model whose inputs, if any, keep their values.
#[derive(Debug)]
pub struct HeldInputs<'a, M: ?Sized>(pub(super) &'a M);

/// A model whose inputs may be unknowns of the search.
#[derive(Debug)]
pub struct FreeInputs<'a, M: ?Sized>(pub(super) &'a M);

impl<S, M, const N: usize> Balance<S, N, 0> for HeldInputs<'_, M>
where
    S: Scalar,
    M: Lagrangian<N, S, Model: StateJacobian<N, S>> + ?Sized,
{
    quantities_of_model! { self: self.0.model(), 0, |_inputs| self.0.inputs() }

    fn inputs(&self) -> SVector<S, 0> {
        SVector::zeros()
    }

    fn linearize(&self, state: &State<S, N>, _: &SVector<S, 0>) -> Linearization<S, N> {
        self.0.linearize(state)
    }

    fn input_jacobian(&self, _: &State<S, N>, _: &SVector<S, 0>) -> SMatrix<S, N, 0> {
        SMatrix::zeros()
    }

    fn forcing(&self, state: &State<S, N>, _: &SVector<S, 0>, _: &[bool; N]) -> SVector<S, N> {
        self.0.forcing(state)
    }
}

impl<S, M, const N: usize, const U: usize> Balance<S, N, U> for FreeInputs<'_, M>
where
    S: Scalar,
    M: Inputs<N, U, S> + StateJacobian<N, S> + ?Sized,
{
    quantities_of_model! { self: self.0, U, |inputs| *inputs }

    fn inputs(&self) -> SVector<S, U> {
        self.0.inputs()
    }

    fn linearize(&self, state: &State<S, N>, inputs: &SVector<S, U>) -> Linearization<S, N> {
        self.0.linearize(state, inputs)
    }

    fn input_jacobian(&self, state: &State<S, N>, inputs: &SVector<S, U>) -> SMatrix<S, N, U> {
        self.0.input_jacobian(state, inputs)
    }

    fn forcing(&self, state: &State<S, N>, inputs: &SVector<S, U>, _: &[bool; N]) -> SVector<S, N> {
        self.0.forcing(state, inputs, &self.0.prepare())
    }
}

/// A point of the search: a state and inputs.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point<S: Scalar, const N: usize, const U: usize> {
    pub(super) state: State<S, N>,
    pub(super) inputs: SVector<S, U>,
    /// The coordinates whose accelerations are residuals; the other velocities and accelerations follow from theirs.
    pub(super) independent: [bool; N],
}

impl<S: SingleNumber, const N: usize, const U: usize> Point<S, N, U> {
    /// Returns the point displaced by `factor · step`, where the step is measured in `sizes`.
    pub(super) fn moved(
        &self,
        step: &Variables<S, N, U>,
        factor: f64,
        sizes: &Variables<S, N, U>,
    ) -> Self {
        let factor = S::from_f64(factor);
        let change = step.zip_map(sizes, |x, size| factor * x * size);
        let State { t, x } = self.state;
        Self {
            state: State::new(t, x.q + change.positions, x.v + change.velocities),
            inputs: self.inputs + change.inputs,
            ..*self
        }
    }
}

/// Returns the derivatives ∂pᵢ/∂qⱼ of the momenta of ignorable coordinates i by the other coordinates j.
///
/// Only ignorable coordinates may have velocities in the given state. For an ignorable coordinate i, Lagrange's
/// equation is ṗᵢ = Qᵢ, so that fᵢ = Qᵢ − Σ ∂pᵢ/∂qⱼ q̇ⱼ. The part of fᵢ that is odd in one q̇ⱼ is −∂pᵢ/∂qⱼ q̇ⱼ. This is
/// exact if L is of second degree in the velocities and Qᵢ does not contain q̇ⱼ.
pub(super) fn momentum_gradients<S, B, const N: usize, const U: usize>(
    model: &B,
    point: &Point<S, N, U>,
) -> SMatrix<S, N, N>
where
    S: SingleNumber,
    B: Balance<S, N, U>,
{
    let Point {
        state,
        inputs,
        independent,
    } = point;
    let fastest = largest(&state.v);
    let speed = S::from_f64(if fastest > 0.0 { fastest } else { 1.0 });
    let mut gradients = SMatrix::zeros();
    for j in (0..N).filter(|j| !B::IGNORABLE[*j]) {
        let forcing = |velocity: S| {
            let mut moving = *state;
            moving.v[j] = velocity;
            model.forcing(&moving, inputs, independent)
        };
        let odd = forcing(-speed) - forcing(speed);
        for i in (0..N).filter(|i| B::IGNORABLE[*i]) {
            gradients[(i, j)] = odd[i] / (speed + speed);
        }
    }
    gradients
}
