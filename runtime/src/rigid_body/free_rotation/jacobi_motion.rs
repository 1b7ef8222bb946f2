//! Free rotations by Jacobi's elliptic functions, in principal axes.
//!
//! Axes are numbered so that I₂ is the middle moment and the angular velocity circles around axis 3: I₁ < I₂ < I₃ if
//! L² > 2 E I₂, and I₁ > I₂ > I₃ otherwise. Then ω₁ = A₁ cn τ, ω₂ = A₂ sn τ, ω₃ = A₃ dn τ with τ = τ₀ + σ t.

use nalgebra::{Matrix3, Rotation3, Vector3};

use crate::elliptic::{Modulus, sign};
use crate::integrate::SingleNumber;
use crate::rigid_body::order::{is_less, length};
use crate::rotation::{EulerAngles, EulerSequence, components, product};

/// A motion whose angular velocity circles around principal axis 3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct JacobiMotion<S> {
    moments: [S; 3],
    /// A₁, A₂, A₃ with their signs.
    amplitudes: [S; 3],
    modulus: Modulus<S>,
    /// The initial argument τ₀.
    phase: S,
    /// The frequency σ.
    frequency: S,
    /// The angular momentum L.
    momentum: S,
    /// The inverse quaternion of the orientation at time 0, in axes with **L** along the third.
    initial_inverse: [S; 4],
}

impl<S: SingleNumber> JacobiMotion<S> {
    /// Creates the motion with ascending moments and the given components of the angular velocity along principal axes,
    /// whose orientation in the body is given. Also returns the orientation of the axes as they are renumbered here.
    pub(super) fn new(
        [i1, i2, i3]: [S; 3],
        omega: &Vector3<S>,
        axes: &Rotation3<S>,
    ) -> (Self, Rotation3<S>) {
        // L² − 2 E I₂.
        let above = i3 * (i3 - i2) * omega.z * omega.z;
        let below = i1 * (i2 - i1) * omega.x * omega.x;
        if is_less(above, below) {
            // Axes 3, −2 and 1.
            let [zero, one] = [S::zero(), S::one()];
            let renumbered = Matrix3::new(zero, zero, one, zero, -one, zero, one, zero, zero);
            let axes = Rotation3::from_matrix_unchecked(axes.matrix() * renumbered);
            let omega = renumbered.tr_mul(omega);
            return (Self::about_third([i3, i2, i1], &omega, below - above), axes);
        }
        (Self::about_third([i1, i2, i3], omega, above - below), *axes)
    }

    /// Creates the motion about axis 3, given |L² − 2 E I₂|.
    fn about_third([i1, i2, i3]: [S; 3], omega: &Vector3<S>, to_middle: S) -> Self {
        let [d12, d13, d23] = [(i2 - i1).abs(), (i3 - i1).abs(), (i3 - i2).abs()];
        // √|2 E I₃ − L²| and √|L² − 2 E I₁|, as sums of terms of one sign.
        let [x, y, z]: [S; 3] = (*omega).into();
        let zero = S::zero();
        let root = |a: S, b: S| length(&Vector3::new(a, b, zero));
        let to_third = root((i1 * d13).sqrt() * x, (i2 * d23).sqrt() * y);
        let to_first = root((i2 * d12).sqrt() * y, (i3 * d13).sqrt() * z);
        let ratio = to_third / to_first;
        let modulus = Modulus::new(
            d12 / d23 * ratio * ratio,
            d13 * to_middle / (d23 * to_first * to_first),
        );
        let [of_first, of_third] = [sign(omega.x), sign(omega.z)];
        let of_second = of_first * of_third * sign(i3 - i1);
        let amplitudes = [
            of_first * to_third / (i1 * d13).sqrt(),
            of_second * to_third / (i2 * d23).sqrt(),
            of_third * to_first / (i3 * d13).sqrt(),
        ];
        let [cosine, sine] = [omega.x / amplitudes[0], omega.y / amplitudes[1]];
        let norm = (cosine * cosine + sine * sine).sqrt();
        let [cosine, sine] = [cosine / norm, sine / norm];
        let momentum = length(&Vector3::new(i1 * omega.x, i2 * omega.y, i3 * omega.z));
        let motion = Self {
            moments: [i1, i2, i3],
            amplitudes,
            modulus,
            phase: modulus.first(sine, cosine),
            frequency: to_first * (d23 / (i1 * i2 * i3)).sqrt(),
            momentum,
            initial_inverse: [S::one(), S::zero(), S::zero(), S::zero()],
        };
        // The orientation at time 0 is the origin.
        let [w, x, y, z] = motion.about_momentum(S::zero());
        Self {
            initial_inverse: [w, -x, -y, -z],
            ..motion
        }
    }

    /// Returns the angular velocity along the principal axes.
    pub(super) fn angular_velocity(&self, time: S) -> Vector3<S> {
        let (sn, cn, dn) = self.modulus.jacobi(self.argument(time));
        let [a, b, c] = self.amplitudes;
        Vector3::new(a * cn, b * sn, c * dn)
    }

    /// Returns the orientation at a time relative to the orientation at time 0, as a quaternion.
    pub(super) fn turned(&self, time: S) -> [S; 4] {
        product(&self.initial_inverse, &self.about_momentum(time))
    }

    /// Returns 2 K/σ.
    pub(super) fn half_period(&self) -> Option<S> {
        let half = self.modulus.complete_first() * S::from_f64(2.0) / self.frequency;
        half.is_finite().then_some(half)
    }

    fn argument(&self, time: S) -> S {
        self.phase + self.frequency * time
    }

    /// Returns the characteristic n of the integral of the third kind, at most 0.
    fn characteristic(&self) -> S {
        let [i1, i2, i3] = self.moments;
        -i3 * (i2 - i1) / (i1 * (i3 - i2))
    }

    /// Returns the orientation R = Rz(φ) Rx(θ) Rz(ψ) in axes whose third is along **L**, as a quaternion.
    ///
    /// **L** has the components L (sin θ sin ψ, sin θ cos ψ, cos θ) in the body. φ̇ = (2 E − I₃ω₃²) L/(L² − I₃²ω₃²) is
    /// the sum of the constant L/I₃ and of L (I₃ − I₁)/(I₁I₃ (1 − n sn²τ)).
    fn about_momentum(&self, time: S) -> [S; 4] {
        let [i1, i2, i3] = self.moments;
        let (sn, cn, dn) = self.modulus.jacobi(self.argument(time));
        let [a, b, c] = self.amplitudes;
        let [l1, l2, l3] = [i1 * a * cn, i2 * b * sn, i3 * c * dn];
        let theta = (l1 * l1 + l2 * l2).sqrt().atan2(l3);
        // The ratio of the amplitudes is known even where they vanish.
        let across = sign(a) * (i1 / (i3 - i1).abs()).sqrt() * cn;
        let along = sign(b) * (i2 / (i3 - i2).abs()).sqrt() * sn;
        let psi = across.atan2(along);
        // The frequency and the integral are both small where the motion of the angular velocity is slow.
        let third =
            self.modulus
                .third_between(self.characteristic(), self.phase, self.frequency * time);
        let anomaly = (i3 - i1) / (i1 * self.frequency) * third;
        let phi = self.momentum / i3 * (time + anomaly);
        let angles = EulerAngles::new(EulerSequence::Zxz, [phi, theta, psi]);
        components(&angles.quaternion())
    }
}
