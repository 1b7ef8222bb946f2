//! The free rotation of a rigid body in closed form.
//!
//! C. G. J. Jacobi, *Sur la rotation d'un corps*, J. reine angew. Math. **39** (1849) 293–350; L. D. Landau & E. M.
//! Lifshitz, *Mechanics*, 3rd edition (1976), § 37, for the angular velocity. The angle about the angular momentum is
//! an elliptic integral of the third kind. Differences are taken only of moments of inertia, so that motions near a
//! steady rotation or a separatrix keep their accuracy.

mod jacobi_motion;

use nalgebra::{Rotation3, Vector3};

use super::error::BodyError;
use super::euler_equations::{check_moments, gyroscopic};
use super::inertia_tensor::InertiaTensor;
use super::order::length;
use super::rotation_state::RotationState;
use crate::integrate::SingleNumber;
use crate::rotation::{components, normalized, product, quaternion_of};
use crate::scalar::Scalar;

use jacobi_motion::JacobiMotion;

/// The rotation of a body without a moment, about its centre of gravity or a fixed point, in closed form.
///
/// Euler's equations (3.5)–(3.7) with **N** = 0 and the equations of the orientation are solved by Jacobi's elliptic
/// functions. The state at any time takes one evaluation, with an error of a few rounding errors of the number of
/// turns.
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian::rigid_body::{EulerEquations, FreeRotation, InertiaTensor, RotationState};
///
/// let racket = InertiaTensor::principal([1.0, 2.0, 2.8]);
/// let start = RotationState::aligned(Vector3::new(0.1, 5.0, 0.0));
/// let motion = FreeRotation::new(&racket, &start)?;
///
/// let end = Problem::new(EulerEquations::new(racket)?, At::from((0.0, start))).solve(10.0, Taylor::new())?;
/// assert!((motion.at(10.0).angular_velocity - end.angular_velocity).norm() < 1e-11);
/// assert!(motion.at(10.0).orientation().angle_to(&end.orientation()) < 1e-7);
/// // The racket turns over after each half period.
/// let flip = motion.half_period().unwrap_or(f64::NAN);
/// assert!((motion.at(flip).angular_velocity.y + 5.0).abs() < 1e-11);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeRotation<S: Scalar = f64> {
    /// The orientation of the body at time 0.
    start: [S; 4],
    kind: Kind<S>,
}

/// The kinds of free rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind<S: Scalar> {
    /// A rotation with this constant angular velocity.
    Steady(Vector3<S>),
    /// A rotation by elliptic functions, in principal axes. The rotation `axes` takes components in these axes to
    /// components in axes of the body.
    Jacobi {
        motion: JacobiMotion<S>,
        axes: Rotation3<S>,
    },
}

impl<S: SingleNumber> FreeRotation<S> {
    /// Creates the motion of a body with an inertia tensor, starting from a state at time 0.
    ///
    /// # Errors
    /// [`BodyError::NoInertia`] unless all principal moments are positive, [`BodyError::NotFinite`] if the state is
    /// not finite, and [`BodyError::NotDifferentiable`] if derivative parts of dual numbers perturb a steady rotation.
    pub fn new(inertia: &InertiaTensor<S>, start: &RotationState<S>) -> Result<Self, BodyError> {
        let principal = inertia.principal_axes();
        check_moments(principal.moments)?;
        let omega = start.angular_velocity;
        let orientation = start.orientation();
        let state = components(&orientation)
            .into_iter()
            .chain(omega.iter().copied());
        if let Some(value) = state.map(Scalar::largest).find(|x| !x.is_finite()) {
            let quantity = "a component of the state of rotation";
            return Err(BodyError::NotFinite { quantity, value });
        }
        let axes = principal.axes;
        let along = axes.matrix().tr_mul(&omega);
        let of_principal = InertiaTensor::principal(principal.moments);
        let gyroscopic = gyroscopic(&of_principal, &along);
        let is_steady = length(&gyroscopic).largest() <= 0.0;
        let parts = gyroscopic.iter().map(|x| largest_derivative(*x));
        if let Some(value) = parts.into_iter().find(|part| is_steady && *part > 0.0) {
            return Err(BodyError::NotDifferentiable { value });
        }
        let kind = if is_steady {
            Kind::Steady(omega)
        } else {
            let (motion, axes) = JacobiMotion::new(principal.moments, &along, &axes);
            Kind::Jacobi { motion, axes }
        };
        Ok(Self {
            start: components(&orientation),
            kind,
        })
    }

    /// Returns the state at a time after the start, or before it if the time is negative.
    #[must_use]
    pub fn at(&self, time: S) -> RotationState<S> {
        match &self.kind {
            Kind::Steady(omega) => {
                let turned = product(&self.start, &turn(omega, time));
                RotationState::new(&normalized(turned), *omega)
            }
            Kind::Jacobi { motion, axes } => {
                // From axes of the body to axes of space at the start, by way of principal axes.
                let axis = components(&quaternion_of(axes));
                let since = product(&product(&axis, &motion.turned(time)), &conjugate(&axis));
                let orientation = normalized(product(&self.start, &since));
                RotationState::new(&orientation, axes.matrix() * motion.angular_velocity(time))
            }
        }
    }

    /// Returns the period of the components of the angular velocity in axes of the body; the orientation is usually not
    /// periodic.
    ///
    /// Returns `None` for a steady rotation, and for the motion that approaches the middle axis forever.
    #[must_use]
    pub fn period(&self) -> Option<S> {
        self.half_period().map(|half| half + half)
    }

    /// Returns half of the period, after which two components along principal axes have changed their signs, including
    /// the component along the middle axis. A tennis racket that rotates about this axis turns over once in this time.
    #[must_use]
    pub fn half_period(&self) -> Option<S> {
        match &self.kind {
            Kind::Steady(_) => None,
            Kind::Jacobi { motion, .. } => motion.half_period(),
        }
    }
}

/// Returns the largest magnitude of the derivative parts.
fn largest_derivative<S: Scalar>(x: S) -> f64 {
    let parts = (0..S::DERIVATIVES).map(|index| x.derivative_part(index).abs());
    parts.fold(0.0, f64::max)
}

fn conjugate<S: Scalar>([w, x, y, z]: &[S; 4]) -> [S; 4] {
    [*w, -*x, -*y, -*z]
}

/// Returns the quaternion of a rotation with a constant angular velocity.
fn turn<S: SingleNumber>(omega: &Vector3<S>, time: S) -> [S; 4] {
    let speed = length(omega);
    if speed.largest() <= 0.0 {
        // To first order, for derivative parts.
        let half = time * S::from_f64(0.5);
        let [x, y, z]: [S; 3] = (omega * half).into();
        return [S::one(), x, y, z];
    }
    let (sine, cosine) = (speed * time * S::from_f64(0.5)).sin_cos();
    let [x, y, z]: [S; 3] = (omega * (sine / speed)).into();
    [cosine, x, y, z]
}
