//! The inertia tensor (2.1), and the sign of its products of inertia.

use core::ops::{Add, Mul, Neg, Sub};

use nalgebra::{Matrix3, Rotation3, Vector3};

use super::error::BodyError;
use super::order::length;
use crate::integrate::SingleNumber;
use crate::limits::rigid_bodies::ASYMMETRY;
use crate::linalg::largest;
use crate::scalar::Scalar;

/// The products of inertia of (2.1), Ixy = +∫ xy dm; the entries of the tensor are their **negatives**.
///
/// A body with more mass where x and y have equal signs has a positive `xy`. Much software reports the entries of the
/// tensor under the names of the products; [`CadReport`](super::CadReport) and [`UrdfInertial`](super::UrdfInertial)
/// state which are meant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProductsOfInertia<S = f64> {
    /// +∫ xy dm.
    pub xy: S,
    /// +∫ xz dm.
    pub xz: S,
    /// +∫ yz dm.
    pub yz: S,
}

impl<S: Scalar> ProductsOfInertia<S> {
    /// Returns the zero products of inertia of a body with three planes of symmetry along the axes.
    #[must_use]
    pub fn zero() -> Self {
        let [xy, xz, yz] = [S::zero(); 3];
        Self { xy, xz, yz }
    }
}

impl<S: Scalar> Neg for ProductsOfInertia<S> {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            xy: -self.xy,
            xz: -self.xz,
            yz: -self.yz,
        }
    }
}

/// The inertia tensor \[I\] of a mass distribution about a point (2.1), in mass times length squared.
///
/// ```text
///        Ixx  −Ixy  −Ixz        Ixx = ∫ (y² + z²) dm      Ixy = ∫ xy dm
/// [I] = −Ixy   Iyy  −Iyz        Iyy = ∫ (x² + z²) dm      Ixz = ∫ xz dm
///       −Ixz  −Iyz   Izz        Izz = ∫ (x² + y²) dm      Iyz = ∫ yz dm
/// ```
///
/// [`matrix`](Self::matrix) is the tensor with the negative products, [`products`](Self::products) are the integrals
/// themselves. The tensor is symmetric by construction; [`RigidBody::new`](super::RigidBody::new) checks whether a body
/// can have it.
///
/// ```
/// use lagrangian::rigid_body::{InertiaTensor, ProductsOfInertia};
///
/// let products = ProductsOfInertia { xy: 0.5, xz: 0.0, yz: 0.0 };
/// let tensor = InertiaTensor::from_moments_and_products([2.0, 2.5, 3.0], products);
/// assert_eq!(tensor.matrix()[(0, 1)], -0.5);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InertiaTensor<S: Scalar = f64> {
    /// Ixx, Iyy, Izz.
    moments: Vector3<S>,
    products: ProductsOfInertia<S>,
}

impl<S: Scalar> InertiaTensor<S> {
    /// Creates the tensor with moments of inertia Ixx, Iyy, Izz and products of inertia +∫ xy dm, +∫ xz dm, +∫ yz dm.
    #[must_use]
    pub fn from_moments_and_products(moments: [S; 3], products: ProductsOfInertia<S>) -> Self {
        Self {
            moments: moments.into(),
            products,
        }
    }

    /// Creates the tensor in principal axes (2.5): I₁, I₂, I₃ and no products of inertia.
    #[must_use]
    pub fn principal(moments: [S; 3]) -> Self {
        Self::from_moments_and_products(moments, ProductsOfInertia::zero())
    }

    /// Creates the tensor from the second moments ∫ **r** **r**ᵀ dm, whose upper triangle is read: ∫ x² dm on the
    /// diagonal, +∫ xy dm beside it.
    #[must_use]
    pub fn from_second_moments(second: &Matrix3<S>) -> Self {
        let [x, y, z] = [second[(0, 0)], second[(1, 1)], second[(2, 2)]];
        let products = ProductsOfInertia {
            xy: second[(0, 1)],
            xz: second[(0, 2)],
            yz: second[(1, 2)],
        };
        Self::from_moments_and_products([y + z, x + z, x + y], products)
    }

    /// Creates the tensor of a mass at a point **d** from the point of reference: m (|**d**|² 1 − **d** **d**ᵀ), the
    /// term of the parallel axis theorem (2.2).
    #[must_use]
    pub fn of_particle(mass: S, d: &Vector3<S>) -> Self {
        let scaled = d * mass;
        Self::from_second_moments(&(scaled * d.transpose()))
    }

    /// Returns Ixx, Iyy and Izz.
    #[must_use]
    pub fn moments(&self) -> [S; 3] {
        self.moments.into()
    }

    /// Returns the products of inertia +∫ xy dm, +∫ xz dm, +∫ yz dm.
    #[must_use]
    pub fn products(&self) -> ProductsOfInertia<S> {
        self.products
    }

    /// Returns the tensor (2.1) as a matrix, whose off-diagonal entries are the negatives of the products of inertia.
    #[must_use]
    pub fn matrix(&self) -> Matrix3<S> {
        let [xx, yy, zz] = self.moments();
        let ProductsOfInertia { xy, xz, yz } = -self.products;
        Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz)
    }

    /// Returns the second moments ∫ **r** **r**ᵀ dm = ½ tr\[I\] 1 − \[I\].
    #[must_use]
    pub fn second_moments(&self) -> Matrix3<S> {
        let [xx, yy, zz] = self.moments();
        let ProductsOfInertia { xy, xz, yz } = self.products;
        let half = S::from_f64(0.5);
        let [x, y, z] = [
            (yy + zz - xx) * half,
            (xx + zz - yy) * half,
            (xx + yy - zz) * half,
        ];
        Matrix3::new(x, xy, xz, xy, y, yz, xz, yz, z)
    }

    /// Returns the moment of inertia about the line through the point of reference along a direction vector of any
    /// length: êᵀ\[I\]ê (2.4), which is ∫ h² dm (2.3) with the distance h from the line.
    ///
    /// # Errors
    /// [`BodyError::NoDirection`] if the vector is zero or not finite.
    pub fn about_line(&self, direction: &Vector3<S>) -> Result<S, BodyError> {
        let norm = length(direction);
        if !(norm.smallest() > 0.0 && norm.is_finite()) {
            let length = norm.smallest();
            return Err(BodyError::NoDirection { length });
        }
        let unit = direction.map(|component| component / norm);
        Ok(unit.dot(&(*self * unit)))
    }

    /// Returns the tensor in other axes: R \[I\] Rᵀ, where R takes components in the present axes to components in the
    /// new axes. This is also the tensor of the body after a rotation by R.
    #[must_use]
    pub fn rotated(&self, rotation: &Rotation3<S>) -> Self {
        let r = rotation.matrix();
        let matrix = r * self.matrix() * r.transpose();
        let products = [matrix[(0, 1)], matrix[(0, 2)], matrix[(1, 2)]].map(Neg::neg);
        Self::from_lists(matrix.diagonal().into(), products)
    }

    /// Returns the tensor with all entries multiplied by a factor.
    #[must_use]
    pub fn scaled(&self, factor: S) -> Self {
        let [moments, products] = [self.moments * factor, Vector3::from(self.list()) * factor];
        Self::from_lists(moments.into(), products.into())
    }

    fn list(&self) -> [S; 3] {
        [self.products.xy, self.products.xz, self.products.yz]
    }

    fn from_lists(moments: [S; 3], [xy, xz, yz]: [S; 3]) -> Self {
        Self::from_moments_and_products(moments, ProductsOfInertia { xy, xz, yz })
    }

    /// Combines each entry with the entry of another tensor.
    pub(super) fn zip_map<T: Scalar>(
        &self,
        other: &InertiaTensor<T>,
        mut function: impl FnMut(S, T) -> S,
    ) -> Self {
        let mut zipped = |x: [S; 3], y: [T; 3]| core::array::from_fn(|i| function(x[i], y[i]));
        let moments = zipped(self.moments(), other.moments());
        Self::from_lists(moments, zipped(self.list(), other.list()))
    }

    /// Converts the nine entries to another scalar.
    pub(super) fn map<T: Scalar>(&self, mut convert: impl FnMut(S) -> T) -> InertiaTensor<T> {
        InertiaTensor::from_lists(self.moments().map(&mut convert), self.list().map(convert))
    }
}

impl<S: SingleNumber> InertiaTensor<S> {
    /// Creates the tensor from its matrix, with the negative products of inertia beside the diagonal.
    ///
    /// # Errors
    /// [`BodyError::NotFinite`], or [`BodyError::NotSymmetric`] if two entries that should be equal differ by more than
    /// rounding; otherwise their mean is used.
    pub fn from_matrix(matrix: &Matrix3<S>) -> Result<Self, BodyError> {
        let half = S::from_f64(0.5);
        let largest = largest(matrix);
        let allowed = ASYMMETRY * S::machine_epsilon() * largest;
        let mean = |row: usize, column: usize| {
            let [entry, opposite] = [matrix[(row, column)], matrix[(column, row)]];
            if (entry - opposite).abs().largest() <= allowed {
                return Ok((entry + opposite) * half);
            }
            let [entry, opposite] = [entry, opposite].map(Scalar::largest);
            Err(BodyError::NotSymmetric {
                row,
                column,
                entry,
                opposite,
            })
        };
        if let Some(value) = matrix.iter().map(|x| x.largest()).find(|x| !x.is_finite()) {
            let quantity = "an entry of the inertia tensor";
            return Err(BodyError::NotFinite { quantity, value });
        }
        let [xy, xz, yz] = [mean(0, 1)?, mean(0, 2)?, mean(1, 2)?];
        let moments = [matrix[(0, 0)], matrix[(1, 1)], matrix[(2, 2)]];
        Ok(Self::from_lists(moments, [-xy, -xz, -yz]))
    }
}

impl<S: Scalar> Mul<Vector3<S>> for InertiaTensor<S> {
    type Output = Vector3<S>;

    /// Returns \[I\] **ω**.
    fn mul(self, vector: Vector3<S>) -> Vector3<S> {
        self.matrix() * vector
    }
}

impl<S: Scalar> Add for InertiaTensor<S> {
    type Output = Self;

    /// Returns the tensor of two mass distributions about one point.
    fn add(self, other: Self) -> Self {
        let products = Vector3::from(self.list()) + Vector3::from(other.list());
        Self::from_lists((self.moments + other.moments).into(), products.into())
    }
}

impl<S: Scalar> Sub for InertiaTensor<S> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + other.scaled(-S::one())
    }
}
