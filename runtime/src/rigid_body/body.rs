//! A rigid body: its mass, its centre of gravity and its inertia.

use nalgebra::{Rotation3, Vector3};

use super::error::BodyError;
use super::inertia_tensor::InertiaTensor;
use super::principal_axes::PrincipalAxes;
use super::validity::{finite, physical, positive};
use crate::integrate::SingleNumber;
use crate::limits::rigid_bodies::UNPHYSICAL_ROUNDING;
use crate::scalar::Scalar;

/// The ten numbers of a rigid body: mass, centre of gravity (1.1), and inertia tensor (2.1).
///
/// They are in axes fixed to the body, whose origin is any of its points. Bodies are made of [solids](super::Solid),
/// [particles](Self::particle), reports of other programs, or [numbers](Self::new); moved, turned, composed and
/// subtracted.
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
    /// About the centre of gravity.
    inertia: InertiaTensor<S>,
}

impl<S: SingleNumber> RigidBody<S> {
    /// The body of a mass, a centre of gravity in the axes of the body, and an inertia tensor about the **centre of
    /// gravity**.
    ///
    /// # Errors
    /// [`BodyError`] unless the mass is positive, all numbers are finite, no principal moment is negative, and none
    /// exceeds the sum of the others, up to rounding.
    pub fn new(mass: S, center: Vector3<S>, inertia: InertiaTensor<S>) -> Result<Self, BodyError> {
        Self::within(mass, center, inertia, allowance::<S>(&inertia))
    }

    /// The same with an inertia tensor about the **origin** of the body's axes.
    ///
    /// # Errors
    /// As those of [`new`](Self::new). The parallel axis theorem (2.2) subtracts, and what rounding leaves of a body far
    /// from its origin is allowed.
    pub fn with_inertia_about_origin(
        mass: S,
        center: Vector3<S>,
        inertia: InertiaTensor<S>,
    ) -> Result<Self, BodyError> {
        let about_center = inertia - InertiaTensor::of_particle(mass, &center);
        Self::within(mass, center, about_center, allowance::<S>(&inertia))
    }

    /// The same with principal moments that may be negative by `allowed`, or so much larger than the sum of the others.
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

    /// A particle at a point: no inertia about itself.
    ///
    /// # Errors
    /// [`BodyError`] if the mass is not positive or a number is not finite.
    pub fn particle(mass: S, position: Vector3<S>) -> Result<Self, BodyError> {
        Self::new(mass, position, InertiaTensor::principal([S::zero(); 3]))
    }

    /// The body that bodies make together, such as one of particles: its mass is their sum, its centre of gravity (1.1),
    /// its inertia by the parallel axis theorem (2.2).
    ///
    /// # Errors
    /// [`BodyError::NoParts`] if there are none.
    pub fn composed(parts: impl IntoIterator<Item = Self>) -> Result<Self, BodyError> {
        let mut parts = parts.into_iter();
        let first = parts.next().ok_or(BodyError::NoParts)?;
        Ok(parts.fold(first, |whole, part| whole.plus(&part)))
    }

    /// This body together with another one.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        self.combined(other, S::one())
    }

    /// This body without another one, such as a hole of the same density, that is a part of it.
    ///
    /// # Errors
    /// [`BodyError`] if nothing is left, or something that no body is: then the other one is not a part of it.
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

    /// The principal moments and axes of the inertia about the centre of gravity (2.5).
    #[must_use]
    pub fn principal_axes(&self) -> PrincipalAxes<S> {
        self.inertia.principal_axes()
    }
}

/// What rounding leaves of a tensor of which a part was subtracted.
fn allowance<S: Scalar>(inertia: &InertiaTensor<S>) -> f64 {
    let moments = inertia.moments().map(|moment| moment.abs().largest());
    UNPHYSICAL_ROUNDING * S::machine_epsilon() * moments.into_iter().fold(0.0, f64::max)
}

impl<S: Scalar> RigidBody<S> {
    /// The body of numbers that are known to be those of a body.
    pub(super) fn of_valid(mass: S, center: Vector3<S>, inertia: InertiaTensor<S>) -> Self {
        Self {
            mass,
            center,
            inertia,
        }
    }

    /// The mass m.
    #[must_use]
    pub fn mass(&self) -> S {
        self.mass
    }

    /// The centre of gravity `r_C` (1.1), in the axes of the body from their origin. (It is the centre of mass; the
    /// two differ only where gravity does over the size of the body.)
    #[must_use]
    pub fn center(&self) -> Vector3<S> {
        self.center
    }

    /// The inertia tensor `[I_C]` about the centre of gravity (2.1), in the axes of the body.
    #[must_use]
    pub fn inertia(&self) -> InertiaTensor<S> {
        self.inertia
    }

    /// The inertia tensor `[I_O]` about a point O, in the axes of the body: `[I_C]` + m (|**d**|² 1 − **d** **d**ᵀ), the
    /// parallel axis theorem (2.2) for all entries at once, where **d** leads from the point to the centre of gravity.
    #[must_use]
    pub fn inertia_about(&self, point: &Vector3<S>) -> InertiaTensor<S> {
        self.inertia + InertiaTensor::of_particle(self.mass, &(self.center - point))
    }

    /// The moment of inertia about the line through a point with a direction, of any length (2.3), (2.4).
    ///
    /// # Errors
    /// [`BodyError::NoDirection`] if the vector along the line is zero.
    pub fn inertia_about_line(
        &self,
        point: &Vector3<S>,
        direction: &Vector3<S>,
    ) -> Result<S, BodyError> {
        self.inertia_about(point).about_line(direction)
    }

    /// The body after a displacement, in the same axes.
    #[must_use]
    pub fn moved(&self, displacement: Vector3<S>) -> Self {
        Self {
            center: self.center + displacement,
            ..*self
        }
    }

    /// The body after a rotation about the origin of the axes. The same body in axes of which the rotation gives the old
    /// components from the new ones is that turned by its inverse.
    #[must_use]
    pub fn turned(&self, rotation: &Rotation3<S>) -> Self {
        Self {
            mass: self.mass,
            center: rotation.matrix() * self.center,
            inertia: self.inertia.rotated(rotation),
        }
    }

    /// The same numbers on another scalar, such as dual numbers, of which one is then given a derivative part.
    #[must_use]
    pub fn map<T: Scalar>(&self, mut convert: impl FnMut(S) -> T) -> RigidBody<T> {
        RigidBody {
            mass: convert(self.mass),
            center: self.center.map(&mut convert),
            inertia: self.inertia.map(convert),
        }
    }

    /// This body with `sign` times another one: of the masses m and m′ whose centres are **d** apart, the inertia
    /// about their common centre has the term m m′/(m + m′) (|**d**|² 1 − **d** **d**ᵀ).
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
