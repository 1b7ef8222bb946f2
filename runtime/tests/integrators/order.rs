//! The order of each method, measured.

use crate::common::{Oscillator, assert_close, equation};
use lagrangian::prelude::*;
use nalgebra::SVector;

/// ẍ = −x from (1, 0) on.
fn oscillator() -> Problem<f64, Oscillator> {
    let start = At::from((0.0, SVector::from([1.0, 0.0])));
    Problem::new(Oscillator, start)
}

/// The error at t = 1 of ẍ = −x in `steps` equal steps of a method given by its step.
fn error<I: Integrator<f64, Oscillator>>(method: impl Fn(f64) -> I, steps: u32) -> f64 {
    let method = method(1.0 / f64::from(steps));
    let end = oscillator().solve(1.0, method).unwrap();
    (end.x - SVector::from([1.0_f64.cos(), -1.0_f64.sin()])).norm()
}

/// [`Dop853`] at a fixed step: the tolerance is so wide that every step is accepted, and the step
/// may not grow.
fn fixed_dop853(step: f64) -> Dop853 {
    Dop853::new()
        .absolute_tolerance(1e9)
        .initial_step(step)
        .max_step(step)
}

/// The slope of log error over log step between two numbers of steps.
fn slope<I: Integrator<f64, Oscillator>>(method: impl Fn(f64) -> I, steps: [u32; 2]) -> f64 {
    let [coarse, fine] = steps.map(|n| error(&method, n).ln());
    (coarse - fine) / (f64::from(steps[1]) / f64::from(steps[0])).ln()
}

#[test]
fn classical_runge_kutta_is_of_order_four() {
    // The next term of the error is smaller by h: at h = 1/32 the slope is off by a few percent.
    assert_close(slope(RungeKutta::classical, [16, 32]), 4.0, 0.1);
    assert_close(slope(RungeKutta::classical, [64, 128]), 4.0, 0.03);
}

#[test]
fn classical_runge_kutta_reaches_a_roundoff_plateau() {
    // At h = 2⁻¹⁴ the truncation error is about h⁴/120 = 1e-19.
    assert!(error(RungeKutta::classical, 1 << 14) < 4.0 * f64::EPSILON);
}

#[test]
fn dormand_prince_is_of_order_eight() {
    assert_close(slope(fixed_dop853, [2, 4]), 8.0, 0.5);
    assert_close(slope(fixed_dop853, [4, 8]), 8.0, 0.3);
}

/// [`Taylor`] at a fixed step.
fn fixed_taylor<const HALF: usize>(step: f64) -> Taylor<HALF> {
    Taylor::of_half_order()
        .absolute_tolerance(1e9)
        .max_step(step)
}

#[test]
fn corrected_taylor_polynomials_are_of_one_order_more_than_their_degree() {
    assert_close(slope(fixed_taylor::<1>, [64, 128]), 3.0, 0.05);
    assert_close(slope(fixed_taylor::<2>, [8, 16]), 5.0, 0.05);
    assert_close(slope(fixed_taylor::<3>, [4, 8]), 7.0, 0.1);
    assert_close(slope(fixed_taylor::<4>, [2, 4]), 9.0, 0.3);
}

#[test]
fn taylor_polynomials_reach_a_roundoff_plateau() {
    for steps in [2, 16, 1024] {
        assert!(error(fixed_taylor::<12>, steps) < 4.0 * f64::EPSILON);
    }
}

#[test]
fn dormand_prince_reaches_a_roundoff_plateau() {
    for steps in [64, 256, 1024] {
        assert!(error(fixed_dop853, steps) < 4.0 * f64::EPSILON);
    }
}

/// ẋ = (p + 1) t^p is integrated exactly by a method of order p + 1.
#[test]
fn polynomials_are_exact_up_to_the_order() {
    let power = |p: i32| {
        let power = equation::<1, _>(move |t, _| SVector::from([f64::from(p + 1) * t.powi(p)]));
        Problem::new(power, At::from((0.0, SVector::from([0.0]))))
    };
    let fixed = RungeKutta::classical(1.0);
    for p in 0..8 {
        let end = power(p).solve(1.0, fixed_dop853(1.0)).unwrap();
        // The weights of the stages are up to 6, their sum times ε.
        assert_close(end[0], 1.0, 50.0 * f64::EPSILON);
    }
    for p in 0..4 {
        let end = power(p).solve(1.0, fixed).unwrap();
        assert_close(end[0], 1.0, 4.0 * f64::EPSILON);
    }
    let end = power(4).solve(1.0, fixed).unwrap();
    assert!((end[0] - 1.0).abs() > 1e-3, "order 4 is not 5");
    let end = power(8).solve(1.0, fixed_dop853(1.0)).unwrap();
    assert!((end[0] - 1.0).abs() > 1e-6, "order 8 is not 9");
}

/// The largest error of the dense output within steps of one size.
fn dense_error(steps: u32) -> f64 {
    let step = 2.0 / f64::from(steps);
    let times: Vec<f64> = (0..=100).map(|i| f64::from(i) * 0.02).collect();
    let motion = oscillator()
        .save(&times)
        .solve(2.0, fixed_dop853(step))
        .unwrap();
    assert_eq!(motion.statistics.steps, u64::from(steps));
    let errors = motion.samples().iter().map(|x| (x[0] - x.t.cos()).abs());
    errors.fold(0.0, f64::max)
}

#[test]
fn dense_output_is_of_order_seven() {
    // An interpolating polynomial of degree 7 has an error of order h⁸.
    let slope = (dense_error(2).ln() - dense_error(4).ln()) / 2.0_f64.ln();
    assert_close(slope, 8.0, 0.6);
    let slope = (dense_error(4).ln() - dense_error(8).ln()) / 2.0_f64.ln();
    assert_close(slope, 8.0, 0.6);
}

#[test]
fn dense_output_is_exact_for_polynomials_of_degree_seven() {
    let power = equation::<1, _>(|t, _| SVector::from([7.0 * t.powi(6)]));
    let motion = Problem::new(power, At::from((0.0, SVector::from([0.0]))))
        .save([0.1, 0.35, 0.5, 0.8, 1.0])
        .solve(1.0, fixed_dop853(1.0))
        .unwrap();
    assert_eq!((motion.statistics.steps, motion.samples().len()), (1, 5));
    for sample in motion {
        // The coefficients of the dense output are up to 500.
        assert_close(sample[0], sample.t.powi(7), 1000.0 * f64::EPSILON);
    }
}

#[test]
fn dense_output_costs_three_evaluations_only_in_steps_that_are_sampled() {
    let cost = |times: &[f64]| {
        let motion = oscillator().save(times).solve(1.0, fixed_dop853(0.25));
        motion.unwrap().statistics.evaluations
    };
    // One evaluation at the start, twelve a step.
    assert_eq!(cost(&[1.0]), 49);
    assert_eq!(cost(&[0.1, 1.0]), 52);
    assert_eq!(cost(&[0.1, 0.2, 1.0]), 52);
    assert_eq!(cost(&[0.1, 0.3, 1.0]), 55);
    assert_eq!(cost(&[0.0, 1.0]), 49);
}

#[test]
fn single_precision_is_integrated_too() {
    let start = At::from((0.0_f32, SVector::from([1.0, 0.0])));
    let method = Dop853::new()
        .relative_tolerance(1e-6)
        .absolute_tolerance(1e-6);
    let end = Problem::new(Oscillator, start).solve(1.0, method).unwrap();
    assert_close(f64::from(end[0]), 1.0_f64.cos(), 1e-5);
}

/// What the published code DOP853 counts with its default settings for the same equations, start
/// (2, 0) and tolerances: accepted and rejected steps, evaluations.
#[test]
fn the_steps_are_those_of_the_reference_code() {
    let counts = |dynamics: &dyn Dynamics<State = SVector<f64, 2>>, end, tolerance| {
        let method = Dop853::new()
            .relative_tolerance(tolerance)
            .absolute_tolerance(tolerance);
        let start = At::from((0.0, SVector::from([2.0, 0.0])));
        let end = Problem::new(dynamics, start).solve(end, method).unwrap();
        let Statistics {
            steps,
            rejected,
            evaluations,
            ..
        } = end.statistics;
        (steps, rejected, evaluations)
    };
    let van_der_pol = |stiffness: f64| {
        equation::<2, _>(move |_, x| {
            SVector::from([x[1], ((1.0 - x[0] * x[0]) * x[1] - x[0]) * stiffness])
        })
    };
    assert_eq!(counts(&van_der_pol(1000.0), 2.0, 1e-9), (1345, 122, 17495));
    assert_eq!(counts(&van_der_pol(10.0), 2.0, 1e-6), (31, 5, 429));
    let driven_pendulum =
        equation::<2, _>(|t, x| SVector::from([x[1], -x[0].sin() + 0.1 * (0.7 * t).cos()]));
    assert_eq!(counts(&driven_pendulum, 50.0, 1e-10), (189, 49, 2809));
    assert_eq!(counts(&driven_pendulum, -50.0, 1e-6), (60, 16, 898));
}
