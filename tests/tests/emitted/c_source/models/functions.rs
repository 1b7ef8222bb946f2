//! The elementary functions.

use lagrangian::prelude::*;

use crate::c_source::agreement::Agreement;
use crate::c_source::checks::{check, free, state_matrix};
use crate::c_source::program::Case;

/// All functions of the language, and those that stand for what is written by exponentials.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    define(s = x / 4.0),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = ln(1.0 + exp(y)) + ln(cosh(x)) + atan2(x, 3.0 + y),
    dissipation = 0.5 * m * (1.0 + tanh(x)) * dot(x).powi(2),
    force(x = -c * abs(dot(x)) * dot(x) - signum(dot(x)), y = max(x, y) * min(x, y) - sqrt(x.powi(2) + y.powi(2))),
    output(
        tangent = tan(x), inverse_sine = asin(s), inverse_cosine = acos(s), inverse_tangent = atan(x),
        hyperbolic = sinh(x), cosine = cosh(x), in_between = tanh(x), inverse = asinh(x), beyond = acosh(2.0 + s), within = atanh(s),
        exponential = exp(x), logarithm = ln(5.0 + x), power = powf(5.0 + x, y), sign = signum(x), size = abs(x), secant = 1.0 / cosh(x),
        logistic = 1.0 / (1.0 + exp(-x)), root = (x + 5.0).powf(1.0 / 3.0), angle = atan2(y, x), least = min(x, y), most = max(x, y),
        slope = x / (x.powi(2) + y.powi(2)), sine = sin(100.0 * x), speed = dot(x).powi(2) / sqrt(dot(x).powi(2) + dot(y).powi(2)),
    ),
    c,
)]
pub(in super::super) struct Functions {
    m: f64,
    c: f64,
}

pub(in super::super) fn elementary_functions() -> Case {
    let model = |_: &[f64]| Functions { m: 1.25, c: 0.3 };
    let mut checks = free!(2, model);
    checks.push(state_matrix!(2, model, ""));
    macro_rules! outputs {
        ($($name:ident),*) => {
            $(checks.push(check(
                stringify!($name),
                1,
                concat!("$_outputs o; $_compute_outputs(POINT, &o); y[0] = o.", stringify!($name), ";"),
                move |point| Some(vec![model(&[]).outputs(&point.state::<2>()).$name]),
            ));)*
        };
    }
    outputs! {
        tangent, inverse_sine, inverse_cosine, inverse_tangent, hyperbolic, cosine, in_between, inverse, beyond, within, exponential,
        logarithm, power, sign, size, secant, logistic, root, angle, least, most, slope, sine, speed
    }
    Case {
        prefix: "functions",
        source: Functions::C_SOURCE,
        header: Functions::C_HEADER,
        casadi: Functions::C_CASADI,
        parameters: vec![1.25, 0.3],
        coordinates: 2,
        inputs: 0,
        checks,
        agreement: Agreement::Units(2.0),
    }
}
