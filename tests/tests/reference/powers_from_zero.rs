//! Taylor series of powers with an exponent that is a parameter, from a base that is exactly 0.

use lagrangian::prelude::*;

/// A force that is a power of the coordinate.
#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), force(x = x.powf(n)))]
struct Power {
    n: f64,
}

macro_rules! elementary {
    ($($model:ident = $force:expr;)*) => {$(
        #[derive(Lagrangian)]
        #[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), force(x = $force))]
        struct $model;
    )*};
}

elementary! {
    Constant = 1.0;
    Linear = x;
    Quadratic = x * x;
    Cubic = x * x * x;
}

/// Where a motion from x = 0 ends.
macro_rules! end {
    ($model:expr) => {{
        let model = $model;
        let start = State::new(0.0, [0.0], [1.0]);
        let end = Problem::new(&model, start).solve(1.25, Taylor::new());
        let end = end.unwrap();
        [end.q[0], end.v[0]]
    }};
}

#[test]
fn powers_with_whole_exponents_move_as_products_do() {
    let products = [end!(Constant), end!(Linear), end!(Quadratic), end!(Cubic)];
    for (n, expected) in [0.0, 1.0, 2.0, 3.0].into_iter().zip(products) {
        for (found, expected) in end!(Power { n }).into_iter().zip(expected) {
            let difference = (found - expected).abs();
            assert!(
                difference <= 4e-15 * expected.abs(),
                "{n}: {found} {expected}"
            );
        }
    }
}

/// Beyond these, the series has the terms of order 0 alone, and the first step is as long as that is right: with any positive exponent
/// the motion is the one whose energy is constant, ½ ẋ² − xⁿ⁺¹/(n + 1) = ½.
#[test]
fn powers_with_other_exponents_keep_the_energy() {
    for n in [0.25, 0.5, 1.5, 2.5, 3.5, 4.0, 5.0, 5.5, 7.0, 12.0] {
        let [x, v] = end!(Power { n });
        let error = v * v - 1.0 - 2.0 * x.powf(n + 1.0) / (n + 1.0);
        assert!(error.abs() <= 1e-11 * v * v, "{n}: {error:e}");
    }
}
