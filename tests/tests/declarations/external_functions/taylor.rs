//! Taylor series of models with external functions, beside those of the same models with built-in ones.

use lagrangian::prelude::*;
use lagrangian::quantities::MotionSeries;
use lagrangian::{DoubleDouble, Scalar, Series, TaylorCoefficients};
use lagrangian_tests::assert_close;

/// Half the order of the polynomials.
const HALF: usize = 10;

fn sine<S: Scalar>(x: S) -> S {
    x.sin()
}

fn cosine<S: Scalar>(x: S) -> S {
    x.cos()
}

fn tanh<S: Scalar>(x: S) -> S {
    x.tanh()
}

/// Of a gas in a cylinder.
fn quotient<S: Scalar>(volume: S, temperature: S) -> S {
    temperature / volume
}

/// A driven pendulum with saturated damping, whose functions are external; it hangs from a piston.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(theta, x),
    function(my_sine(x) = sine(x), derivative(x) = my_cosine(x)),
    function(my_cosine(x) = cosine(x), derivative(x) = -my_sine(x)),
    function(saturation(x) = tanh(x), derivative(x) = 1.0 - saturation(x).powi(2)),
    function(
        pressure(volume, temperature) = quotient(volume, temperature),
        derivative(volume) = -pressure(volume, temperature) * pressure(volume, 1.0),
        derivative(temperature) = pressure(volume, 1.0),
    ),
    define(p = [x + l * my_sine(theta), -l * my_cosine(theta)]),
    kinetic = 0.5 * m * dot(p).norm_squared() + 0.5 * piston * dot(x).powi(2),
    potential = m * g * p.y,
    force(
        theta = -c * saturation(dot(theta) / l) + my_sine(1.5 * t),
        x = pressure(1.5 + x, heat * my_cosine(t) + 2.0) - pressure(1.5 - x, 3.0),
    ),
    event(vertical = my_sine(theta), slow = saturation(dot(theta)) - 0.01),
)]
struct External<T: Scalar> {
    m: T,
    g: T,
    l: T,
    c: T,
    piston: T,
    heat: T,
}

/// The same in the functions of the language.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(theta, x),
    define(p = [x + l * sin(theta), -l * cos(theta)]),
    kinetic = 0.5 * m * dot(p).norm_squared() + 0.5 * piston * dot(x).powi(2),
    potential = m * g * p.y,
    force(
        theta = -c * tanh(dot(theta) / l) + sin(1.5 * t),
        x = (heat * cos(t) + 2.0) / (1.5 + x) - 3.0 / (1.5 - x),
    ),
    event(vertical = sin(theta), slow = tanh(dot(theta)) - 0.01),
)]
struct BuiltIn<T: Scalar> {
    m: T,
    g: T,
    l: T,
    c: T,
    piston: T,
    heat: T,
}

macro_rules! with_parameters {
    ($model:ident, $scalar:ty) => {
        $model {
            m: <$scalar>::from_f64(0.7),
            g: <$scalar>::from_f64(9.81),
            l: <$scalar>::from_f64(0.9),
            c: <$scalar>::from_f64(0.4),
            piston: <$scalar>::from_f64(1.3),
            heat: <$scalar>::from_f64(0.8),
        }
    };
}

/// The coefficients of a motion, one after the other.
fn coefficients<M>(model: &M) -> Vec<DoubleDouble>
where
    M: Lagrangian<2, DoubleDouble, Model: MotionSeries<2, DoubleDouble>>,
{
    let exact = |values: [f64; 2]| values.map(DoubleDouble::from_f64);
    let x = Phase::new(exact([0.7, -0.2]), exact([1.9, 0.6]));
    let mut polynomial = TaylorCoefficients::<_, HALF>::new(x);
    let [t, unit] = exact([0.7, 0.25]);
    model
        .dynamics()
        .series((t, &x), unit, &mut polynomial, None);
    let higher = polynomial.higher().iter();
    let phases = higher.flat_map(|x| x.q.iter().chain(&x.v));
    phases.copied().collect()
}

#[test]
fn coefficients_are_those_of_built_in_functions() {
    let found = coefficients(&with_parameters!(External, DoubleDouble));
    let expected = coefficients(&with_parameters!(BuiltIn, DoubleDouble));
    assert_eq!(found.len(), expected.len());
    for (index, (found, expected)) in found.iter().zip(&expected).enumerate() {
        let [difference, size] = [*found - *expected, *expected].map(|x| x.abs().largest());
        let allowed = 1e-27 * size.max(1e-6);
        assert!(difference <= allowed, "{index}: {difference:e} of {size:e}");
    }
}

#[test]
fn motions_are_those_of_built_in_functions() {
    let start = State::new(0.0, [1.2, 0.1], [0.0, 0.0]);
    let external = with_parameters!(External, f64);
    let built_in = with_parameters!(BuiltIn, f64);
    let found = Problem::new(&external, start).solve(10.0, Taylor::new());
    let expected = Problem::new(&built_in, start).solve(10.0, Taylor::new());
    let [found, expected] = [found, expected].map(Result::unwrap);
    for (found, expected) in [(found.q, expected.q), (found.v, expected.v)] {
        assert_close("motion", found.as_slice(), expected.as_slice(), 1e-12);
    }
}

/// Zeros without a change of sign, and two within one step, are found: the series of the events are known.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    function(my_sine(x) = sine(x), derivative(x) = my_cosine(x)),
    function(my_cosine(x) = cosine(x), derivative(x) = -my_sine(x)),
    kinetic = 0.5 * dot(x).powi(2),
    event(touch = 1.0 - my_sine(x), pair = my_cosine(x) * my_cosine(x + 1e-4)),
)]
struct Free;

#[test]
fn events_of_external_functions_have_series() {
    let motion = Problem::new(&Free, State::new(0.0, [0.0], [1.0]))
        .on([Free::TOUCH, Free::PAIR])
        .record()
        .solve(3.0, Taylor::new())
        .unwrap();
    let times = |event: usize| -> Vec<f64> {
        let events = motion.events().iter();
        let events = events.filter(|occurrence| occurrence.event == event);
        events.map(|occurrence| occurrence.t).collect()
    };
    let quarter = core::f64::consts::FRAC_PI_2;
    let [touches, pair] = [0, 1].map(times);
    // A double root is as sharp as the root of the rounding errors.
    assert_eq!((touches.len(), pair.len()), (1, 2));
    assert!((touches[0] - quarter).abs() < 1e-7, "{touches:?}");
    assert_close("pair", &pair, &[quarter - 1e-4, quarter], 1e-9);
}

/// A spring that is stiffer behind a stop, from a table of straight pieces.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    scalar = f64,
    coordinates(x),
    function(table(x) = pull(x), derivative(x) = slope(x)),
    function(slope(x) = if x < 0.5 { 1.0 } else { 9.0 }, derivative(x) = 0.0),
    kinetic = 0.5 * dot(x).powi(2),
    force(x = -table(x)),
)]
struct Stop;

fn pull(x: f64) -> f64 {
    if x < 0.5 { x } else { 0.5 + 9.0 * (x - 0.5) }
}

/// Steps end at the corners of a function. Of 2,000 motions like these, the largest error is 3.5e-13.
#[test]
fn corners_of_a_table_are_met() {
    for speed in (0..30).map(|i| 0.7 + 0.02 * f64::from(i)) {
        let start = State::new(0.0, [0.0], [speed]);
        let motion = Problem::new(&Stop, start).solve(1.0, Taylor::new());
        let motion = motion.unwrap();
        assert!(motion.statistics.steps < 20);
        // x = speed · sin t until x = 1/2; then 9 (x − 4/9) is the force.
        let corner = (0.5 / speed).asin();
        let phase = 3.0 * (1.0 - corner);
        let (offset, speed) = (1.0 / 18.0, speed * corner.cos());
        let x = 4.0 / 9.0 + offset * phase.cos() + speed / 3.0 * phase.sin();
        let v = speed * phase.cos() - 3.0 * offset * phase.sin();
        assert_close("motion", &[motion.q[0], motion.v[0]], &[x, v], 5e-13);
    }
}

/// A pendulum with a sine whose second derivative has the wrong sign.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    function(my_sine(x) = sine(x), derivative(x) = my_cosine(x)),
    function(my_cosine(x) = cosine(x), derivative(x) = my_sine(x)),
    kinetic = 0.5 * dot(x).powi(2),
    force(x = -my_sine(x)),
)]
struct Wrong;

/// The end of each step is compared with the equations of motion: one step without that would change
/// the energy by sin ½ · 0.1³/3.
#[test]
fn a_wrong_derivative_makes_small_steps_and_no_wrong_motion() {
    let start = State::new(0.0, [0.5], [1.0]);
    let motion = Problem::new(&Wrong, start).solve(0.1, Taylor::new());
    let motion = motion.unwrap();
    assert!(motion.statistics.steps > 300);
    let energies = [motion.last, start].map(|x| 0.5 * x.v[0] * x.v[0] - x.q[0].cos());
    assert_close("energy", &energies[..1], &energies[1..], 1e-9);
}
