//! Steady precession of a symmetric top (4.11).

use crate::integrate::SingleNumber;

/// The precession rates φ̇ at which a symmetric top keeps its inclination θ: the solutions of −I φ̇² sin θ cos θ +
/// `I_s` φ̇ ω₃ sin θ + dV/dθ = 0 (4.11).
///
/// The component ω₃ of the angular velocity along the axis is given, which is a constant of the motion, not ψ̇. The
/// motion is steady if in addition θ̇ = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SteadyPrecession<S = f64> {
    /// No solution: the top spins too slowly to stay at an inclination above the horizontal.
    None {
        /// The discriminant (`I_s` ω₃ sin θ)² + 4 I sin θ cos θ dV/dθ, which is negative.
        discriminant: S,
        /// The least magnitude of ω₃ for which there is a solution at this inclination; infinite if there is none for
        /// any ω₃.
        least_axial_velocity: S,
    },
    /// One solution: the axis is horizontal.
    One {
        /// The precession rate φ̇.
        rate: S,
    },
    /// Two solutions, which coincide for the least spin for which there are any.
    Two {
        /// The rate of smaller magnitude, about m g l/(`I_s` ω₃) for a fast top.
        slow: S,
        /// The rate of greater magnitude, about `I_s` ω₃/(I cos θ).
        fast: S,
    },
    /// Any rate: the axis is vertical, or the axis is horizontal and nothing acts on a top without spin.
    Any,
}

impl<S: SingleNumber> SteadyPrecession<S> {
    /// Returns the steady precessions of a top at an inclination θ from the vertical.
    ///
    /// The moments of inertia about the fixed point are the transverse I and the axial `I_s`; the slope dV/dθ of the
    /// potential energy is −m g l sin θ for a weight. Both solutions are accurate to all digits, since the slow one is
    /// computed from the product of both.
    ///
    /// ```
    /// use lagrangian::rigid_body::SteadyPrecession;
    ///
    /// let (i, i_s, mgl) = (1.2, 0.5, 5.1);
    /// let (spin, theta) = (40.0, 0.5_f64);
    /// let slope = -mgl * theta.sin();
    /// let precession = SteadyPrecession::of_top(i, i_s, spin, theta, slope);
    /// let SteadyPrecession::Two { slow, fast } = precession else { unreachable!() };
    /// for rate in [slow, fast] {
    ///     let sum = -i * rate * rate * theta.cos() + i_s * rate * spin - mgl;
    ///     assert!(sum.abs() < 1e-12);
    /// }
    /// ```
    #[must_use]
    pub fn of_top(
        transverse: S,
        axial: S,
        axial_velocity: S,
        inclination: S,
        potential_slope: S,
    ) -> Self {
        let (sine, cosine) = inclination.sin_cos();
        let quadratic = transverse * sine * cosine;
        let linear = axial * axial_velocity * sine;
        let is_zero = |x: S| x.abs().largest() <= 0.0;
        // The lower bound for (I_s ω₃ sin θ)².
        let least = S::from_f64(-4.0) * quadratic * potential_slope;
        let discriminant = linear * linear - least;
        let reach = (axial * sine).abs();
        let none = Self::None {
            discriminant,
            least_axial_velocity: if is_zero(reach) {
                S::from_f64(f64::INFINITY)
            } else {
                least.sqrt() / reach
            },
        };
        if discriminant.largest() < 0.0 {
            return none;
        }
        let root = discriminant.sqrt();
        let signed = if linear.largest() < 0.0 { -root } else { root };
        let half = (linear + signed) * S::from_f64(0.5);
        match (is_zero(quadratic), is_zero(half)) {
            (true, true) if is_zero(potential_slope) => Self::Any,
            (true, true) => none,
            (true, false) => Self::One {
                rate: -potential_slope / half,
            },
            (false, true) => {
                let [slow, fast] = [S::zero(); 2];
                Self::Two { slow, fast }
            }
            (false, false) => Self::Two {
                slow: -potential_slope / half,
                fast: half / quadratic,
            },
        }
    }
}
