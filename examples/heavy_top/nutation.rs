//! The nutation of the symmetric top in closed form.
//!
//! By the constants (4.8) and the energy (4.10), u = cos θ obeys u̇² = f(u) with a cubic f, so that θ
//! is an elliptic function of the time. Roots are measured from the initial tilt, u = u₀ + δ, or from
//! the vertical, 1 ∓ u, whichever is nearer, and only β times the third root is used: what is a small
//! difference stays accurate near a steady precession and near the vertical, and a top without weight
//! (β = 0) is no special case.

use lagrangian::State;

use crate::cubic::{polished_root, roots_around_zero};
use crate::elliptic::{amplitude, complete_first, complete_third, incomplete_first};
use crate::model::HeavyTop;
use crate::symmetric_top::SymmetricTop;

/// The least 1 ∓ cos θ that means anything: at a tilt of some 10⁻¹² rad the rounding of the initial
/// state decides on which side the axis passes the vertical.
const VERTICAL: f64 = 1e-24;

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
    /// The parameter m.
    parameter: f64,
    /// b − a and b + a with a = `C_ψ`/I and b = `C_φ`/I, in rad/s.
    momenta: [f64; 2],
}

impl Nutation {
    /// The nutation of `top` through `state`. None if the tilt has no period: where the axis reaches
    /// the vertical, from which it need not return, or where nothing moves it.
    pub(crate) fn through(top: &SymmetricTop, state: &State<f64, 3>) -> Option<Self> {
        let (tilt, [precession, nutation, spin]) = (state.q[HeavyTop::THETA], state.v.into());
        let (sine, cosine) = tilt.sin_cos();
        // 1 − u₀ and 1 + u₀, without cancellation.
        let upper = 2.0 * (0.5 * tilt).sin().powi(2);
        let lower = 2.0 * (0.5 * tilt).cos().powi(2);
        let a = top.axial * (spin + precession * cosine) / top.transverse;
        let beta = 2.0 * top.moment / top.transverse;
        let swing = nutation.powi(2) + (precession * sine).powi(2);
        let momenta = [-upper, lower].map(|end| precession * sine.powi(2) + a * end);
        // u̇² = f(u₀ + δ) = speed + slope δ + bend δ² + β δ³; what slope has in brackets is (4.11).
        let speed = (sine * nutation).powi(2);
        let slope = sine.powi(2) * (2.0 * precession * (a - precession * cosine) - beta)
            - 2.0 * cosine * nutation.powi(2);
        let bend = 2.0 * beta * cosine - swing - a * a;
        let [fall, rise] = roots_around_zero([speed, slope, bend, beta], [-lower, upper]);
        let from_vertical = |sign: f64, start: f64, way: f64, momentum: f64| {
            let energy = swing - sign * beta * start;
            let slope = 2.0 * (energy - sign * a * momentum);
            let bend = 2.0 * sign * beta - energy - a * a;
            distance([-momentum.powi(2), slope, bend, -sign * beta], start, way)
        };
        let above = from_vertical(1.0, upper, rise, momenta[0]);
        let below = from_vertical(-1.0, lower, -fall, momenta[1]);
        let span = rise - fall;
        // β (u₃ − u₁), by the sum of the roots.
        let square = -bend - beta * (2.0 * fall + rise);
        let parameter = beta * span / square;
        let periodic = parameter < 1.0 && above > VERTICAL && below > VERTICAL;
        periodic.then(|| Self {
            above,
            below,
            span,
            rate: 0.5 * square.sqrt(),
            phase: initial_phase(-fall, span, parameter).copysign(-nutation),
            parameter,
            momenta,
        })
    }

    /// The least tilt in rad.
    pub(crate) fn least_tilt(&self) -> f64 {
        self.tilt(1.0, 0.0)
    }

    /// The greatest tilt in rad.
    pub(crate) fn greatest_tilt(&self) -> f64 {
        self.tilt(0.0, 1.0)
    }

    /// The period of the tilt, 2 K(m) / ω, in s.
    pub(crate) fn period(&self) -> f64 {
        2.0 * complete_first(self.parameter) / self.rate
    }

    /// The angle in rad by which φ grows in each period.
    pub(crate) fn precession(&self) -> f64 {
        let Self {
            above, below, span, ..
        } = *self;
        let [minus, plus] = self.momenta;
        let third = |complement: f64| complete_third(complement, self.parameter);
        // The characteristics are n = (u₂ − u₁)/(1 − u₁) and n = −(u₂ − u₁)/(1 + u₁).
        let upper = minus / (above + span) * third(above / (above + span));
        let lower = plus / below * third((below + span) / below);
        (upper + lower) / self.rate
    }

    /// The tilt in rad at time `t` in s after the start.
    pub(crate) fn tilt_at(&self, t: f64) -> f64 {
        // Whole periods are taken off first: they would only cost digits.
        let period = 2.0 * complete_first(self.parameter);
        let argument = (self.rate * t) % period + self.phase;
        let (sn, cn) = amplitude(argument, self.parameter).sin_cos();
        self.tilt(sn, cn)
    }

    /// The tilt in rad where sn and cn have these values. From half angles: accurate near the vertical.
    fn tilt(&self, sn: f64, cn: f64) -> f64 {
        let upper = self.above + self.span * cn * cn;
        let lower = self.below + self.span * sn * sn;
        2.0 * upper.sqrt().atan2(lower.sqrt())
    }
}

/// How far a turning point is from the vertical, on the way to which it lies, in cos θ. The root of
/// `cubic`, which is measured from the vertical, is used where it is nearer than `start`.
fn distance(cubic: [f64; 4], start: f64, way: f64) -> f64 {
    if way < 0.5 * start {
        start - way
    } else {
        polished_root(cubic, start - way)
    }
}

/// The argument from 0 to K(m) at which sn² is `height / span`.
fn initial_phase(height: f64, span: f64, parameter: f64) -> f64 {
    let square = if span > 0.0 { height / span } else { 0.0 };
    incomplete_first(square.sqrt().min(1.0), parameter)
}

#[cfg(test)]
mod tests;
