//! The symmetric top, i1 = i2 = I, and its steady precession (4.11).

use crate::model::HeavyTop;

/// A heavy top that is symmetric about the axis on which its centre of mass lies.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SymmetricTop {
    /// The moment of inertia I across the axis, about the pivot, in kg m².
    pub(crate) transverse: f64,
    /// The moment of inertia `I_s` about the axis, in kg m².
    pub(crate) axial: f64,
    /// Weight times arm, m g l ≥ 0, in N m.
    pub(crate) moment: f64,
}

impl SymmetricTop {
    /// The top as a symmetric one, if it is one.
    pub(crate) fn of(top: &HeavyTop) -> Option<Self> {
        top.i1.total_cmp(&top.i2).is_eq().then_some(Self {
            transverse: top.i1,
            axial: top.i3,
            moment: top.m * top.g * top.l,
        })
    }

    /// The precession rates at which the tilt stays as it is (4.11), the slow one first, in rad/s.
    /// None if ω₃ is too small; only one where the axis is horizontal.
    pub(crate) fn steady_precession(&self, tilt: f64, axial_rate: f64) -> Vec<f64> {
        let momentum = self.axial * axial_rate;
        let leading = 2.0 * self.transverse * tilt.cos();
        let discriminant = momentum * momentum - 2.0 * leading * self.moment;
        // A sum of terms of one sign; the slow root follows from the product of both.
        let sum = momentum + discriminant.sqrt().copysign(momentum);
        let mut rates = vec![2.0 * self.moment / sum];
        // At 90° the cosine is a rounding error, and the fast precession infinite.
        if leading.abs() > 1e-14 * self.transverse {
            rates.push(sum / leading);
        }
        // Without a real root the square root is not a number.
        rates.retain(|rate| rate.is_finite());
        rates
    }

    /// The least |ω₃| with which a steady precession exists at this tilt, in rad/s.
    pub(crate) fn least_axial_rate(&self, tilt: f64) -> f64 {
        2.0 / self.axial * (self.transverse * self.moment * tilt.cos()).max(0.0).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::SymmetricTop;
    use crate::close;

    #[test]
    fn steady_precession_roots() {
        let top = SymmetricTop {
            transverse: 0.4,
            axial: 0.25,
            moment: 3.5316,
        };
        let rates = top.steady_precession(0.6, 18.0);
        // Expected values: mpmath at 30 digits.
        close(rates[0], 0.836_083_461_238_540_5, 1e-15);
        close(rates[1], 12.794_735_077_025_022, 1e-15);
        close(top.least_axial_rate(0.6), 8.638_155_740_373_32, 1e-15);
        assert!(top.steady_precession(0.6, 8.638).is_empty());
        let mirrored = top.steady_precession(0.6, -18.0);
        assert_eq!(mirrored, [-rates[0], -rates[1]]);
    }

    #[test]
    fn steady_precession_of_the_horizontal_axis_has_one_root() {
        let top = SymmetricTop {
            transverse: 1.0,
            axial: 2.0,
            moment: 2.0,
        };
        let rates = top.steady_precession(90_f64.to_radians(), 3.0);
        assert_eq!(rates.len(), 1);
        close(rates[0], 1.0 / 3.0, 1e-15);
    }

    #[test]
    fn steady_precession_without_spin_is_the_conical_pendulum() {
        let top = SymmetricTop {
            transverse: 0.4,
            axial: 0.25,
            moment: 3.5316,
        };
        let rates = top.steady_precession(2.0, 0.0);
        close(rates[0], (3.5316 / (0.4 * -2_f64.cos())).sqrt(), 1e-15);
        close(rates[1], -rates[0], 1e-15);
    }
}
