//! The closed form of nutation beside values of mpmath, special cases, and where it has limits.

use std::f64::consts::TAU;

use lagrangian::rigid_body::{Nutation, SteadyPrecession};

use crate::common::assert_close;

/// Fails unless a value is as close as that to an expected one, relative to the larger of its magnitude and 1.
#[track_caller]
fn close(value: f64, expected: f64, tolerance: f64) {
    assert_close(value, expected, tolerance * expected.abs().max(1.0));
}

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
    Nutation::of_top(
        transverse,
        axial,
        moment,
        tilt,
        [precession, nutation, spin],
    )
}

#[test]
fn four_tops() {
    for case in CASES {
        let form = nutation(case.top, case.start).expect("it stays off the vertical");
        close(form.least_inclination(), case.limits[0], 2e-15);
        close(form.greatest_inclination(), case.limits[1], 2e-15);
        close(form.period(), case.period, 4e-15);
        // The difference of two larger terms.
        close(form.precession(), case.precession, 5e-14);
        close(form.inclination_at(0.0), case.start[0], 2e-15);
        for (t, tilt) in [0.25, 1.0, 5.0].into_iter().zip(case.tilts) {
            close(form.inclination_at(t), tilt, 2e-14);
        }
    }
}

#[test]
fn released_from_rest_it_falls_from_a_cusp() {
    let (a, u0) = (0.5 * 15.0, 0.5_f64.cos());
    let form = nutation([1.0, 0.5, 9.81], [0.5, 0.0, 0.0, 15.0]).expect("it is off the vertical");
    // With φ̇ = θ̇ = 0 at u₀ the cubic has the factor u − u₀, and the rest is a quadratic.
    let ratio = a * a / (4.0 * 9.81);
    let u1 = ratio - (ratio * ratio - 2.0 * ratio * u0 + 1.0).sqrt();
    close(form.least_inclination(), 0.5, 1e-15);
    close(form.greatest_inclination(), u1.acos(), 2e-15);
    // The same motion, from its lowest point on.
    let tilt = form.greatest_inclination();
    let precession = a * (u0 - u1) / (1.0 - u1 * u1);
    let later = nutation([1.0, 0.5, 9.81], [tilt, 0.0, precession, 15.0]).expect("as before");
    close(later.least_inclination(), 0.5, 1e-14);
    close(later.precession(), form.precession(), 1e-13);
    close(
        later.inclination_at(0.25 * form.period()),
        form.inclination_at(0.75 * form.period()),
        1e-14,
    );
}

#[test]
fn close_to_the_vertical() {
    let through = |precession: f64, spin: f64| {
        let rates = [precession, 0.0, spin];
        Nutation::of_top(1.5, 0.5, 5.0, 1.0, rates).expect("it passes the vertical by")
    };
    // mpmath at 60 digits. The tilt is as accurate as the difference of the momenta, which is
    // some 10⁻⁶ of either.
    for (precession, least, period, growth) in [
        (
            3.921,
            2.776_949_942_447_047e-6,
            1.054_012_502_199_646_8,
            6.763_350_693_983_953,
        ),
        (
            3.920_99,
            5.411_475_934_347_196e-7,
            1.054_013_649_102_019,
            6.763_351_988_311_951,
        ),
    ] {
        let form = through(precession, 16.0);
        close(form.least_inclination() / least, 1.0, 1e-8);
        close(form.period(), period, 4e-15);
        close(form.precession(), growth, 2e-14);
    }
    let form = through(-1.5686, 3.0);
    close(form.greatest_inclination(), 3.139_997_778_208_209_6, 1e-15);
    close(form.period(), 2.044_901_236_739_982_8, 4e-15);
    close(form.precession(), -4.832_907_330_776_662, 2e-14);
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
    let slope = -9.81 * 0.5_f64.sin();
    let steady = SteadyPrecession::of_top(1.0, 0.5, 12.6, 0.5, slope);
    let SteadyPrecession::Two { slow, fast } = steady else {
        panic!("it spins fast enough");
    };
    for precession in [slow, fast] {
        let form = nutation([1.0, 0.5, 9.81], [0.5, 0.0, precession, 12.6])
            .expect("it is off the vertical");
        close(
            form.greatest_inclination() - form.least_inclination(),
            0.0,
            1e-13,
        );
        close(form.precession() / form.period(), precession, 1e-13);
    }
}

#[test]
fn none_for_what_is_no_top() {
    let top = |i: f64, i_s: f64, weight: f64, tilt: f64, spin: f64| {
        Nutation::of_top(i, i_s, weight, tilt, [0.0, 0.1, spin])
    };
    assert!(top(1.0, 0.5, 9.81, 0.5, 15.0).is_some());
    for (i, i_s, weight, tilt, spin) in [
        (0.0, 0.5, 9.81, 0.5, 15.0),
        (1.0, -0.5, 9.81, 0.5, 15.0),
        (f64::INFINITY, 0.5, 9.81, 0.5, 15.0),
        (1.0, 0.5, -9.81, 0.5, 15.0),
        (1.0, 0.5, f64::NAN, 0.5, 15.0),
        (1.0, 0.5, 9.81, f64::NAN, 15.0),
        (1.0, 0.5, 9.81, 0.5, f64::INFINITY),
        (1.0, 0.5, 9.81, 0.5, 1e300),
    ] {
        let found = top(i, i_s, weight, tilt, spin);
        assert!(found.is_none(), "{found:?}");
    }
}
