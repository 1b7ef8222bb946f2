//! Systems of ordinary differential equations, as an integrator sees them.

use super::component_name::ComponentName;
use super::error::IntegrationError;
use super::projection::Projection;
use super::singularity::Singularity;
use crate::linalg::{ErrorTolerance, VectorSpace};
use crate::scalar::Scalar;

/// A system of first-order differential equations ẋ = f(t, x).
///
/// Integrators accept any type that implements this trait. [`Lagrangian::dynamics`](crate::Lagrangian::dynamics)
/// returns the equations of motion of a model.
///
/// ```
/// use lagrangian::{At, Dop853, Dynamics, Problem};
/// use lagrangian::nalgebra::SVector;
///
/// /// ẋ = −x.
/// struct Decay;
///
/// impl Dynamics for Decay {
///     type State = SVector<f64, 1>;
///
///     fn derivative(&self, _: f64, x: &Self::State) -> Self::State {
///         -x
///     }
/// }
///
/// let start = At { t: 0.0, x: SVector::from([1.0]) };
/// let end = Problem::new(&Decay, start).solve(1.0, Dop853::new())?;
/// assert!((end[0] - (-1.0_f64).exp()).abs() < 1e-9);
/// # Ok::<(), lagrangian::IntegrationError>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not something that an integrator steps",
    note = "a model enters by reference, `Problem::new(&model, start)`; a control law returns as many numbers as there are inputs"
)]
pub trait Dynamics<S: Scalar = f64> {
    /// The state x.
    type State: VectorSpace<S>;

    /// Returns the derivative f(t, x).
    fn derivative(&self, t: S, x: &Self::State) -> Self::State;

    /// Returns the allowed error of a step in each component: absolute + relative · size, where the size by default is
    /// the magnitude of the component, and absolute · rate + relative · size for a velocity
    /// ([`VectorSpace::allowed_error`]).
    ///
    /// In the equations of motion of a model, the size of a coordinate that is an angle is 1, since whole turns do not
    /// matter, and the size of any other ignorable coordinate is |q̇|/rate.
    #[inline]
    fn allowed_error(&self, x: &Self::State, tolerance: &ErrorTolerance<S>) -> Self::State {
        x.allowed_error(tolerance)
    }

    /// Returns the sizes to which rounding errors of the components are proportional near a state, where constraints carry
    /// rounding errors from components of the given sizes to others, even to those that are zero. By default `None`: each
    /// component has its own.
    ///
    /// In the equations of motion of a model with constraints, the sizes are in the metric of the mass matrix.
    #[inline]
    fn rounding_sizes(&self, t: S, x: &Self::State, sizes: &Self::State) -> Option<Self::State> {
        let _ = (t, x, sizes);
        None
    }

    /// Returns a state at which the derivative is the same as at x + `compensation`, but is computed with smaller
    /// rounding errors, because whole periods ([`PERIODS`](crate::GeneralizedCoordinates::PERIODS)) of angles are
    /// subtracted. By default it is x.
    ///
    /// Steppers evaluate derivatives at this state; their own state continues to count turns. The compensation is what
    /// rounding has removed from x.
    ///
    /// Under a control law nothing is reduced, since a law may count turns.
    #[inline]
    fn reduced(&self, x: &Self::State, compensation: &Self::State) -> Self::State {
        let _ = compensation;
        x.clone()
    }

    /// Returns the singularity near a state, if the smallest relative pivot of the mass matrix (or an equivalent
    /// measure) is below `min_pivot` or NaN.
    #[inline]
    fn singularity(&self, t: S, x: &Self::State, min_pivot: f64) -> Option<Singularity> {
        let _ = (t, x, min_pivot);
        None
    }

    /// Returns the singularity near a state at the end of a step. Where it is certain that no singularity is ever met,
    /// nothing is evaluated. By default it calls [`singularity`](Self::singularity).
    #[inline]
    fn singularity_in_motion(&self, t: S, x: &Self::State, min_pivot: f64) -> Option<Singularity> {
        self.singularity(t, x, min_pivot)
    }

    /// Returns a singularity, in any lane, between the states before and after a step, even if it is near neither of
    /// them: a pole, at which the equations have no value.
    #[inline]
    fn singularity_between(
        &self,
        before: &Self::State,
        (t, after): (S, &Self::State),
    ) -> Option<Singularity> {
        let _ = (before, t, after);
        None
    }

    /// Returns the coordinate whose inertia has nearly vanished at a state, if there is one: it moves too fast for any
    /// step. Called when no step is small enough.
    fn vanishing_inertia(&self, t: S, x: &Self::State) -> Option<Singularity> {
        let _ = (t, x);
        None
    }

    /// Returns the coordinate whose inertia has nearly vanished in one lane.
    fn vanishing_inertia_in_lane(&self, lane: usize, t: S, x: &Self::State) -> Option<Singularity> {
        let _ = lane;
        self.vanishing_inertia(t, x)
    }

    /// Prepares for a motion from a state: called before each motion, whether it begins, continues from a checkpoint, or was
    /// changed. By default nothing is prepared. What is prepared must not depend on which state of the motion it is.
    fn begin(&mut self, t: S, x: &Self::State) {
        let _ = (t, x);
    }

    /// Returns an error if a parameter is meaningless, such as a period that is not positive. A
    /// [`Problem`](crate::Problem) checks its dynamics at the start and after each change to them.
    ///
    /// # Errors
    ///
    /// None by default.
    fn check(&self) -> Result<(), IntegrationError> {
        Ok(())
    }

    /// Returns the next time at which the state is updated (by a sampled controller, or by a difference equation beside
    /// the differential ones), as far as `x` determines it; by default `None`. If a [`Problem`](crate::Problem) is
    /// integrated forwards in time, a step ends there.
    fn next_update(&self, x: &Self::State) -> Option<f64> {
        let _ = x;
        None
    }

    /// Updates the state at the time that [`next_update`](Self::next_update) returned. From then on, it returns a later
    /// time.
    fn update(&self, t: S, x: &mut Self::State) {
        let _ = (t, x);
    }

    /// Returns the state nearest to `x` on the manifold on which the equations hold, for example with a unit
    /// quaternion, or with positions and velocities that satisfy constraints. By default `None`: there is no manifold.
    ///
    /// Each step is taken, and its error is estimated, without regard to the manifold. Once it is accepted, its end is
    /// projected before anything else sees it, and so are the states of samples and events (E. Hairer, C. Lubich & G.
    /// Wanner, *Geometric Numerical Integration*, 2nd edition (2006), IV.4).
    /// [`Statistics::projection`](crate::Statistics::projection) tells how far the ends of steps were moved. A move by
    /// more than ten times the allowed error is an error, [`OffManifold`](crate::IntegrationError::OffManifold). The
    /// same limit applies to the start, and to a state left by a reaction or by
    /// [`Run::change`](crate::problem::Run::change); such a state, if it is near enough, is not changed before the end
    /// of the first step. Fixed steps, which have no tolerance, have to start within 10⁻⁶ of the size of each
    /// component.
    ///
    /// The projection must depend on `t` and `x` alone and always take the same number of iterations, so that a motion
    /// is identical to the last bit when it is integrated alone, in lanes, or resumed from a checkpoint. It must leave
    /// a state on the manifold in place except for rounding. After n iterations of Newton's method with the gradients
    /// of the first iteration, a relative error e becomes eⁿ⁺¹: two iterations are enough for tolerances of 10⁻⁶, three
    /// for any tolerance, and [`Dual`](crate::Dual) numbers need one more. Project positions before velocities, whose
    /// constraints are evaluated at the projected positions. For a mechanical system the nearest state is meant in the
    /// metric of the mass matrix, so that the correction acts like constraint forces.
    ///
    /// ```
    /// use lagrangian::prelude::*;
    /// use lagrangian::problem::Projection;
    ///
    /// /// A mass on a rod of length 1 about the origin, without gravity: (x, y, ẋ, ẏ).
    /// struct Rod;
    ///
    /// impl Dynamics for Rod {
    ///     type State = SVector<f64, 4>;
    ///
    ///     fn derivative(&self, _: f64, x: &Self::State) -> Self::State {
    ///         // The acceleration that the rod imparts, from x·ẍ + |ẋ|² = 0.
    ///         let multiplier = -(x[2] * x[2] + x[3] * x[3]) / (x[0] * x[0] + x[1] * x[1]);
    ///         SVector::from([x[2], x[3], multiplier * x[0], multiplier * x[1]])
    ///     }
    ///
    ///     fn project(&self, _: f64, x: &Self::State) -> Option<Projection<f64, Self::State>> {
    ///         let length = x[0].hypot(x[1]);
    ///         let axis = [x[0] / length, x[1] / length];
    ///         let radial = axis[0] * x[2] + axis[1] * x[3];
    ///         let velocity = [x[2] - radial * axis[0], x[3] - radial * axis[1]];
    ///         let state = SVector::from([axis[0], axis[1], velocity[0], velocity[1]]);
    ///         // At the origin there is no nearest direction.
    ///         Some(Projection::new(state).checked(0, axis[0].hypot(axis[1]) - 1.0, 1e-12))
    ///     }
    ///
    ///     fn constraint_name(&self, _: usize) -> &'static str {
    ///         "the length of the rod"
    ///     }
    /// }
    ///
    /// let start = At { t: 0.0, x: SVector::from([1.0, 0.0, 0.0, 1.0]) };
    /// let end = Problem::new(&Rod, start).solve(1000.0, Dop853::new())?;
    /// assert!((end[0].hypot(end[1]) - 1.0).abs() < 1e-15);
    /// assert!((end[0] - 1000.0_f64.cos()).abs() < 1e-6);
    /// assert!(end.statistics.projection < 1.0);
    /// # Ok::<(), IntegrationError>(())
    /// ```
    #[inline]
    fn project(&self, t: S, x: &Self::State) -> Option<Projection<S, Self::State>> {
        let _ = (t, x);
        None
    }

    /// Returns the smallest sine of the angle between the gradient of a constraint and the span of the gradients of others: 0 in
    /// a singular configuration. Methods that [pass](crate::Taylor::pass_singular_configurations) such configurations find
    /// them by it. By default `None`: there are no constraints, or nothing is known of them.
    fn constraint_sine(&self, t: S, x: &Self::State) -> Option<S> {
        let _ = (t, x);
        None
    }

    /// Returns the constraint that a state violates most, and its residual, for error messages. By default `None`: it is not
    /// known.
    fn violated_constraint(&self, t: S, x: &Self::State) -> Option<(usize, S)> {
        let _ = (t, x);
        None
    }

    /// Returns the name, for error messages, of a constraint onto which [`project`](Self::project) projects.
    fn constraint_name(&self, index: usize) -> &'static str {
        let _ = index;
        "a constraint"
    }

    /// Returns the name of a component for error messages.
    fn component_name(&self, index: usize) -> ComponentName {
        ComponentName::Index(index)
    }
}

/// Methods that another system answers.
macro_rules! forward {
    ($self:ident => $dynamics:expr; $(
        $method:ident($($argument:ident: $type:ty),*) -> $result:ty;
    )*) => {$(
        #[inline]
        fn $method(&$self, $($argument: $type),*) -> $result {
            $dynamics.$method($($argument),*)
        }
    )*};
}
pub(super) use forward;

/// The methods of `Dynamics` that another system answers, without the allowed error and those that change the system.
macro_rules! forward_dynamics {
    ($self:ident => $dynamics:expr) => {
        $crate::integrate::dynamics::forward! { $self => $dynamics;
            derivative(t: S, x: &Self::State) -> Self::State;
            rounding_sizes(t: S, x: &Self::State, sizes: &Self::State) -> Option<Self::State>;
            reduced(x: &Self::State, compensation: &Self::State) -> Self::State;
            singularity(t: S, x: &Self::State, min_pivot: f64) -> Option<Singularity>;
            singularity_in_motion(t: S, x: &Self::State, min_pivot: f64) -> Option<Singularity>;
            singularity_between(before: &Self::State, after: (S, &Self::State)) -> Option<Singularity>;
            vanishing_inertia(t: S, x: &Self::State) -> Option<Singularity>;
            vanishing_inertia_in_lane(lane: usize, t: S, x: &Self::State) -> Option<Singularity>;
            check() -> Result<(), IntegrationError>;
            next_update(x: &Self::State) -> Option<f64>;
            update(t: S, x: &mut Self::State) -> ();
            project(t: S, x: &Self::State) -> Option<Projection<S, Self::State>>;
            constraint_sine(t: S, x: &Self::State) -> Option<S>;
            violated_constraint(t: S, x: &Self::State) -> Option<(usize, S)>;
            constraint_name(index: usize) -> &'static str;
            component_name(index: usize) -> ComponentName;
        }
    };
}
pub(super) use forward_dynamics;

impl<S: Scalar, D: Dynamics<S> + ?Sized> Dynamics<S> for &D {
    type State = D::State;

    #[inline]
    fn allowed_error(&self, x: &D::State, tolerance: &ErrorTolerance<S>) -> D::State {
        (**self).allowed_error(x, tolerance)
    }

    forward_dynamics! { self => (**self) }
}
