//! Taylor series of motions: whether the polynomials satisfy the equations of motion.
//!
//! The derivative of the polynomial of order 8, after a time at which its last term is about 10⁻²² of the first, is
//! compared with the derivative that the equations give there, in double-double arithmetic: a wrong coefficient of any
//! order shows.

use lagrangian::prelude::*;
use lagrangian::quantities::MotionSeries;
use lagrangian::{DoubleDouble, Series, TaylorCoefficients};
use lagrangian_tests::{Figures, Parametrized, array, list, number, public_cases};
use serde_json::Value;

/// Half the order of the polynomials.
const HALF: usize = 4;

/// The size of the last term after the time of the comparison, relative to the first.
const LAST_TERM: f64 = 1e-22;

/// Relative to the greatest derivative. A coefficient of order 8 that is off by its size makes 8·10⁻²²; the terms that
/// are left out are smaller by the cube root of 10.
const TOLERANCE: f64 = 2e-23;

/// A case: its identifier, and the residual at one of its states.
type Row = (&'static str, fn(&Value, &Value) -> f64);

const CASES: &[Row] = &lagrangian_tests::public_cases!(free, driven);

#[test]
fn polynomials_satisfy_the_equations_of_motion() {
    let mut figures = Figures::new();
    for (case, &(id, residual)) in public_cases().iter().zip(CASES) {
        assert_eq!(case["id"], id);
        for (index, state) in list(&case["states"]).iter().enumerate() {
            let at = format!("{id}, state {index}");
            figures.record("residual", &at, residual(case, state), TOLERANCE);
        }
    }
    figures.finish();
}

/// A mass under a force that is a function of its position, for each of several functions.
macro_rules! forces {
    ($($model:ident($x:ident, $y:ident) = $force:expr, from $start:expr;)*) => {
        $(
            #[derive(Lagrangian)]
            #[lagrangian(
                taylor,
                coordinates($x, $y),
                kinetic = 0.5 * (dot($x).powi(2) + dot($y).powi(2)),
                force($x = $force, $y = -$y),
            )]
            struct $model;
        )*

        /// The residuals, with the function.
        fn residuals_of_functions() -> Vec<(&'static str, f64)> {
            vec![$((stringify!($force), residual(&$model, plane($start))),)*]
        }
    };
}

forces! {
    Sine(x, y) = sin(x), from [0.3, 0.8];
    Cosine(x, y) = cos(x), from [0.3, 0.8];
    Both(x, y) = sin(x) * cos(x), from [0.3, 0.8];
    Tangent(x, y) = tan(x), from [0.3, 0.8];
    ArcSine(x, y) = asin(x), from [0.3, 0.8];
    ArcCosine(x, y) = acos(x), from [0.3, 0.8];
    ArcTangent(x, y) = atan(x), from [0.3, 0.8];
    HyperbolicSine(x, y) = sinh(x), from [0.3, 0.8];
    HyperbolicCosine(x, y) = cosh(x), from [0.3, 0.8];
    BothHyperbolic(x, y) = sinh(x) * cosh(x), from [0.3, 0.8];
    HyperbolicTangent(x, y) = tanh(x), from [0.3, 0.8];
    AreaSine(x, y) = asinh(x), from [0.3, 0.8];
    AreaCosine(x, y) = acosh(x), from [1.3, 0.8];
    AreaTangent(x, y) = atanh(x), from [0.3, 0.8];
    Exponential(x, y) = exp(x), from [0.3, 0.8];
    Logarithm(x, y) = ln(x), from [0.3, 0.8];
    Root(x, y) = sqrt(x), from [0.3, 0.8];
    CubeRoot(x, y) = x.powf(1.0 / 3.0), from [0.3, 0.8];
    NegativePower(x, y) = x.powi(-3), from [-0.3, 0.8];
    HighPower(x, y) = x.powi(13), from [-0.9, 0.8];
    GeneralPower(x, y) = x.powf(y), from [0.3, 0.8];
    PowerOfNumber(x, y) = powf(1.7, x), from [0.3, 0.8];
    Quotient(x, y) = y / x, from [0.3, 0.8];
    QuotientOfNumber(x, y) = 2.0 / x, from [0.3, 0.8];
    Angle(x, y) = atan2(x, y), from [-0.3, -0.8];
    AngleToNumber(x, y) = atan2(2.0, x), from [0.3, 0.8];
    AngleFromNumber(x, y) = atan2(x, -2.0), from [0.3, 0.8];
    Magnitude(x, y) = abs(x * y), from [-0.3, 0.8];
    Sign(x, y) = signum(x) * y, from [-0.3, 0.8];
    Lesser(x, y) = min(x, y * y), from [-0.3, 0.8];
    Greater(x, y) = max(x, y * y), from [-0.3, 0.8];
    OfTime(x, y) = sin(t * x) / (1.0 + t * t), from [0.3, 0.8];
    OfVelocity(x, y) = -dot(x) * abs(dot(x)) - dot(y), from [0.3, 0.8];
}

/// A state at t = 0.7 with a velocity.
fn plane(q: [f64; 2]) -> State<DoubleDouble, 2> {
    State::new(
        DoubleDouble::from_f64(0.7),
        q.map(DoubleDouble::from_f64),
        [0.4, -0.9].map(DoubleDouble::from_f64),
    )
}

#[test]
fn every_function_has_a_series() {
    let mut figures = Figures::new();
    for (function, residual) in residuals_of_functions() {
        figures.record("residual", function, residual, TOLERANCE);
    }
    figures.finish();
}

/// Nine angles, each of which meets every other one in T: M is factored numerically.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(q[9]),
    kinetic = (0..9).map(|i| 0.5 * m * dot(q[i]).powi(2) * (2.0 + sin(q[i]))).sum()
        + (0..9).map(|i| (0..9).map(|j| 0.05 * m * cos(q[i] - 2 * q[j]) * dot(q[i]) * dot(q[j])).sum()).sum(),
    potential = (0..9).map(|i| -m * cos(q[i] + t)).sum(),
)]
struct Coupled {
    m: f64,
}

#[test]
fn systems_that_are_solved_numerically_have_series() {
    let values = |scale: f64| {
        let mut angle = 0.0_f64;
        [scale; 9].map(|scale| {
            angle += 1.3;
            scale * angle.cos()
        })
    };
    let exact = |values: [f64; 9]| values.map(DoubleDouble::from_f64);
    let state = State::new(
        DoubleDouble::from_f64(0.7),
        exact(values(0.8)),
        exact(values(-0.6)),
    );
    let mut figures = Figures::new();
    let residual = residual(&Coupled { m: 1.3 }, state);
    figures.record("residual", "nine coupled angles", residual, TOLERANCE);
    figures.finish();
}

/// A rotor with a product of inertia in bearings with friction, on a table whose speed grows: its series is that of
/// quasi-velocities, which do not vanish with the velocities.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(phi, theta, psi),
    define(
        nutation = dot(phi) + rate * t,
        w1 = nutation * sin(theta) * sin(psi) + dot(theta) * cos(psi),
        w2 = nutation * sin(theta) * cos(psi) - dot(theta) * sin(psi),
        w3 = nutation * cos(theta) + dot(psi),
    ),
    kinetic = 0.5 * (a * w1.powi(2) + b * w2.powi(2) + c * w3.powi(2)) - d * w1 * w2,
    potential = a * sin(theta) * cos(psi),
    dissipation = 0.5 * b * dot(psi).powi(2),
    force(theta = c * sin(t) - d * dot(theta) * abs(dot(theta))),
)]
struct RotorOnTable {
    a: f64,
    b: f64,
    c: f64,
    d: f64,
    rate: f64,
}

#[test]
fn quasi_velocities_in_a_moving_frame_have_series() {
    let rotor = RotorOnTable {
        a: 1.1,
        b: 1.7,
        c: 0.6,
        d: 0.3,
        rate: -0.8,
    };
    let exact = |values: [f64; 3]| values.map(DoubleDouble::from_f64);
    let state = State::new(
        DoubleDouble::from_f64(0.7),
        exact([0.4, -2.1, 1.3]),
        exact([0.9, -0.5, 2.2]),
    );
    let mut figures = Figures::new();
    figures.record("residual", "rotor", residual(&rotor, state), TOLERANCE);
    figures.finish();
}

fn free<M, const N: usize>(case: &Value, state: &Value) -> f64
where
    M: Parametrized + Lagrangian<N, DoubleDouble, Model: MotionSeries<N, DoubleDouble>>,
{
    let model = M::with(&|name| number(&case["params"][name]));
    residual(&model, point(state))
}

fn driven<M, const N: usize, const U: usize>(case: &Value, state: &Value) -> f64
where
    M: Parametrized + Lagrangian<N, DoubleDouble, Model: MotionSeries<N, DoubleDouble>>,
{
    let valued = |name: &str| {
        state["u"]
            .get(name)
            .unwrap_or_else(|| &case["params"][name])
    };
    let model = M::with(&|name| number(valued(name)));
    residual(&model, point(state))
}

fn point<const N: usize>(state: &Value) -> State<DoubleDouble, N> {
    let exact = |values: [f64; N]| values.map(DoubleDouble::from_f64);
    State::new(
        DoubleDouble::from_f64(number(&state["t"])),
        exact(array(&state["q"])),
        exact(array(&state["qd"])),
    )
}

/// The greatest difference between the derivative of the polynomial and that of the equations, relative to the latter.
fn residual<M, const N: usize>(model: &M, state: State<DoubleDouble, N>) -> f64
where
    M: Lagrangian<N, DoubleDouble, Model: MotionSeries<N, DoubleDouble>>,
{
    let dynamics = model.dynamics();
    let mut polynomial = TaylorCoefficients::<_, HALF>::new(Phase::from(state));
    let one = DoubleDouble::from_f64(1.0);
    let begin = (state.t, &state.into());
    dynamics.series(begin, one, &mut polynomial, None);
    let unit = DoubleDouble::from_f64(time_of_comparison(&polynomial));
    dynamics.series(begin, unit, &mut polynomial, None);
    let mut x = Phase::from(state);
    x.add_scaled(one, &polynomial.change(one));
    let expected = dynamics.derivative(state.t + unit, &x);
    let mut found = polynomial.derivative(one).map(|component| component / unit);
    found.add_scaled(-one, &expected);
    size(&found) / size(&expected)
}

/// The time at which the last terms are `LAST_TERM` relative to the first: a power of two.
fn time_of_comparison<const N: usize>(
    polynomial: &TaylorCoefficients<Phase<DoubleDouble, N>, HALF>,
) -> f64 {
    let higher = polynomial.higher();
    let rates = (1..).zip(&higher[1..]);
    let rates =
        rates.map(|(order, term)| (size(term) / size(&higher[0])).powf(1.0 / f64::from(order)));
    let rate = rates.fold(0.0, f64::max);
    let time = LAST_TERM.powf(1.0 / 7.0) / rate;
    time.log2().floor().min(0.0).exp2()
}

/// The greatest magnitude of a component; NaN if one is NaN.
fn size<const N: usize>(x: &Phase<DoubleDouble, N>) -> f64 {
    let sizes = x.components().map(|component| component.abs().to_f64());
    sizes.fold(
        0.0,
        |greatest, size| if size <= greatest { greatest } else { size },
    )
}
