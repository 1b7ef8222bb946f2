//! Functions that stand for quotients and logarithms of exponentials, on all scalars.

use lagrangian::num_traits::{One as _, Zero as _};
use lagrangian::{DoubleDouble, Dual, Lanes, Scalar};

/// x, the logistic function, softplus, sech and ln cosh, by mpmath with forty digits, as high and low parts.
const HYPERBOLIC: [(f64, [&str; 4]); 6] = [
    (
        -40.0,
        [
            "4.248354255291588977280720904404506e-18",
            "4.248354255291588986304977843631582e-18",
            "8.496708510583177990658469565717316e-18",
            "39.30685281944005469058276787854182",
        ],
    ),
    (
        -3.0,
        [
            "0.0474258731775667808788481517717522",
            "0.04858735157374205875892591985469",
            "0.09932792741943320782901244809925379",
            "2.309328504577785140113627560585346",
        ],
    ),
    (
        0.0,
        ["0.5", "0.6931471805599453094172321214581766", "1.0", "0.0"],
    ),
    (
        0.25,
        [
            "0.5621765008857981040273236379029464",
            "0.8259394198788435622078361316583179",
            "0.9695436291402145850506901996377775",
            "0.03092980362016137145576523362299418",
        ],
    ),
    (
        3.0,
        [
            "0.9525741268224332191211518482282478",
            "3.04858735157374205875892591985469",
            "0.09932792741943320782901244809925379",
            "2.309328504577785140113627560585346",
        ],
    ),
    (
        40.0,
        [
            "0.999999999999999995751645744708411",
            "40.00000000000000000424835425529159",
            "8.496708510583177990658469565717316e-18",
            "39.30685281944005469058276787854182",
        ],
    ),
];

/// The functions far below and far above 0.
fn at_both_ends<S: Scalar>() -> [f64; 6] {
    let [low, high] = [-800.0, 800.0].map(S::from_f64);
    [
        low.logistic(),
        low.softplus(),
        low.sech(),
        high.logistic(),
        high.softplus(),
        high.sech(),
    ]
    .map(S::largest)
}

#[test]
fn logistic_functions_have_all_digits_and_do_not_overflow() {
    for (x, expected) in HYPERBOLIC {
        let found = [x.logistic(), x.softplus(), x.sech(), x.log_cosh()];
        let double = DoubleDouble::from(x);
        let double = [
            double.logistic(),
            double.softplus(),
            double.sech(),
            double.log_cosh(),
        ];
        let lanes = Lanes::<4>::from_f64(x);
        let lanes = [
            lanes.logistic(),
            lanes.softplus(),
            lanes.sech(),
            lanes.log_cosh(),
        ];
        for (i, text) in expected.into_iter().enumerate() {
            let expected: DoubleDouble = text.parse().unwrap();
            let size = if expected.is_zero() {
                DoubleDouble::one()
            } else {
                expected
            };
            let error = (DoubleDouble::from(found[i]) - expected) / size;
            assert!(
                error.largest().abs() < 4.0 * f64::EPSILON,
                "{i} at {x}: {error:?}"
            );
            let error = (double[i] - expected) / size;
            assert!(error.largest().abs() < 1e-29, "{i} at {x}: {error:?}");
            assert_eq!(lanes[i].in_lane(3).to_bits(), found[i].to_bits());
        }
    }
    let expected = [0.0, 0.0, 0.0, 1.0, 800.0, 0.0];
    for found in [
        at_both_ends::<f64>(),
        at_both_ends::<f32>(),
        at_both_ends::<DoubleDouble>(),
        at_both_ends::<Lanes<2>>(),
    ] {
        for (found, expected) in found.into_iter().zip(expected) {
            assert!(
                (found - expected).abs() < f64::MIN_POSITIVE,
                "{found} {expected}"
            );
        }
    }
}

#[test]
fn dual_numbers_have_their_derivatives_where_exponentials_overflow() {
    for x in [-800.0, -30.0, -1.0, 0.0, 0.7, 20.0, 800.0_f64] {
        let variable = Dual::<Dual>::variable(Dual::variable(x, 0), 0);
        let [s, c] = [x.logistic(), (-x).logistic()];
        let (tangent, secant) = (x.tanh(), x.sech());
        let square = secant * secant;
        let expected = [
            (variable.logistic(), [s, s * c, s * c * (c - s)]),
            (variable.softplus(), [x.softplus(), s, s * c]),
            (
                variable.sech(),
                [secant, -secant * tangent, secant - 2.0 * secant * square],
            ),
            (variable.log_cosh(), [x.log_cosh(), tangent, square]),
        ];
        for (i, (found, expected)) in expected.into_iter().enumerate() {
            let [slope] = found.derivative;
            let found = [found.value.value, slope.value, slope.derivative[0]];
            for (found, expected) in found.into_iter().zip(expected) {
                let error = (found - expected).abs();
                assert!(
                    error < 1e-14 * (1.0 + expected.abs()),
                    "{i} at {x}: {found} {expected}"
                );
            }
        }
    }
}
