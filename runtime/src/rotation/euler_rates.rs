//! Rates of Euler angles and angular velocity (4.4), generalized forces and moments.
//!
//! The columns of E in **ω** = E (φ̇, θ̇, ψ̇) are unit vectors along the axes of the three rotations, in axes of the
//! body. The second is normal to the others. E is therefore inverted in the frame of the second axis, the third axis
//! and their normal, and the only division is by det E = ∓sin θ or ±cos θ.

use nalgebra::{Matrix3, Vector3};

use super::error::RotationError;
use super::euler_angles::EulerAngles;
use super::euler_sequence::EulerSequence;
use crate::integrate::SingleNumber;
use crate::limits::rotations::AT_POLE;
use crate::scalar::Scalar;

/// The axes of the three rotations, in axes of the body.
struct Axes<S: Scalar> {
    first: Vector3<S>,
    second: Vector3<S>,
    third: Vector3<S>,
    /// The unit vector along the vector product of the second and the third axis.
    normal: Vector3<S>,
    /// The scalar product of the first and the third axis.
    cosine: S,
    /// The scalar product of the first axis and the normal, det E.
    determinant: S,
}

impl<S: Scalar> Axes<S> {
    fn of(angles: &EulerAngles<S>) -> Self {
        let sequence = angles.sequence;
        let [i, j, k] = sequence.axes();
        let remaining = sequence.remaining_axis();
        let [_, theta, psi] = angles.angles;
        let [(sin_theta, cos_theta), spin] = [theta.sin_cos(), psi.sin_cos()];
        let sign: S = sequence.sign();
        // Before the third rotation, the first axis is cos θ e₁ + sin θ e₁ × e₂.
        let mut first = Vector3::zeros();
        first[i] = cos_theta;
        first[remaining] = sign * sin_theta;
        let second = turned_back(k, spin, &Vector3::ith(j, S::one()));
        let third = Vector3::ith(k, S::one());
        let (cosine, determinant) = if sequence.repeats_axis() {
            (cos_theta, -sin_theta)
        } else {
            (sign * sin_theta, sign * cos_theta)
        };
        Self {
            first: turned_back(k, spin, &first),
            second,
            third,
            normal: second.cross(&third),
            cosine,
            determinant,
        }
    }

    /// Returns the axes, or an error at a pole.
    fn regular(self, sequence: EulerSequence, angle: S) -> Result<Self, RotationError> {
        // The rounding error of the angle appears in a sine that should be 0.
        let rounded = 1.0 + angle.abs().largest();
        if self.determinant.abs().smallest() > AT_POLE * S::machine_epsilon() * rounded {
            return Ok(self);
        }
        Err(RotationError::Singular {
            sequence,
            angle: angle.largest(),
            determinant: self.determinant.largest(),
        })
    }
}

/// Returns the components of a vector in axes that were turned about one of them by the angle with this sine and
/// cosine.
fn turned_back<S: Scalar>(axis: usize, (sine, cosine): (S, S), vector: &Vector3<S>) -> Vector3<S> {
    let [j, k] = [(axis + 1) % 3, (axis + 2) % 3];
    let mut turned = *vector;
    turned[j] = cosine * vector[j] + sine * vector[k];
    turned[k] = cosine * vector[k] - sine * vector[j];
    turned
}

impl<S: Scalar> EulerAngles<S> {
    /// Returns the matrix E of **ω** = E (φ̇, θ̇, ψ̇), with **ω** in axes of the body. For z-x-z it is given in (4.4).
    #[must_use]
    pub fn rate_matrix(&self) -> Matrix3<S> {
        let axes = Axes::of(self);
        Matrix3::from_columns(&[axes.first, axes.second, axes.third])
    }

    /// Returns |det E|, which is |sin θ| for Euler's sequences and |cos θ| for the sequences of Tait and Bryan.
    ///
    /// It is 0 at a pole and 1 farthest from it. The rates and their relative errors grow with its inverse.
    #[must_use]
    pub fn regularity(&self) -> S {
        Axes::of(self).determinant.abs()
    }

    /// Returns the angular velocity in axes of the body, given the rates of the angles (4.4).
    #[must_use]
    pub fn angular_velocity(&self, rates: &Vector3<S>) -> Vector3<S> {
        self.rate_matrix() * rates
    }

    /// Returns the angular velocity in axes of space, R E (φ̇, θ̇, ψ̇).
    #[must_use]
    pub fn angular_velocity_in_space(&self, rates: &Vector3<S>) -> Vector3<S> {
        self.rotation().matrix() * self.angular_velocity(rates)
    }

    /// Returns the rates of the angles, given the angular velocity in axes of the body: the inverse of (4.4).
    ///
    /// # Errors
    /// [`RotationError::Singular`] at a pole, in any lane.
    pub fn rates(&self, angular_velocity: &Vector3<S>) -> Result<Vector3<S>, RotationError> {
        let axes = Axes::of(self).regular(self.sequence, self.angles[1])?;
        let first = axes.normal.dot(angular_velocity) / axes.determinant;
        let second = axes.second.dot(angular_velocity);
        let third = axes.third.dot(angular_velocity) - axes.cosine * first;
        Ok(Vector3::new(first, second, third))
    }

    /// Returns the generalized forces Q = Eᵀ **N** of the angles, given a moment in axes of the body.
    ///
    /// By virtual power, **N** · **ω** = Q · q̇. The generalized forces are the moments about the axes of the three
    /// rotations, which are not orthogonal.
    #[must_use]
    pub fn generalized_forces(&self, moment: &Vector3<S>) -> Vector3<S> {
        let axes = Axes::of(self);
        let [first, second, third] = [axes.first, axes.second, axes.third];
        Vector3::new(first.dot(moment), second.dot(moment), third.dot(moment))
    }

    /// Returns the moment in axes of the body, given the generalized forces of the angles: Q = Eᵀ **N** solved for
    /// **N**.
    ///
    /// # Errors
    /// [`RotationError::Singular`] at a pole, in any lane.
    pub fn moment(&self, generalized_forces: &Vector3<S>) -> Result<Vector3<S>, RotationError> {
        let axes = Axes::of(self).regular(self.sequence, self.angles[1])?;
        let [first, second, third]: [S; 3] = (*generalized_forces).into();
        let about_normal = (first - axes.cosine * third) / axes.determinant;
        Ok(axes.normal * about_normal + axes.second * second + axes.third * third)
    }
}

impl<S: SingleNumber> EulerAngles<S> {
    /// Returns this orientation in another sequence.
    #[must_use]
    pub fn in_sequence(&self, sequence: EulerSequence) -> Self {
        Self::of_quaternion(sequence, &self.quaternion())
    }

    /// Returns this state, orientation and angular velocity, as angles and rates of another sequence, in which a motion
    /// can be continued where the present sequence comes near its pole.
    ///
    /// # Errors
    /// [`RotationError::Singular`] if the other sequence is at its pole.
    pub fn continued(
        &self,
        sequence: EulerSequence,
        rates: &Vector3<S>,
    ) -> Result<(Self, Vector3<S>), RotationError> {
        let continued = self.in_sequence(sequence);
        let rates = continued.rates(&self.angular_velocity(rates))?;
        Ok((continued, rates))
    }
}
