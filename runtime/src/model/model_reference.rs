//! References to models, alone and with other inputs.

use nalgebra::SVector;

use super::inputs::Inputs;
use super::lagrangian::Lagrangian;
use super::quantities::Quantities;
use super::with_inputs::WithInputs;
use crate::scalar::Scalar;

/// A reference to a model is a model.
impl<M, S, const N: usize> Lagrangian<N, S> for &M
where
    M: Lagrangian<N, S>,
    S: Scalar,
{
    type Model = M::Model;

    #[inline]
    fn model(&self) -> &M::Model {
        (**self).model()
    }

    #[inline]
    fn inputs(&self) -> <M::Model as Quantities<N, S>>::Inputs {
        Lagrangian::inputs(*self)
    }
}

impl<M, S, const N: usize, const U: usize> Lagrangian<N, S> for WithInputs<'_, M, S, U>
where
    M: Inputs<N, U, S>,
    S: Scalar,
{
    type Model = M;

    fn model(&self) -> &M {
        self.model
    }

    #[inline]
    fn inputs(&self) -> SVector<S, U> {
        self.inputs
    }
}
