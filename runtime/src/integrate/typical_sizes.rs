//! Systems with typical sizes of their coordinates, for the absolute tolerance.

use super::dynamics::{ComponentName, Dynamics};
use super::singularity::Singularity;
use super::taylor::{Series, TaylorCoefficients};
use crate::linalg::{ErrorTolerance, VectorSpace};
use crate::scalar::Scalar;

/// A system with a typical size of each component, made by [`Dynamics::with_sizes`].
#[derive(Clone, Copy, Debug)]
pub struct WithSizes<'a, D: ?Sized, X> {
    dynamics: &'a D,
    sizes: X,
}

impl<'a, D: ?Sized, X> WithSizes<'a, D, X> {
    pub(super) fn new(dynamics: &'a D, sizes: X) -> Self {
        Self { dynamics, sizes }
    }
}

/// Typical sizes: of all components of a state, or of the coordinates of a mechanical system, as an array.
pub trait TypicalSizes<X> {
    /// The size of each component.
    fn into_state(self) -> X;
}

impl<X> TypicalSizes<X> for X {
    fn into_state(self) -> X {
        self
    }
}

impl<S: Scalar, D: Dynamics<S> + ?Sized> Dynamics<S> for WithSizes<'_, D, D::State> {
    type State = D::State;

    #[inline]
    fn derivative(&self, t: S, x: &Self::State) -> Self::State {
        self.dynamics.derivative(t, x)
    }

    fn allowed_error(&self, x: &Self::State, tolerance: &ErrorTolerance<S>) -> Self::State {
        let only = |relative, absolute| ErrorTolerance {
            relative,
            absolute,
            ..*tolerance
        };
        let mut sizes = self.sizes.components();
        let absolute = self
            .dynamics
            .allowed_error(x, &only(0.0, tolerance.absolute));
        let mut allowed =
            absolute.map(|allowed| sizes.next().map_or(allowed, |size| allowed * size.abs()));
        let relative = self
            .dynamics
            .allowed_error(x, &only(tolerance.relative, 0.0));
        allowed.add_scaled(S::one(), &relative);
        allowed
    }

    #[inline]
    fn reduced(&self, x: &Self::State, compensation: &Self::State) -> Self::State {
        self.dynamics.reduced(x, compensation)
    }

    #[inline]
    fn singularity(&self, t: S, x: &Self::State, min_pivot: f64) -> Option<Singularity> {
        self.dynamics.singularity(t, x, min_pivot)
    }

    fn vanishing_inertia(&self, t: S, x: &Self::State) -> Option<Singularity> {
        self.dynamics.vanishing_inertia(t, x)
    }

    #[inline]
    fn singularity_in_lane(
        &self,
        lane: usize,
        t: S,
        x: &Self::State,
        min_pivot: f64,
    ) -> Option<Singularity> {
        self.dynamics.singularity_in_lane(lane, t, x, min_pivot)
    }

    fn vanishing_inertia_in_lane(&self, lane: usize, t: S, x: &Self::State) -> Option<Singularity> {
        self.dynamics.vanishing_inertia_in_lane(lane, t, x)
    }

    fn component_name(&self, index: usize) -> ComponentName {
        self.dynamics.component_name(index)
    }
}

impl<S: Scalar, D: Series<S> + ?Sized> Series<S> for WithSizes<'_, D, D::State> {
    #[inline]
    fn series<const HALF: usize>(
        &self,
        t: S,
        x: &Self::State,
        unit: S,
        coefficients: &mut TaylorCoefficients<Self::State, HALF>,
    ) {
        self.dynamics.series(t, x, unit, coefficients);
    }
}
