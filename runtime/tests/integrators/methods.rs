//! One table of all methods; each row runs all tests: order by slope, exactness on polynomials, reversibility, dense
//! output, events, conservation.

use crate::common::{Oscillator, assert_close};
use lagrangian::prelude::*;
use lagrangian::{
    ButcherTableau, DoubleDouble, Series, SeriesMemory, SingleNumber, TaylorCoefficients,
};

type X<S> = SVector<S, 2>;

/// Explicit midpoint: C. Runge, Math. Ann. 46 (1895) 167.
const MIDPOINT: ButcherTableau<2> = ButcherTableau {
    nodes: [0.0, 0.5],
    matrix: [&[], &[0.5]],
    weights: [0.0, 1.0],
};

/// ẋ = (p + 1) tᵖ, ẏ = 0, whose solution is a polynomial of degree p + 1.
struct Power(u16);

impl<S: Scalar> Dynamics<S> for Power {
    type State = X<S>;

    fn derivative(&self, t: S, _: &X<S>) -> X<S> {
        SVector::from([number::<S>(self.0 + 1) * power(t, self.0), S::zero()])
    }
}

impl<S: Scalar> Series<S> for Power {
    fn series<const HALF: usize>(
        &self,
        (t, x): (S, &X<S>),
        unit: S,
        coefficients: &mut TaylorCoefficients<X<S>, HALF>,
        _: Option<&mut SeriesMemory>,
    ) {
        *coefficients.initial_mut() = *x;
        // (t + u)ᵖ⁺¹ by the binomial theorem.
        let degree = self.0 + 1;
        let mut binomial = S::one();
        for (k, coefficient) in (1..).zip(coefficients.higher_mut()) {
            let term = if k <= degree {
                binomial *= number::<S>(degree - k + 1) / number(k);
                binomial * power(t, degree - k) * power(unit, k)
            } else {
                S::zero()
            };
            *coefficient = SVector::from([term, S::zero()]);
        }
    }
}

fn number<S: Scalar>(x: u16) -> S {
    S::from_f64(x.into())
}

fn power<S: Scalar>(x: S, exponent: u16) -> S {
    (0..exponent).fold(S::one(), |product, _| product * x)
}

/// The state of the oscillator.
fn exact<S: Scalar>(t: f64) -> X<S> {
    let (sine, cosine) = S::from_f64(t).sin_cos();
    SVector::from([cosine, -sine])
}

/// The largest difference of two states.
fn distance<S: Scalar>(x: &X<S>, y: &X<S>) -> f64 {
    let differences = x
        .iter()
        .zip(y.iter())
        .map(|(x, y)| (*x - *y).abs().largest());
    differences.fold(0.0, f64::max)
}

/// The oscillator from t = 0 on.
fn oscillator<S: Scalar>() -> Problem<S, Oscillator> {
    let (t, x) = (S::zero(), exact(0.0));
    Problem::new(Oscillator, At { t, x })
}

/// The error of the oscillator after two steps of this size, or at t = 2.
fn error<S: Scalar>(method: impl Integrator<S, Oscillator>, step: f64) -> f64 {
    let end = f64::max(2.0, 2.0 * step);
    let found = oscillator().solve(end, method).unwrap();
    distance(&found.x, &exact(end))
}

/// The order is the slope of log error over log step.
fn order<S: Scalar, I>(method: impl Fn(f64) -> I, order: u16, step: f64)
where
    I: Integrator<S, Oscillator> + Integrator<S, Power>,
{
    let errors = [step, 0.5 * step].map(|h| error::<S>(method(h), step));
    assert_close(
        (errors[0] / errors[1]).log2(),
        order.into(),
        0.08 * f64::from(order),
    );

    for degree in 0..order {
        let (t, x) = (S::zero(), SVector::from([S::zero(), S::one()]));
        let end = Problem::new(Power(degree), At { t, x }).solve(1.0, method(1.0));
        let expected = SVector::from([S::one(); 2]);
        assert!(distance(&end.unwrap().x, &expected) <= 64.0 * S::machine_epsilon());
    }
}

/// Forwards and back, dense output, events and the energy at small steps.
fn motion<S: SingleNumber, I>(method: I, accuracy: f64)
where
    I: Integrator<S, Oscillator> + Copy,
{
    let there = oscillator().solve(7.0, method).unwrap().last;
    let back = Problem::new(Oscillator, there).solve(0.0, method).unwrap();
    assert!(distance(&back.x, &exact(0.0)) < accuracy, "reversibility");
    let energy = there[0] * there[0] + there[1] * there[1];
    assert!(
        (energy - S::one()).abs().largest() < accuracy,
        "conservation"
    );

    let times: Vec<f64> = (1..=70).map(|i| 0.1 * f64::from(i)).collect();
    let sampled = oscillator::<S>().save(&times).solve(7.0, method).unwrap();
    for (sample, t) in sampled.samples().iter().zip(times) {
        let error = distance(&sample.x, &exact(t));
        assert!(error <= accuracy, "at {t}: {error:e}");
    }

    let mut at = At {
        t: S::zero(),
        x: exact(0.0),
    };
    for n in 0..4 {
        let until_zero = Problem::new(Oscillator, at).when(|x| x[0]).stop();
        let end = until_zero.solve(100.0, method).unwrap();
        assert_eq!(end.reason, StopReason::Condition);
        at = end.last;
        assert_close(
            at.t.largest(),
            std::f64::consts::PI * (f64::from(n) + 0.5),
            f64::max(2.0 * accuracy, 1e-14),
        );
    }
}

/// Bad tolerances, times and states are values, whatever the method.
fn bad_input(method: impl Integrator<f64, Oscillator> + Copy) {
    let run = |t: f64, x: f64, end: f64| {
        let x = SVector::from([x, 0.0]);
        let solved = Problem::new(Oscillator, At { t, x }).solve(end, method);
        solved.unwrap_err().error()
    };
    for wrong in [f64::NAN, f64::INFINITY] {
        assert!(matches!(
            run(wrong, 1.0, 1.0),
            IntegrationError::NonFiniteTime { .. }
        ));
        assert!(matches!(
            run(0.0, 1.0, wrong),
            IntegrationError::NonFiniteTime { .. }
        ));
        assert!(matches!(
            run(0.0, wrong, 1.0),
            IntegrationError::NonFiniteState { .. }
        ));
    }
}

fn fixed_dop853(step: f64) -> Dop853 {
    let method = Dop853::new().absolute_tolerance(1e9);
    method.initial_step(step).max_step(step)
}

/// Polynomials of degree n, whose ends are corrected by the derivative there: order n + 1.
fn fixed_taylor<const HALF: usize>(step: f64) -> Taylor<HALF> {
    Taylor::of_half_order()
        .absolute_tolerance(1e9)
        .max_step(step)
}

macro_rules! table {
    ($($name:ident: $method:expr, in $scalar:ty, order $order:literal from step $step:literal, $fine:expr, to $accuracy:literal;)*) => {
        $(#[test]
        fn $name() {
            order::<$scalar, _>($method, $order, $step);
            motion::<$scalar, _>($fine, $accuracy);
            bad_input($fine);
        })*
    };
}

table! {
    midpoint: |h| RungeKutta::new(MIDPOINT, h), in f64, order 2 from step 0.02, RungeKutta::new(MIDPOINT, 2.5e-3), to 1e-5;
    classical: RungeKutta::classical, in f64, order 4 from step 0.1, RungeKutta::classical(0.01), to 1e-8;
    dormand_prince: fixed_dop853, in f64, order 8 from step 0.5, Dop853::new(), to 1e-8;
    taylor_2: fixed_taylor::<1>, in f64, order 3 from step 0.02, fixed_taylor::<1>(2.5e-3), to 1e-5;
    taylor_4: fixed_taylor::<2>, in f64, order 5 from step 0.1, fixed_taylor::<2>(0.01), to 1e-8;
    taylor_6: fixed_taylor::<3>, in f64, order 7 from step 0.25, fixed_taylor::<3>(0.05), to 1e-8;
    taylor_8: fixed_taylor::<4>, in f64, order 9 from step 0.5, fixed_taylor::<4>(0.1), to 1e-9;
    taylor_12: fixed_taylor::<6>, in f64, order 13 from step 1.0, Taylor::order_12().relative_tolerance(1e-12), to 1e-9;
    taylor_16: fixed_taylor::<8>, in f64, order 17 from step 2.0, Taylor::order_16(), to 1e-12;
    taylor_28: fixed_taylor::<14>, in DoubleDouble, order 29 from step 4.0, Taylor::new(), to 1e-27;
    taylor_40: fixed_taylor::<20>, in DoubleDouble, order 41 from step 8.0, Taylor::order_40(), to 1e-27;
}

/// Tolerances of zero, NaN, or beyond the digits of the scalar are values: an error, a stop, or the digits that there are.
#[test]
fn tolerances_beyond_the_digits_end() {
    fn ends(method: impl Integrator<f64, Oscillator>) {
        let solved = oscillator().max_steps(5000).solve(5.0, method);
        match solved.map_err(IntegrationError::from) {
            Ok(end) if end.reason == StopReason::Completed => {
                assert_close(end[0], 5.0_f64.cos(), 1e-14);
            }
            Ok(end) => assert_eq!(end.reason, StopReason::StepLimit),
            Err(error) => assert!(
                matches!(error, IntegrationError::StepTooSmall { .. }),
                "{error}"
            ),
        }
    }
    for tolerance in [1e-17, 1e-30, 1e-300] {
        ends(
            Dop853::new()
                .relative_tolerance(tolerance)
                .absolute_tolerance(tolerance),
        );
        ends(Taylor::new().relative_tolerance(tolerance));
        ends(Taylor::order_12().absolute_tolerance(tolerance));
    }
    for (relative, absolute) in [
        (0.0, 0.0),
        (f64::NAN, 1e-9),
        (-1.0, 1e-9),
        (1e-9, f64::INFINITY),
    ] {
        let taylor = Taylor::new()
            .relative_tolerance(relative)
            .absolute_tolerance(absolute);
        let solved = oscillator::<f64>().solve(1.0, taylor);
        let error = solved.unwrap_err().error();
        assert!(
            matches!(error, IntegrationError::InvalidTolerance { .. }),
            "{error}"
        );
    }
}
