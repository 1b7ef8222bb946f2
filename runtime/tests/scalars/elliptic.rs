//! Elliptic functions and integrals against values that mpmath computed with 40 digits, and their identities.

use crate::common::assert_close;
use lagrangian::elliptic::{Modulus, carlson_rc, carlson_rf, carlson_rj};
use lagrangian::prelude::*;
use lagrangian::{DoubleDouble, Dual, SingleNumber};

type D = DoubleDouble;

fn d(value: f64) -> D {
    D::from_f64(value)
}

fn modulus<S: SingleNumber>(m: f64) -> Modulus<S> {
    Modulus::new(S::from_f64(m), S::from_f64(1.0 - m))
}

#[track_caller]
fn digits(found: D, expected: &str, tolerance: f64) {
    let expected: D = expected.parse().unwrap();
    let error = ((found - expected) / expected).to_f64().abs();
    assert!(error < tolerance, "{error:e}");
}

#[test]
fn functions_of_jacobi() {
    let table = [
        (
            0.25,
            0.75,
            [
                "0.6701113282238753299945023434033705",
                "0.742260606381635766364600509579561",
                "0.9421983347186028680276528583836482",
            ],
        ),
        (
            0.875,
            2.5,
            [
                "0.9999564188284435885686663777009224",
                "-0.009335975781583231661937632580066934",
                "0.3536612296935020555691087010077247",
            ],
        ),
        (
            0.96875,
            5.0,
            [
                "0.8583016346439666148742457794663175",
                "-0.5131454998024389261625103474204634",
                "0.5351070985966366658558264874341798",
            ],
        ),
        (
            0.5,
            -13.75,
            [
                "0.8412019017563833031753731686576204",
                "0.5407211485427993257457046038535487",
                "0.8038592415595668367672866366101927",
            ],
        ),
        (
            0.0,
            1.25,
            [
                "0.9489846193555862143484908470360493",
                "0.315322362395268665447538552438038",
                "1.0",
            ],
        ),
    ];
    for (m, u, [sn, cn, dn]) in table {
        let found = modulus(m).jacobi(d(u));
        digits(found.0, sn, 1e-29);
        digits(found.1, cn, 1e-28);
        digits(found.2, dn, 1e-29);
        let double = modulus(m).jacobi(u);
        assert_close(double.0, found.0.to_f64(), 4e-15);
        assert_close(double.1, found.1.to_f64(), 8e-15);
        assert_close(double.2, found.2.to_f64(), 4e-15);
    }
}

#[test]
fn integrals_of_legendre() {
    let table = [
        (
            [-0.75, 0.875, 0.375],
            "0.9152616999666520923650808323031718",
            "0.7933443943325245889382886506398482",
        ),
        (
            [-25.0, 1.5, 0.96875],
            "2.745205265015907195395981597497764",
            "0.3683066341147637407746829521040792",
        ),
        (
            [0.5, 1.0, 0.875],
            "1.18007380109212439441387437611209",
            "1.419805208537131416051880771521578",
        ),
        (
            [-3.0, 1.25, 0.0],
            "1.25",
            "0.7030816642503661172570532771957479",
        ),
        (
            [-2.0, -0.5, 1.0],
            "-0.5222381032784403301898871449364483",
            "-0.4549491059493113409867942409423096",
        ),
    ];
    for ([n, phi, m], first, third) in table {
        let (sine, cosine) = d(phi).sin_cos();
        digits(modulus(m).first(sine, cosine), first, 1e-29);
        digits(modulus(m).third(d(n), sine, cosine), third, 1e-29);
        let (sine, cosine) = phi.sin_cos();
        let [first, third]: [D; 2] = [first, third].map(|text| text.parse().unwrap());
        let modulus = modulus(m);
        assert_close(modulus.first(sine, cosine), first.to_f64(), 4e-15);
        assert_close(modulus.third(n, sine, cosine), third.to_f64(), 4e-15);
    }
}

#[test]
fn integrals_of_carlson() {
    let table = [
        (
            [2.0, 3.0, 4.0, 5.0],
            [
                "0.5840828416771517066928491689256679",
                "0.1429757966715675383323387942198577",
                "0.5115768659444348750062389338899529",
            ],
        ),
        (
            [0.0, 1.0, 2.0, 0.5],
            [
                "1.31102877714605990523241979494556",
                "2.9366712692381184224373106939745",
                "2.221441469079183123507940495030347",
            ],
        ),
        (
            [0.125, 0.25, 0.5, 40.0],
            [
                "1.937715306544904926461803542714756",
                "0.1285120324441228119781491963789944",
                "0.2398963932496649983255946761024176",
            ],
        ),
    ];
    for (arguments, [rf, rj, rc]) in table {
        let [x, y, z, p] = arguments.map(d);
        digits(carlson_rf(x, y, z), rf, 1e-30);
        digits(carlson_rj(x, y, z, p), rj, 1e-30);
        digits(carlson_rc(x, p), rc, 1e-30);
    }
}

#[test]
fn complete_integrals_up_to_the_separatrix() {
    digits(
        modulus(0.5).complete_first(),
        "1.85407467730137191843385034719526",
        1e-30,
    );
    // The complement is 2⁻¹⁰⁰, and m is 1 in f64: K is ln 4/√(1 − m).
    let tiny = power_of_two(-100);
    let near = Modulus::new(1.0, tiny);
    assert_close(near.complete_first(), 36.043_653_389_117_15, 1e-14);
    let (sn, cn, dn) = near.jacobi(30.0);
    assert_close(sn, 1.0, 1e-15);
    assert_close(cn, 1.871_514_056_090_52e-13, 2e-16);
    assert_close(dn, 1.871_535_131_445_55e-13, 2e-16);
    let separatrix = Modulus::new(1.0, 0.0_f64);
    assert!(separatrix.complete_first().is_infinite());
    let (sn, cn, dn) = separatrix.jacobi(-1.5);
    assert_close(sn, (-1.5_f64).tanh(), 1e-16);
    assert_close(cn, 1.0 / 1.5_f64.cosh(), 1e-16);
    assert_close(dn, cn, 0.0);
}

fn power_of_two(exponent: i32) -> f64 {
    2.0_f64.powi(exponent)
}

#[test]
fn identities() {
    for m in [0.0, 1e-12, 0.3, 0.7, 0.999_999, 1.0] {
        let modulus = modulus::<f64>(m);
        for step in -40..40 {
            let u = 0.37 * f64::from(step);
            let (sn, cn, dn) = modulus.jacobi(u);
            assert_close(sn * sn + cn * cn, 1.0, 1e-15);
            assert_close(dn * dn + m * sn * sn, 1.0, 2e-15);
            // F is the inverse, up to half periods.
            let (_, reduced) = modulus.reduced(u);
            let (sn, cn, _) = modulus.jacobi(reduced);
            if cn > 1e-2 {
                assert_close(modulus.first(sn, cn), reduced, 1e-13);
                if m < 1.0 {
                    let half_period = 2.0 * modulus.complete_first() * sn.signum();
                    assert_close(modulus.first(sn, -cn), half_period - reduced, 1e-12);
                }
            }
            // sn′ = cn dn.
            let h = 1e-4;
            let slope = (modulus.jacobi(u + h).0 - modulus.jacobi(u - h).0) / (2.0 * h);
            let (_, cn, dn) = modulus.jacobi(u);
            assert_close(slope, cn * dn, 2e-8);
        }
    }
}

#[test]
fn derivatives_have_all_digits() {
    let dual = <Dual>::constant;
    let along = |m: f64| {
        let m = Dual::variable(m, 0);
        Modulus::new(m, dual(1.0) - m)
    };
    assert_close(
        along(0.5).complete_first().derivative[0],
        0.847_213_084_793_979,
        2e-15,
    );
    let (sine, cosine) = 0.875_f64.sin_cos();
    let third = along(0.375).third(dual(-0.75), dual(sine), dual(cosine));
    assert_close(third.derivative[0], 0.094_479_509_168_511_48, 1e-15);
    assert_close(
        along(0.25).jacobi(dual(0.75)).0.derivative[0],
        -0.046_253_893_547_061_61,
        1e-15,
    );
}

/// The difference of two integrals of the third kind, in double-doubles, by the addition theorem.
#[test]
fn integrals_between_two_arguments() {
    // m and 1 − m are exact.
    for m in [0.0, 0.3125, 1.0 - f64::from(2.0_f32.powi(-20))] {
        let (precise, rough) = (modulus::<D>(m), modulus::<f64>(m));
        let quarter = precise.complete_first();
        for n in [-0.3, -40.0, -1e8] {
            let third = |u: D| {
                let (turns, rest) = precise.reduced(u);
                let (sn, cn, _) = precise.jacobi(rest);
                d(2.0 * turns) * precise.complete_third(d(n)) + precise.third(d(n), sn, cn)
            };
            for i in [-7, -3, 0, 2, 5] {
                for k in [-13, -6, -1, 0, 1, 3, 4, 11] {
                    let u = d(0.137 * f64::from(i)) * quarter;
                    let v = d(0.271 * f64::from(k)) * quarter;
                    let expected = third(u + v) - third(u);
                    let size = 1e-3 + third(v).to_f64().abs();
                    let found = precise.third_between(d(n), u, v);
                    let error = (found - expected).to_f64().abs();
                    assert!(error < 1e-26 * size, "{m} {n} {i} {k}: {error:e}");
                    let found = rough.third_between(n, u.to_f64(), v.to_f64());
                    let error = (found - expected.to_f64()).abs();
                    // Of the symmetric integrals, which are of the size of K, the sum may be small.
                    let size = size + quarter.to_f64();
                    assert!(error < 1e-14 * size, "{m} {n} {i} {k}: {error:e}");
                }
            }
        }
    }
}

/// K(m), F(φ|m) from the sine of φ, and sn(u|m), by mpmath with 30 digits.
#[test]
fn first_kind_and_sine_beside_mpmath() {
    let modulus = modulus::<f64>;
    for (m, expected) in [
        (0.0, core::f64::consts::FRAC_PI_2),
        (0.3, 1.713_889_448_178_791),
        (0.75, 2.156_515_647_499_643_2),
        (0.999, 4.841_132_560_550_297),
    ] {
        assert_close(modulus(m).complete_first() / expected, 1.0, 4e-16);
        assert_close(modulus(m).first(1.0, 0.0) / expected, 1.0, 2e-15);
    }
    let first = |sine: f64, m: f64| modulus(m).first(sine, (1.0 - sine * sine).sqrt());
    assert_close(first(0.6, 0.3), 0.656_418_097_039_575_5, 4e-16);
    assert_close(first(-0.999, 0.75), -2.067_154_661_955_832_5, 4e-15);
    for (u, m, expected) in [
        (0.7, 0.3, 0.632_304_776_310_864_5),
        (-1.9, 0.75, -0.991_650_867_351_617),
        (12.5, 0.2, -0.691_223_147_857_439_2),
        (3.0, 0.999, 0.995_293_128_337_884_4),
        (1.0, 0.0, 0.841_470_984_807_896_5),
    ] {
        assert_close(modulus(m).jacobi(u).0, expected, 1e-14);
    }
    for m in [0.0, 0.2, 0.9] {
        for sine in [-0.9, -0.1, 0.0, 0.4, 0.99] {
            assert_close(modulus(m).jacobi(first(sine, m)).0, sine, 4e-15);
        }
    }
}
