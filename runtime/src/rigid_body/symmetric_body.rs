//! A rigid body that is symmetric about an axis.

use nalgebra::Vector3;

use super::body::RigidBody;
use super::error::BodyError;
use super::inertia_tensor::{InertiaTensor, ProductsOfInertia};
use crate::integrate::SingleNumber;
use crate::limits::rigid_bodies::ASYMMETRY;
use crate::linalg::largest;
use crate::scalar::Scalar;

/// A rigid body with an axis of symmetry, the third of its axes, as in (4.7): four numbers.
///
/// They are the mass m, the height l of the centre of gravity along the axis, and the moments of inertia about the
/// centre of gravity: I about every axis across, and Iₛ about the axis of symmetry. As a parameter of a declaration it
/// avoids terms that are zero.
///
/// ```
/// use lagrangian::nalgebra::{Rotation3, Vector3};
/// use lagrangian::rigid_body::{Solid, SymmetricBody};
///
/// // A top that stands on the apex of its cone.
/// let cone = Solid::cone(0.03, 0.06)?.with_density(700.0)?;
/// let upside_down = Rotation3::from_axis_angle(&Vector3::x_axis(), core::f64::consts::PI);
/// let top = SymmetricBody::of(&cone.turned(&upside_down).moved(Vector3::new(0.0, 0.0, 0.06)))?;
/// assert!((top.height() - 0.045).abs() < 1e-15);
/// // About the tip, by the parallel axis theorem (2.2): 3/20 m r² + 3/5 m h².
/// let expected = top.mass() * (0.15 * 0.03 * 0.03 + 0.6 * 0.06 * 0.06);
/// assert!((top.transverse_moment_about_origin() - expected).abs() < 1e-16);
/// # Ok::<(), lagrangian::rigid_body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SymmetricBody<S: Scalar = f64> {
    mass: S,
    height: S,
    transverse: S,
    axial: S,
}

impl<S: SingleNumber> SymmetricBody<S> {
    /// Creates a body with a mass m, a height l of the centre of gravity along the axis, which may be negative, and
    /// moments of inertia about the **centre of gravity**: I across the axis, and Iₛ about it.
    ///
    /// # Errors
    /// [`BodyError`] unless the mass is positive, all numbers are finite, no moment is negative, and Iₛ does not exceed
    /// 2 I, up to rounding.
    pub fn new(mass: S, height: S, transverse: S, axial: S) -> Result<Self, BodyError> {
        let body = Self {
            mass,
            height,
            transverse,
            axial,
        };
        RigidBody::new(mass, body.center(), body.inertia())?;
        Ok(body)
    }

    /// Converts a body whose third axis is an axis of symmetry.
    ///
    /// # Errors
    /// [`BodyError::NotSymmetricAboutAxis`] if it is not: a product of inertia, the difference of the moments across,
    /// or the distance of the centre of gravity from the axis is not zero, up to rounding.
    pub fn of(body: &RigidBody<S>) -> Result<Self, BodyError> {
        let center = body.center();
        let [x, y, axial] = body.inertia().moments();
        let ProductsOfInertia { xy, xz, yz } = body.inertia().products();
        let origin = Vector3::repeat(S::zero());
        let moment = largest(&body.inertia_about(&origin).moments());
        let rounding = ASYMMETRY * S::machine_epsilon();
        let length = (moment / body.mass().largest()).sqrt();
        for (quantity, value, size) in [
            ("the product of inertia xy", xy, moment),
            ("the product of inertia xz", xz, moment),
            ("the product of inertia yz", yz, moment),
            (
                "the difference of the moments of inertia across",
                x - y,
                moment,
            ),
            (
                "the x coordinate of the centre of gravity",
                center.x,
                length,
            ),
            (
                "the y coordinate of the centre of gravity",
                center.y,
                length,
            ),
        ] {
            if value.abs().largest() > rounding * size {
                let value = value.largest();
                return Err(BodyError::NotSymmetricAboutAxis { quantity, value });
            }
        }
        Ok(Self {
            mass: body.mass(),
            height: center.z,
            transverse: (x + y) * S::from_f64(0.5),
            axial,
        })
    }
}

impl<S: Scalar> SymmetricBody<S> {
    /// Returns the mass m.
    #[must_use]
    pub fn mass(&self) -> S {
        self.mass
    }

    /// Returns the height l of the centre of gravity: its coordinate along the axis, from the origin of the axes of the
    /// body.
    #[must_use]
    pub fn height(&self) -> S {
        self.height
    }

    /// Returns the moment of inertia I across the axis, about the centre of gravity.
    #[must_use]
    pub fn transverse_moment(&self) -> S {
        self.transverse
    }

    /// Returns the moment of inertia I + m l² (2.2) across the axis, about the origin of the axes of the body, such as
    /// the fixed point of a top.
    #[must_use]
    pub fn transverse_moment_about_origin(&self) -> S {
        self.transverse + self.mass * self.height * self.height
    }

    /// Returns the moment of inertia Iₛ about the axis of symmetry.
    #[must_use]
    pub fn axial_moment(&self) -> S {
        self.axial
    }

    /// Returns the centre of gravity (0, 0, l) in the axes of the body.
    #[must_use]
    pub fn center(&self) -> Vector3<S> {
        Vector3::new(S::zero(), S::zero(), self.height)
    }

    /// Returns the inertia tensor about the centre of gravity, in the axes of the body: diag(I, I, Iₛ).
    #[must_use]
    pub fn inertia(&self) -> InertiaTensor<S> {
        InertiaTensor::principal([self.transverse, self.transverse, self.axial])
    }

    /// Converts the numbers to another scalar, such as dual numbers, one of which may then be given a derivative part.
    #[must_use]
    pub fn map<T: Scalar>(&self, mut convert: impl FnMut(S) -> T) -> SymmetricBody<T> {
        SymmetricBody {
            mass: convert(self.mass),
            height: convert(self.height),
            transverse: convert(self.transverse),
            axial: convert(self.axial),
        }
    }
}

impl<S: Scalar> From<SymmetricBody<S>> for RigidBody<S> {
    fn from(body: SymmetricBody<S>) -> Self {
        Self::of_valid(body.mass(), body.center(), body.inertia())
    }
}
