//! Elliptic functions and integrals against values that mpmath computed with 40 digits, and their identities.

use crate::common::assert_close;
use lagrangian::elliptic::{Modulus, carlson_rc, carlson_rf, carlson_rj};
use lagrangian::prelude::*;
use lagrangian::{DoubleDouble, SingleNumber};

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

#[cfg(feature = "num-dual")]
#[test]
fn derivatives_have_all_digits() {
    use num_dual::Dual64;
    let dual = |value: f64| Dual64::from_re(value);
    let along = |m: f64| {
        let m = dual(m).derivative();
        Modulus::new(m, dual(1.0) - m)
    };
    assert_close(
        along(0.5).complete_first().eps,
        0.847_213_084_793_979,
        2e-15,
    );
    let (sine, cosine) = 0.875_f64.sin_cos();
    let third = along(0.375).third(dual(-0.75), dual(sine), dual(cosine));
    assert_close(third.eps, 0.094_479_509_168_511_48, 1e-15);
    assert_close(
        along(0.25).jacobi(dual(0.75)).0.eps,
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

/// Arguments from 1e-300 to 1e300, and 0: x, y, z, p, with `R_F`(x, y, z), `R_C`(x, p) and `R_J`(x, y, z, p), by mpmath with
/// 330 digits.
#[test]
fn integrals_of_carlson_of_extreme_arguments() {
    let table: [[f64; 7]; 18] = [
        [
            31416816.438270222,
            2.173805164766285e60,
            5.266481828924139e60,
            1.589759733158318e-300,
            8.436220411327531e-31,
            0.06324283347531898,
            5.607405599621962e-62,
        ],
        [
            7.671266705813413e140,
            7.824072216581356e60,
            7.824072216581356e60,
            1.3851012640551394e-300,
            3.3500565453212934e-69,
            1.834555273795971e-68,
            5.7497537513235794e-129,
        ],
        [
            2.9528824710982357e140,
            4.925456799646863e140,
            8.697030221739677,
            5.565186854461536,
            8.010753861163995e-71,
            9.401633463441492e-69,
            3.08166871398057e-141,
        ],
        [
            8.205357891317517,
            9.073865423775377e-300,
            3.64502122137156,
            8.854903221653812e-300,
            0.6648467913055205,
            120.80393397309759,
            1.8359324749451957e149,
        ],
        [
            5.680656861333075e140,
            8.801492827839046e140,
            0.0,
            97559500.89287692,
            5.889545922923114e-71,
            6.44221793013861e-69,
            6.747282576664879e-145,
        ],
        [
            8.085717241424642e-200,
            7.950460711997088e-300,
            9.742370509530024e140,
            7.616558635106585e-20,
            1.2588403552798083e-68,
            5691680093.303181,
            2.6234700257619698e-49,
        ],
        [
            9.646216709342286e-200,
            2.9621775743669595e60,
            2.9621775743669595e60,
            5.059919658567003e-40,
            9.126711703688555e-31,
            6.9830968668208275e19,
            7.072260212131107e-41,
        ],
        [
            4.752151262861406,
            4.752151262861406,
            4.752151262861406,
            6.114990321440242e-300,
            0.45872760122085393,
            158.69903307794084,
            99.89600291980541,
        ],
        [
            96702947.06533675,
            8.753780116234783e60,
            8.753780116234783e60,
            9.738677222900842e-200,
            5.3091141155303886e-31,
            0.02430474645218386,
            8.329457490178973e-63,
        ],
        [
            5.8329671749752304e-300,
            9.451382169259809e60,
            2.022285767437323e-100,
            32722735.98223279,
            6.061980287364058e-29,
            0.0002745965476952782,
            3.701459669992721e-36,
        ],
        [
            34172750.00831498,
            34172750.00831498,
            34172750.00831498,
            5.6770482197914724e-300,
            0.00017106455629284248,
            0.060537379788969246,
            5.2995133740762405e-09,
        ],
        [
            3.737063968535597e-20,
            3.737063968535597e-20,
            3.737063968535597e-20,
            0.0027197380057886592,
            5172907755.812119,
            30.120095250290966,
            5705962539055.673,
        ],
        [
            8.228236085355258e-40,
            0.009428356639519962,
            0.009428356639519962,
            97193028.63483785,
            16.177144920777145,
            0.00015933174748588671,
            4.993254912770706e-07,
        ],
        [
            1.398815749174785e-200,
            1.398815749174785e-200,
            1.398815749174785e-200,
            6.078894875151636e140,
            8.4551193688797815e99,
            6.370999346324654e-71,
            4.1726923441831383e-41,
        ],
        [
            77406842.92459644,
            77406842.92459644,
            77406842.92459644,
            0.0015502554845144014,
            0.00011366069899183042,
            0.0014787379487129777,
            5.2905293569907065e-11,
        ],
        [
            17493443.815255266,
            3.117376832347423,
            8.592424502422517e-100,
            4.7374393732662714e60,
            0.00218922442131605,
            7.216856077350074e-31,
            1.3863339974354133e-63,
        ],
        [
            2.6749993058037985e-20,
            7.768471112792331e-100,
            0.006270555836264525,
            9.413102709433037e300,
            270.04771548497087,
            5.119805685641917e-151,
            8.606547399541851e-299,
        ],
        [
            0.004244233207027823,
            5.343360788880593e-100,
            0.0,
            5.316308761487889e60,
            1733.69721841966,
            6.812629629074355e-31,
            9.783276119958346e-58,
        ],
    ];
    for [x, y, z, p, first, elementary, third] in table {
        for [x, y, z] in [[x, y, z], [z, x, y], [y, z, x]] {
            assert_close(carlson_rf(x, y, z) / first, 1.0, 4e-15);
            assert_close(carlson_rj(x, y, z, p) / third, 1.0, 4e-15);
        }
        if elementary.is_normal() {
            assert_close(carlson_rc(x, p) / elementary, 1.0, 4e-15);
        }
    }
}

/// `R_J`(0, y, y, p) = 3π/(2 (y √p + p √y)), and `R_J`(y, y, y, p) in arcs.
#[test]
fn the_third_integral_in_closed_form() {
    for exponent in (-300_i32..=300).step_by(20) {
        for other in (-280..=280).step_by(35) {
            let (y, p) = (
                libm::exp10(f64::from(exponent)),
                libm::exp10(f64::from(other)),
            );
            let root = p.sqrt() * y.sqrt();
            let expected = 1.5 * std::f64::consts::PI / root / (y.sqrt() + p.sqrt());
            if expected.is_normal() {
                assert_close(carlson_rj(0.0, y, y, p) / expected, 1.0, 1e-14);
                assert_close(carlson_rj(y, y, 0.0, p) / expected, 1.0, 1e-14);
            }
            let expected = 3.0 / (y - p) * (carlson_rc(y, p) - 1.0 / y.sqrt());
            if expected.is_normal() && (exponent - other).abs() > 2 {
                assert_close(carlson_rj(y, y, y, p) / expected, 1.0, 1e-14);
            }
        }
    }
    for e in [20, 40, 60, 80, 100, 120, 160, 200] {
        let y = libm::exp10(f64::from(-e));
        let expected = d(1.5) * D::pi() / (d(y) + d(y).sqrt());
        let error = carlson_rj(d(0.0), d(y), d(y), d(1.0)) / expected - d(1.0);
        assert!(error.to_f64().abs() < 1e-28, "{e}: {error:?}");
    }
    for e in [5_i16, 10, 20, 30, 36] {
        let y = libm::exp10f(f32::from(-e));
        let expected = 1.5 * std::f32::consts::PI / (y + y.sqrt());
        assert!(
            (carlson_rj(0.0_f32, y, y, 1.0) / expected - 1.0).abs() < 4e-6,
            "{e}"
        );
    }
}

#[test]
fn integrals_that_diverge_are_infinite() {
    let [x, zero] = [2.0_f64, 0.0];
    for found in [
        carlson_rf(zero, zero, x),
        carlson_rf(zero, zero, zero),
        carlson_rc(x, zero),
        carlson_rj(zero, x, zero, x),
        carlson_rj(x, x, x, zero),
    ] {
        assert!(found > 1e300 && found.is_infinite(), "{found}");
    }
    for found in [
        carlson_rf(-x, x, x),
        carlson_rc(-x, x),
        carlson_rj(x, -x, x, x),
    ] {
        assert!(found.is_nan(), "{found}");
    }
}

/// n, m, sin φ and cos φ, with Π(n|m) and Π(n; φ|m), by mpmath with 330 digits: of both signs of n the terms of the defining sum would
/// cancel.
#[test]
fn integrals_of_the_third_kind_of_large_characteristics() {
    let table: [[f64; 6]; 14] = [
        [
            -2.1491587326138156e110,
            0.4871139231527861,
            0.5145462241254096,
            0.8574626424738769,
            1.0714838527803445e-55,
            1.0714838527803445e-55,
        ],
        [
            -1253762215788186.8,
            0.9999990463256836,
            0.9806410050412401,
            -0.19581424675366846,
            4.436212542914861e-08,
            4.4362130233490765e-08,
        ],
        [
            -1.1508296388879926e148,
            0.9999990463256836,
            0.6401483668860594,
            -0.7682513054809026,
            1.4642470504252837e-74,
            1.4642470504252837e-74,
        ],
        [
            -2.081960408683216e177,
            0.9999990463256836,
            0.9504987625130495,
            0.3107283419019923,
            3.442576848339379e-89,
            3.442576848339379e-89,
        ],
        [
            -2.806276390494135e212,
            0.0,
            0.9519239902848512,
            -0.30633432181224246,
            9.376800061249883e-107,
            9.376800061249883e-107,
        ],
        [
            -6.335056951928539e246,
            0.36777527591626424,
            0.3344655137490851,
            -0.9424079902635379,
            6.240862515050785e-124,
            6.240862515050785e-124,
        ],
        [
            -0.009420527592252708,
            0.5,
            0.9748615849130875,
            0.22281133333101133,
            1.8446579798318472,
            1.532370637955033,
        ],
        [
            -1.466103099110152e106,
            0.9999990463256836,
            0.2250155015099251,
            -0.9743551837396037,
            1.2972916451444427e-53,
            1.2972916451444427e-53,
        ],
        [
            -3.4907682664771864e152,
            0.5358362199429954,
            0.19450287825462945,
            -0.9809019473681683,
            8.407354642529788e-77,
            8.407354642529788e-77,
        ],
        [
            -0.17786631910871034,
            0.5,
            0.9641697038037199,
            0.2652862270587131,
            1.6963884958445425,
            1.37657581894353,
        ],
        [
            -0.002411135036952085,
            0.5,
            0.9104763724511847,
            -0.413561090055788,
            1.8516515098924173,
            2.436916858151186,
        ],
        [
            -25578183.161867853,
            0.9592624048128686,
            0.9752783054106712,
            -0.2209801506816611,
            0.00031066471620735215,
            0.0003107027474562619,
        ],
        [
            -1.6740557771937974e19,
            0.5,
            0.35589971469714615,
            -0.9345241532879126,
            3.839148534686615e-10,
            3.8391485365006253e-10,
        ],
        [
            -0.004545409186475414,
            0.0,
            0.999531287871534,
            0.03061379698555353,
            1.5672384950350189,
            1.5367584152807936,
        ],
    ];
    for [n, m, sine, cosine, complete, incomplete] in table {
        let modulus = Modulus::new(m, 1.0 - m);
        assert_close(modulus.complete_third(n) / complete, 1.0, 4e-15);
        assert_close(modulus.third(n, sine, cosine) / incomplete, 1.0, 8e-15);
    }
}
