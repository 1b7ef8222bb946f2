//! Elementary functions and their derivatives as they are emitted, over the whole range of numbers.

use lagrangian::Scalar;
use lagrangian::prelude::*;
use lagrangian::quantities::StateJacobian;

const DATA: &str = include_str!("../../data/elementary_functions.txt");

/// f(x), f′(x) and f″(x): of a unit mass with the potential f, −ẍ and its slope are the derivatives.
type Row = fn(f64) -> [f64; 3];

macro_rules! models {
    ($($function:ident $model:ident)*) => {
        $(
            #[derive(Lagrangian)]
            #[lagrangian(
                coordinates(x),
                kinetic = 0.5 * dot(x).powi(2),
                potential = $function(x),
                output(value = $function(x)),
            )]
            struct $model {}
        )*

        /// The functions by name, on each format.
        const FUNCTIONS: &[(&str, Row, Row)] = &[$(
            (stringify!($function), |x| row::<f64, _>(&$model {}, |s| $model {}.outputs(s).value, x),
             |x| row::<f32, _>(&$model {}, |s| $model {}.outputs(s).value, x)),
        )*];
    };
}

models! {
    sin Sine cos Cosine tan Tangent asin Arcsine acos Arccosine atan Arctangent
    sinh HyperbolicSine cosh HyperbolicCosine tanh HyperbolicTangent
    asinh InverseSine acosh InverseCosine atanh InverseTangent
    exp Exponential ln Logarithm sqrt Root
}

fn row<S: Scalar, M: Lagrangian<1, S, Model: StateJacobian<1, S>>>(
    model: &M,
    value: impl Fn(&State<S, 1>) -> S,
    x: f64,
) -> [f64; 3] {
    let state = State::new(S::zero(), [S::from_f64(x)], [S::zero()]);
    let slope = model.linearize(&state).position[(0, 0)];
    [value(&state), -model.accelerations(&state)[0], -slope].map(Scalar::smallest)
}

#[test]
fn values_and_derivatives_are_finite_and_right_wherever_the_truth_is() {
    let mut wrong = Vec::new();
    let mut count = 0;
    for line in DATA.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        let function = FUNCTIONS.iter().find(|(name, ..)| *name == words[1]);
        let Some((name, double, single)) = function else {
            continue;
        };
        let x = f64::from_bits(u64::from_str_radix(words[2], 16).unwrap());
        // Below the root of the smallest number a value may be 0.
        let (row, epsilon, negligible) = if words[0] == "64" {
            (double(x), f64::EPSILON, 1e-153)
        } else {
            (single(x), f64::from(f32::EPSILON), 1e-18)
        };
        for (order, (found, expected)) in row.into_iter().zip(&words[3..]).enumerate() {
            count += 1;
            let expected: f64 = expected.parse().unwrap();
            let error = (found - expected).abs();
            let close = found.total_cmp(&expected).is_eq()
                || error <= 8.0 * epsilon * expected.abs() + negligible;
            if !close {
                wrong.push(format!(
                    "{name} {}, {order} at {x:e}: {found:e} for {expected:e}",
                    words[0]
                ));
            }
        }
    }
    assert!(count > 4500, "{count}");
    assert!(
        wrong.is_empty(),
        "{} of {count}:\n{}",
        wrong.len(),
        wrong.join("\n")
    );
}
