//! Systems with typical sizes of their coordinates, for the absolute tolerance.

use super::component_name::ComponentName;
use super::dynamics::{Dynamics, forward_dynamics};
use super::error::IntegrationError;
use super::event::MetConditions;
use super::projection::Projection;
use super::singularity::Singularity;
use super::taylor::{BranchVisitor, Series, SeriesMemory, SwitchingFunction, TaylorCoefficients};
use crate::linalg::{ErrorTolerance, VectorSpace};
use crate::scalar::Scalar;

/// A system with a typical size of each component, created by [`with_sizes`](SetTypicalSizes::with_sizes).
#[derive(Clone, Copy, Debug)]
pub struct WithSizes<D, X> {
    pub(super) dynamics: D,
    pub(super) sizes: X,
}

/// An extension of all systems by typical sizes of their coordinates.
pub trait SetTypicalSizes<S: Scalar = f64>: Dynamics<S> {
    /// Sets a typical size of each coordinate. The absolute tolerances of a coordinate and of its velocity are
    /// multiplied by this size, which is 1 by default.
    ///
    /// The tolerances are then pure numbers, and the sizes have the units of the coordinates. An infinite size excludes
    /// a coordinate and its velocity from the error control. A size that is negative or not a number is an error when
    /// the integration begins.
    ///
    /// ```
    /// use lagrangian::prelude::*;
    ///
    /// /// A cart that travels kilometres with a swinging pendulum.
    /// #[derive(Lagrangian)]
    /// #[lagrangian(
    ///     coordinates(x, theta),
    ///     kinetic = m * dot(x).powi(2) + m * l * cos(theta) * dot(x) * dot(theta)
    ///         + 0.5 * m * (l * dot(theta)).powi(2),
    ///     potential = 0.5 * k * x.powi(2) - m * g * l * cos(theta),
    /// )]
    /// struct Cart { m: f64, l: f64, k: f64, g: f64 }
    ///
    /// let cart = Cart { m: 1.0, l: 1.0, k: 1e-4, g: 9.81 };
    /// let mut sizes = [1.0; 2];
    /// sizes[Cart::X] = 1000.0;
    /// let start = State::new(0.0, [700.0, 0.1], [0.0, 0.0]);
    /// Problem::new(cart.dynamics().with_sizes(sizes), start).solve(10.0, Dop853::new())?;
    /// # Ok::<(), IntegrationError>(())
    /// ```
    fn with_sizes(self, sizes: impl TypicalSizes<Self::State>) -> WithSizes<Self, Self::State>
    where
        Self: Sized,
    {
        WithSizes {
            dynamics: self,
            sizes: sizes.into_state(),
        }
    }
}

impl<S: Scalar, D: Dynamics<S> + ?Sized> SetTypicalSizes<S> for D {}

/// Typical sizes: of all components of a state, or of the coordinates of a mechanical system, as an array.
pub trait TypicalSizes<X> {
    /// Returns the size of each component.
    fn into_state(self) -> X;
}

impl<X> TypicalSizes<X> for X {
    fn into_state(self) -> X {
        self
    }
}

impl<S: Scalar, D: Dynamics<S>> Dynamics<S> for WithSizes<D, D::State> {
    type State = D::State;

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
            absolute.map(|allowed| sizes.next().map_or(allowed, |size| allowed * size));
        let relative = self
            .dynamics
            .allowed_error(x, &only(tolerance.relative, 0.0));
        allowed.add_scaled(S::one(), &relative);
        allowed
    }

    fn begin(&mut self, t: S, x: &Self::State) {
        self.dynamics.begin(t, x);
    }

    forward_dynamics! { self => self.dynamics }
}

impl<S: Scalar, D: Series<S>> Series<S> for WithSizes<D, D::State> {
    #[inline]
    fn series<const HALF: usize>(
        &self,
        begin: (S, &Self::State),
        unit: S,
        coefficients: &mut TaylorCoefficients<Self::State, HALF>,
        memory: Option<&mut SeriesMemory>,
    ) {
        self.dynamics.series(begin, unit, coefficients, memory);
    }

    fn branches<const HALF: usize>(
        &self,
        t: S,
        x: &Self::State,
        unit: S,
        motion: &TaylorCoefficients<Self::State, HALF>,
        visit: &mut BranchVisitor<'_, S>,
    ) {
        self.dynamics.branches(t, x, unit, motion, visit);
    }

    fn switching_function(&self, index: usize) -> SwitchingFunction {
        self.dynamics.switching_function(index)
    }

    #[inline]
    fn events_in_step<const HALF: usize, const OF_MOTION: usize>(
        &self,
        begin: (S, &Self::State),
        unit: S,
        motion: &TaylorCoefficients<Self::State, OF_MOTION>,
        end: (S, &Self::State),
        (watched, visit): (
            MetConditions,
            &mut impl FnMut(usize, &TaylorCoefficients<S, HALF>, S),
        ),
    ) {
        self.dynamics
            .events_in_step(begin, unit, motion, end, (watched, visit));
    }
}
