//! Functions that rise within a short length: exponentials, logistic functions, logarithms of sums of exponentials, and
//! what is composed of them, in forces and in potentials.
//!
//! With the clause `taylor`, each is derived and validated, and has finite accelerations, derivatives and series far from
//! where it is steep, where an exponential is beyond the range of numbers.

use lagrangian_symbolic::Symbol;
use proc_macro2::TokenStream;

use crate::plan::{NoTaylorSeries, Rates, TaylorMethod};
use crate::tests::derived::{Derived, derive};

/// A particle under this force, or in this potential.
fn declaration(clause: &str, function: &str) -> TokenStream {
    let text = format!(
        "#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), {clause} = {function})]
         struct Steep {{ a: f64, n: f64 }}"
    );
    text.parse().unwrap()
}

/// The value of a symbol at x, at unit velocity.
fn at(x: f64, acceleration: f64) -> impl Fn(Symbol) -> f64 {
    move |symbol| match symbol {
        Symbol::Coordinate(_) => x,
        Symbol::Velocity(_) => 1.0,
        Symbol::Acceleration(_) => acceleration,
        Symbol::Parameter(0) => 1.5,
        _ => 2.0,
    }
}

/// The acceleration and its coefficients of order 1 and 2.
fn series(taylor: &TaylorMethod, setup: &[f64], x: f64, acceleration: f64) -> [f64; 3] {
    let of_setup = |symbol, other: f64| match symbol {
        Symbol::Invariant(i) => setup.get(i as usize).copied().unwrap_or(f64::NAN),
        _ => other,
    };
    let mut initial = taylor
        .program
        .initial
        .evaluate(|symbol| of_setup(symbol, at(x, acceleration)(symbol)));
    let invariants = initial.pop().unwrap_or_default();
    let mut found = [acceleration, 0.0, 0.0];
    let mut factors: Vec<Vec<f64>> = Vec::new();
    for (k, order) in [(1, 1.0), (2, 2.0)] {
        let value = |symbol: Symbol| match symbol {
            Symbol::Order => order,
            Symbol::ReciprocalOrder => 1.0 / order,
            Symbol::Convolution(i) => {
                let pair = &taylor.program.convolutions[i as usize];
                (1..k)
                    .map(|j| factors[j - 1][pair.0] * factors[k - j - 1][pair.1])
                    .sum()
            }
            Symbol::Invariant(i) => invariants[i as usize],
            Symbol::Coordinate(_) if k == 1 => 1.0,
            Symbol::Coordinate(_) => acceleration / 2.0,
            Symbol::Velocity(_) => found[k - 1] / order,
            _ => 0.0,
        };
        let mut terms = taylor.program.recurrence.evaluate(value).concat();
        found[k] = terms[0];
        factors.push(terms.split_off(1));
    }
    found
}

/// What is computed at x: q̈, ∂q̈/∂q and the coefficients of q̈.
struct Steep {
    derived: Derived,
    taylor: Result<TaylorMethod, NoTaylorSeries>,
}

impl Steep {
    fn of(clause: &str, function: &str) -> Self {
        let mut derived = derive(declaration(clause, function));
        let Derived {
            model,
            equations,
            methods,
            ..
        } = &mut derived;
        let taylor = methods.taylor_method(model, equations);
        Self { derived, taylor }
    }

    fn values(&self, x: f64) -> [f64; 4] {
        let methods = &self.derived.methods;
        let setup = methods.prepare.program.evaluate(at(x, 0.0)).concat();
        let run = |program: &lagrangian_symbolic::Program, acceleration: f64| {
            let value = |symbol: Symbol| match symbol {
                Symbol::Invariant(i) => setup[i as usize],
                _ => at(x, acceleration)(symbol),
            };
            program.evaluate(value).concat()
        };
        let acceleration = run(&methods.accelerations.program, 0.0).pop().unwrap();
        let linearization = run(&methods.linearize.as_ref().unwrap().program, acceleration);
        let [value, first, second] = match &self.taylor {
            Ok(taylor) if matches!(taylor.rates, Rates::Accelerations(_)) => {
                series(taylor, &setup, x, acceleration)
            }
            Ok(_) => [acceleration; 3],
            Err(_) => [f64::NAN; 3],
        };
        let pivots = methods
            .linearize
            .as_ref()
            .unwrap()
            .outputs
            .pivots()
            .unwrap_or(0);
        [value, linearization[pivots + 1], first, second]
    }
}

/// Functions of x with a slope k.
const FUNCTIONS: [&str; 30] = [
    "ln(1.0 + exp(k * x))",
    "1.0 / (1.0 + exp(k * x))",
    "exp(k * x) / (1.0 + exp(k * x))",
    "exp(k * x) / (1.0 + exp(k * x)).powi(2)",
    "tanh(k * x)",
    "1.0 / cosh(k * x)",
    "1.0 / cosh(k * x).powi(2)",
    "ln(cosh(k * x))",
    "exp(-(k * x).powi(2))",
    "(exp(k * x) - exp(-k * x)) / (exp(k * x) + exp(-k * x))",
    "2.0 / (exp(k * x) + exp(-k * x))",
    "ln(exp(k * x) + exp(-k * x))",
    "exp(2.0 * k * x) / (exp(2.0 * k * x) + exp(k * x) + 1.0)",
    "1.0 / (2.0 + a * exp(k * x))",
    "ln(3.0 + a * exp(k * x))",
    "(1.0 + exp(k * x)).powf(-n)",
    "(1.0 + exp(k * x)).powf(-0.5)",
    "atan(exp(k * x))",
    "x / (1.0 + exp(-k * x))",
    "sinh(k * x) / cosh(k * x)",
    "k * x / sqrt(1.0 + (k * x).powi(2))",
    "atan(k * x)",
    "(1.0 + (k * x).powi(2)).powf(-1.5)",
    "1.0 / (1.0 + (k * x).powi(4))",
    "asinh(k * x)",
    "sqrt(1.0 + (k * x).powi(2))",
    "(exp(k * x) - 1.0) / (exp(k * x) + 1.0)",
    "1.0 / (1.0 + exp(k * x) + exp(-k * x))",
    "1.0 / (1.0 + cosh(k * x))",
    "ln(1.0 + exp(k * x) + exp(3.0 * k * x))",
];

/// Functions of such functions.
const OUTER: [&str; 8] = [
    "tanh(f)",
    "1.0 / (1.0 + exp(-f))",
    "ln(1.0 + exp(f))",
    "sqrt(1.0 + (f).powi(2))",
    "(f).powi(2)",
    "1.0 / (2.0 + (f).powi(2))",
    "ln(cosh(f))",
    "atan(f)",
];

fn with_slope(function: &str, k: &str) -> String {
    function.replace("k *", &format!("{k} *"))
}

/// Checks one function as a force and as a potential.
fn check(function: &str) {
    for (clause, function) in [
        ("force(x", format!("{function})")),
        ("potential", function.into()),
    ] {
        let steep = Steep::of(clause, &function);
        let methods = &steep.derived.methods;
        let wrong = methods.disagreements(&steep.derived.validator);
        assert!(wrong.is_empty(), "{clause} = {function}: {wrong:?}");
        assert!(steep.taylor.is_ok(), "{clause} = {function}: no series");
        for x in [-1e3, -800.0, -40.0, -0.3, 0.0, 0.02, 2.7, 45.0, 800.0, 1e3] {
            let values = steep.values(x);
            let is_finite = values.iter().all(|x| x.is_finite());
            assert!(is_finite, "{clause} = {function} at {x}: {values:?}");
        }
    }
}

#[test]
fn steep_functions_are_derived_with_series() {
    for function in FUNCTIONS {
        for slope in ["1.0", "20.0", "1000.0", "10000.0"] {
            check(&with_slope(function, slope));
        }
    }
}

#[test]
fn functions_of_steep_functions_are_derived_with_series() {
    for (i, function) in FUNCTIONS.into_iter().enumerate() {
        for (j, outer) in OUTER
            .into_iter()
            .enumerate()
            .filter(|(j, _)| (i + j) % 3 == 0)
        {
            let slope = ["1.0", "20.0", "1000.0"][(i + j) / 3 % 3];
            let inner = with_slope(function, slope);
            check(
                &outer
                    .replace("f)", &format!("{inner})"))
                    .replace("f))", &format!("{inner}))")),
            );
        }
    }
}

/// σ(x), with all digits in both tails.
fn logistic(x: f64) -> f64 {
    if x < 0.0 {
        x.exp() / (1.0 + x.exp())
    } else {
        1.0 / (1.0 + (-x).exp())
    }
}

#[test]
fn logistic_functions_keep_their_digits() {
    let force = Steep::of("force(x", "1.0 / (1.0 + exp(-3.0 * x)))");
    let potential = Steep::of("potential", "ln(1.0 + exp(3.0 * x))");
    for x in [-300.0, -120.0, -12.0, -1.0, 0.0, 0.4, 5.0, 60.0, 300.0] {
        let [s, c] = [logistic(3.0 * x), logistic(-3.0 * x)];
        // w = σ(3x), and the series of w and of −3 w along x(t) = x + t + ½ q̈ t² + ….
        let [slope, curvature] = [3.0 * s * c, 9.0 * s * c * (c - s)];
        let force_series = [s, slope, slope, f64::midpoint(curvature, slope * s)];
        let a = -3.0 * s;
        let potential_series = [
            a,
            -3.0 * slope,
            -3.0 * slope,
            (-3.0 * curvature - 3.0 * slope * a) / 2.0,
        ];
        for (steep, expected) in [(&force, force_series), (&potential, potential_series)] {
            let found = steep.values(x);
            let size = 9.0 * s * c + 9.0 * s * s * c;
            for (i, (found, expected)) in found.into_iter().zip(expected).enumerate() {
                let allowed = 1e-12 * if i == 3 { size } else { expected.abs() };
                assert!(
                    (found - expected).abs() <= allowed,
                    "{i} at {x}: {found} {expected}"
                );
            }
        }
    }
}
