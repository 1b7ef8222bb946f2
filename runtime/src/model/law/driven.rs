//! Inputs that are functions of time.

use nalgebra::SVector;

use super::{Law, LawSeries};
use crate::model::phase::Phase;
use crate::model::signals::Signals;
use crate::scalar::Scalar;

/// A law whose `U` inputs are [signals](Signals); constructed by [`Problem::driven_by`](crate::Problem::driven_by).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Driven<I, const U: usize>(pub(crate) I);

impl<I, S, const N: usize, const U: usize> Law<N, SVector<S, U>, S> for Driven<I, U>
where
    I: Signals<S, U>,
    S: Scalar,
{
    type States = ();

    const READS_MOTION: bool = false;

    #[inline]
    fn evaluate(&self, _: &SVector<S, U>, t: S, _: &Phase<S, N>) -> (SVector<S, U>, ()) {
        (self.0.values(t), ())
    }

    fn series<const HALF: usize, R>(
        &self,
        _: &SVector<S, U>,
        (t, _): (S, &Phase<S, N>),
        unit: S,
        then: impl FnOnce(&[SVector<S, U>], &[()]) -> R,
    ) -> Option<R> {
        let mut inputs = [[SVector::from_element(S::zero()); 2]; HALF];
        let inputs = inputs.as_flattened_mut();
        self.0.series::<HALF>(t, unit, inputs);
        Some(then(inputs, &[]))
    }
}

impl<I, S, const N: usize, const U: usize> LawSeries<N, SVector<S, U>, S> for Driven<I, U>
where
    I: Signals<S, U>,
    S: Scalar,
{
}
