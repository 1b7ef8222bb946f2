//! The twelve sequences of Euler angles.

use core::fmt;

use crate::scalar::Scalar;

/// The axes of three successive rotations, each about an axis of the body in the orientation that the previous
/// rotations have produced (intrinsic).
///
/// `Zxz` is R = `Rz`(φ) `Rx`(θ) `Rz`(ψ), the `rotation_zxz(phi, theta, psi)` of declarations. Rotations about fixed
/// axes of space (extrinsic) correspond to the reversed sequence with the angles in reversed order: roll, pitch and yaw
/// about the fixed axes x, y and z are the angles (yaw, pitch, roll) of `Zyx`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum EulerSequence {
    /// x, y, x.
    Xyx,
    /// x, z, x.
    Xzx,
    /// y, x, y.
    Yxy,
    /// y, z, y.
    Yzy,
    /// z, x, z: precession, nutation and spin (4.4).
    Zxz,
    /// z, y, z.
    Zyz,
    /// x, y, z: Cardan angles.
    Xyz,
    /// x, z, y.
    Xzy,
    /// y, x, z.
    Yxz,
    /// y, z, x.
    Yzx,
    /// z, x, y.
    Zxy,
    /// z, y, x: yaw, pitch and roll.
    Zyx,
}

impl EulerSequence {
    /// All twelve sequences: Euler's, then the sequences of Tait and Bryan.
    pub const ALL: [Self; 12] = [
        Self::Xyx,
        Self::Xzx,
        Self::Yxy,
        Self::Yzy,
        Self::Zxz,
        Self::Zyz,
        Self::Xyz,
        Self::Xzy,
        Self::Yxz,
        Self::Yzx,
        Self::Zxy,
        Self::Zyx,
    ];

    /// Returns the indices of the axes: 0 for x, 1 for y, 2 for z.
    #[must_use]
    pub fn axes(self) -> [usize; 3] {
        match self {
            Self::Xyx => [0, 1, 0],
            Self::Xzx => [0, 2, 0],
            Self::Yxy => [1, 0, 1],
            Self::Yzy => [1, 2, 1],
            Self::Zxz => [2, 0, 2],
            Self::Zyz => [2, 1, 2],
            Self::Xyz => [0, 1, 2],
            Self::Xzy => [0, 2, 1],
            Self::Yxz => [1, 0, 2],
            Self::Yzx => [1, 2, 0],
            Self::Zxy => [2, 0, 1],
            Self::Zyx => [2, 1, 0],
        }
    }

    /// Returns whether the first and the third axis are equal: a sequence of Euler in the narrow sense, singular where
    /// the second angle is a multiple of π. The sequences of Tait and Bryan are singular at odd multiples of π/2.
    #[must_use]
    pub fn repeats_axis(self) -> bool {
        let [first, _, third] = self.axes();
        first == third
    }

    /// Returns the axis that is neither the first nor the second one.
    pub(super) fn remaining_axis(self) -> usize {
        let [first, second, _] = self.axes();
        3 - first - second
    }

    /// Returns whether the first, the second and the remaining axis are right-handed.
    pub(super) fn is_cyclic(self) -> bool {
        let [first, second, _] = self.axes();
        second == (first + 1) % 3
    }

    /// Returns 1 if these axes are right-handed, otherwise −1.
    pub(super) fn sign<S: Scalar>(self) -> S {
        if self.is_cyclic() {
            S::one()
        } else {
            -S::one()
        }
    }
}

impl fmt::Display for EulerSequence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [first, second, third] = self.axes().map(|axis| ["x", "y", "z"][axis % 3]);
        write!(f, "{first}-{second}-{third}")
    }
}
