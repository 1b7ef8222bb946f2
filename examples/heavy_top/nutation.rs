//! The nutation of the symmetric top in closed form.
//!
//! By the constants (4.8) and the energy (4.10), u = cos θ obeys u̇² = f(u) with a cubic f, so that θ
//! is an elliptic function of the time. Roots are measured from the initial tilt, u = u₀ + δ, or from
//! the vertical, 1 ∓ u, whichever is nearer, and only β times the third root is used: what is a small
//! difference stays accurate near a steady precession and near the vertical, and a top without weight
//! (β = 0) is no special case.

use lagrangian::State;
use lagrangian::elliptic::{Modulus, carlson_rj};

use crate::cubic::{polished_root, roots_around_zero};
use crate::model::HeavyTop;

/// The least 1 ∓ cos θ that means anything: at a tilt of some 10⁻¹² rad the rounding of the initial
/// state decides on which side the axis passes the vertical.
const VERTICAL: f64 = 1e-24;

/// What a whole nutation does.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cycle {
    /// The least and the greatest tilt in rad.
    pub(crate) least_tilt: f64,
    pub(crate) greatest_tilt: f64,
    /// The angle in rad by which φ grows.
    pub(crate) precession: f64,
    /// The period in s.
    pub(crate) period: f64,
}

/// A nutation in closed form: cos θ = u₁ + (u₂ − u₁) sn²(ω t + τ₀ | m).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Nutation {
    /// 1 − u₂ at the least tilt.
    above: f64,
    /// 1 + u₁ at the greatest tilt.
    below: f64,
    /// u₂ − u₁.
    span: f64,
    /// ω, in 1/s.
    rate: f64,
    /// τ₀.
    phase: f64,
    /// m.
    modulus: Modulus,
    /// b − a and b + a with a = `C_ψ`/I and b = `C_φ`/I, in rad/s.
    momenta: [f64; 2],
}

impl Nutation {
    /// The nutation of `top` through `state`. None if the top is not symmetric, or the tilt has no period: where the axis
    /// reaches the vertical, from which it need not return, or where nothing moves it.
    pub(crate) fn through(top: &HeavyTop, state: &State<f64, 3>) -> Option<Self> {
        let (tilt, [precession, nutation, spin]) = (state.q[HeavyTop::THETA], state.v.into());
        let (sine, cosine) = tilt.sin_cos();
        // 1 − u₀ and 1 + u₀, without cancellation.
        let upper = 2.0 * (0.5 * tilt).sin().powi(2);
        let lower = 2.0 * (0.5 * tilt).cos().powi(2);
        let a = top.i3 * (spin + precession * cosine) / top.i1;
        let beta = 2.0 * top.m * top.g * top.l / top.i1;
        let swing = nutation.powi(2) + (precession * sine).powi(2);
        let momenta = [-upper, lower].map(|end| precession * sine.powi(2) + a * end);
        // u̇² = f(u₀ + δ) = speed + slope δ + bend δ² + β δ³; what slope has in brackets is (4.11).
        let speed = (sine * nutation).powi(2);
        let slope = sine.powi(2) * (2.0 * precession * (a - precession * cosine) - beta)
            - 2.0 * cosine * nutation.powi(2);
        let bend = 2.0 * beta * cosine - swing - a * a;
        let [fall, rise] = roots_around_zero([speed, slope, bend, beta], [-lower, upper]);
        // How far a turning point is from the vertical, on the way to which it lies; by the root of the cubic that is measured
        // from the vertical where it is nearer than the start.
        let from_vertical = |sign: f64, start: f64, way: f64, momentum: f64| {
            let energy = swing - sign * beta * start;
            let slope = 2.0 * (energy - sign * a * momentum);
            let bend = 2.0 * sign * beta - energy - a * a;
            if way < 0.5 * start {
                return start - way;
            }
            polished_root([-momentum.powi(2), slope, bend, -sign * beta], start - way)
        };
        let above = from_vertical(1.0, upper, rise, momenta[0]);
        let below = from_vertical(-1.0, lower, -fall, momenta[1]);
        let span = rise - fall;
        // β (u₃ − u₁) and β (u₃ − u₂), by the sum of the roots.
        let square = -bend - beta * (2.0 * fall + rise);
        let rest = -bend - beta * (fall + 2.0 * rise);
        let modulus = Modulus::new(beta * span / square, rest / square);
        // The argument from 0 to K(m) at which sn² : cn² = −fall : rise, any where the tilt is steady.
        let part = |way: f64| if span > 0.0 { (way / span).sqrt() } else { 1.0 };
        let phase = modulus.first(part(-fall), part(rise));
        let has_period = modulus.complement() > 0.0 && above > VERTICAL && below > VERTICAL;
        (top.is_symmetric() && has_period).then(|| Self {
            above,
            below,
            span,
            rate: 0.5 * square.sqrt(),
            phase: phase.copysign(-nutation),
            modulus,
            momenta,
        })
    }

    /// A whole nutation. The period is 2 K(m) / ω.
    pub(crate) fn cycle(&self) -> Cycle {
        let (lowest, highest) = (self.below + self.span, self.above + self.span);
        let [minus, plus] = self.momenta;
        // The characteristics are n = (u₂ − u₁)/(1 − u₁) and n = −(u₂ − u₁)/(1 + u₁).
        let upper = minus / highest * complete_third(self.above / highest, &self.modulus);
        let lower = plus / self.below * complete_third(lowest / self.below, &self.modulus);
        Cycle {
            least_tilt: self.tilt(1.0, 0.0),
            greatest_tilt: self.tilt(0.0, 1.0),
            precession: (upper + lower) / self.rate,
            period: 2.0 * self.modulus.complete_first() / self.rate,
        }
    }

    /// The tilt in rad at time `t` in s after the start.
    pub(crate) fn tilt_at(&self, t: f64) -> f64 {
        // Whole periods are taken off first: they would only cost digits.
        let period = 2.0 * self.modulus.complete_first();
        let (sn, cn, _) = self.modulus.jacobi((self.rate * t) % period + self.phase);
        self.tilt(sn, cn)
    }

    /// The tilt in rad where sn and cn have these values. From half angles: accurate near the vertical.
    fn tilt(&self, sn: f64, cn: f64) -> f64 {
        let upper = self.above + self.span * cn * cn;
        let lower = self.below + self.span * sn * sn;
        2.0 * upper.sqrt().atan2(lower.sqrt())
    }
}

/// The complete integral of the third kind Π(n|m), given `complement` = 1 − n > 0, which may be small or large: near 1, n itself
/// would have lost its digits.
fn complete_third(complement: f64, modulus: &Modulus) -> f64 {
    let (m, rest) = (modulus.parameter(), modulus.complement());
    let first = modulus.complete_first();
    if complement > 2.0 {
        // For negative n its terms cancel; with N = (m − n)/(1 − n) all are positive.
        let weight = m + complement - 1.0;
        let third = complete_third(rest / complement, modulus);
        return (complement - 1.0) * rest / (complement * weight) * third + m / weight * first;
    }
    first + (1.0 - complement) / 3.0 * carlson_rj(0.0, rest, 1.0, complement)
}

#[cfg(test)]
mod tests;
