//! Integrations in progress, and solutions that can be asked at any time.

use crate::common::{Oscillator, assert_close, equation};
use core::f64::consts::{FRAC_PI_2, PI};
use lagrangian::prelude::*;
use lagrangian::{DenseOutput, Partial};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};

type X = SVector<f64, 2>;

/// The oscillator from a time and a state on.
fn from(t: f64, x: [f64; 2]) -> Problem<f64, Oscillator> {
    let x = SVector::from(x);
    Problem::new(Oscillator, At { t, x })
}

const START: [f64; 2] = [1.0, 0.25];

fn problem() -> Problem<f64, Oscillator> {
    from(0.5, START)
}

fn bits<'a>(x: impl IntoIterator<Item = &'a f64>) -> Vec<u64> {
    x.into_iter().map(|component| component.to_bits()).collect()
}

const ENDS: [f64; 2] = [8.0, -7.0];

fn steps_are_those_of_the_whole<I: Integrator<f64, Oscillator> + Copy>(method: I) {
    for end in ENDS {
        let whole = problem().solve(end, method).unwrap();

        let mut run = problem().start(method).unwrap();
        let mut previous = run.state().t;
        let mut steps = 0;
        while let Some(step) = run.step(end).unwrap() {
            assert_eq!(run.previous_time().to_bits(), previous.to_bits());
            previous = step.t;
            steps += 1;
        }
        assert_eq!(steps, whole.statistics.steps);
        assert_eq!(run.statistics(), whole.statistics);
        assert_eq!(run.state(), whole.last);
        assert!(run.step(end).unwrap().is_none(), "at the end");

        let mut run = problem().max_steps(3).start(method).unwrap();
        let mut calls = 1;
        while run.advance(end).unwrap().reason == StopReason::StepLimit {
            calls += 1;
        }
        assert!(calls > 1);
        assert_eq!(bits(&run.state().x), bits(&whole.x));
        assert_eq!(run.statistics(), whole.statistics);
    }
}

#[test]
fn an_integration_step_by_step_is_that_at_once() {
    steps_are_those_of_the_whole(RungeKutta::classical(0.01));
    steps_are_those_of_the_whole(Dop853::new());
    steps_are_those_of_the_whole(Taylor::new().max_step(0.5));
    steps_are_those_of_the_whole(Taylor::order_12());
}

/// Within the last step, and nowhere else.
fn asked_within_a_step<I: Integrator<f64, Oscillator>>(method: I) {
    let mut run = from(0.0, [1.0, 0.0]).start(method).unwrap();
    assert_eq!(run.at(0.0).unwrap(), run.state());
    run.at(0.1).unwrap_err();
    run.advance(2.0).unwrap();
    run.step(4.0).unwrap().unwrap();
    let (from, to) = (run.previous_time(), run.state().t);
    assert_close(from, 2.0, 0.0);
    for i in 0..=8 {
        let t = from + (to - from) * f64::from(i) / 8.0;
        assert_close(run.at(t).unwrap()[0], t.cos(), 1e-8);
    }
    for t in [from - 1e-9, to + 1e-9, f64::NAN] {
        let error = run.at(t).unwrap_err();
        let IntegrationError::OutsideSolution { start, end, .. } = error else {
            panic!("{error}")
        };
        assert_eq!((start, end), (from, to));
    }
}

#[test]
fn an_integration_is_asked_within_its_last_step() {
    asked_within_a_step(RungeKutta::classical(0.01));
    asked_within_a_step(Dop853::new());
    asked_within_a_step(Taylor::new());
}

/// A velocity that is reversed twice leads back to the start.
fn changed_on_the_way<I: Integrator<f64, Oscillator>>(method: I) {
    let mut run = problem().start(method).unwrap();
    run.advance(3.0).unwrap();
    let before = run.statistics();
    run.change(|x, _| x[1] = -x[1]).unwrap();
    assert_close(run.state().t, 3.0, 0.0);
    run.advance(5.5).unwrap();
    assert!(run.statistics().steps > before.steps);
    assert_close(run.state()[0], START[0], 1e-8);
    assert_close(run.state()[1], -START[1], 1e-8);

    let state = run.state();
    let error = run.change(|x, _| x.x = SVector::from([f64::NAN, 0.0]));
    let error = error.unwrap_err();
    assert!(matches!(error, IntegrationError::NonFiniteState { .. }));
    assert_eq!(run.state(), state);
    for end in [f64::NAN, f64::INFINITY] {
        run.advance(end).unwrap_err();
        run.step(end).unwrap_err();
        assert_eq!(run.state(), state);
    }
    run.change(|_, dynamics| *dynamics = Oscillator).unwrap();
    run.advance(6.0).unwrap();
    assert_close(run.state().t, 6.0, 0.0);
}

#[test]
fn states_and_dynamics_are_changed_on_the_way() {
    changed_on_the_way(RungeKutta::classical(0.01));
    changed_on_the_way(Dop853::new());
    changed_on_the_way(Taylor::new());
}

/// A condition within a step is where the integration goes on from.
fn stopped_by_a_condition<I: Integrator<f64, Oscillator>>(method: I) {
    let problem = from(0.0, [1.0, 0.0]).when(|x| x[0]).stop();
    let mut run = problem.start(method).unwrap();
    for crossing in 0..5 {
        let expected = PI * (f64::from(crossing) + 0.5);
        let last = loop {
            let step = run.step(100.0).unwrap().unwrap();
            if step.reason != StopReason::StepLimit {
                break step;
            }
        };
        assert_eq!(last.reason, StopReason::Condition);
        assert_close(last.t, expected, 1e-7);
        assert_eq!(run.state(), last.last);
    }
}

#[test]
fn conditions_stop_a_running_integration() {
    stopped_by_a_condition(RungeKutta::classical(0.01));
    stopped_by_a_condition(Dop853::new());
    stopped_by_a_condition(Taylor::new());
}

#[test]
fn a_flag_cancels() {
    fn unless(flag: &AtomicBool) -> ControlFlow<()> {
        if flag.load(Ordering::Relaxed) {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    let flag = AtomicBool::new(false);
    let mut count = 0;
    let observed = problem().each_step(|_| {
        count += 1;
        flag.store(count == 4, Ordering::Relaxed);
        unless(&flag)
    });
    let end = observed.solve(1e3, Dop853::new()).unwrap();
    assert_eq!(
        (end.reason, end.statistics.steps),
        (StopReason::Observer, 4)
    );

    let cancelled = AtomicBool::new(true);
    let observed = problem().each_step(|_| unless(&cancelled));
    let mut run = observed.start(Dop853::new()).unwrap();
    assert_eq!(run.advance(1e3).unwrap().reason, StopReason::Observer);
    assert_eq!(run.statistics().steps, 1);
    cancelled.store(false, Ordering::Relaxed);
    assert_eq!(run.advance(20.0).unwrap().reason, StopReason::Completed);
}

/// The solution is what samples are, to the last bit, and its derivative is the state's.
fn solution_and_samples<I, T>(method: I, accuracy: f64)
where
    I: Integrator<f64, Oscillator, Stepper = T> + Copy,
    T: DenseOutput<f64, Oscillator>,
{
    for end in ENDS {
        let times: Vec<f64> = (0..=200)
            .map(|i| 0.5 + (end - 0.5) * f64::from(i) / 200.0)
            .collect();
        let sampled = problem().save(&times).solve(end, method).unwrap();
        let solution = problem().save(Dense).solve(end, method).unwrap();
        assert_eq!(solution.last, *sampled.samples().last().unwrap());
        assert_eq!(solution.last, sampled.last);
        for sample in sampled.samples() {
            let found = solution.at(sample.t).unwrap();
            assert_eq!(bits(&found.x), bits(&sample.x), "at t = {}", sample.t);
            let before = solution.before(sample.t).unwrap();
            if sample.t - end != 0.0 {
                assert_eq!(bits(&before.x), bits(&sample.x));
            }
            // The end of the last step is not the value of its polynomial, if it was corrected.
            assert!((before.x - sample.x).norm() < 1e-15);
            let slope = solution.derivative(sample.t).unwrap().unwrap();
            assert_close(slope[0], sample[1], accuracy);
            assert_close(slope[1], -sample[0], accuracy);
        }
        let ends: Vec<f64> = solution.times().collect();
        assert_eq!(ends.len() as u64, solution.statistics.steps + 1);
        assert_eq!((ends[0], *ends.last().unwrap()), (0.5, end));
        for t in ends {
            let (at, before) = (solution.at(t).unwrap(), solution.before(t).unwrap());
            assert!((at.x - before.x).norm() < 1e-14);
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
    solution_and_samples(Dop853::new(), 1e-7);
    solution_and_samples(Taylor::new(), 1e-12);
    solution_and_samples(Taylor::order_12().relative_tolerance(1e-8), 1e-6);
}

#[test]
fn a_solution_that_is_empty_or_ends_early() {
    let solution = problem().save(Dense).solve(0.5, Dop853::new()).unwrap();
    assert_eq!(solution.at(0.5).unwrap().x, SVector::from(START));
    assert_eq!(solution.derivative(0.5).unwrap(), None);
    solution.at(0.6).unwrap_err();

    // 1/(1 − t) is infinite at 1.
    let blows_up = equation::<1, _>(|_, x| x.map(|x| x * x));
    let start = At::from((0.0, SVector::from([1.0])));
    let partial = Problem::new(blows_up, start)
        .save(Dense)
        .solve(2.0, Dop853::new())
        .unwrap_err();
    let solution = partial.solution();
    assert_close(solution.at(0.5).unwrap()[0], 2.0, 1e-8);
    assert_close(solution.t, 1.0, 1e-6);
    assert!(
        partial.to_string().contains("known until t = "),
        "{partial}"
    );

    // Up to a condition within a step.
    let solution = from(0.0, [1.0, 0.0])
        .when(|x| x[0])
        .stop()
        .save(Dense)
        .solve(9.0, Taylor::new())
        .unwrap();
    assert_close(solution.t, FRAC_PI_2, 1e-15);
    assert_eq!(solution.at(solution.t).unwrap(), solution.last);
    assert_close(solution.before(solution.t).unwrap()[0], 0.0, 1e-15);
    solution.at(FRAC_PI_2 + 1e-9).unwrap_err();
}

/// The derivative of the interpolating polynomial is that of its values.
#[test]
fn derivatives_are_those_of_the_polynomials() {
    fn check<I, T>(method: I)
    where
        I: Integrator<f64, Oscillator, Stepper = T>,
        T: DenseOutput<f64, Oscillator>,
    {
        let mut run = problem().start(method).unwrap();
        let interpolant = |stepper: &T| stepper.clone().interpolant(&Oscillator);
        assert!(interpolant(run.stepper()).is_none());
        run.step(9.0).unwrap();
        let (from, to) = (run.previous_time(), run.state().t);
        let polynomial = interpolant(run.stepper()).unwrap();
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
    check(Dop853::new().initial_step(0.5));
    check(Taylor::new());
}

#[test]
fn errors_convert() {
    fn ends<X, K>(partial: Partial<Solution<f64, X, K>>) -> IntegrationError {
        partial.into()
    }
    let still = equation::<1, _>(|_, _| SVector::from([f64::NAN]));
    let partial = Problem::new(still, At::from((0.0, SVector::from([1.0]))))
        .save(Dense)
        .solve(2.0, Dop853::new())
        .unwrap_err();
    assert!(matches!(
        ends(partial),
        IntegrationError::NonFiniteDerivative { .. }
    ));
}

/// A solution is known until the time at which the observer has stopped, also at an event or a sample within a step.
#[test]
fn a_solution_that_the_observer_stops_is_known_until_then() {
    let stop = |kind| {
        move |progress: &Progress<'_, X>| {
            if progress.kind == kind {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        }
    };
    let solution = from(0.0, [1.0, 0.0])
        .when(|x| x[0])
        .record()
        .each_step(stop(ObservationKind::Event(0)))
        .save(Dense)
        .solve(10.0, Dop853::new())
        .unwrap();
    assert_eq!(solution.reason, StopReason::Observer);
    let end = solution.t;
    for part in [0.1, 0.5, 0.999, 1.0] {
        let x = solution.at(part * end).unwrap();
        assert_close(x[0], (part * end).cos(), 1e-8);
    }

    let solution = from(0.0, [1.0, 0.0])
        .each_step(stop(ObservationKind::Sample))
        .save([2.5, 7.0])
        .solve(10.0, Dop853::new())
        .unwrap();
    assert_eq!(solution.reason, StopReason::Observer);
    assert_eq!((solution.t, solution.samples().len()), (2.5, 1));
    assert_close(solution[0], 2.5_f64.cos(), 1e-8);
}
