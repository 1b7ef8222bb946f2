//! Constant inputs.

use super::{Law, LawSeries};
use crate::model::phase::Phase;
use crate::scalar::Scalar;

/// A law that holds the inputs at the values of the model's fields or of
/// [`with_inputs`](crate::Lagrangian::with_inputs).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held;

impl<V: Clone, S: Scalar, const N: usize> Law<N, V, S> for Held {
    type States = ();

    const READS_MOTION: bool = false;

    const IS_HELD: bool = true;

    #[inline]
    fn evaluate(&self, given: &V, _: S, _: &Phase<S, N>) -> (V, ()) {
        (given.clone(), ())
    }

    #[inline]
    fn series<const HALF: usize, R>(
        &self,
        given: &V,
        _: (S, &Phase<S, N>),
        _: S,
        then: impl FnOnce(&[V], &[()]) -> R,
    ) -> Option<R> {
        Some(then(core::slice::from_ref(given), &[]))
    }
}

impl<V: Clone, S: Scalar, const N: usize> LawSeries<N, V, S> for Held {}
