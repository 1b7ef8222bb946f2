//! What systems are made of.

use lagrangian::{Dynamics, EquationsOfMotion, Lagrangian};

use crate::jacobian::{ModelJacobian, NoJacobian};

/// What an [`OdeSystem`](crate::OdeSystem) is made of: a model, by reference, with the Jacobian of its equations of motion; or any
/// [`Dynamics`], without a Jacobian.
///
/// `K` is the kind of the source, which the compiler infers.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is neither a reference to a model nor dynamics",
    note = "a model enters by reference, `OdeSystem::new(&model, start)`"
)]
pub trait Source<K> {
    /// The derivative.
    type Dynamics: Dynamics;
    /// Its Jacobian: [`ModelJacobian`] or [`NoJacobian`].
    type Jacobian;

    /// The dynamics, and their Jacobian.
    fn into_parts(self) -> (Self::Dynamics, Self::Jacobian);
}

/// The kind of sources that are models with `N` coordinates.
#[derive(Clone, Copy, Debug)]
pub struct ByModel<const N: usize>;

/// The kind of sources that are dynamics.
#[derive(Clone, Copy, Debug)]
pub struct ByDynamics;

impl<'a, M, const N: usize> Source<ByModel<N>> for &'a M
where
    M: Lagrangian<N>,
{
    type Dynamics = EquationsOfMotion<&'a M, f64, N>;
    type Jacobian = ModelJacobian<'a, M, N>;

    fn into_parts(self) -> (Self::Dynamics, Self::Jacobian) {
        (self.dynamics(), ModelJacobian::new(self))
    }
}

impl<D: Dynamics> Source<ByDynamics> for D {
    type Dynamics = D;
    type Jacobian = NoJacobian;

    fn into_parts(self) -> (D, NoJacobian) {
        (self, NoJacobian)
    }
}
