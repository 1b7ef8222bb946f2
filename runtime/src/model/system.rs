//! Models as what a problem is made of.

use super::equations_of_motion::EquationsOfMotion;
use super::lagrangian::Lagrangian;
use super::owned_equations::OwnedEquations;
use super::phase::Phase;
use super::quantities::Quantities;
use crate::integrate::System;
use crate::scalar::Scalar;

/// The kind of systems that are models, by reference.
#[derive(Clone, Copy, Debug)]
pub struct ByModel<const N: usize>;

/// The kind of systems that are models which the problem owns, so that reactions to events can change them.
#[derive(Clone, Copy, Debug)]
pub struct ByOwnedModel<const N: usize>;

impl<'a, M, S, const N: usize> System<ByModel<N>, S> for &'a M
where
    M: Lagrangian<N, S>,
    S: Scalar,
{
    type Dynamics = EquationsOfMotion<'a, M::Model, S, N>;
    type State = Phase<S, N>;

    fn into_dynamics(self) -> Self::Dynamics {
        self.dynamics()
    }
}

impl<M, S, const N: usize> System<ByOwnedModel<N>, S> for M
where
    M: Quantities<N, S>,
    S: Scalar,
{
    type Dynamics = OwnedEquations<M, S, N>;
    type State = Phase<S, N>;

    fn into_dynamics(self) -> Self::Dynamics {
        OwnedEquations::new(self)
    }
}
