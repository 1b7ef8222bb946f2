//! Static state feedback.

use nalgebra::SVector;

use super::Law;
use crate::linalg::IntoVector;
use crate::model::phase::Phase;
use crate::model::state::State;
use crate::scalar::Scalar;

/// A law whose `U` inputs are a function u(t, q, q̇); constructed by [`Problem::feedback`](crate::Problem::feedback).
#[derive(Clone, Copy, Debug)]
pub struct Feedback<F, const U: usize>(pub(crate) F);

impl<F, A, S, const N: usize, const U: usize> Law<N, SVector<S, U>, S> for Feedback<F, U>
where
    F: Fn(&State<S, N>) -> A,
    A: IntoVector<S, U>,
    S: Scalar,
{
    type States = ();

    #[inline]
    fn evaluate(&self, _: &SVector<S, U>, t: S, x: &Phase<S, N>) -> (SVector<S, U>, ()) {
        ((self.0)(&x.at_time(t)).into_vector(), ())
    }
}
