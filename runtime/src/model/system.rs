//! Models as systems from which problems are constructed.

use super::equations_of_motion::EquationsOfMotion;
use super::lagrangian::Lagrangian;
use super::phase::Phase;
use crate::integrate::System;
use crate::scalar::Scalar;

/// The marker for systems that are models, owned or by reference.
#[derive(Clone, Copy, Debug)]
pub struct ByModel<const N: usize>;

impl<M, S, const N: usize> System<ByModel<N>, S> for M
where
    M: Lagrangian<N, S>,
    S: Scalar,
{
    type Dynamics = EquationsOfMotion<M, S, N>;
    type State = Phase<S, N>;

    fn into_dynamics(self) -> Self::Dynamics {
        EquationsOfMotion::new(self)
    }
}
