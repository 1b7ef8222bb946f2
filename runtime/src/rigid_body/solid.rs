//! Solids, surfaces and lines of uniform density.
//!
//! The formulas can be found in any handbook, such as the tables of M. R. Spiegel, *Theory and Problems of Theoretical
//! Mechanics* (1967), chapter 9. They are written with the second moments ∫ x² dm/m; each moment of inertia is the sum
//! of two of these. Differences of powers of an outer and an inner radius are divided by their common factor.

use nalgebra::{Matrix3, Vector3};

use super::body::RigidBody;
use super::error::BodyError;
use super::inertia_tensor::InertiaTensor;
use super::validity::{finite, positive};
use crate::integrate::SingleNumber;
use crate::scalar::Scalar;

/// A solid, a surface or a line of uniform density, before its mass is known.
///
/// Axes of rotation are along z. All shapes have their centre of gravity at the origin, except meshes and the cone,
/// whose base is there. [`with_mass`](Self::with_mass) and [`with_density`](Self::with_density) turn it into a
/// [`RigidBody`].
///
/// ```
/// use lagrangian::rigid_body::Solid;
///
/// let ball = Solid::sphere(0.5)?.with_mass(2.0)?;
/// assert!((ball.inertia().moments()[2] - 0.4 * 2.0 * 0.25_f64).abs() < 1e-16);
/// # Ok::<(), lagrangian::rigid_body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solid<S: Scalar = f64> {
    /// The volume, area or length.
    content: S,
    center: Vector3<S>,
    /// The inertia tensor about the centre, for a mass of 1.
    inertia: InertiaTensor<S>,
}

/// Returns a fraction of small whole numbers.
fn fraction<S: Scalar>(numerator: f64, denominator: f64) -> S {
    S::ratio(numerator, denominator)
}

impl<S: SingleNumber> Solid<S> {
    /// Creates a box with edges of these lengths along x, y and z.
    ///
    /// # Errors
    /// [`BodyError`] if a length is not positive and finite.
    pub fn cuboid(x: S, y: S, z: S) -> Result<Self, BodyError> {
        let edges = all_positive("an edge of the box", [x, y, z])?;
        let twelfth = fraction::<S>(1.0, 12.0);
        Ok(Self::centered(
            x * y * z,
            edges.map(|edge| edge * edge * twelfth),
        ))
    }

    /// Creates a cylinder about z with this radius and height.
    ///
    /// # Errors
    /// [`BodyError`] if a size is not positive and finite.
    pub fn cylinder(radius: S, height: S) -> Result<Self, BodyError> {
        let radius = positive("the radius of the cylinder", radius)?;
        let height = positive("the height of the cylinder", height)?;
        let square = radius * radius;
        let across = square * fraction(1.0, 4.0);
        let along = height * height * fraction(1.0, 12.0);
        let volume = S::pi() * square * height;
        Ok(Self::of_revolution(volume, across, along))
    }

    /// Creates a tube about z, a cylinder with a coaxial cylindrical hole.
    ///
    /// # Errors
    /// [`BodyError`] if a size is not positive and finite, or the inner radius is not less than the outer one.
    pub fn tube(inner_radius: S, outer_radius: S, height: S) -> Result<Self, BodyError> {
        let [inner, outer] = radii(inner_radius, outer_radius)?;
        let height = positive("the height of the tube", height)?;
        let across = (inner * inner + outer * outer) * fraction(1.0, 4.0);
        let along = height * height * fraction(1.0, 12.0);
        let volume = S::pi() * (outer - inner) * (outer + inner) * height;
        Ok(Self::of_revolution(volume, across, along))
    }

    /// Creates a sphere.
    ///
    /// # Errors
    /// [`BodyError`] if the radius is not positive and finite.
    pub fn sphere(radius: S) -> Result<Self, BodyError> {
        let radius = positive("the radius of the sphere", radius)?;
        Self::ellipsoid(radius, radius, radius)
    }

    /// Creates a sphere with a concentric spherical hole.
    ///
    /// # Errors
    /// [`BodyError`] if a size is not positive and finite, or the inner radius is not less than the outer one.
    pub fn hollow_sphere(inner_radius: S, outer_radius: S) -> Result<Self, BodyError> {
        let [inner, outer] = radii(inner_radius, outer_radius)?;
        let [a, b] = [inner * inner, outer * outer];
        let mixed = inner * outer;
        // (outer³ − inner³)/(outer − inner) and (outer⁵ − inner⁵)/(outer − inner).
        let cubes = a + mixed + b;
        let fifth_powers = a * a + a * mixed + a * b + b * mixed + b * b;
        let second = fifth_powers / cubes * fraction(1.0, 5.0);
        let volume = fraction::<S>(4.0, 3.0) * S::pi() * (outer - inner) * cubes;
        Ok(Self::centered(volume, [second; 3]))
    }

    /// Creates a thin spherical shell, whose density is mass per area.
    ///
    /// # Errors
    /// [`BodyError`] if the radius is not positive and finite.
    pub fn spherical_shell(radius: S) -> Result<Self, BodyError> {
        let radius = positive("the radius of the spherical shell", radius)?;
        let square = radius * radius;
        Ok(Self::centered(
            S::from_f64(4.0) * S::pi() * square,
            [square * fraction(1.0, 3.0); 3],
        ))
    }

    /// Creates a cone about z with its base in the plane z = 0 and its apex at z = `height`. The centre of gravity is
    /// at a quarter of the height.
    ///
    /// # Errors
    /// [`BodyError`] if a size is not positive and finite.
    pub fn cone(radius: S, height: S) -> Result<Self, BodyError> {
        let radius = positive("the radius of the cone", radius)?;
        let height = positive("the height of the cone", height)?;
        let square = radius * radius;
        let across = square * fraction(3.0, 20.0);
        let along = height * height * fraction(3.0, 80.0);
        let volume = S::pi() * square * height * fraction(1.0, 3.0);
        let cone = Self::of_revolution(volume, across, along);
        let [x, y] = [S::zero(); 2];
        let center = Vector3::new(x, y, height * fraction(1.0, 4.0));
        Ok(Self { center, ..cone })
    }

    /// Creates an ellipsoid with semi-axes of these lengths along x, y and z.
    ///
    /// # Errors
    /// [`BodyError`] if a length is not positive and finite.
    pub fn ellipsoid(x: S, y: S, z: S) -> Result<Self, BodyError> {
        let semi_axes = all_positive("a semi-axis of the ellipsoid", [x, y, z])?;
        let fifth = fraction::<S>(1.0, 5.0);
        Ok(Self::centered(
            fraction::<S>(4.0, 3.0) * S::pi() * x * y * z,
            semi_axes.map(|length| length * length * fifth),
        ))
    }

    /// Creates a torus about z: a disc of radius `minor_radius` revolved at the distance `major_radius`.
    ///
    /// # Errors
    /// [`BodyError`] if a size is not positive and finite, or the minor radius is not less than the major one.
    pub fn torus(major_radius: S, minor_radius: S) -> Result<Self, BodyError> {
        let names = ["the minor radius", "the major radius"];
        let [minor, major] = ascending(names, [minor_radius, major_radius])?;
        let [large, small] = [major * major, minor * minor];
        let across = large * fraction(1.0, 2.0) + small * fraction(3.0, 8.0);
        let along = small * fraction(1.0, 4.0);
        let volume = S::from_f64(2.0) * S::pi() * S::pi() * major * small;
        Ok(Self::of_revolution(volume, across, along))
    }

    /// Creates a capsule about z: a cylinder of this radius and length between two hemispheres.
    ///
    /// # Errors
    /// [`BodyError`] if a size is not positive and finite.
    pub fn capsule(radius: S, length: S) -> Result<Self, BodyError> {
        let radius = positive("the radius of the capsule", radius)?;
        let length = positive("the length of the capsule", length)?;
        let square = radius * radius;
        // Lengths of equivalent cylinders with this radius: of the middle, and of both hemispheres.
        let ends = radius * fraction(4.0, 3.0);
        let whole = length + ends;
        let [of_middle, of_ends] = [length / whole, ends / whole];
        let across = square * (of_middle * fraction(1.0, 4.0) + of_ends * fraction(1.0, 5.0));
        let quarter = length * length * fraction(1.0, 4.0);
        let along_ends =
            quarter + length * radius * fraction(3.0, 8.0) + square * fraction(1.0, 5.0);
        let along = of_middle * quarter * fraction(1.0, 3.0) + of_ends * along_ends;
        let volume = S::pi() * square * whole;
        Ok(Self::of_revolution(volume, across, along))
    }

    /// Creates a thin rod along z, whose density is mass per length.
    ///
    /// # Errors
    /// [`BodyError`] if the length is not positive and finite.
    pub fn rod(length: S) -> Result<Self, BodyError> {
        let length = positive("the length of the rod", length)?;
        let along = length * length * fraction(1.0, 12.0);
        Ok(Self::centered(length, [S::zero(), S::zero(), along]))
    }

    /// Creates a thin disc in the plane z = 0, whose density is mass per area.
    ///
    /// # Errors
    /// [`BodyError`] if the radius is not positive and finite.
    pub fn disc(radius: S) -> Result<Self, BodyError> {
        let radius = positive("the radius of the disc", radius)?;
        let square = radius * radius;
        let across = square * fraction(1.0, 4.0);
        Ok(Self::of_revolution(S::pi() * square, across, S::zero()))
    }

    /// Creates a thin rectangular plate in the plane z = 0 with edges of these lengths along x and y, whose density is
    /// mass per area.
    ///
    /// # Errors
    /// [`BodyError`] if a length is not positive and finite.
    pub fn plate(x: S, y: S) -> Result<Self, BodyError> {
        all_positive("an edge of the plate", [x, y])?;
        let twelfth = fraction::<S>(1.0, 12.0);
        Ok(Self::centered(
            x * y,
            [x * x * twelfth, y * y * twelfth, S::zero()],
        ))
    }

    /// Creates a solid from its integrals: volume, ∫ **r** dV, and ∫ **r** **r**ᵀ dV.
    #[cfg(feature = "alloc")]
    pub(super) fn from_integrals(volume: S, first: Vector3<S>, second: &Matrix3<S>) -> Self {
        let center = first.map(|component| component / volume);
        let second = second.map(|component| component / volume);
        let about_center = second - center * center.transpose();
        Self {
            content: volume,
            center,
            inertia: InertiaTensor::from_second_moments(&about_center),
        }
    }

    /// Returns the body of this shape with a mass.
    ///
    /// # Errors
    /// [`BodyError`] if the mass is not positive and finite, or if the resulting inertia is not physical.
    pub fn with_mass(&self, mass: S) -> Result<RigidBody<S>, BodyError> {
        positive("the mass", mass)?;
        let inertia = self.inertia.scaled(mass);
        RigidBody::new(mass, self.center, inertia)
    }

    /// Returns the body of this shape with a mass per volume, area or length.
    ///
    /// # Errors
    /// [`BodyError`] if the density is not positive and finite, or if the resulting inertia is not physical.
    pub fn with_density(&self, density: S) -> Result<RigidBody<S>, BodyError> {
        positive("the density", density)?;
        self.with_mass(density * self.content)
    }
}

impl<S: Scalar> Solid<S> {
    /// Returns the volume; for a surface its area, for a line its length.
    #[must_use]
    pub fn content(&self) -> S {
        self.content
    }

    /// Returns the centre of gravity.
    #[must_use]
    pub fn center(&self) -> Vector3<S> {
        self.center
    }

    /// Returns the solid after a displacement.
    #[must_use]
    pub fn moved(&self, displacement: Vector3<S>) -> Self {
        let center = self.center + displacement;
        Self { center, ..*self }
    }

    /// A solid of revolution about the third axis, by its second moments across and along this axis.
    fn of_revolution(content: S, across: S, along: S) -> Self {
        Self::centered(content, [across, across, along])
    }

    /// Creates a solid about the origin with these ∫ x² dm/m, ∫ y² dm/m, ∫ z² dm/m, and no products of inertia.
    fn centered(content: S, second_moments: [S; 3]) -> Self {
        let second = Matrix3::from_diagonal(&second_moments.into());
        Self {
            content,
            center: Vector3::zeros(),
            inertia: InertiaTensor::from_second_moments(&second),
        }
    }
}

/// Checks an inner and an outer radius.
fn radii<S: SingleNumber>(inner: S, outer: S) -> Result<[S; 2], BodyError> {
    ascending(["the inner radius", "the outer radius"], [inner, outer])
}

/// Checks that the first of two sizes is the smaller one.
fn ascending<S: SingleNumber>(
    [quantity, limit]: [&'static str; 2],
    [small, large]: [S; 2],
) -> Result<[S; 2], BodyError> {
    let small = positive(quantity, small)?;
    let large = finite(limit, large)?;
    if (large - small).smallest() > 0.0 {
        return Ok([small, large]);
    }
    let [value, limit_value] = [small, large].map(Scalar::largest);
    Err(BodyError::TooLarge {
        quantity,
        value,
        limit,
        limit_value,
    })
}

/// Checks that all sizes are positive and finite.
fn all_positive<S: SingleNumber, const N: usize>(
    quantity: &'static str,
    sizes: [S; N],
) -> Result<[S; N], BodyError> {
    for size in sizes {
        positive(quantity, size)?;
    }
    Ok(sizes)
}
