//! The model: a rigid body that turns about a fixed pivot under its weight.

use lagrangian::prelude::*;
use lagrangian::rigid_body::{Nutation, SteadyPrecession};

/// A heavy top, pinned at a fixed point, in z-x-z Euler angles; its centre of mass lies on the third
/// principal axis.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(
        // The angular velocity in principal axes (4.4).
        w1 = dot(phi) * sin(theta) * sin(psi) + dot(theta) * cos(psi),
        w2 = dot(phi) * sin(theta) * cos(psi) - dot(theta) * sin(psi),
        w3 = dot(phi) * cos(theta) + dot(psi),
    ),
    // (4.5)
    kinetic = 0.5 * (i1 * w1.powi(2) + i2 * w2.powi(2) + i3 * w3.powi(2)),
    potential = m * g * l * cos(theta),
    event(turn = dot(theta)),
    taylor,
)]
pub(crate) struct HeavyTop {
    /// First principal moment of inertia about the pivot in kg m².
    pub(crate) i1: f64,
    /// Second principal moment of inertia about the pivot in kg m².
    pub(crate) i2: f64,
    /// Third principal moment of inertia in kg m².
    pub(crate) i3: f64,
    /// Mass in kg.
    pub(crate) m: f64,
    /// Acceleration of gravity in m/s².
    pub(crate) g: f64,
    /// Distance from the pivot to the centre of mass in m.
    pub(crate) l: f64,
}

impl HeavyTop {
    /// Whether it is symmetric about the axis on which its centre of mass lies.
    pub(crate) fn is_symmetric(&self) -> bool {
        self.i1.total_cmp(&self.i2).is_eq()
    }

    /// The nutation from a state in closed form, if the top is symmetric and its tilt has a period.
    pub(crate) fn nutation(&self, start: &State<f64, 3>) -> Option<Nutation> {
        let (weight, tilt) = (self.m * self.g * self.l, start.q[Self::THETA]);
        let nutation = Nutation::of_top(self.i1, self.i3, weight, tilt, start.v.into());
        nutation.filter(|_| self.is_symmetric())
    }

    /// The precession rates at which a symmetric top keeps its tilt (4.11), with `axial_rate` ω₃.
    pub(crate) fn steady_precession(&self, tilt: f64, axial_rate: f64) -> SteadyPrecession {
        let slope = -self.m * self.g * self.l * tilt.sin();
        match SteadyPrecession::of_top(self.i1, self.i3, axial_rate, tilt, slope) {
            // At 90° the cosine is a rounding error, and the fast precession infinite.
            SteadyPrecession::Two { slow: rate, .. } if tilt.cos().abs() < 1e-14 => {
                SteadyPrecession::One { rate }
            }
            precession => precession,
        }
    }
}

#[cfg(test)]
mod tests {
    use lagrangian::rigid_body::SteadyPrecession;

    use super::HeavyTop;
    use crate::tests::close;

    /// The symmetric top with the moments of inertia I and `I_s` and the moment m g l of its weight.
    fn symmetric(transverse: f64, axial: f64, moment: f64) -> HeavyTop {
        HeavyTop {
            i1: transverse,
            i2: transverse,
            i3: axial,
            m: moment,
            g: 1.0,
            l: 1.0,
        }
    }

    /// The slow and the fast precession.
    fn rates(top: &HeavyTop, tilt: f64, axial_rate: f64) -> [f64; 2] {
        match top.steady_precession(tilt, axial_rate) {
            SteadyPrecession::Two { slow, fast } => [slow, fast],
            other => panic!("two rates, not {other:?}"),
        }
    }

    #[test]
    fn steady_precession_roots() {
        let top = symmetric(0.4, 0.25, 3.5316);
        let [slow, fast] = rates(&top, 0.6, 18.0);
        // Expected values: mpmath at 30 digits.
        close(slow, 0.836_083_461_238_540_5, 1e-15);
        close(fast, 12.794_735_077_025_022, 1e-15);
        let SteadyPrecession::None {
            least_axial_velocity: least,
            ..
        } = top.steady_precession(0.6, 8.638)
        else {
            panic!("it spins too slowly");
        };
        close(least, 8.638_155_740_373_32, 1e-15);
        let mirrored = rates(&top, 0.6, -18.0);
        close(mirrored[0], -slow, 0.0);
        close(mirrored[1], -fast, 0.0);
    }

    #[test]
    fn steady_precession_of_the_horizontal_axis_has_one_root() {
        let top = symmetric(1.0, 2.0, 2.0);
        let SteadyPrecession::One { rate } = top.steady_precession(90_f64.to_radians(), 3.0) else {
            panic!("one rate");
        };
        close(rate, 1.0 / 3.0, 1e-15);
    }

    #[test]
    fn steady_precession_without_spin_is_the_conical_pendulum() {
        let top = symmetric(0.4, 0.25, 3.5316);
        let [slow, fast] = rates(&top, 2.0, 0.0);
        close(slow, (3.5316 / (0.4 * -2_f64.cos())).sqrt(), 1e-15);
        close(fast, -slow, 1e-15);
    }
}
