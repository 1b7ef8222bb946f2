//! Integrations in progress, and solutions that can be asked at any time.

use crate::common::{Oscillator, assert_close};
use lagrangian::prelude::*;
use lagrangian::{DenseOutput, Interpolant, Partial, VectorSpace};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};

type X = SVector<f64, 2>;

fn start() -> (f64, X) {
    (0.5, SVector::from([1.0, 0.25]))
}

fn bits<'a>(x: impl IntoIterator<Item = &'a f64>) -> Vec<u64> {
    x.into_iter().map(|component| component.to_bits()).collect()
}

const ENDS: [f64; 2] = [8.0, -7.0];

fn steps_are_those_of_the_driver<I>(method: &I)
where
    I: Integrator<f64, Oscillator> + IntegrationMethod,
{
    for end in ENDS {
        let whole = method
            .driver()
            .run_until(&Oscillator, start(), end)
            .unwrap();

        let mut running = method.driver().start(&Oscillator, start()).unwrap();
        let mut previous = running.time();
        let mut steps = 0;
        for step in running.steps_to(end) {
            let step = step.unwrap();
            assert_eq!(step.start.to_bits(), previous.to_bits());
            previous = step.end.t;
            steps += 1;
        }
        assert_eq!(steps, whole.statistics.steps);
        assert_eq!(running.statistics(), whole.statistics);
        assert_eq!(running.sample(), whole.last);
        assert!(running.step_towards(end).unwrap().is_none(), "at the end");

        let mut running = method
            .driver()
            .max_steps(3)
            .start(&Oscillator, start())
            .unwrap();
        let mut calls = 1;
        while running.advance_to(end).unwrap().reason == StopReason::StepLimit {
            calls += 1;
        }
        assert!(calls > 1);
        assert_eq!(bits(running.state()), bits(&whole.last.x));
        assert_eq!(running.statistics(), whole.statistics);
    }
}

#[test]
fn an_integration_step_by_step_is_that_at_once() {
    steps_are_those_of_the_driver(&RungeKutta::classical(0.01));
    steps_are_those_of_the_driver(&Dop853::new());
    steps_are_those_of_the_driver(&Taylor::new().max_step(0.5));
    steps_are_those_of_the_driver(&Taylor::order_12());
}

/// Within the last step, and nowhere else.
fn asked_within_a_step<I: Integrator<f64, Oscillator> + IntegrationMethod>(method: &I) {
    let mut running = method
        .driver()
        .start(&Oscillator, (0.0, SVector::from([1.0, 0.0])))
        .unwrap();
    assert_eq!(running.at(0.0).unwrap(), *running.state());
    running.at(0.1).unwrap_err();
    running.advance_to(2.0).unwrap();
    running.step_towards(4.0).unwrap().unwrap();
    let (from, to) = (running.previous_time(), running.time());
    assert_close(from, 2.0, 0.0);
    for i in 0..=8 {
        let t = from + (to - from) * f64::from(i) / 8.0;
        assert_close(running.at(t).unwrap()[0], t.cos(), 1e-8);
    }
    for t in [from - 1e-9, to + 1e-9, f64::NAN] {
        let error = running.at(t).unwrap_err();
        let IntegrationError::OutsideSolution { start, end, .. } = error else {
            panic!("{error}")
        };
        assert_eq!((start, end), (from, to));
    }
}

#[test]
fn an_integration_is_asked_within_its_last_step() {
    asked_within_a_step(&RungeKutta::classical(0.01));
    asked_within_a_step(&Dop853::new());
    asked_within_a_step(&Taylor::new());
}

/// A velocity that is reversed twice leads back to the start.
fn changed_on_the_way<I: Integrator<f64, Oscillator> + IntegrationMethod>(method: &I) {
    let mut running = method.driver().start(&Oscillator, start()).unwrap();
    running.advance_to(3.0).unwrap();
    let before = running.statistics();
    let x = *running.state();
    running.restart(SVector::from([x[0], -x[1]])).unwrap();
    assert_close(running.time(), 3.0, 0.0);
    running.advance_to(5.5).unwrap();
    assert!(running.statistics().steps > before.steps);
    assert_close(running.state()[0], start().1[0], 1e-8);
    assert_close(running.state()[1], -start().1[1], 1e-8);

    let state = *running.state();
    let error = running.restart(SVector::from([f64::NAN, 0.0])).unwrap_err();
    assert!(matches!(error, IntegrationError::NonFiniteState { .. }));
    assert_eq!(*running.state(), state);
    for end in [f64::NAN, f64::INFINITY] {
        running.advance_to(end).unwrap_err();
        assert_eq!(running.steps_to(end).count(), 1, "one error, then none");
    }
    running.change_dynamics(&Oscillator).unwrap();
    running.advance_to(6.0).unwrap();
    assert_close(running.time(), 6.0, 0.0);
}

#[test]
fn states_and_dynamics_are_changed_on_the_way() {
    changed_on_the_way(&RungeKutta::classical(0.01));
    changed_on_the_way(&Dop853::new());
    changed_on_the_way(&Taylor::new());
}

/// A condition within a step is where the integration goes on from.
fn stopped_by_a_condition<I: Integrator<f64, Oscillator> + IntegrationMethod>(method: &I) {
    let driver = method.driver().stop_at_zero(|_, x: &X| x[0]);
    let initial = (0.0, SVector::from([1.0, 0.0]));
    let mut running = driver.start(&Oscillator, initial).unwrap();
    for crossing in 0..5 {
        let expected = std::f64::consts::PI * (f64::from(crossing) + 0.5);
        let last = running.steps_to(100.0).last().unwrap().unwrap();
        assert_eq!(last.stop, Some(StopReason::Condition));
        assert_close(last.end.t, expected, 1e-7);
        assert_eq!(running.sample(), last.end);
    }
}

#[test]
fn conditions_stop_a_running_integration() {
    stopped_by_a_condition(&RungeKutta::classical(0.01));
    stopped_by_a_condition(&Dop853::new());
    stopped_by_a_condition(&Taylor::new());
}

#[test]
fn a_flag_cancels() {
    let flag = AtomicBool::new(false);
    let mut count = 0;
    let driver = Dop853::new().driver().observe(|_: &Progress<'_, X>| {
        count += 1;
        flag.store(count == 4, Ordering::Relaxed);
        Observer::<X>::observe(
            &mut &flag,
            &Progress {
                kind: ObservationKind::Step,
                t: 0.0,
                x: &start().1,
                start: 0.0,
                end: 0.0,
                statistics: Statistics::default(),
            },
        )
    });
    let outcome = driver.run_until(&Oscillator, start(), 1e3).unwrap();
    assert_eq!(
        (outcome.reason, outcome.statistics.steps),
        (StopReason::Observer, 4)
    );

    let cancelled = AtomicBool::new(true);
    let driver = Dop853::new().driver().observe(&cancelled);
    let mut running = driver.start(&Oscillator, start()).unwrap();
    assert_eq!(
        running.advance_to(1e3).unwrap().reason,
        StopReason::Observer
    );
    assert_eq!(running.statistics().steps, 1);
    cancelled.store(false, Ordering::Relaxed);
    assert_eq!(
        running.advance_to(20.0).unwrap().reason,
        StopReason::Completed
    );
}

/// The solution is what samples are, to the last bit, and its derivative is the state's.
fn solution_and_samples<I, T>(method: &I, accuracy: f64)
where
    I: Integrator<f64, Oscillator, Stepper = T> + IntegrationMethod,
    T: DenseOutput<f64, Oscillator>,
{
    for end in ENDS {
        let times: Vec<f64> = (0..=200)
            .map(|i| 0.5 + (end - 0.5) * f64::from(i) / 200.0)
            .collect();
        let samples = method.sample(&Oscillator, start(), &times).unwrap();
        let solution = method.driver().solve(&Oscillator, start(), end).unwrap();
        assert_eq!(*solution.last(), *samples.last());
        for sample in samples.samples() {
            let found = solution.at(sample.t).unwrap();
            assert_eq!(bits(&found), bits(&sample.x), "at t = {}", sample.t);
            assert_eq!(bits(&solution.before(sample.t).unwrap()), bits(&sample.x));
            let slope = solution.derivative(sample.t).unwrap().unwrap();
            assert_close(slope[0], sample.x[1], accuracy);
            assert_close(slope[1], -sample.x[0], accuracy);
        }
        let ends: Vec<f64> = solution.times().collect();
        assert_eq!(ends.len() as u64, solution.outcome().statistics.steps + 1);
        assert_eq!((ends[0], *ends.last().unwrap()), (0.5, end));
        for t in ends {
            let (at, before) = (solution.at(t).unwrap(), solution.before(t).unwrap());
            assert!((at - before).norm() < 1e-14);
        }
        for t in [end + (end - 0.5) * 1e-9, 0.5 - (end - 0.5) * 1e-9, f64::NAN] {
            let error = solution.at(t).unwrap_err();
            assert!(
                matches!(error, IntegrationError::OutsideSolution { .. }),
                "{error}"
            );
            solution.before(t).unwrap_err();
            solution.derivative(t).unwrap_err();
        }
    }
}

#[test]
fn a_dense_solution_is_asked_at_any_time() {
    solution_and_samples(&Dop853::new(), 1e-7);
    solution_and_samples(&Taylor::new(), 1e-12);
    solution_and_samples(&Taylor::order_12().relative_tolerance(1e-8), 1e-6);
}

#[test]
fn a_solution_that_is_empty_or_ends_early() {
    let solution = Dop853::new()
        .driver()
        .solve(&Oscillator, start(), 0.5)
        .unwrap();
    assert_eq!(solution.at(0.5).unwrap(), start().1);
    assert_eq!(solution.derivative(0.5).unwrap(), None);
    solution.at(0.6).unwrap_err();

    // 1/(1 − t) is infinite at 1.
    let blows_up = crate::common::equation::<1, _>(|_, x| x.map(|x| x * x));
    let start = (0.0, SVector::from([1.0]));
    let partial = Dop853::new()
        .driver()
        .solve(&blows_up, start, 2.0)
        .unwrap_err();
    let solution = partial.solution();
    assert_close(solution.at(0.5).unwrap()[0], 2.0, 1e-8);
    assert_close(solution.last().t, 1.0, 1e-6);
    assert!(
        partial.to_string().contains("known until t = "),
        "{partial}"
    );

    // Up to a condition within a step.
    let driver = Taylor::new().driver().stop_at_zero(|_, x: &X| x[0]);
    let solution = driver
        .solve(&Oscillator, (0.0, SVector::from([1.0, 0.0])), 9.0)
        .unwrap();
    let end = std::f64::consts::FRAC_PI_2;
    assert_close(solution.last().t, end, 1e-15);
    assert_eq!(solution.at(solution.last().t).unwrap(), solution.last().x);
    assert_close(solution.before(solution.last().t).unwrap()[0], 0.0, 1e-15);
    solution.at(end + 1e-9).unwrap_err();
}

/// The derivative of the interpolating polynomial is that of its values.
#[test]
fn derivatives_are_those_of_the_polynomials() {
    fn check<I, T>(method: &I)
    where
        I: Integrator<f64, Oscillator, Stepper = T> + IntegrationMethod,
        T: DenseOutput<f64, Oscillator>,
    {
        let mut running = method.driver().start(&Oscillator, start()).unwrap();
        assert!(running.stepper_mut().interpolant(&Oscillator).is_none());
        running.step_towards(9.0).unwrap();
        let (from, to) = (running.previous_time(), running.time());
        let polynomial = running.stepper_mut().interpolant(&Oscillator).unwrap();
        for fraction in [0.1, 0.5, 0.8] {
            let (t, d) = (from + fraction * (to - from), 1e-3 * (to - from));
            // Four differences: the error is d⁴ x⁗.
            let x = |k: f64| polynomial.at(t + k * d);
            let mut slope = (x(1.0) - x(-1.0)) * 8.0 - (x(2.0) - x(-2.0));
            slope /= 12.0 * d;
            slope.add_scaled(-1.0, &polynomial.derivative(t));
            assert!(slope.norm() < 1e-10, "{slope}");
        }
    }
    check(&Dop853::new().initial_step(0.5));
    check(&Taylor::new());
}

#[test]
fn errors_convert() {
    fn ends<X, P>(partial: Partial<lagrangian::DenseSolution<X, P>>) -> IntegrationError {
        partial.into()
    }
    let still = crate::common::equation::<1, _>(|_, _| SVector::from([f64::NAN]));
    let partial = Dop853::new()
        .driver()
        .solve(&still, (0.0, SVector::from([1.0])), 2.0)
        .unwrap_err();
    assert!(matches!(
        ends(partial),
        IntegrationError::NonFiniteDerivative { .. }
    ));
}

/// A solution is known until the time at which the observer has stopped, also at an event or a sample within a step.
#[test]
fn a_solution_that_the_observer_stops_is_known_until_then() {
    for kind in [ObservationKind::Event(0), ObservationKind::Sample] {
        let solution = Dop853::new()
            .driver()
            .events(Event::either(), |_, x: &SVector<f64, 2>| x[0])
            .observe(|progress: &Progress<'_, SVector<f64, 2>>| {
                if progress.kind == kind && progress.t > progress.start {
                    ControlFlow::Break(())
                } else {
                    ControlFlow::Continue(())
                }
            })
            .solve(&Oscillator, (0.0, SVector::from([1.0, 0.0])), 10.0)
            .unwrap();
        assert_eq!(solution.outcome().reason, StopReason::Observer);
        let end = solution.last().t;
        for part in [0.1, 0.5, 0.999, 1.0] {
            let x = solution.at(part * end).unwrap();
            assert_close(x[0], (part * end).cos(), 1e-8);
        }
    }
}
