//! References to models.

use super::lagrangian::Lagrangian;
use super::quantities::Quantities;
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
