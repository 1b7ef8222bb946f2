//! The building blocks of Taylor series: against the functions themselves, in double-doubles, and in equations of motion
//! written by hand.

use lagrangian::prelude::*;
use lagrangian::recurrences::{
    ArcCosine, ArcSine, ArcTangent, ArcTangent2, Exponential, HyperbolicSineCosine,
    HyperbolicTangent, InverseHyperbolicCosine, InverseHyperbolicSine, InverseHyperbolicTangent,
    Logarithm, Power, Product, Quotient, SineCosine, Square, SquareRoot, Tangent,
};
use lagrangian::{DoubleDouble, Lanes, Series, SeriesMemory, TaylorCoefficients};
use nalgebra::SVector;

const HALF: usize = 12;

type D = DoubleDouble;

/// Two cubic polynomials as series.
const X: [f64; 4] = [0.375, 0.75, -0.25, 0.125];
const Y: [f64; 4] = [1.5, -0.5, 0.25, 1.0];

fn polynomial(coefficients: [f64; 4], tau: D) -> D {
    let terms = coefficients.iter().rev();
    terms.fold(D::from_f64(0.0), |sum, c| sum * tau + D::from_f64(*c))
}

/// Fails unless the series of a function of two series is the function of their sums.
fn check(name: &str, mut next: impl FnMut(D, D) -> D, function: impl Fn(D, D) -> D) {
    let term = |of: [f64; 4], k: usize| D::from_f64(of.get(k).copied().unwrap_or(0.0));
    let series: Vec<D> = (0..2 * HALF)
        .map(|k| next(term(X, k), term(Y, k)))
        .collect();
    for tau in [0.0, 1.0 / 64.0, -1.0 / 64.0, 1.0 / 80.0] {
        let tau = D::from_f64(tau);
        let sum = series
            .iter()
            .rev()
            .fold(D::from_f64(0.0), |sum, c| sum * tau + *c);
        let expected = function(polynomial(X, tau), polynomial(Y, tau));
        let error = (sum - expected).abs().to_f64() / expected.abs().to_f64();
        assert!(error < 1e-28, "{name} at {}: {error:e}", tau.to_f64());
    }
}

#[test]
fn functions_of_series_are_series_of_functions() {
    let mut block = Product::<D, HALF>::new();
    check("product", |x, y| block.next(x, y), |x, y| x * y);
    let mut block = Square::<D, HALF>::new();
    check("square", |x, _| block.next(x), |x, _| x * x);
    let mut block = Quotient::<D, HALF>::new();
    check("quotient", |x, y| block.next(x, y), |x, y| x / y);
    let mut block = SquareRoot::<D, HALF>::new();
    check("root", |x, _| block.next(x), |x, _| x.sqrt());
    for exponent in [-1.5, 0.0, 0.25, 3.0] {
        let exponent = D::from_f64(exponent);
        let mut block = Power::<D, HALF>::new(exponent);
        check("power", |x, _| block.next(x), |x, _| x.powf(exponent));
    }
    let mut block = ArcTangent2::<D, HALF>::new();
    check("angle", |x, y| block.next(x, y), D::atan2);
}

/// The coefficients of a power of a polynomial, from those of x and of z, by the terms of order 0, 1, ….
fn power<S: Scalar>(exponent: S, x: [S; 4]) -> Vec<S> {
    let mut block = Power::<S, HALF>::new(exponent);
    let term = |k: usize| x.get(k).copied().unwrap_or(S::zero());
    (0..2 * HALF).map(|k| block.next(term(k))).collect()
}

#[test]
fn powers_of_what_vanishes_have_series() {
    let number = |x: f64| D::from_f64(x);
    // Of (xₘ tᵐ + …)ⁿ for whole m n: the power of the other factor, m n orders higher; for others 0.
    for m in 1..4 {
        let x: [f64; 4] = core::array::from_fn(|k| if k < m { 0.0 } else { X[k] + 0.5 });
        let other = core::array::from_fn(|k| number(x.get(k + m).copied().unwrap_or(0.0)));
        for n in [0.0, 1.0, 1.5, 2.0, 3.0, 4.0, 7.0, 11.0, 40.0] {
            let found = power(number(n), x.map(number));
            let factor = power(number(n), other);
            let shift = n * f64::from(u32::try_from(m).unwrap());
            for (k, found) in (0_u32..).zip(&found) {
                let k = f64::from(k);
                let index = k - shift;
                let expected = if index < 0.0 || index.fract() > 0.0 {
                    number(0.0)
                } else {
                    // Small whole numbers.
                    let index =
                        (0..2 * HALF).find(|i| f64::from(u32::try_from(*i).unwrap()) >= index);
                    factor[index.unwrap()]
                };
                let error = (*found - expected).abs().to_f64();
                assert!(
                    error <= 1e-29 * (1.0 + expected.abs().to_f64()),
                    "{n}, {m}, order {k}: {} {}",
                    found.to_f64(),
                    expected.to_f64()
                );
            }
        }
    }
}

#[test]
fn powers_of_what_vanishes_in_some_lanes_have_their_series() {
    let starts = [[0.375, 0.75], [0.0, 0.75], [0.0, 0.0], [-0.5, 0.0]];
    for n in [0.0, 1.0, 3.0, 4.0, 5.0] {
        let x = |k: usize| starts.map(|start| [start[0], start[1], -0.25, 0.125][k]);
        let found = power(Lanes([n; 4]), core::array::from_fn(|k| Lanes(x(k))));
        for lane in 0..4 {
            let alone = power(n, core::array::from_fn(|k| x(k)[lane]));
            for (found, alone) in found.iter().zip(alone) {
                let difference = (found.in_lane(lane) - alone).abs();
                assert!(difference <= 0.0, "{n} {lane}: {found:?} {alone}");
            }
        }
    }
}

#[test]
fn sines_and_cosines_are_pairs() {
    let mut block = SineCosine::<D, HALF>::new();
    check("sine", |x, _| block.next(x).0, |x, _| x.sin());
    let mut block = SineCosine::<D, HALF>::new();
    check("cosine", |x, _| block.next(x).1, |x, _| x.cos());
    let mut block = HyperbolicSineCosine::<D, HALF>::new();
    check("hyperbolic sine", |x, _| block.next(x).0, |x, _| x.sinh());
    let mut block = HyperbolicSineCosine::<D, HALF>::new();
    check("hyperbolic cosine", |x, _| block.next(x).1, |x, _| x.cosh());
}

macro_rules! functions {
    ($($block:ident $function:ident $argument:tt;)*) => {
        #[test]
        fn functions_of_one_series() {
            $(
                let mut block = $block::<D, HALF>::new();
                check(
                    stringify!($function),
                    |x, y| block.next([x, y][$argument]),
                    |x, y| [x, y][$argument].$function(),
                );
            )*
        }
    };
}

functions! {
    Exponential exp 0; Logarithm ln 0; Tangent tan 0; HyperbolicTangent tanh 0;
    ArcSine asin 0; ArcCosine acos 0; ArcTangent atan 0;
    InverseHyperbolicSine asinh 0; InverseHyperbolicCosine acosh 1; InverseHyperbolicTangent atanh 0;
}

/// θ̈ = −sin θ − sin t θ̇: a pendulum by hand.
struct ByHand;

#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(theta),
    kinetic = 0.5 * dot(theta).powi(2),
    potential = -cos(theta),
    force(theta = -sin(t) * dot(theta)),
)]
struct Derived;

impl<S: Scalar> Dynamics<S> for ByHand {
    type State = SVector<S, 2>;

    fn derivative(&self, t: S, x: &Self::State) -> Self::State {
        SVector::from([x[1], -x[0].sin() - t.sin() * x[1]])
    }
}

impl<S: Scalar> Series<S> for ByHand {
    fn series<const HALF: usize>(
        &self,
        (t, x): (S, &Self::State),
        unit: S,
        coefficients: &mut TaylorCoefficients<Self::State, HALF>,
        _: Option<&mut SeriesMemory>,
    ) {
        let mut angle = SineCosine::<S, HALF>::new();
        let mut time = SineCosine::<S, HALF>::new();
        let mut friction = Product::<S, HALF>::new();
        coefficients.solve(t, x, unit, |order, x| {
            let (restoring, _) = angle.next(x[0]);
            let (rate, _) = time.next(order.time());
            SVector::from([x[1], -restoring - friction.next(rate, x[1])])
        });
    }
}

#[test]
fn motions_by_hand_are_those_of_the_derived_model() {
    let number = D::from_f64;
    let method = Taylor::order_40();
    let by_hand = At::from((number(1.0), SVector::from([2.0, 0.5].map(number))));
    let by_hand = Problem::new(&ByHand, by_hand).solve(20.0, method).unwrap();
    let start = State::new(number(1.0), [number(2.0)], [number(0.5)]);
    let derived = Problem::new(&Derived, start).solve(20.0, method).unwrap();
    for (by_hand, derived) in [(by_hand[0], derived.q[0]), (by_hand[1], derived.v[0])] {
        let difference = (by_hand - derived).largest();
        assert!(difference.abs() < 1e-27, "{difference}");
    }
}

#[test]
fn the_orders_of_a_constant() {
    let mut coefficients = TaylorCoefficients::<SVector<f64, 1>, 2>::new(SVector::from([0.0]));
    // ẋ = 3 + t from x = 1 at t = 2, in units of 2: 1 + 10 τ + 2 τ².
    coefficients.solve(2.0, &SVector::from([1.0]), 2.0, |order, _| {
        SVector::from([order.constant(3.0) + order.time()])
    });
    let higher: Vec<f64> = coefficients.higher().iter().map(|x| x[0]).collect();
    assert_eq!(coefficients.initial()[0].to_bits(), 1.0_f64.to_bits());
    assert_eq!(higher, [10.0, 2.0, 0.0, 0.0]);
}

#[test]
fn too_many_orders_are_no_panic() {
    let mut block = Quotient::<f64, 1>::new();
    let mut angle = ArcTangent2::<f64, 1>::new();
    let mut power = Power::<f64, 1>::new(0.5);
    for _ in 0..5 {
        let _ = (block.next(1.0, 2.0), angle.next(1.0, 2.0), power.next(1.0));
    }
    let mut nothing = SquareRoot::<f64, 0>::new();
    let _ = (nothing.next(1.0), nothing.next(1.0));
}
