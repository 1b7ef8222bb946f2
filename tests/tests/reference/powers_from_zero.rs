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
        let end = Taylor::new().integrate_to(&model.dynamics(), start, 1.25);
        let end = end.unwrap().state();
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
