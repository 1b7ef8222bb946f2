use super::*;

/// Central differences of each row against the next one, at points inside of all domains.
#[test]
fn each_derivative_is_the_slope_of_the_one_before() {
    const STEP: f64 = 1e-5;
    let points = |function: Unary| match function {
        Unary::Acosh => [1.3, 1.9, 4.0],
        Unary::Ln => [0.2, 0.9, 4.0],
        _ => [-0.7, 0.2, 0.6],
    };
    for function in Unary::ALL {
        for x in points(function) {
            let (below, above) = (
                derivatives(function, x - STEP),
                derivatives(function, x + STEP),
            );
            let here = derivatives(function, x);
            for order in 0..3 {
                let slope = (above[order] - below[order]) / (2.0 * STEP);
                let error = (slope - here[order + 1]).abs();
                // The third difference times h²/6, and rounding over h.
                assert!(
                    error < 1e-7 * (1.0 + slope.abs()),
                    "{} {order} at {x}: {slope} and {}",
                    function.name(),
                    here[order + 1]
                );
            }
        }
    }
}

#[test]
fn powers_and_functions_of_two_arguments_have_their_slopes() {
    const STEP: f64 = 1e-5;
    for k in [-2.0, -1.0, -0.5, 0.5, 1.0, 1.5, 2.0, 3.0, 7.0] {
        let [below, here, above] = [-STEP, 0.0, STEP].map(|h| power_derivatives(1.7 + h, k));
        for order in 0..3 {
            let slope = (above[order] - below[order]) / (2.0 * STEP);
            assert!(
                (slope - here[order + 1]).abs() < 1e-7 * (1.0 + slope.abs()),
                "{k} {order}"
            );
        }
    }
    let (x, y) = (HyperDual::constant(1.3), HyperDual::constant(0.4));
    for function in Binary::ALL {
        let value = |dx: f64, dy: f64| function.value(1.3 + dx, 0.4 + dy);
        let expected = [
            (value(STEP, 0.0) - value(-STEP, 0.0)) / (2.0 * STEP),
            (value(0.0, STEP) - value(0.0, -STEP)) / (2.0 * STEP),
        ];
        for (slope, expected) in x.slopes(function, y).iter().zip(expected) {
            assert!(
                (slope.value - expected).abs() < 1e-8,
                "{} {expected}",
                function.name()
            );
        }
    }
}

#[test]
fn mixed_parts_are_second_derivatives() {
    // x² y along x and y: ∂²/∂x∂y = 2 x.
    let x = HyperDual {
        value: 3.0,
        first: 1.0,
        ..HyperDual::default()
    };
    let y = HyperDual {
        value: 5.0,
        second: 1.0,
        ..HyperDual::default()
    };
    let product = x * x * y;
    assert_eq!(
        [product.value, product.first, product.second, product.mixed],
        [45.0, 30.0, 9.0, 6.0]
    );
    // sin (x y): ∂²/∂x∂y = cos xy − xy sin xy.
    let sine = (x * y).unary(Unary::Sin);
    let expected = 15.0_f64.cos() - 15.0 * 15.0_f64.sin();
    assert!((sine.mixed - expected).abs() < 1e-13);
}

/// Derivatives that are numbers where the square of the argument is none.
#[test]
fn derivatives_do_not_overflow_far_off() {
    let x = 1e200;
    for function in [Unary::Asinh, Unary::Acosh] {
        let [_, slope, second, _] = derivatives(function, x);
        assert!((slope * x - 1.0).abs() < 1e-14, "{}", function.name());
        assert!(second == 0.0 && slope.is_finite(), "{}", function.name());
    }
    assert!(derivatives(Unary::Atan, x).iter().all(|x| x.is_finite()));
}
