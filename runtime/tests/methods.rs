//! One table of all methods; each row runs all tests: order by slope, exactness on polynomials, reversibility, dense
//! output, events, conservation.

mod common;

use common::{Oscillator, assert_close};
use lagrangian::prelude::*;
use lagrangian::{ButcherTableau, Series, TaylorCoefficients};

type X = SVector<f64, 2>;

/// Explicit midpoint: C. Runge, Math. Ann. 46 (1895) 167.
const MIDPOINT: ButcherTableau<2> = ButcherTableau {
    nodes: [0.0, 0.5],
    matrix: [&[], &[0.5]],
    weights: [0.0, 1.0],
};

/// ẋ = (p + 1) tᵖ, ẏ = 0, whose solution is a polynomial of degree p + 1.
struct Power(u16);

impl Dynamics for Power {
    type State = X;

    fn derivative(&self, t: f64, _: &X) -> X {
        SVector::from([f64::from(self.0 + 1) * t.powi(self.0.into()), 0.0])
    }
}

impl Series for Power {
    fn series<const HALF: usize>(
        &self,
        t: f64,
        x: &X,
        unit: f64,
        coefficients: &mut TaylorCoefficients<X, HALF>,
    ) {
        *coefficients.initial_mut() = *x;
        // (t + u)ᵖ⁺¹ by the binomial theorem.
        let degree = self.0 + 1;
        let mut binomial = 1.0;
        for (k, coefficient) in (1..).zip(coefficients.higher_mut()) {
            let term = if k <= degree {
                binomial *= f64::from(degree - k + 1) / f64::from(k);
                binomial * t.powi((degree - k).into()) * unit.powi(k.into())
            } else {
                0.0
            };
            *coefficient = SVector::from([term, 0.0]);
        }
    }
}

const START: [f64; 2] = [1.0, 0.0];

/// The error of the oscillator at t = 2 with steps of this size.
fn error<I: Integrator<f64, Oscillator> + IntegrationMethod>(method: &I) -> f64 {
    let start = (0.0, SVector::from(START));
    let end = method.integrate_to(&Oscillator, start, 2.0).unwrap();
    (end.x - SVector::from([2.0_f64.cos(), -2.0_f64.sin()])).norm()
}

/// The order is the slope of log error over log step.
fn order<I>(method: impl Fn(f64) -> I, order: u16, step: f64)
where
    I: Integrator<f64, Oscillator> + Integrator<f64, Power> + IntegrationMethod,
{
    let slope = (error(&method(step)) / error(&method(0.5 * step))).log2();
    assert_close(slope, order.into(), 0.08 * f64::from(order));

    for power in 0..order {
        let start = (0.0, SVector::from([0.0, 1.0]));
        let end = method(1.0).integrate_to(&Power(power), start, 1.0).unwrap();
        assert_close(end.x[0], 1.0, 64.0 * f64::EPSILON);
    }
}

/// Forwards and back, dense output, events and the energy at small steps.
fn motion<I>(method: &I, accuracy: f64)
where
    I: Integrator<f64, Oscillator> + IntegrationMethod,
{
    let start = (0.0, SVector::from(START));
    let there = method.integrate_to(&Oscillator, start, 7.0).unwrap();
    let back = method.integrate_to(&Oscillator, there, 0.0).unwrap();
    assert!((back.x - start.1).norm() < accuracy, "reversibility");
    assert!((there.x.norm() - 1.0).abs() < accuracy, "conservation");

    let times: Vec<f64> = (1..=70).map(|i| 0.1 * f64::from(i)).collect();
    let samples = method.sample(&Oscillator, start, &times).unwrap();
    for sample in samples.samples() {
        assert_close(sample.x[0], sample.t.cos(), accuracy);
        assert_close(sample.x[1], -sample.t.sin(), accuracy);
    }

    let mut at = Sample::from(start);
    for n in 0..4 {
        let driver = method.driver().stop_at_zero(|_, x: &X| x[0]);
        let outcome = driver.run_until(&Oscillator, at, 100.0).unwrap();
        assert_eq!(outcome.reason, StopReason::Condition);
        at = outcome.last;
        assert_close(
            at.t,
            std::f64::consts::PI * (f64::from(n) + 0.5),
            2.0 * accuracy,
        );
    }
}

/// Bad tolerances, times and states are values, whatever the method.
fn bad_input<I: Integrator<f64, Oscillator> + IntegrationMethod>(method: &I) {
    let run = |t: f64, x: f64, end: f64| {
        let start = (t, SVector::from([x, 0.0]));
        method.integrate_to(&Oscillator, start, end).unwrap_err()
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

fn fixed_taylor<const HALF: usize>(step: f64) -> Taylor<HALF> {
    Taylor::of_half_order()
        .absolute_tolerance(1e9)
        .max_step(step)
}

macro_rules! table {
    ($($name:ident: $method:expr, order $order:literal from step $step:literal, $fine:expr, to $accuracy:literal;)*) => {
        $(#[test]
        fn $name() {
            order($method, $order, $step);
            motion(&$fine, $accuracy);
            bad_input(&$fine);
        })*
    };
}

table! {
    midpoint: |h| RungeKutta::new(MIDPOINT, h), order 2 from step 0.02, RungeKutta::new(MIDPOINT, 1e-3), to 1e-5;
    classical: RungeKutta::classical, order 4 from step 0.1, RungeKutta::classical(0.01), to 1e-8;
    dormand_prince: fixed_dop853, order 8 from step 0.5, Dop853::new(), to 1e-8;
    taylor_2: fixed_taylor::<1>, order 2 from step 0.02, fixed_taylor::<1>(1e-3), to 1e-5;
    taylor_4: fixed_taylor::<2>, order 4 from step 0.1, fixed_taylor::<2>(0.01), to 1e-8;
    taylor_6: fixed_taylor::<3>, order 6 from step 0.25, fixed_taylor::<3>(0.05), to 1e-8;
    taylor_8: fixed_taylor::<4>, order 8 from step 0.5, fixed_taylor::<4>(0.1), to 1e-9;
    taylor_12: fixed_taylor::<6>, order 12 from step 1.0, Taylor::order_12().relative_tolerance(1e-12), to 1e-9;
    taylor_16: fixed_taylor::<8>, order 16 from step 2.0, Taylor::order_16(), to 1e-12;
}

/// Tolerances of zero, NaN, or beyond the digits of the scalar are values: an error, a stop, or the digits that there are.
#[test]
fn tolerances_beyond_the_digits_end() {
    fn ends<I>(method: &I)
    where
        I: Integrator<f64, Oscillator> + IntegrationMethod,
    {
        let start = (0.0, SVector::from(START));
        let driver = method.driver().max_steps(5000);
        match driver.run_until(&Oscillator, start, 5.0) {
            Ok(outcome) if outcome.reason == StopReason::Completed => {
                assert_close(outcome.last.x[0], 5.0_f64.cos(), 1e-14);
            }
            Ok(outcome) => assert_eq!(outcome.reason, StopReason::StepLimit),
            Err(error) => assert!(
                matches!(error, IntegrationError::StepTooSmall { .. }),
                "{error}"
            ),
        }
    }
    for tolerance in [1e-17, 1e-30, 1e-300] {
        ends(
            &Dop853::new()
                .relative_tolerance(tolerance)
                .absolute_tolerance(tolerance),
        );
        ends(&Taylor::new().relative_tolerance(tolerance));
        ends(&Taylor::order_12().absolute_tolerance(tolerance));
    }
    for (relative, absolute) in [
        (0.0, 0.0),
        (f64::NAN, 1e-9),
        (-1.0, 1e-9),
        (1e-9, f64::INFINITY),
    ] {
        let start = (0.0, SVector::from(START));
        let taylor = Taylor::new()
            .relative_tolerance(relative)
            .absolute_tolerance(absolute);
        let error = taylor.integrate_to(&Oscillator, start, 1.0).unwrap_err();
        assert!(
            matches!(error, IntegrationError::InvalidTolerance { .. }),
            "{error}"
        );
    }
}
