//! Unit quaternions, and conversions from and to rotation matrices, on every scalar.

use nalgebra::{Matrix3, Quaternion, Rotation3, UnitQuaternion, Vector3};

use super::error::RotationError;
use crate::integrate::SingleNumber;
use crate::limits::rotations::NOT_ORTHONORMAL;
use crate::scalar::Scalar;

/// Returns the product p q, in components (w, x, y, z).
pub(crate) fn product<S: Scalar>(p: &[S; 4], q: &[S; 4]) -> [S; 4] {
    let [pw, px, py, pz] = *p;
    let [qw, qx, qy, qz] = *q;
    [
        pw * qw - px * qx - py * qy - pz * qz,
        pw * qx + px * qw + py * qz - pz * qy,
        pw * qy + py * qw + pz * qx - px * qz,
        pw * qz + pz * qw + px * qy - py * qx,
    ]
}

/// Returns the components (w, x, y, z) of a quaternion.
pub(crate) fn components<S: Scalar>(quaternion: &UnitQuaternion<S>) -> [S; 4] {
    let [x, y, z, w]: [S; 4] = quaternion.as_ref().coords.into();
    [w, x, y, z]
}

/// Returns the unit quaternion with these components (w, x, y, z), divided by their norm.
pub(crate) fn normalized<S: Scalar>(components: [S; 4]) -> UnitQuaternion<S> {
    let squares = components.iter().fold(S::zero(), |sum, x| sum + *x * *x);
    let norm = squares.sqrt();
    let [w, x, y, z] = components.map(|component| component / norm);
    UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z))
}

/// Returns the unit quaternion with these components (w, x, y, z), divided by their norm.
///
/// # Errors
/// [`RotationError::NoOrientation`] if the norm is zero or not finite.
///
/// ```
/// use lagrangian::rotation::unit_quaternion;
///
/// assert_eq!(unit_quaternion([2.0, 0.0, 0.0, 0.0])?.w, 1.0);
/// assert!(unit_quaternion([0.0; 4]).is_err());
/// # Ok::<(), lagrangian::rotation::RotationError>(())
/// ```
pub fn unit_quaternion<S: Scalar>(components: [S; 4]) -> Result<UnitQuaternion<S>, RotationError> {
    let unit = normalized(components);
    if unit.as_ref().coords.iter().all(|x| x.is_finite()) {
        return Ok(unit);
    }
    let squares = components.iter().fold(S::zero(), |sum, x| sum + *x * *x);
    let norm = squares.sqrt().smallest();
    Err(RotationError::NoOrientation { norm })
}

/// Returns the rotation matrix R of a unit quaternion, which takes components in axes of the body to components in axes
/// of space.
#[must_use]
pub fn rotation_of<S: Scalar>(quaternion: &UnitQuaternion<S>) -> Rotation3<S> {
    let [w, x, y, z] = components(quaternion);
    let [one, two] = [S::one(), S::from_f64(2.0)];
    let [wx, wy, wz] = [x, y, z].map(|component| two * w * component);
    let [xx, yy, zz] = [x, y, z].map(|component| two * component * component);
    let [xy, xz, yz] = [two * x * y, two * x * z, two * y * z];
    Rotation3::from_matrix_unchecked(Matrix3::new(
        one - (yy + zz),
        xy - wz,
        xz + wy,
        xy + wz,
        one - (xx + zz),
        yz - wx,
        xz - wy,
        yz + wx,
        one - (xx + yy),
    ))
}

/// Returns the unit quaternion of a rotation matrix; of the two that differ in sign, the one whose largest component is
/// positive.
///
/// S. W. Shepperd, *Quaternion from Rotation Matrix*, J. Guidance Control **1** (1978) 223–224: computed from the
/// largest component, which cannot be small.
#[must_use]
pub fn quaternion_of<S: SingleNumber>(rotation: &Rotation3<S>) -> UnitQuaternion<S> {
    let r = rotation.matrix();
    let trace = r.trace();
    let mut largest = 0;
    let mut size = trace;
    for axis in 0..3 {
        if (r[(axis, axis)] - size).largest() > 0.0 {
            (largest, size) = (axis + 1, r[(axis, axis)]);
        }
    }
    let two = S::from_f64(2.0);
    let unscaled = if largest == 0 {
        let [x, y, z] = [(2, 1), (0, 2), (1, 0)].map(|(i, j)| r[(i, j)] - r[(j, i)]);
        [S::one() + trace, x, y, z]
    } else {
        let i = largest - 1;
        let [j, k] = [(i + 1) % 3, (i + 2) % 3];
        let mut components = [S::zero(); 4];
        components[0] = r[(k, j)] - r[(j, k)];
        components[i + 1] = S::one() - trace + two * r[(i, i)];
        components[j + 1] = r[(i, j)] + r[(j, i)];
        components[k + 1] = r[(i, k)] + r[(k, i)];
        components
    };
    normalized(unscaled)
}

/// Returns a matrix as a rotation, if it is one up to rounding.
///
/// # Errors
/// [`RotationError::NotOrthonormal`] or [`RotationError::Reflection`], with the wrong value.
///
/// ```
/// use lagrangian::rotation::{RotationError, verified_rotation};
/// use lagrangian::nalgebra::Matrix3;
///
/// let mirror = Matrix3::new(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1.0);
/// assert_eq!(verified_rotation(&mirror), Err(RotationError::Reflection { determinant: -1.0 }));
/// ```
pub fn verified_rotation<S: Scalar>(matrix: &Matrix3<S>) -> Result<Rotation3<S>, RotationError> {
    let allowed = NOT_ORTHONORMAL * S::machine_epsilon();
    for (i, j) in [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)] {
        let product = matrix.column(i).dot(&matrix.column(j));
        let expected = if i == j { S::one() } else { S::zero() };
        let difference = (product - expected).abs().largest();
        if difference > allowed || difference.is_nan() {
            return Err(RotationError::NotOrthonormal {
                columns: [i, j],
                product: product.largest(),
            });
        }
    }
    let [first, second, third] = [0, 1, 2].map(|k| matrix.column(k).into_owned());
    let determinant = first.cross(&second).dot(&third).smallest();
    if determinant < 0.0 {
        return Err(RotationError::Reflection { determinant });
    }
    Ok(Rotation3::from_matrix_unchecked(*matrix))
}

/// Returns the derivative q̇ = ½ q ∘ (0, **ω**) of the quaternion of an orientation, given the angular velocity in axes
/// of the body.
///
/// Components are in the order (w, x, y, z), as in the quaternion, which need not have norm 1.
#[must_use]
pub fn quaternion_rate<S: Scalar>(quaternion: &[S; 4], angular_velocity: &Vector3<S>) -> [S; 4] {
    let half = S::from_f64(0.5);
    let [x, y, z]: [S; 3] = (angular_velocity * half).into();
    product(quaternion, &[S::zero(), x, y, z])
}
