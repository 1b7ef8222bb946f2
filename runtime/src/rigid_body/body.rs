//! A rigid body: its mass, its centre of gravity and its inertia.

use nalgebra::{Rotation3, Vector3};

use super::error::BodyError;
use super::inertia_tensor::InertiaTensor;
use super::principal_axes::PrincipalAxes;
use super::validity::{finite, physical, positive};
use crate::integrate::SingleNumber;
use crate::limits::rigid_bodies::UNPHYSICAL_ROUNDING;
use crate::linalg::largest;
use crate::scalar::Scalar;

/// The ten numbers of a rigid body: mass, centre of gravity (1.1), and inertia tensor (2.1).
///
/// They refer to axes fixed to the body, whose origin is any of its points. Bodies are constructed from
/// [solids](super::Solid), [particles](Self::particle), reports of other programs, or [numbers](Self::new); they can be
/// moved, turned, composed and subtracted.
///
/// ```
/// use lagrangian::rigid_body::{RigidBody, Solid};
/// use lagrangian::nalgebra::{Rotation3, Vector3};
///
/// // A hammer: a handle along z, and a head across it.
/// let handle = Solid::cylinder(0.015, 0.3)?.with_density(700.0)?;
/// let turned = Rotation3::from_axis_angle(&Vector3::y_axis(), core::f64::consts::FRAC_PI_2);
/// let head = Solid::cylinder(0.02, 0.1)?.with_density(7850.0)?.turned(&turned);
/// let hammer = RigidBody::composed([handle, head.moved(Vector3::new(0.0, 0.0, 0.16))])?;
///
/// // About the end of the handle, by the parallel axis theorem (2.2).
/// let end = Vector3::new(0.0, 0.0, -0.15);
/// let arm = hammer.center().z + 0.15;
/// let expected = hammer.inertia().moments()[1] + hammer.mass() * arm * arm;
/// assert!((hammer.inertia_about(&end).moments()[1] - expected).abs() < 1e-15);
/// # Ok::<(), lagrangian::rigid_body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidBody<S: Scalar = f64> {
    mass: S,
    center: Vector3<S>,
    /// The inertia tensor about the centre of gravity.
    inertia: InertiaTensor<S>,
}

impl<S: SingleNumber> RigidBody<S> {
    /// Creates a body with a mass, a centre of gravity in the axes of the body, and an inertia tensor about the
    /// **centre of gravity**.
    ///
    /// # Errors
    /// [`BodyError`] unless the mass is positive, all numbers are finite, no principal moment is negative, and none
    /// exceeds the sum of the others, up to rounding.
    pub fn new(mass: S, center: Vector3<S>, inertia: InertiaTensor<S>) -> Result<Self, BodyError> {
        Self::within(mass, center, inertia, allowance::<S>(&inertia))
    }

    /// Creates a body with an inertia tensor about the **origin** of the body's axes.
    ///
    /// # Errors
    /// The errors of [`new`](Self::new). The parallel axis theorem (2.2) subtracts, and the rounding errors of a body
    /// far from its origin are allowed.
    pub fn with_inertia_about_origin(
        mass: S,
        center: Vector3<S>,
        inertia: InertiaTensor<S>,
    ) -> Result<Self, BodyError> {
        let about_center = inertia - InertiaTensor::of_particle(mass, &center);
        Self::within(mass, center, about_center, allowance::<S>(&inertia))
    }

    /// Creates a body whose principal moments may be negative by `allowed`, or exceed the sum of the others by it.
    pub(super) fn within(
        mass: S,
        center: Vector3<S>,
        inertia: InertiaTensor<S>,
        allowed: f64,
    ) -> Result<Self, BodyError> {
        positive("the mass", mass)?;
        for coordinate in center.iter() {
            finite("a coordinate of the centre of gravity", *coordinate)?;
        }
        physical(&inertia, allowed)?;
        Ok(Self {
            mass,
            center,
            inertia,
        })
    }

    /// Creates a particle at a point, without inertia about itself.
    ///
    /// # Errors
    /// [`BodyError`] if the mass is not positive or a number is not finite.
    pub fn particle(mass: S, position: Vector3<S>) -> Result<Self, BodyError> {
        Self::new(mass, position, InertiaTensor::principal([S::zero(); 3]))
    }

    /// Composes a body from others, such as particles: its mass is the sum, its centre of gravity follows from (1.1),
    /// and its inertia from the parallel axis theorem (2.2).
    ///
    /// # Errors
    /// [`BodyError::NoParts`], if there are no parts.
    pub fn composed(parts: impl IntoIterator<Item = Self>) -> Result<Self, BodyError> {
        let mut parts = parts.into_iter();
        let first = parts.next().ok_or(BodyError::NoParts)?;
        Ok(parts.fold(first, |whole, part| whole.plus(&part)))
    }

    /// Returns this body together with another one.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        self.combined(other, S::one())
    }

    /// Returns this body without another body that is a part of it, such as a hole of equal density.
    ///
    /// # Errors
    /// [`BodyError`], if nothing is left, or if the result is not a physical body: then the other body is not a part of
    /// this one.
    pub fn minus(&self, other: &Self) -> Result<Self, BodyError> {
        positive("the mass of the difference", self.mass - other.mass)?;
        let Self {
            mass,
            center,
            inertia,
        } = self.combined(other, -S::one());
        let allowed = allowance::<S>(&self.inertia) + allowance::<S>(&other.inertia);
        Self::within(mass, center, inertia, allowed)
    }

    /// Returns the principal moments and axes of the inertia about the centre of gravity (2.5).
    #[must_use]
    pub fn principal_axes(&self) -> PrincipalAxes<S> {
        self.inertia.principal_axes()
    }
}

/// Returns a bound on the rounding errors of a tensor from which a part was subtracted.
fn allowance<S: Scalar>(inertia: &InertiaTensor<S>) -> f64 {
    UNPHYSICAL_ROUNDING * S::machine_epsilon() * largest(&inertia.moments())
}

impl<S: Scalar> RigidBody<S> {
    /// Creates a body from numbers that are known to be valid.
    pub(super) fn of_valid(mass: S, center: Vector3<S>, inertia: InertiaTensor<S>) -> Self {
        Self {
            mass,
            center,
            inertia,
        }
    }

    /// Returns the mass m.
    #[must_use]
    pub fn mass(&self) -> S {
        self.mass
    }

    /// Returns the centre of gravity `r_C` (1.1), in the axes of the body, from their origin. (It is the centre of
    /// mass; the two differ only if gravity varies over the size of the body.)
    #[must_use]
    pub fn center(&self) -> Vector3<S> {
        self.center
    }

    /// Returns the inertia tensor `[I_C]` about the centre of gravity (2.1), in the axes of the body.
    #[must_use]
    pub fn inertia(&self) -> InertiaTensor<S> {
        self.inertia
    }

    /// Returns the inertia tensor `[I_O]` about a point O, in the axes of the body.
    ///
    /// It is `[I_C]` + m (|**d**|² 1 − **d** **d**ᵀ), the parallel axis theorem (2.2) for all entries at once, where
    /// **d** leads from the point to the centre of gravity.
    #[must_use]
    pub fn inertia_about(&self, point: &Vector3<S>) -> InertiaTensor<S> {
        self.inertia + InertiaTensor::of_particle(self.mass, &(self.center - point))
    }

    /// Returns the moment of inertia about the line through a point along a direction vector of any length (2.3),
    /// (2.4).
    ///
    /// # Errors
    /// [`BodyError::NoDirection`], if the vector along the line is zero.
    pub fn inertia_about_line(
        &self,
        point: &Vector3<S>,
        direction: &Vector3<S>,
    ) -> Result<S, BodyError> {
        self.inertia_about(point).about_line(direction)
    }

    /// Returns the body after a displacement, in unchanged axes.
    #[must_use]
    pub fn moved(&self, displacement: Vector3<S>) -> Self {
        Self {
            center: self.center + displacement,
            ..*self
        }
    }

    /// Returns the body after a rotation about the origin of the axes. To express a body in new axes, turn it by the
    /// inverse of the rotation that takes the new components to the old ones.
    #[must_use]
    pub fn turned(&self, rotation: &Rotation3<S>) -> Self {
        Self {
            mass: self.mass,
            center: rotation.matrix() * self.center,
            inertia: self.inertia.rotated(rotation),
        }
    }

    /// Converts the numbers to another scalar, such as dual numbers, one of which may then be given a derivative part.
    #[must_use]
    pub fn map<T: Scalar>(&self, mut convert: impl FnMut(S) -> T) -> RigidBody<T> {
        RigidBody {
            mass: convert(self.mass),
            center: self.center.map(&mut convert),
            inertia: self.inertia.map(convert),
        }
    }

    /// Returns this body plus `sign` times another one. For masses m and m′ whose centres are **d** apart, the inertia
    /// about the common centre has the term m m′/(m + m′) (|**d**|² 1 − **d** **d**ᵀ).
    fn combined(&self, other: &Self, sign: S) -> Self {
        let other_mass = sign * other.mass;
        let mass = self.mass + other_mass;
        let d = other.center - self.center;
        let reduced_mass = self.mass * other_mass / mass;
        Self {
            mass,
            center: self.center + d * (other_mass / mass),
            inertia: self.inertia
                + other.inertia.scaled(sign)
                + InertiaTensor::of_particle(reduced_mass, &d),
        }
    }
}
