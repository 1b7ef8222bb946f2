//! A rigid body in its principal axes.

use nalgebra::Vector3;

use super::body::RigidBody;
use super::error::BodyError;
use super::inertia_tensor::InertiaTensor;
use crate::integrate::SingleNumber;
use crate::scalar::Scalar;

/// A rigid body in the principal axes through its centre of gravity (2.5): four numbers, the mass and the principal
/// moments I₁, I₂, I₃.
///
/// The origin of its axes is the centre of gravity, and there are no products of inertia. As a parameter of a
/// declaration it avoids terms that are zero.
///
/// ```
/// use lagrangian::nalgebra::Vector3;
/// use lagrangian::rigid_body::{PrincipalBody, RigidBody, Solid};
///
/// let book = Solid::cuboid(0.2_f64, 0.3, 0.04)?.with_density(400.0)?;
/// let moved = book.moved(Vector3::new(0.0, 1.0, 0.0));
/// // In the order of its principal axes, the least moment first.
/// let body = PrincipalBody::of(&moved);
/// let [x, y, z] = book.inertia().moments();
/// for (moment, expected) in body.moments().into_iter().zip([y, x, z]) {
///     assert!((moment - expected).abs() < 1e-15);
/// }
/// let back = RigidBody::from(body).turned(&moved.principal_axes().axes).moved(moved.center());
/// assert!((back.inertia().matrix() - moved.inertia().matrix()).norm() < 1e-15);
/// # Ok::<(), lagrangian::rigid_body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrincipalBody<S: Scalar = f64> {
    mass: S,
    moments: [S; 3],
}

impl<S: SingleNumber> PrincipalBody<S> {
    /// Creates a body with a mass and principal moments I₁, I₂, I₃ about the centre of gravity, in any order.
    ///
    /// # Errors
    /// [`BodyError`] unless the mass is positive, all numbers are finite, no moment is negative, and none exceeds the
    /// sum of the others, up to rounding.
    pub fn new(mass: S, moments: [S; 3]) -> Result<Self, BodyError> {
        let inertia = InertiaTensor::principal(moments);
        RigidBody::new(mass, Vector3::zeros(), inertia)?;
        Ok(Self { mass, moments })
    }

    /// Returns a body in its principal axes, I₁ ≤ I₂ ≤ I₃. These axes have their origin at the
    /// [`center`](RigidBody::center) of the body and the directions of its
    /// [`principal_axes`](RigidBody::principal_axes).
    #[must_use]
    pub fn of(body: &RigidBody<S>) -> Self {
        Self {
            mass: body.mass(),
            moments: body.principal_axes().moments,
        }
    }
}

impl<S: Scalar> PrincipalBody<S> {
    /// Returns the mass m.
    #[must_use]
    pub fn mass(&self) -> S {
        self.mass
    }

    /// Returns the principal moments I₁, I₂, I₃ about the centre of gravity.
    #[must_use]
    pub fn moments(&self) -> [S; 3] {
        self.moments
    }

    /// Returns the centre of gravity in the axes of the body: their origin.
    #[must_use]
    pub fn center(&self) -> Vector3<S> {
        Vector3::repeat(S::zero())
    }

    /// Returns the inertia tensor about the centre of gravity in the axes of the body, which is diagonal.
    #[must_use]
    pub fn inertia(&self) -> InertiaTensor<S> {
        InertiaTensor::principal(self.moments)
    }

    /// Converts the numbers to another scalar, such as dual numbers, one of which may then be given a derivative part.
    #[must_use]
    pub fn map<T: Scalar>(&self, mut convert: impl FnMut(S) -> T) -> PrincipalBody<T> {
        PrincipalBody {
            mass: convert(self.mass),
            moments: self.moments.map(convert),
        }
    }
}

impl<S: Scalar> From<PrincipalBody<S>> for RigidBody<S> {
    fn from(body: PrincipalBody<S>) -> Self {
        Self::of_valid(body.mass(), body.center(), body.inertia())
    }
}
