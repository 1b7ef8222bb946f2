//! The nutation of the symmetric top in closed form.
//!
//! By the constants (4.8) and the energy (4.10), u = cos θ obeys u̇² = f(u) with a cubic f, so that θ
//! is an elliptic function of the time. Everything is measured from the initial tilt, u = u₀ + δ, and
//! only β times the third root is used, not the root: what is then a small difference stays accurate
//! near a steady precession, and a top without weight (β = 0) is no special case.

use lagrangian::State;

use crate::cubic::roots_around_zero;
use crate::elliptic::{complete_first, complete_third, incomplete_first, sine_amplitude};
use crate::model::HeavyTop;
use crate::symmetric_top::SymmetricTop;

/// The least distance of cos θ from ±1 that the roots of a cubic in cos θ can resolve: a tilt of some
/// 10⁻⁶ rad.
const VERTICAL: f64 = 1e-12;

/// A nutation in closed form: cos θ = u₁ + (u₂ − u₁) sn²(ω t + τ₀ | m).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Nutation {
    /// 1 − u₁ and 1 + u₁ at the greatest tilt.
    complements: [f64; 2],
    /// u₂ − u₁.
    span: f64,
    /// ω, in 1/s.
    rate: f64,
    /// τ₀.
    phase: f64,
    /// The parameter m.
    parameter: f64,
    /// (b − a)/2 and (b + a)/2 with a = `C_ψ`/I and b = `C_φ`/I, in rad/s.
    halves: [f64; 2],
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
        // u̇² = f(u₀ + δ) = speed + slope δ + bend δ² + β δ³; what slope has in brackets is (4.11).
        let speed = (sine * nutation).powi(2);
        let slope = sine.powi(2) * (2.0 * precession * (a - precession * cosine) - beta)
            - 2.0 * cosine * nutation.powi(2);
        let bend = 2.0 * beta * cosine - nutation.powi(2) - (precession * sine).powi(2) - a * a;
        let [fall, rise] = roots_around_zero([speed, slope, bend, beta], [-lower, upper]);
        let span = rise - fall;
        // β (u₃ − u₁), by the sum of the roots.
        let square = -bend - beta * (2.0 * fall + rise);
        let parameter = beta * span / square;
        let complements = [upper - fall, lower + fall];
        let periodic = parameter < 1.0 && complements[1] > VERTICAL && upper - rise > VERTICAL;
        periodic.then(|| Self {
            complements,
            span,
            rate: 0.5 * square.sqrt(),
            phase: initial_phase(-fall, span, parameter).copysign(-nutation),
            parameter,
            halves: [-upper, lower].map(|end| 0.5 * (precession * sine.powi(2) + a * end)),
        })
    }

    /// The least tilt in rad.
    pub(crate) fn least_tilt(&self) -> f64 {
        self.tilt_above(self.span)
    }

    /// The greatest tilt in rad.
    pub(crate) fn greatest_tilt(&self) -> f64 {
        self.tilt_above(0.0)
    }

    /// The period of the tilt, 2 K(m) / ω, in s.
    pub(crate) fn period(&self) -> f64 {
        2.0 * complete_first(self.parameter) / self.rate
    }

    /// The angle in rad by which φ grows in each period.
    pub(crate) fn precession(&self) -> f64 {
        let [above, below] = self.complements;
        let term = |half: f64, complement: f64, n: f64| {
            half / complement * complete_third(n, self.parameter)
        };
        2.0 / self.rate
            * (term(self.halves[0], above, self.span / above)
                + term(self.halves[1], below, -self.span / below))
    }

    /// The tilt in rad at time `t` in s after the start.
    pub(crate) fn tilt_at(&self, t: f64) -> f64 {
        // Whole periods are taken off first: they would only cost digits.
        let half = 2.0 * complete_first(self.parameter);
        let argument = (self.rate * t) % half + self.phase;
        self.tilt_above(self.span * sine_amplitude(argument, self.parameter).powi(2))
    }

    /// The tilt at which cos θ is greater than u₁ by `rise`: in half angles, accurate near the poles.
    fn tilt_above(&self, rise: f64) -> f64 {
        let [above, below] = self.complements;
        2.0 * (above - rise).max(0.0).sqrt().atan2((below + rise).sqrt())
    }
}

/// The argument from 0 to K(m) at which sn² is `height / span`.
fn initial_phase(height: f64, span: f64, parameter: f64) -> f64 {
    let square = if span > 0.0 { height / span } else { 0.0 };
    incomplete_first(square.sqrt().min(1.0), parameter)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use lagrangian::State;

    use super::Nutation;
    use crate::{close, symmetric_top::SymmetricTop};

    /// A motion, and what mpmath gives for it at 30 digits.
    struct Case {
        /// I, `I_s` and m g l.
        top: [f64; 3],
        /// θ, θ̇, φ̇ and ω₃.
        start: [f64; 4],
        limits: [f64; 2],
        period: f64,
        precession: f64,
        /// θ after 0.25, 1 and 5 s.
        tilts: [f64; 3],
    }

    const CASES: [Case; 4] = [
        Case {
            top: [0.4, 0.25, 3.531_6],
            start: [0.6, 0.2, 0.8, 18.0],
            limits: [0.581_999_365_075_691_3, 0.622_672_543_835_746_8],
            period: 0.635_548_173_465_706_8,
            precession: 0.531_077_097_057_882_1,
            tilts: [
                0.617_040_670_365_637_8,
                0.595_947_276_079_865,
                0.585_734_676_010_443_9,
            ],
        },
        Case {
            top: [1.0, 0.5, 9.81],
            start: [0.5, 0.3, 0.1, 15.0],
            limits: [0.490_168_614_408_853_9, 0.792_284_687_093_822_7],
            period: 1.211_762_425_527_400_9,
            precession: 1.852_155_334_008_880_3,
            tilts: [
                0.660_294_933_302_023_3,
                0.538_188_938_040_416_5,
                0.585_841_155_125_335_2,
            ],
        },
        Case {
            top: [1.0, 2.0, 2.0],
            start: [1.8, -0.5, 1.0, 3.0],
            limits: [1.558_336_818_902_064_5, 1.826_706_665_900_784_7],
            period: 1.022_897_320_296_791_3,
            precession: 0.332_681_886_359_908_14,
            tilts: [
                1.615_946_588_956_569_2,
                1.810_329_690_304_054_2,
                1.826_346_995_324_752_4,
            ],
        },
        Case {
            top: [15.234_375, 0.468_75, 147.15],
            start: [1.25, 0.4, -3.5, 120.0],
            limits: [1.246_819_791_219_703_9, 2.875_716_771_171_239],
            period: 0.902_483_409_405_559,
            precession: 0.978_571_266_593_893_6,
            tilts: [
                2.008_229_006_533_931_7,
                1.403_050_848_071_253_1,
                2.718_006_987_876_357_5,
            ],
        },
    ];

    /// The nutation of a top (I, `I_s`, m g l) that starts with θ, θ̇, φ̇ and ω₃.
    fn nutation(top: [f64; 3], start: [f64; 4]) -> Option<Nutation> {
        let [transverse, axial, moment] = top;
        let [tilt, nutation, precession, axial_rate] = start;
        let spin = axial_rate - precession * tilt.cos();
        Nutation::through(
            &SymmetricTop {
                transverse,
                axial,
                moment,
            },
            &State::new(0.0, [0.0, tilt, 0.0], [precession, nutation, spin]),
        )
    }

    #[test]
    fn four_tops() {
        for case in CASES {
            let form = nutation(case.top, case.start).expect("it stays off the vertical");
            close(form.least_tilt(), case.limits[0], 2e-15);
            close(form.greatest_tilt(), case.limits[1], 2e-15);
            close(form.period(), case.period, 4e-15);
            // The difference of two larger terms.
            close(form.precession(), case.precession, 5e-14);
            close(form.tilt_at(0.0), case.start[0], 2e-15);
            for (t, tilt) in [0.25, 1.0, 5.0].into_iter().zip(case.tilts) {
                close(form.tilt_at(t), tilt, 2e-14);
            }
        }
    }

    #[test]
    fn released_from_rest_it_falls_from_a_cusp() {
        let (a, u0) = (0.5 * 15.0, 0.5_f64.cos());
        let form =
            nutation([1.0, 0.5, 9.81], [0.5, 0.0, 0.0, 15.0]).expect("it is off the vertical");
        // With φ̇ = θ̇ = 0 at u₀ the cubic has the factor u − u₀, and the rest is a quadratic.
        let ratio = a * a / (4.0 * 9.81);
        let u1 = ratio - (ratio * ratio - 2.0 * ratio * u0 + 1.0).sqrt();
        close(form.least_tilt(), 0.5, 1e-15);
        close(form.greatest_tilt(), u1.acos(), 2e-15);
        // The same motion, from its lowest point on.
        let tilt = form.greatest_tilt();
        let precession = a * (u0 - u1) / (1.0 - u1 * u1);
        let later = nutation([1.0, 0.5, 9.81], [tilt, 0.0, precession, 15.0]).expect("as before");
        close(later.least_tilt(), 0.5, 1e-14);
        close(later.precession(), form.precession(), 1e-13);
        close(
            later.tilt_at(0.25 * form.period()),
            form.tilt_at(0.75 * form.period()),
            1e-14,
        );
    }

    #[test]
    fn none_at_rest() {
        assert!(nutation([1.0, 0.5, 0.0], [0.5, 0.0, 0.0, 0.0]).is_none());
    }

    #[test]
    fn none_through_the_vertical() {
        // A pendulum in a plane, and a top that passes upright with C_φ = C_ψ.
        assert!(nutation([1.0, 0.5, 5.0], [2.0, 1.0, 0.0, 0.0]).is_none());
        let precession = 0.5 * 15.0 / (1.0 + 0.5_f64.cos());
        assert!(nutation([1.0, 0.5, 9.81], [0.5, 0.0, precession, 15.0]).is_none());
    }

    #[test]
    fn without_weight_the_axis_goes_round_the_angular_momentum() {
        let across = (0.3 * 0.7_f64.sin()).hypot(0.4);
        let form = nutation([1.0, 0.5, 0.0], [0.7, 0.4, 0.3, 6.0]).expect("it is off the vertical");
        close(form.period(), TAU / across.hypot(0.5 * 6.0), 4e-15);
    }

    #[test]
    fn none_in_a_steady_precession() {
        let top = SymmetricTop {
            transverse: 1.0,
            axial: 0.5,
            moment: 9.81,
        };
        for precession in top.steady_precession(0.5, 12.6) {
            let form = nutation([1.0, 0.5, 9.81], [0.5, 0.0, precession, 12.6])
                .expect("it is off the vertical");
            close(form.greatest_tilt() - form.least_tilt(), 0.0, 1e-13);
            close(form.precession() / form.period(), precession, 1e-13);
        }
    }
}
