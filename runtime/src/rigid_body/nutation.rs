//! The nutation of a heavy symmetric top in closed form.
//!
//! H. Goldstein, C. Poole & J. Safko, *Classical Mechanics*, 3rd edition (2002), § 5.7: by the momenta (4.8) and the
//! energy (4.10), u = cos θ obeys u̇² = f(u) with a cubic f, so that u is a quadratic function of Jacobi's sn, and φ an
//! integral of the third kind. Roots are measured from the initial inclination, u = u₀ + δ, or from the vertical, 1 ∓
//! u, whichever is nearer, and only β times the third root is used. Small differences therefore stay accurate near a
//! steady precession and near the vertical, and a top without weight (β = 0) is not a special case.

mod cubic;

use crate::elliptic::{Modulus, carlson_rj};
use crate::limits::rigid_bodies::VERTICAL;
use crate::scalar::Scalar;

use cubic::{polished_root, roots_around_zero};

/// The nutation of a heavy symmetric top, a body that turns about a fixed point on its axis of symmetry: cos θ = u₁ +
/// (u₂ − u₁) sn²(ω t + τ₀ | m).
///
/// The state at any time takes one evaluation. Angles are in rad, in the order precession, nutation and spin (4.4); θ
/// is the inclination of the axis from the upward vertical.
///
/// ```
/// use lagrangian::rigid_body::Nutation;
///
/// // A top that is let go at 0.5 rad: it falls from a cusp, and rises to it again after each period.
/// let [i, i_s, mgl, spin] = [1.2, 0.5, 5.1, 40.0];
/// let top = Nutation::of_top(i, i_s, mgl, 0.5, [0.0, 0.0, spin]).ok_or("its axis reaches the vertical")?;
/// assert!((top.least_inclination() - 0.5).abs() < 1e-15);
/// assert!((top.inclination_at(top.period()) - 0.5).abs() < 1e-14);
/// // On average it precesses about as fast as in the slow steady precession (4.11).
/// let mean = top.precession() / top.period();
/// assert!((mean / (mgl / (i_s * spin)) - 1.0).abs() < 0.02);
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nutation {
    /// 1 − u₂, at the least inclination.
    above: f64,
    /// 1 + u₁, at the greatest inclination.
    below: f64,
    /// u₂ − u₁.
    span: f64,
    /// The frequency ω.
    rate: f64,
    /// The initial argument τ₀.
    phase: f64,
    /// The modulus, with the parameter m.
    modulus: Modulus,
    /// b − a and b + a with a = `C_ψ`/I and b = `C_φ`/I.
    momenta: [f64; 2],
}

impl Nutation {
    /// Returns the nutation of a top that starts from an inclination θ at time 0 with the rates φ̇, θ̇ and ψ̇.
    ///
    /// The moments of inertia about the fixed point are the transverse I and the axial `I_s`; the weight m g l is not
    /// negative. For a centre of gravity below the fixed point, let θ exceed ½π.
    ///
    /// Returns `None` if θ has no period: if the axis reaches the vertical, from which it need not return, or if
    /// nothing moves it. Also returns `None` if a number is not finite, a moment of inertia is not positive, or the
    /// weight is negative.
    #[must_use]
    pub fn of_top(
        transverse: f64,
        axial: f64,
        weight: f64,
        inclination: f64,
        rates: [f64; 3],
    ) -> Option<Self> {
        let [precession, nutation, spin] = rates;
        let (sine, cosine) = Scalar::sin_cos(inclination);
        let half_angle = Scalar::sin_cos(0.5 * inclination);
        // 1 − u₀ and 1 + u₀, without cancellation.
        let upper = 2.0 * square(half_angle.0);
        let lower = 2.0 * square(half_angle.1);
        let a = axial * (spin + precession * cosine) / transverse;
        let beta = 2.0 * weight / transverse;
        let swing = square(nutation) + square(precession * sine);
        if ![a, swing].iter().all(|x| x.is_finite()) || !is_top([transverse, axial], weight) {
            return None;
        }
        let momenta = [-upper, lower].map(|end| precession * square(sine) + a * end);
        // u̇² = f(u₀ + δ) = speed + slope δ + bend δ² + β δ³; the expression in parentheses in the slope is (4.11).
        let speed = square(sine * nutation);
        let slope = square(sine) * (2.0 * precession * (a - precession * cosine) - beta)
            - 2.0 * cosine * square(nutation);
        let bend = 2.0 * beta * cosine - swing - a * a;
        let [fall, rise] = roots_around_zero([speed, slope, bend, beta], [-lower, upper]);
        let constants = [swing, beta, a];
        let above = from_vertical(1.0, constants, upper, rise, momenta[0]);
        let below = from_vertical(-1.0, constants, lower, -fall, momenta[1]);
        let span = rise - fall;
        // β (u₃ − u₁) and β (u₃ − u₂), by the sum of the roots.
        let fastest = -bend - beta * (2.0 * fall + rise);
        let rest = -bend - beta * (fall + 2.0 * rise);
        let modulus = Modulus::new(beta * span / fastest, rest / fastest);
        // The argument from 0 to K(m) at which sn² : cn² = −fall : rise; any argument will do if the inclination is
        // steady.
        let part = |way: f64| {
            if span > 0.0 {
                Scalar::sqrt(way / span)
            } else {
                1.0
            }
        };
        let phase = modulus.first(part(-fall), part(rise));
        let has_period = modulus.complement() > 0.0 && above > VERTICAL && below > VERTICAL;
        has_period.then(|| Self {
            above,
            below,
            span,
            rate: 0.5 * Scalar::sqrt(fastest),
            phase: phase.copysign(-nutation),
            modulus,
            momenta,
        })
    }

    /// Returns the least θ.
    #[must_use]
    pub fn least_inclination(&self) -> f64 {
        self.inclination(1.0, 0.0)
    }

    /// Returns the greatest θ.
    #[must_use]
    pub fn greatest_inclination(&self) -> f64 {
        self.inclination(0.0, 1.0)
    }

    /// Returns the time from one least θ to the next, 2 K(m)/ω.
    #[must_use]
    pub fn period(&self) -> f64 {
        2.0 * self.modulus.complete_first() / self.rate
    }

    /// Returns the angle by which φ grows in a period.
    #[must_use]
    pub fn precession(&self) -> f64 {
        let (lowest, highest) = (self.below + self.span, self.above + self.span);
        let [minus, plus] = self.momenta;
        // The characteristics are n = (u₂ − u₁)/(1 − u₁) and n = −(u₂ − u₁)/(1 + u₁).
        let upper = minus / highest * complete_third(self.above / highest, &self.modulus);
        let lower = plus / self.below * complete_third(lowest / self.below, &self.modulus);
        (upper + lower) / self.rate
    }

    /// Returns θ at a time after the start, or before it if the time is negative.
    #[must_use]
    pub fn inclination_at(&self, time: f64) -> f64 {
        // Whole periods are subtracted first, since they would only cost accuracy.
        let period = 2.0 * self.modulus.complete_first();
        let argument = (self.rate * time) % period + self.phase;
        let (sn, cn, _) = self.modulus.jacobi(argument);
        self.inclination(sn, cn)
    }

    /// Returns θ for given values of sn and cn, from half angles, which are accurate near the vertical.
    fn inclination(&self, sn: f64, cn: f64) -> f64 {
        let upper = self.above + self.span * cn * cn;
        let lower = self.below + self.span * sn * sn;
        2.0 * Scalar::atan2(Scalar::sqrt(upper), Scalar::sqrt(lower))
    }
}

/// Returns the distance of a turning point from the vertical: upwards for the sign 1, downwards for −1.
///
/// `way` is how much nearer the turning point is to the vertical than the start is. If it is nearer to the vertical
/// than to the start, the root of the cubic is measured from the vertical.
fn from_vertical(sign: f64, constants: [f64; 3], start: f64, way: f64, momentum: f64) -> f64 {
    if way < 0.5 * start {
        return start - way;
    }
    let [swing, beta, a] = constants;
    let energy = swing - sign * beta * start;
    let slope = 2.0 * (energy - sign * a * momentum);
    let bend = 2.0 * sign * beta - energy - a * a;
    polished_root([-square(momentum), slope, bend, -sign * beta], start - way)
}

fn square(x: f64) -> f64 {
    x * x
}

/// Returns whether a top with these numbers exists.
fn is_top(moments: [f64; 2], weight: f64) -> bool {
    let are_positive = moments.iter().all(|x| *x > 0.0 && x.is_finite());
    are_positive && weight >= 0.0 && weight.is_finite()
}

/// Returns the complete integral of the third kind Π(n|m), given `complement` = 1 − n > 0, which may be small or large:
/// near n = 1, n itself would not determine it accurately.
fn complete_third(complement: f64, modulus: &Modulus) -> f64 {
    let (m, rest) = (modulus.parameter(), modulus.complement());
    let first = modulus.complete_first();
    if complement > 2.0 {
        // For negative n the terms cancel; with N = (m − n)/(1 − n) all are positive.
        let weight = m + complement - 1.0;
        let third = complete_third(rest / complement, modulus);
        return (complement - 1.0) * rest / (complement * weight) * third + m / weight * first;
    }
    first + (1.0 - complement) / 3.0 * carlson_rj(0.0, rest, 1.0, complement)
}

#[cfg(test)]
mod tests {
    use super::complete_third;
    use crate::elliptic::Modulus;

    /// Compares with values of mpmath at 30 digits.
    #[test]
    fn complete_integrals_of_the_third_kind_by_their_complement() {
        for (n, m, expected) in [
            (0.5, 0.3, 2.461_255_352_272_422_3),
            (-2.0, 0.75, 1.139_293_797_107_275_4),
            (0.2, 0.6, 2.207_471_843_841_303_5),
            (0.99, 0.1, 16.477_578_238_044_92),
            (-5000.0, 0.3, 0.022_265_230_070_180_928),
            (0.0, 0.5, 1.854_074_677_301_371_9),
            (-0.3, 0.999, 3.934_766_841_844_367),
        ] {
            let found = complete_third(1.0 - n, &Modulus::new(m, 1.0 - m));
            assert!(
                (found / expected - 1.0).abs() < 4e-15,
                "Π({n}|{m}) = {found}"
            );
        }
    }
}
