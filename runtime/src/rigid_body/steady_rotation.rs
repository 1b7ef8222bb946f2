//! Steady rotations about principal axes and their stability (3.8).

use crate::integrate::SingleNumber;
use crate::limits::rigid_bodies::EQUAL_MOMENTS;
use crate::linalg::largest;

/// The behaviour of a small perturbation of a steady rotation without a moment.
///
/// Perturbations of a free rotation never decay, since nothing takes their energy. A steady rotation is called stable
/// here if perturbations stay small. With dissipation inside the body, only the rotation about the axis of the largest
/// moment is stable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SteadyRotation<S = f64> {
    /// Stable: the moment is the least or the largest, and the angular velocity circles around the axis.
    Stable {
        /// The angular frequency of the perturbation in axes of the body, in rad over time.
        frequency: S,
    },
    /// Unstable, I₁ > I₃ > I₂ or I₂ > I₃ > I₁ (3.8): the moment is between the others, and perturbations grow as eʳᵗ.
    Unstable {
        /// The growth rate r.
        growth_rate: S,
    },
    /// The moment equals one of the others: a perturbation along the third axis persists, and causes the perturbation
    /// along the axis of the equal moment to grow in proportion to time.
    Drifting {
        /// The growth rate of this perturbation, in units of the persistent one.
        rate: S,
    },
    /// All moments are equal: the perturbed rotation is steady, too.
    Indifferent,
}

impl<S: SingleNumber> SteadyRotation<S> {
    /// Returns the steady rotations about the axes 1, 2 and 3 with this angular velocity, for principal moments I₁, I₂,
    /// I₃.
    ///
    /// If moments are equal, rotations about axes between their principal axes are steady, too, and of the same kind.
    /// Moments count as equal if they differ only by rounding.
    ///
    /// ```
    /// use lagrangian::rigid_body::SteadyRotation;
    ///
    /// // A tennis racket.
    /// let [handle, across, through] = SteadyRotation::about_axes([1.0, 2.0, 2.8], 5.0_f64);
    /// assert!(matches!(handle, SteadyRotation::Stable { .. }));
    /// let SteadyRotation::Unstable { growth_rate } = across else { unreachable!() };
    /// // Ω √((I₂ − I₁)(I₃ − I₂)/(I₁ I₃)).
    /// assert!((growth_rate - 5.0 * (0.8_f64 / 2.8).sqrt()).abs() < 1e-14);
    /// assert!(matches!(through, SteadyRotation::Stable { .. }));
    /// ```
    #[must_use]
    pub fn about_axes(moments: [S; 3], angular_velocity: S) -> [Self; 3] {
        let [first, second, third] = moments;
        [
            Self::about_third([second, third, first], angular_velocity),
            Self::about_third([third, first, second], angular_velocity),
            Self::about_third([first, second, third], angular_velocity),
        ]
    }

    /// Returns the steady rotation about axis 3. To first order, I₁ ω̇₁ = (I₂ − I₃) Ω ω₂ and I₂ ω̇₂ = (I₃ − I₁) Ω ω₁.
    fn about_third([first, second, third]: [S; 3], angular_velocity: S) -> Self {
        let largest = largest(&[first, second, third]);
        let zero_if_rounding = |difference: S| {
            let rounding = EQUAL_MOMENTS * S::machine_epsilon() * largest;
            if difference.abs().largest() <= rounding {
                S::zero()
            } else {
                difference
            }
        };
        // ω̇₁ = a Ω ω₂ and ω̇₂ = b Ω ω₁.
        let a = zero_if_rounding(second - third) / first;
        let b = zero_if_rounding(third - first) / second;
        let speed = angular_velocity.abs();
        match (sign(a), sign(b)) {
            (0, 0) => Self::Indifferent,
            (_, 0) => Self::Drifting {
                rate: a * angular_velocity,
            },
            (0, _) => Self::Drifting {
                rate: b * angular_velocity,
            },
            (of_a, of_b) if of_a == of_b => Self::Unstable {
                growth_rate: speed * (a * b).sqrt(),
            },
            _ => Self::Stable {
                frequency: speed * (-(a * b)).sqrt(),
            },
        }
    }

    /// Returns whether perturbations stay small.
    #[must_use]
    pub fn is_stable(&self) -> bool {
        matches!(self, Self::Stable { .. } | Self::Indifferent)
    }
}

/// Returns −1, 0 or 1.
fn sign<S: SingleNumber>(x: S) -> i8 {
    i8::from(x.largest() > 0.0) - i8::from(x.largest() < 0.0)
}
