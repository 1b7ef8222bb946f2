//! Masses and inertias in the formats of other programs, with the sign of their products of inertia.

use nalgebra::Vector3;

use super::body::RigidBody;
use super::error::BodyError;
use super::inertia_tensor::{InertiaTensor, ProductsOfInertia};
use crate::integrate::SingleNumber;
use crate::limits::rigid_bodies::UNPHYSICAL_DIGITS;
use crate::linalg::largest;
use crate::rotation::{EulerAngles, EulerSequence};
use crate::scalar::Scalar;

/// The numbers of the element `<inertial>` of the Unified Robot Description Format.
///
/// `ixy`, `ixz` and `iyz` are **entries of the tensor**, −∫ xy dm and so on, about the centre of gravity. Its axes are
/// turned from the axes of the link by the roll, pitch and yaw of `<origin>`: R = Rz(yaw) Ry(pitch) Rx(roll).
///
/// ```
/// use lagrangian::rigid_body::UrdfInertial;
///
/// let link = UrdfInertial {
///     mass: 2.0,
///     xyz: [0.0, 0.0, 0.1],
///     rpy: [0.0, 0.0, 0.0],
///     ixx: 0.03, ixy: -0.001, ixz: 0.0, iyy: 0.04, iyz: 0.0, izz: 0.05,
/// };
/// let body = link.body()?;
/// assert_eq!(body.inertia().products().xy, 0.001);
/// assert_eq!(UrdfInertial::of(&body), link);
/// # Ok::<(), lagrangian::rigid_body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UrdfInertial<S = f64> {
    /// `<mass value>`.
    pub mass: S,
    /// `<origin xyz>`: the centre of gravity in the axes of the link.
    pub xyz: [S; 3],
    /// `<origin rpy>`: roll, pitch and yaw of the axes to which the tensor refers, in radians.
    pub rpy: [S; 3],
    /// The entry xx of the tensor.
    pub ixx: S,
    /// The entry xy of the tensor, −∫ xy dm.
    pub ixy: S,
    /// The entry xz of the tensor, −∫ xz dm.
    pub ixz: S,
    /// The entry yy of the tensor.
    pub iyy: S,
    /// The entry yz of the tensor, −∫ yz dm.
    pub iyz: S,
    /// The entry zz of the tensor.
    pub izz: S,
}

impl<S: SingleNumber> UrdfInertial<S> {
    /// Returns the body in the axes of the link.
    ///
    /// # Errors
    /// [`BodyError`] unless the numbers describe a physical body, to six digits.
    pub fn body(&self) -> Result<RigidBody<S>, BodyError> {
        let products = ProductsOfInertia {
            xy: -self.ixy,
            xz: -self.ixz,
            yz: -self.iyz,
        };
        let moments = [self.ixx, self.iyy, self.izz];
        let inertia = InertiaTensor::from_moments_and_products(moments, products);
        let [roll, pitch, yaw] = self.rpy;
        let axes = EulerAngles::new(EulerSequence::Zyx, [yaw, pitch, roll]);
        let inertia = inertia.rotated(&axes.rotation());
        printed(self.mass, self.xyz.into(), inertia)
    }
}

impl<S: Scalar> UrdfInertial<S> {
    /// Returns the numbers of a body in the axes of the link: roll, pitch and yaw are 0.
    #[must_use]
    pub fn of(body: &RigidBody<S>) -> Self {
        let [ixx, iyy, izz] = body.inertia().moments();
        let ProductsOfInertia { xy, xz, yz } = -body.inertia().products();
        Self {
            mass: body.mass(),
            xyz: body.center().into(),
            rpy: [S::zero(); 3],
            ixx,
            ixy: xy,
            ixz: xz,
            iyy,
            iyz: yz,
            izz,
        }
    }
}

/// The meaning of "Ixy" in a report.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProductSign {
    /// The integral Ixy = +∫ xy dm, as in (2.1). It is positive for a body with more mass where x and y have equal
    /// signs.
    Integral,
    /// The entry of the tensor, −∫ xy dm. It is negative for such a body.
    TensorEntry,
}

/// The mass properties that a CAD program reports, in its axes.
///
/// Programs differ in the sign of products of inertia, some let the user choose it, and a report often contains the
/// tensor both about the centre of gravity and about the origin; [`body_about_center`](Self::body_about_center) and
/// [`body_about_origin`](Self::body_about_origin) accept either. A body whose mass lies where x and y have equal signs
/// shows whether the sign is right. A wrong sign often, but not always, violates the triangle inequality.
///
/// ```
/// use lagrangian::rigid_body::{CadReport, ProductSign};
///
/// let report = CadReport {
///     mass: 1.2,
///     center: [0.02, 0.01, 0.0],
///     moments: [2.0e-3, 3.0e-3, 4.0e-3],
///     products: [4.0e-4, 0.0, 0.0],
///     sign: ProductSign::Integral,
/// };
/// let body = report.body_about_center()?;
/// assert_eq!(body.inertia().matrix()[(0, 1)], -4.0e-4);
/// # Ok::<(), lagrangian::rigid_body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CadReport<S = f64> {
    /// The mass.
    pub mass: S,
    /// The centre of gravity (also called centre of mass or, for uniform density, centre of volume).
    pub center: [S; 3],
    /// Ixx, Iyy, Izz.
    pub moments: [S; 3],
    /// The values that the report calls Ixy, Ixz, Iyz; mind the order.
    pub products: [S; 3],
    /// The meaning of these values.
    pub sign: ProductSign,
}

impl<S: SingleNumber> CadReport<S> {
    /// Returns the body, if the moments and products are about the centre of gravity.
    ///
    /// # Errors
    /// [`BodyError`] unless the numbers describe a physical body, to six digits.
    pub fn body_about_center(&self) -> Result<RigidBody<S>, BodyError> {
        printed(self.mass, self.center.into(), self.tensor())
    }

    /// Returns the body, if the moments and products are about the origin of the axes.
    ///
    /// # Errors
    /// [`BodyError`] unless the numbers describe a physical body, to six digits.
    pub fn body_about_origin(&self) -> Result<RigidBody<S>, BodyError> {
        let center = self.center.into();
        let tensor = self.tensor();
        let about_center = tensor - InertiaTensor::of_particle(self.mass, &center);
        RigidBody::within(self.mass, center, about_center, in_digits(&tensor))
    }

    fn tensor(&self) -> InertiaTensor<S> {
        let [xy, xz, yz] = self.products;
        let products = ProductsOfInertia { xy, xz, yz };
        let products = match self.sign {
            ProductSign::Integral => products,
            ProductSign::TensorEntry => -products,
        };
        InertiaTensor::from_moments_and_products(self.moments, products)
    }
}

impl<S: Scalar> CadReport<S> {
    /// Returns the report of a body about its centre of gravity.
    #[must_use]
    pub fn of(body: &RigidBody<S>, sign: ProductSign) -> Self {
        let products = match sign {
            ProductSign::Integral => body.inertia().products(),
            ProductSign::TensorEntry => -body.inertia().products(),
        };
        Self {
            mass: body.mass(),
            center: body.center().into(),
            moments: body.inertia().moments(),
            products: [products.xy, products.xz, products.yz],
            sign,
        }
    }
}

/// Creates a body from numbers that were printed with a few digits.
fn printed<S: SingleNumber>(
    mass: S,
    center: Vector3<S>,
    inertia: InertiaTensor<S>,
) -> Result<RigidBody<S>, BodyError> {
    RigidBody::within(mass, center, inertia, in_digits(&inertia))
}

/// Returns a bound on the errors of a printed tensor.
fn in_digits<S: Scalar>(tensor: &InertiaTensor<S>) -> f64 {
    UNPHYSICAL_DIGITS * largest(&tensor.moments())
}
