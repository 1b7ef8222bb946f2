//! Conversions between descriptions of rotations: Euler angles of all twelve sequences, matrices and unit quaternions;
//! rates of angles and angular velocity (4.4); generalized forces of angles and moments.
//!
//! An orientation R takes components in axes of the body to components in axes of space. Matrices and quaternions are
//! types of nalgebra; angles are in radians. Conversions between descriptions search for the largest of several
//! numbers, and therefore need a [`SingleNumber`](crate::SingleNumber); everything that depends on angles alone works
//! on every scalar.
//!
//! Angles have poles, where two of their axes are parallel: sin θ = 0 for Euler's sequences, such as z-x-z, and cos θ =
//! 0 for the sequences of Tait and Bryan, such as x-y-z. The rates of the angles are infinite at a pole. A motion that
//! comes near a pole can be continued in another sequence ([`EulerAngles::continued`]), or as a quaternion.
//!
//! ```
//! use lagrangian::rotation::{EulerAngles, EulerSequence};
//! use lagrangian::nalgebra::Vector3;
//!
//! // Precession, nutation and spin of a top that is almost upright.
//! let angles = EulerAngles::new(EulerSequence::Zxz, [0.3, 1e-3, 1.1]);
//! let rates = Vector3::new(2.0, 0.0, 50.0);
//! let omega = angles.angular_velocity(&rates);
//! assert!((angles.rates(&omega)? - rates).norm() < 1e-12);
//!
//! // This state in another sequence, far from its poles.
//! let (cardan, cardan_rates) = angles.continued(EulerSequence::Xyz, &rates)?;
//! assert!(angles.regularity() < 2e-3 && cardan.regularity() > 0.99);
//! assert!((cardan.angular_velocity(&cardan_rates) - omega).norm() < 1e-12);
//! # Ok::<(), lagrangian::rotation::RotationError>(())
//! ```

mod error;
mod euler_sequence;
mod quaternion;
mod euler_angles;
mod euler_rates;

pub use error::RotationError;
pub use euler_angles::EulerAngles;
pub use euler_sequence::EulerSequence;
pub(crate) use quaternion::{components, normalized, product};
pub use quaternion::{
    quaternion_of, quaternion_rate, rotation_of, unit_quaternion, verified_rotation,
};
