//! Dynamic feedback: a controller with its own states.

use nalgebra::SVector;

use super::Law;
use crate::linalg::IntoVector;
use crate::model::phase::Phase;
use crate::model::state::State;
use crate::scalar::Scalar;

/// A law in which the `U` inputs and the derivatives of the `K` states of a controller are a function (u, ż) of t, q,
/// q̇ and z; constructed by [`Problem::feedback_with_states`](crate::Problem::feedback_with_states).
#[derive(Clone, Copy, Debug)]
pub struct DynamicFeedback<F, const U: usize, const K: usize>(pub(crate) F);

impl<F, A, Z, S, const N: usize, const U: usize, const K: usize> Law<N, SVector<S, U>, S>
    for DynamicFeedback<F, U, K>
where
    F: Fn(&State<S, N>, &SVector<S, K>) -> (A, Z),
    A: IntoVector<S, U>,
    Z: IntoVector<S, K>,
    S: Scalar,
{
    type States = SVector<S, K>;

    #[inline]
    fn evaluate(
        &self,
        _: &SVector<S, U>,
        t: S,
        x: &Phase<S, N, SVector<S, K>>,
    ) -> (SVector<S, U>, SVector<S, K>) {
        let (inputs, rates) = (self.0)(&x.at_time(t), &x.z);
        (inputs.into_vector(), rates.into_vector())
    }
}
