//! Momenta (3.1), (3.2), kinetic energies (4.1)–(4.3), and their changes under forces and moments (1.2), (3.3), (3.4).
//!
//! Vectors are components in the axes of the body, in which its centre of gravity and inertia are given. To work in
//! axes of space, use the body [turned](RigidBody::turned) by its orientation.

use nalgebra::Vector3;

use super::body::RigidBody;
use super::error::BodyError;
use super::motion::RigidMotion;
use super::resultant::Resultant;
use crate::integrate::SingleNumber;
use crate::limits::rigid_bodies::NO_INERTIA;
use crate::linalg::Factorization;
use crate::scalar::Scalar;

/// Returns the derivative of a vector in an inertial frame, given the derivatives of its components in rotating axes:
/// d**L**/dt = (L̇₁, L̇₂, L̇₃) + **ω** × **L** (3.4).
///
/// ```
/// use lagrangian::rigid_body::rate_in_space;
/// use lagrangian::nalgebra::Vector3;
///
/// // A vector that is fixed to a body moves with it.
/// let [spin, arm] = [Vector3::new(0.0, 0.0, 2.0), Vector3::new(0.5, 0.0, 0.0)];
/// assert_eq!(rate_in_space(&Vector3::zeros(), &spin, &arm), Vector3::new(0.0, 1.0, 0.0));
/// ```
#[must_use]
pub fn rate_in_space<S: Scalar>(
    rate_of_components: &Vector3<S>,
    angular_velocity: &Vector3<S>,
    vector: &Vector3<S>,
) -> Vector3<S> {
    rate_of_components + angular_velocity.cross(vector)
}

impl<S: Scalar> RigidBody<S> {
    /// Returns the linear momentum m `v_C`, given the velocity of the centre of gravity.
    #[must_use]
    pub fn linear_momentum(&self, velocity_of_center: &Vector3<S>) -> Vector3<S> {
        velocity_of_center * self.mass()
    }

    /// Returns the angular momentum about any point O of the body (3.1), given the velocity of this point: `r_C` × m
    /// `v_O` + \[`I_O`\] **ω**, with `r_C` from O.
    ///
    /// It is computed with the absolute velocities of the particles. About a moving point, its derivative is the
    /// resultant moment only if `v_O` is parallel to `v_C`.
    #[must_use]
    pub fn angular_momentum(
        &self,
        point: &Vector3<S>,
        velocity_of_point: &Vector3<S>,
        angular_velocity: &Vector3<S>,
    ) -> Vector3<S> {
        let lever = self.center() - point;
        let carried = lever.cross(&(velocity_of_point * self.mass()));
        carried + self.inertia_about(point) * *angular_velocity
    }

    /// Returns the angular momentum \[`I_C`\] **ω** about the centre of gravity (3.2).
    #[must_use]
    pub fn angular_momentum_about_center(&self, angular_velocity: &Vector3<S>) -> Vector3<S> {
        self.inertia() * *angular_velocity
    }

    /// Returns the angular momentum \[`I_O`\] **ω** about a point of the body that is fixed in space (3.2).
    #[must_use]
    pub fn angular_momentum_about_fixed_point(
        &self,
        point: &Vector3<S>,
        angular_velocity: &Vector3<S>,
    ) -> Vector3<S> {
        self.inertia_about(point) * *angular_velocity
    }

    /// Returns the kinetic energy, given the velocity of any point O of the body (4.1): ½ m `v_O`² + `v_O` · (**ω** × m
    /// `r_C`) + ½ **ω**ᵀ\[`I_O`\]**ω**.
    #[must_use]
    pub fn kinetic_energy(
        &self,
        point: &Vector3<S>,
        velocity_of_point: &Vector3<S>,
        angular_velocity: &Vector3<S>,
    ) -> S {
        let lever = self.center() - point;
        let half_mass = S::from_f64(0.5) * self.mass();
        let of_point = half_mass * velocity_of_point.dot(velocity_of_point);
        let mixed = self.mass() * velocity_of_point.dot(&angular_velocity.cross(&lever));
        of_point + mixed + self.kinetic_energy_about_fixed_point(point, angular_velocity)
    }

    /// Returns the kinetic energy ½ **ω**ᵀ\[`I_O`\]**ω** of a body with a point that is fixed in space (4.2).
    #[must_use]
    pub fn kinetic_energy_about_fixed_point(
        &self,
        point: &Vector3<S>,
        angular_velocity: &Vector3<S>,
    ) -> S {
        let momentum = self.angular_momentum_about_fixed_point(point, angular_velocity);
        S::from_f64(0.5) * angular_velocity.dot(&momentum)
    }

    /// Returns the kinetic energy ½ m `v_C`² + ½ **ω**ᵀ\[`I_C`\]**ω**, given the velocity of the centre of gravity
    /// (4.3).
    #[must_use]
    pub fn kinetic_energy_of_center(
        &self,
        velocity_of_center: &Vector3<S>,
        angular_velocity: &Vector3<S>,
    ) -> S {
        let half = S::from_f64(0.5);
        let momentum = self.angular_momentum_about_center(angular_velocity);
        half * self.mass() * velocity_of_center.dot(velocity_of_center)
            + half * angular_velocity.dot(&momentum)
    }

    /// Returns the acceleration `F_R`/m of the centre of gravity under a resultant force (1.2).
    #[must_use]
    pub fn acceleration_of_center(&self, resultant_force: &Vector3<S>) -> Vector3<S> {
        resultant_force.map(|component| component / self.mass())
    }

    /// Returns the resultant moment about the centre of gravity for a given rotation, (3.3) with (3.4): \[`I_C`\]
    /// **α** + **ω** × \[`I_C`\] **ω**. In principal axes these are Euler's equations (3.5)–(3.7).
    #[must_use]
    pub fn moment_about_center(
        &self,
        angular_velocity: &Vector3<S>,
        angular_acceleration: &Vector3<S>,
    ) -> Vector3<S> {
        let momentum = self.angular_momentum_about_center(angular_velocity);
        let rate_of_components = self.inertia() * *angular_acceleration;
        rate_in_space(&rate_of_components, angular_velocity, &momentum)
    }

    /// Returns the resultant moment about a point of the body that is fixed in space, for a given rotation.
    #[must_use]
    pub fn moment_about_fixed_point(
        &self,
        point: &Vector3<S>,
        angular_velocity: &Vector3<S>,
        angular_acceleration: &Vector3<S>,
    ) -> Vector3<S> {
        let inertia = self.inertia_about(point);
        let momentum = inertia * *angular_velocity;
        let rate_of_components = inertia * *angular_acceleration;
        rate_in_space(&rate_of_components, angular_velocity, &momentum)
    }

    /// Returns the resultant force (1.2) and moment (3.3) about the centre of gravity for a given motion of the body.
    ///
    /// The motion is given for the origin of the body's axes, and the point of the result is relative to this origin.
    /// [`Resultant::about`] gives the moment about any other point.
    #[must_use]
    pub fn resultant(&self, motion_of_origin: &RigidMotion<S>) -> Resultant<S> {
        let center = self.center();
        let RigidMotion {
            angular_velocity,
            angular_acceleration,
            ..
        } = motion_of_origin;
        Resultant {
            point: center,
            force: motion_of_origin.acceleration_of(&center) * self.mass(),
            moment: self.moment_about_center(angular_velocity, angular_acceleration),
        }
    }
}

impl<S: SingleNumber> RigidBody<S> {
    /// Returns the angular acceleration under a resultant moment about the centre of gravity: (3.3) and (3.4) solved
    /// for **α**.
    ///
    /// # Errors
    /// [`BodyError::NoInertia`] if a principal moment about the centre of gravity is zero, as for a thin rod.
    pub fn angular_acceleration(
        &self,
        angular_velocity: &Vector3<S>,
        moment_about_center: &Vector3<S>,
    ) -> Result<Vector3<S>, BodyError> {
        let principal = self.principal_axes().moments;
        let moments = principal.map(Scalar::largest);
        if moments[0] <= NO_INERTIA * S::machine_epsilon() * moments[2] {
            return Err(BodyError::NoInertia { moments });
        }
        let momentum = self.angular_momentum_about_center(angular_velocity);
        let gyroscopic = angular_velocity.cross(&momentum);
        let inertia = Factorization::new(self.inertia().matrix());
        Ok(inertia.solve(&(moment_about_center - gyroscopic)))
    }
}
