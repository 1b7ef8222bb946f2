//! Jacobians ∂f/∂x of derivatives f(t, x).

use core::marker::PhantomData;

use lagrangian::quantities::StateJacobian;
use lagrangian::{At, Dual, Dynamics, Lagrangian, Phase, VectorSpace};

use crate::on_duals::OnDuals;

/// The Jacobian of the derivative of a state.
pub trait Jacobian {
    /// The state x.
    type State;

    /// Writes ∂fᵢ/∂xⱼ at a time and a state of `n` components to element i n + j of `matrix`, which has n² elements.
    fn write(&self, t: f64, x: &Self::State, matrix: &mut [f64]);
}

/// The place of the Jacobian where none is known.
#[derive(Clone, Copy, Debug)]
pub struct NoJacobian;

/// The Jacobian of the equations of motion of a model, (0, 1; ∂q̈/∂q, ∂q̈/∂q̇), derived with the model:
/// [`Lagrangian::linearize`].
#[derive(Debug)]
pub struct ModelJacobian<'a, M: ?Sized, const N: usize> {
    model: &'a M,
}

impl<'a, M: ?Sized, const N: usize> ModelJacobian<'a, M, N> {
    pub(crate) const fn new(model: &'a M) -> Self {
        Self { model }
    }
}

impl<M: ?Sized, const N: usize> Clone for ModelJacobian<'_, M, N> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M: ?Sized, const N: usize> Copy for ModelJacobian<'_, M, N> {}

impl<M, const N: usize> Jacobian for ModelJacobian<'_, M, N>
where
    M: Lagrangian<N, Model: StateJacobian<N>>,
{
    type State = Phase<f64, N>;

    fn write(&self, t: f64, x: &Phase<f64, N>, matrix: &mut [f64]) {
        let linearization = self.model.linearize(&At { t, x: *x });
        let (upper, lower) = matrix.split_at_mut(2 * N * N);
        for (i, row) in upper.chunks_exact_mut(2 * N).enumerate() {
            row.fill(0.0);
            row[N + i] = 1.0;
        }
        for (i, row) in lower.chunks_exact_mut(2 * N).enumerate() {
            for j in 0..N {
                row[j] = linearization.position[(i, j)];
                row[N + j] = linearization.velocity[(i, j)];
            }
        }
    }
}

/// The Jacobian of dynamics that are evaluated on [dual numbers](Dual), column by column: forward-mode automatic differentiation
/// (A. Griewank & A. Walther, *Evaluating Derivatives*, 2nd ed., 2008, chapter 3).
#[derive(Debug)]
pub struct DualJacobian<D, X> {
    dynamics: D,
    state: PhantomData<fn(&X)>,
}

impl<D, X> DualJacobian<D, X> {
    pub(crate) const fn new(dynamics: D) -> Self {
        Self {
            dynamics,
            state: PhantomData,
        }
    }
}

impl<D: Clone, X> Clone for DualJacobian<D, X> {
    fn clone(&self) -> Self {
        Self::new(self.dynamics.clone())
    }
}

impl<D, X> Jacobian for DualJacobian<D, X>
where
    X: OnDuals,
    D: Dynamics<Dual, State = X::OnDuals>,
{
    type State = X;

    fn write(&self, t: f64, x: &X, matrix: &mut [f64]) {
        let constant = x.on_duals();
        let size = x.components().count();
        for column in 0..size {
            let mut index = 0;
            let seeded = constant.map(|component| {
                let seed = if index == column { 1.0 } else { 0.0 };
                index += 1;
                Dual::new(component.value, [seed])
            });
            let derivative = self.dynamics.derivative(Dual::constant(t), &seeded);
            let rows = matrix.chunks_exact_mut(size);
            for (row, component) in rows.zip(derivative.components()) {
                row[column] = component.derivative[0];
            }
        }
    }
}
