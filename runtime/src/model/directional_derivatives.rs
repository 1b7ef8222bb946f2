//! Derivatives of the motion of a constrained model along directions, by dual numbers.
//!
//! A. Griewank & A. Walther, *Evaluating Derivatives*, 2nd ed., 2008, chapter 3.

use nalgebra::SVector;

use super::by_columns::{constant_state, constants};
use super::constraints::Constraints;
use super::state::State;
use crate::scalar::{Dual, Scalar};

/// A constrained model whose accelerations, multipliers and constraints are differentiated along directions, with the
/// inputs held.
///
/// `#[derive(Lagrangian)]` implements it for models with constraints whose parameters are plain numbers, or of a type parameter that is
/// bounded by `Scalar` alone. They are functions of all coordinates and velocities. Only derivatives along directions that the constraints allow describe motions: see
/// [`TangentSpace`](crate::analysis::TangentSpace).
#[diagnostic::on_unimplemented(
    message = "the accelerations of `{Self}` under constraints cannot be differentiated",
    note = "the model needs constraints, and is evaluated on dual numbers: leave out `scalar = …`, bound a type parameter for its scalar \
            by `Scalar` alone, and write what external functions compute as expressions of the declaration"
)]
pub trait DirectionalDerivatives<const N: usize, const C: usize, S: Scalar = f64>:
    Constraints<N, C, S>
{
    /// The derivatives at a state and inputs along a change of coordinates, velocities and time.
    fn derivatives_along(
        &self,
        state: &State<S, N>,
        inputs: &Self::Inputs,
        direction: &State<S, N>,
    ) -> MotionDerivatives<S, N, C>;

    /// The derivatives by the input with an index.
    fn derivatives_by_input(
        &self,
        state: &State<S, N>,
        inputs: &Self::Inputs,
        input: usize,
    ) -> MotionDerivatives<S, N, C>;
}

/// Derivatives of what determines a constrained motion; see [`DirectionalDerivatives`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionDerivatives<S: Scalar, const N: usize, const C: usize> {
    /// Those of the accelerations q̈.
    pub accelerations: SVector<S, N>,
    /// Those of the multipliers λ.
    pub multipliers: SVector<S, C>,
    /// Those of the residuals w = G q̇ + a of the velocities.
    pub constraint_velocities: SVector<S, C>,
}

/// Returns the derivatives along a change of the state.
pub fn derivatives_along<M, S, const N: usize, const C: usize, const U: usize>(
    model: &M,
    state: &State<S, N>,
    inputs: &SVector<S, U>,
    direction: &State<S, N>,
) -> MotionDerivatives<S, N, C>
where
    M: Constraints<N, C, Dual<S, 1>, Inputs = SVector<Dual<S, 1>, U>>,
    S: Scalar,
{
    let along = |value: S, slope: S| Dual::new(value, [slope]);
    let state = State::new(
        along(state.t, direction.t),
        state.q.zip_map(&direction.q, along),
        state.v.zip_map(&direction.v, along),
    );
    evaluated(model, &state, &constants(inputs))
}

/// Returns the derivatives by an input.
pub fn derivatives_by_input<M, S, const N: usize, const C: usize, const U: usize>(
    model: &M,
    state: &State<S, N>,
    inputs: &SVector<S, U>,
    input: usize,
) -> MotionDerivatives<S, N, C>
where
    M: Constraints<N, C, Dual<S, 1>, Inputs = SVector<Dual<S, 1>, U>>,
    S: Scalar,
{
    let inputs = SVector::from_fn(|i, _| {
        let slope = if i == input { S::one() } else { S::zero() };
        Dual::new(inputs[i], [slope])
    });
    evaluated(model, &constant_state(state), &inputs)
}

fn evaluated<M, S, const N: usize, const C: usize, const U: usize>(
    model: &M,
    state: &State<Dual<S, 1>, N>,
    inputs: &SVector<Dual<S, 1>, U>,
) -> MotionDerivatives<S, N, C>
where
    M: Constraints<N, C, Dual<S, 1>, Inputs = SVector<Dual<S, 1>, U>>,
    S: Scalar,
{
    let slope = |x: Dual<S, 1>| x.derivative[0];
    let prepared = model.prepare();
    let (accelerations, multipliers) =
        model.accelerations_and_multipliers(state, inputs, &prepared);
    MotionDerivatives {
        accelerations: accelerations.map(slope),
        multipliers: multipliers.map(slope),
        constraint_velocities: model.constraint_velocities(state, &prepared).map(slope),
    }
}
