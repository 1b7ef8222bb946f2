//! Steady precession of a symmetric top (4.11).

use crate::integrate::SingleNumber;

/// The precession rates φ̇ at which a symmetric top keeps its inclination θ, that is, the solutions of
/// −I φ̇² sin θ cos θ + `I_s` φ̇ ω₃ sin θ + dV/dθ = 0 (4.11).
///
/// The component ω₃ of the angular velocity along the axis is given, which is a constant of the motion, not ψ̇. The top is
/// steady if θ̇ = 0 besides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SteadyPrecession<S = f64> {
    /// None: the top spins too slowly to stay at an inclination above the horizontal.
    None {
        /// The discriminant (`I_s` ω₃ sin θ)² + 4 I sin θ cos θ dV/dθ, which is negative.
        discriminant: S,
        /// The least magnitude of ω₃ with which there is one at this inclination; infinite where there is none with any.
        least_axial_velocity: S,
    },
    /// One: the axis is horizontal.
    One {
        /// φ̇.
        rate: S,
    },
    /// Two; the same one twice for the least spin at which there is any.
    Two {
        /// That of the smaller magnitude, about m g l/(`I_s` ω₃) for a fast top.
        slow: S,
        /// That of the greater magnitude, about `I_s` ω₃/(I cos θ).
        fast: S,
    },
    /// Any: the axis is vertical or nothing acts on a top without spin whose axis is horizontal.
    Any,
}

impl<S: SingleNumber> SteadyPrecession<S> {
    /// Those of a top with these moments of inertia about the fixed point, transverse I and axial `I_s`, at an inclination
    /// θ from the vertical where the potential energy has the slope dV/dθ: −m g l sin θ for a weight.
    ///
    /// Both solutions have all digits: the slow one is found from the product of both.
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
        // (I_s ω₃ sin θ)² has to be at least as large.
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
