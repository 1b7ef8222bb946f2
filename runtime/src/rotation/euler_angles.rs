//! Euler angles, and conversions from and to orientations.

use nalgebra::{Matrix3, Quaternion, Rotation3, UnitQuaternion};

use super::euler_sequence::EulerSequence;
use super::quaternion::{components, product, quaternion_of};
use crate::integrate::SingleNumber;
use crate::limits::rotations::UNDETERMINED;
use crate::scalar::Scalar;

/// Three Euler angles φ, θ, ψ and the sequence of their axes: the orientation R = R₁(φ) R₂(θ) R₃(ψ).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct EulerAngles<S = f64> {
    /// The axes about which the angles turn.
    pub sequence: EulerSequence,
    /// The angles, in the order in which the rotations are applied to the body.
    pub angles: [S; 3],
}

impl<S: Scalar> EulerAngles<S> {
    /// Creates the angles of a sequence.
    #[must_use]
    pub fn new(sequence: EulerSequence, angles: [S; 3]) -> Self {
        Self { sequence, angles }
    }

    /// Returns the rotation matrix R, which takes components in axes of the body to components in axes of space.
    #[must_use]
    pub fn rotation(&self) -> Rotation3<S> {
        let axes = self.sequence.axes();
        let [first, second, third] = [0, 1, 2].map(|k| elementary(axes[k], self.angles[k]));
        Rotation3::from_matrix_unchecked(first * second * third)
    }

    /// Returns the unit quaternion of the orientation.
    #[must_use]
    pub fn quaternion(&self) -> UnitQuaternion<S> {
        let axes = self.sequence.axes();
        let [first, second, third] = [0, 1, 2].map(|k| {
            let (sine, cosine) = (self.angles[k] * S::from_f64(0.5)).sin_cos();
            let mut factor = [cosine, S::zero(), S::zero(), S::zero()];
            factor[axes[k] + 1] = sine;
            factor
        });
        let [w, x, y, z] = product(&product(&first, &second), &third);
        UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z))
    }
}

/// Returns the matrix of a rotation about an axis.
fn elementary<S: Scalar>(axis: usize, angle: S) -> Matrix3<S> {
    let (sine, cosine) = angle.sin_cos();
    let [j, k] = [(axis + 1) % 3, (axis + 2) % 3];
    let mut matrix = Matrix3::identity();
    [matrix[(j, j)], matrix[(k, k)]] = [cosine, cosine];
    [matrix[(k, j)], matrix[(j, k)]] = [sine, -sine];
    matrix
}

impl<S: SingleNumber> EulerAngles<S> {
    /// Returns the angles of an orientation.
    ///
    /// φ and ψ are in (−π, π], θ is in \[0, π\] for Euler's sequences, and in \[−π/2, π/2\] for the sequences of Tait
    /// and Bryan. Where the angles are singular, only the sum or the difference of φ and ψ is determined, and ψ is 0.
    ///
    /// The angles are accurate up to the pole, in the sense that they describe this orientation. E. Bernardes & S.
    /// Viollet, *Quaternion to Euler angles conversion: a direct, general and computationally efficient method*, PLOS
    /// ONE **17** (2022) e0276302: half the sum and half the difference of φ and ψ are the angles of two pairs of
    /// components.
    #[must_use]
    pub fn of_quaternion(sequence: EulerSequence, quaternion: &UnitQuaternion<S>) -> Self {
        let [first, second, _] = sequence.axes();
        let remaining = sequence.remaining_axis();
        let sign: S = sequence.sign();
        let q = components(quaternion);
        let [w, i, j, k] = [q[0], q[first + 1], q[second + 1], sign * q[remaining + 1]];
        if sequence.repeats_axis() {
            let angles = of_components([w, i, j, k], S::zero()).map(within_half_turn);
            return Self { sequence, angles };
        }
        // R R₂(∓π/2) is a sequence of rotations about the first, the second and again the first axis.
        let root = S::from_f64(0.5).sqrt();
        let [w, i, j, k] =
            [w + sign * j, i + sign * k, j - sign * w, k - sign * i].map(|x| x * root);
        let quarter = S::pi() * S::from_f64(0.5);
        let angles = if sequence.is_cyclic() {
            // (φ + π, −θ, ψ + π) describe the same rotation.
            let [phi, theta, psi] = of_components([w, i, j, k], S::pi());
            [phi + S::pi(), quarter - theta, psi + S::pi()]
        } else {
            let [phi, theta, psi] = of_components([w, i, j, k], S::zero());
            [phi, theta - quarter, psi]
        };
        let angles = angles.map(within_half_turn);
        Self { sequence, angles }
    }

    /// Returns the angles of a rotation matrix; see [`of_quaternion`](Self::of_quaternion).
    #[must_use]
    pub fn of_rotation(sequence: EulerSequence, rotation: &Rotation3<S>) -> Self {
        Self::of_quaternion(sequence, &quaternion_of(rotation))
    }
}

/// Returns the angles φ, θ, ψ of R₁(φ) R₂(θ) R₁(ψ), given the components of its quaternion along the axes 1, 2 and 1 ×
/// 2.
///
/// w = cos ½θ cos ½(φ + ψ), i = cos ½θ sin ½(φ + ψ), j = sin ½θ cos ½(φ − ψ), k = sin ½θ sin ½(φ − ψ). At a pole, ψ has
/// the given value.
fn of_components<S: SingleNumber>([w, i, j, k]: [S; 4], psi_at_pole: S) -> [S; 3] {
    let cosine = (w * w + i * i).sqrt();
    let sine = (j * j + k * k).sqrt();
    let undetermined = UNDETERMINED * S::machine_epsilon();
    let half_sum = i.atan2(w);
    let half_difference = k.atan2(j);
    let two = S::from_f64(2.0);
    let theta = two * sine.atan2(cosine);
    if sine.largest() <= undetermined {
        return [two * half_sum - psi_at_pole, theta, psi_at_pole];
    }
    if cosine.largest() <= undetermined {
        return [two * half_difference + psi_at_pole, theta, psi_at_pole];
    }
    [
        half_sum + half_difference,
        theta,
        half_sum - half_difference,
    ]
}

/// Reduces an angle between −3π and 3π by whole turns to (−π, π].
fn within_half_turn<S: SingleNumber>(angle: S) -> S {
    let turn = S::pi() + S::pi();
    if (angle - S::pi()).largest() > 0.0 {
        angle - turn
    } else if (angle + S::pi()).largest() <= 0.0 {
        angle + turn
    } else {
        angle
    }
}
