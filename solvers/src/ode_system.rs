//! Systems of first-order differential equations on slices.

use alloc::vec::Vec;
use core::fmt;

use lagrangian::{At, Dual, Dynamics, VectorSpace};

use crate::error::SystemError;
use crate::jacobian::{DualJacobian, Jacobian, NoJacobian};
use crate::on_duals::OnDuals;
use crate::source::Source;

/// The first-order system ẋ = f(t, x) of a model or of other dynamics, from an initial state, on slices of numbers.
///
/// With the feature of a solver crate it is a system of that crate: see the page of this crate. Components are in the order of the
/// state: of a model the coordinates, then the velocities.
///
/// `J` is its [`Jacobian`]. A model has one, other dynamics have [`NoJacobian`] until [`jacobian_by`](Self::jacobian_by).
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian_solvers::OdeSystem;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     coordinates(theta),
///     kinetic = 0.5 * m * (l * dot(theta)).powi(2),
///     potential = -m * g * l * cos(theta),
/// )]
/// struct Pendulum { m: f64, l: f64, g: f64 }
///
/// let pendulum = Pendulum { m: 1.0, l: 2.0, g: 10.0 };
/// let system = OdeSystem::new(&pendulum, State::new(0.0, [0.5], [0.25]))?;
/// assert_eq!(system.initial(), [0.5, 0.25]);
///
/// let mut jacobian = [0.0; 4];
/// system.jacobian(0.0, &[0.0, 3.0], &mut jacobian)?;
/// assert_eq!(jacobian, [0.0, 1.0, -5.0, 0.0]);
/// # Ok::<(), lagrangian_solvers::SystemError>(())
/// ```
#[derive(Clone)]
pub struct OdeSystem<D: Dynamics, J = NoJacobian> {
    dynamics: D,
    start: At<f64, D::State>,
    size: usize,
    jacobian: J,
}

impl<D: Dynamics, J> OdeSystem<D, J> {
    /// The system of a model, `&model`, or of [dynamics](Dynamics), from an initial state.
    ///
    /// # Errors
    ///
    /// [`SystemError`] if a [parameter](Dynamics::check) of the dynamics has no meaning, if the initial state, its time or its
    /// derivative is not finite, or if the dynamics [update](Dynamics::next_update) their state at given times.
    pub fn new<K>(
        source: impl Source<K, Dynamics = D, Jacobian = J>,
        start: At<f64, D::State>,
    ) -> Result<Self, SystemError> {
        let (dynamics, jacobian) = source.into_parts();
        check(&dynamics, &start)?;
        Ok(Self {
            size: start.x.components().count(),
            dynamics,
            start,
            jacobian,
        })
    }

    /// The same system with the Jacobian of `dynamics`, the same ones on [dual numbers](Dual).
    ///
    /// ```
    /// use lagrangian::{At, Dynamics, Scalar, nalgebra::Vector2};
    /// use lagrangian_solvers::OdeSystem;
    ///
    /// /// ẍ = (1 − x²) ẋ − x.
    /// struct VanDerPol;
    ///
    /// impl<S: Scalar> Dynamics<S> for VanDerPol {
    ///     type State = Vector2<S>;
    ///
    ///     fn derivative(&self, _: S, x: &Vector2<S>) -> Vector2<S> {
    ///         Vector2::new(x[1], (S::one() - x[0] * x[0]) * x[1] - x[0])
    ///     }
    /// }
    ///
    /// let start = At { t: 0.0, x: Vector2::new(2.0, 0.0) };
    /// let system = OdeSystem::new(&VanDerPol, start)?.jacobian_by(&VanDerPol);
    /// let mut jacobian = [0.0; 4];
    /// system.jacobian(0.0, &[2.0, 3.0], &mut jacobian)?;
    /// assert_eq!(jacobian, [0.0, 1.0, -13.0, -3.0]);
    /// # Ok::<(), lagrangian_solvers::SystemError>(())
    /// ```
    #[must_use]
    pub fn jacobian_by<E>(self, dynamics: E) -> OdeSystem<D, DualJacobian<E, D::State>>
    where
        D::State: OnDuals,
        E: Dynamics<Dual, State = <D::State as OnDuals>::OnDuals>,
    {
        OdeSystem {
            dynamics: self.dynamics,
            start: self.start,
            size: self.size,
            jacobian: DualJacobian::new(dynamics),
        }
    }

    /// The dynamics.
    #[must_use]
    pub const fn dynamics(&self) -> &D {
        &self.dynamics
    }

    /// The initial state, with its time.
    #[must_use]
    pub const fn start(&self) -> &At<f64, D::State> {
        &self.start
    }

    /// The number of components.
    #[must_use]
    pub const fn size(&self) -> usize {
        self.size
    }

    /// The components of the initial state.
    #[must_use]
    pub fn initial(&self) -> Vec<f64> {
        self.start.x.components().collect()
    }

    /// The components of the initial state, as an array.
    ///
    /// # Errors
    ///
    /// [`SystemError::WrongSize`] unless `SIZE` is [`size`](Self::size).
    pub fn initial_array<const SIZE: usize>(&self) -> Result<[f64; SIZE], SystemError> {
        check_size(self.size, SIZE)?;
        let mut components = self.start.x.components();
        Ok([(); SIZE].map(|()| components.next().unwrap_or(f64::NAN)))
    }

    /// The state with these components at a time.
    ///
    /// # Errors
    ///
    /// [`SystemError::WrongSize`] unless there are [`size`](Self::size) of them, and [`SystemError::NonFiniteState`] if one is
    /// infinite or not a number: some solvers end with such states in place of an error.
    pub fn state(&self, t: f64, components: &[f64]) -> Result<At<f64, D::State>, SystemError> {
        let x = self.state_of_slice(components)?;
        check_finite(&self.dynamics, t, &x)?;
        Ok(At { t, x })
    }

    /// Writes the derivative f(t, x) to a slice.
    ///
    /// # Errors
    ///
    /// [`SystemError::WrongSize`] unless both slices have [`size`](Self::size) elements.
    pub fn derivative(&self, t: f64, x: &[f64], derivative: &mut [f64]) -> Result<(), SystemError> {
        check_size(self.size, derivative.len())?;
        let x = self.state_of_slice(x)?;
        let found = self.dynamics.derivative(t, &x);
        for (written, component) in derivative.iter_mut().zip(found.components()) {
            *written = component;
        }
        Ok(())
    }

    /// Writes the Jacobian ∂f/∂x to a slice, row by row.
    ///
    /// # Errors
    ///
    /// [`SystemError::WrongSize`] unless `x` has [`size`](Self::size) elements and `jacobian` the square of it.
    pub fn jacobian(&self, t: f64, x: &[f64], jacobian: &mut [f64]) -> Result<(), SystemError>
    where
        J: Jacobian<State = D::State>,
    {
        check_size(self.size * self.size, jacobian.len())?;
        let x = self.state_of_slice(x)?;
        self.write_jacobian(t, &x, jacobian);
        Ok(())
    }

    /// Writes the Jacobian to a slice of the right size.
    pub(crate) fn write_jacobian(&self, t: f64, x: &D::State, jacobian: &mut [f64])
    where
        J: Jacobian<State = D::State>,
    {
        self.jacobian.write(t, x, jacobian);
    }

    fn state_of_slice(&self, components: &[f64]) -> Result<D::State, SystemError> {
        check_size(self.size, components.len())?;
        Ok(self.state_of(components.iter().copied()))
    }

    /// Writes the derivative, or NaN where there is none: what a solver calls cannot fail otherwise.
    #[cfg(any(feature = "diffsol", feature = "ode-solvers"))]
    pub(crate) fn derivative_or_nan(&self, t: f64, x: &[f64], derivative: &mut [f64]) {
        if self.derivative(t, x, derivative).is_err() {
            derivative.fill(f64::NAN);
        }
    }

    /// The state with these components; those that are missing are NaN.
    pub(crate) fn state_of(&self, mut components: impl Iterator<Item = f64>) -> D::State {
        let next = |_| components.next().unwrap_or(f64::NAN);
        self.start.x.map(next)
    }
}

impl<D, J> fmt::Debug for OdeSystem<D, J>
where
    D: Dynamics<State: fmt::Debug>,
{
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("OdeSystem")
            .field("start", &self.start)
            .finish_non_exhaustive()
    }
}

const fn check_size(expected: usize, found: usize) -> Result<(), SystemError> {
    if expected == found {
        Ok(())
    } else {
        Err(SystemError::WrongSize { expected, found })
    }
}

fn check_finite<D: Dynamics>(dynamics: &D, time: f64, x: &D::State) -> Result<(), SystemError> {
    let Some((index, value)) = x.first_non_finite() else {
        return Ok(());
    };
    Err(SystemError::NonFiniteState {
        time,
        component: dynamics.component_name(index),
        value,
    })
}

/// Whether another solver can begin at this state.
fn check<D: Dynamics>(dynamics: &D, start: &At<f64, D::State>) -> Result<(), SystemError> {
    dynamics
        .check()
        .map_err(|error| SystemError::InvalidParameter { error })?;
    let At { t: time, ref x } = *start;
    if !time.is_finite() {
        return Err(SystemError::NonFiniteTime { time });
    }
    check_finite(dynamics, time, x)?;
    if let Some(time) = dynamics.next_update(x) {
        return Err(SystemError::Updates { time });
    }
    if let Some((index, value)) = dynamics.derivative(time, x).first_non_finite() {
        return Err(SystemError::NonFiniteDerivative {
            time,
            component: dynamics.component_name(index),
            value,
        });
    }
    Ok(())
}
