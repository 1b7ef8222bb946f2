//! The parts of a run keep together what one integration keeps.

use crate::common::Oscillator;
use lagrangian::prelude::*;
use nalgebra::SVector;

type Sample = At<f64, SVector<f64, 2>>;

const START: f64 = 0.7;

fn start() -> Sample {
    At::from((START, SVector::from([1.0, 0.0])))
}

fn times(samples: &[Sample]) -> Vec<f64> {
    samples.iter().map(|sample| sample.t).collect()
}

/// The samples of a run to these times, part by part, and of one integration to the last of them. Steps are the same, since every
/// part ends where one does.
macro_rules! compare {
    ($keep:expr, $ends:expr, $method:expr) => {{
        let problem = || Problem::new(Oscillator, start()).save($keep);
        let mut run = problem().start($method).unwrap();
        let mut found = Vec::new();
        let ends: &[f64] = &$ends;
        for end in ends {
            found.extend_from_slice(run.advance(*end).unwrap().samples());
        }
        let whole = problem().solve(ends[ends.len() - 1], $method).unwrap();
        (found, whole.samples().to_vec())
    }};
}

#[test]
fn a_grid_begins_where_the_problem_does() {
    let method = Dop853::new();
    for direction in [1.0, -1.0] {
        // Ends on the grid, between its points, on one after another, next to one, and twice.
        let steps = [1.0, 1.55, 1.58, 2.0, 2.0, 2.1, 2.1 + 1e-15, 2.4, 7.3];
        let ends = steps.map(|t| START + direction * (t - START));
        let (found, expected) = compare!(Every(0.1), ends, method);
        let [found, expected] = [times(&found), times(&expected)];
        assert_eq!(found.len(), 67);
        assert_eq!(found.len(), expected.len());
        for (t, expected) in found.iter().zip(&expected) {
            assert!((t - expected).abs() < 1e-14, "{t} {expected}");
        }
    }
}

#[test]
fn a_list_may_go_beyond_a_part() {
    let list = [START, 0.9, 1.0, 1.5, 3.0];
    let (found, expected) = compare!(list, [0.8, 1.0, 1.0, 1.2, 2.0, 3.5], Taylor::new());
    assert_eq!(times(&found), list);
    assert_eq!(times(&expected), list);
    for (sample, expected) in found.iter().zip(&expected) {
        assert!((sample.x - expected.x).norm() < 1e-14);
    }
}

#[test]
fn the_end_of_a_part_is_kept_once() {
    let ends = [0.8, 0.9, 1.0];
    let (found, expected) = compare!(StepEnds, ends, RungeKutta::classical(0.05));
    assert_eq!([found.len(), expected.len()], [7, 7]);
    for (sample, expected) in found.iter().zip(&expected) {
        assert!((sample.t - expected.t).abs() < 1e-14 && (sample.x - expected.x).norm() < 1e-14);
    }
}

#[test]
fn single_steps_keep_what_they_come_to() {
    let problem = || Problem::new(Oscillator, start()).save(Every(0.25));
    let mut run = problem().start(RungeKutta::classical(0.1)).unwrap();
    let mut found = Vec::new();
    assert!(run.step(START).unwrap().is_none());
    while let Some(step) = run.step(2.7).unwrap() {
        found.extend(times(step.samples()));
    }
    let whole = problem().solve(2.7, RungeKutta::classical(0.1)).unwrap();
    assert_eq!(found, times(whole.samples()));
    assert_eq!(found.len(), 9);
}

/// A run that stops at an event on the grid, and goes on, keeps the sample there once; so do runs from a checkpoint.
#[test]
fn no_sample_is_lost_or_kept_twice_where_a_run_stops() {
    let problem = || {
        Problem::new(Oscillator, start())
            .when(|x| x.t - 1.2)
            .stop()
            .save(Every(0.25))
    };
    let mut run = problem().start(Taylor::new()).unwrap();
    let mut found = times(run.advance(2.0).unwrap().samples());
    assert_eq!(run.state().t.to_bits(), 1.2_f64.to_bits());
    found.extend(times(run.advance(2.0).unwrap().samples()));
    let mut resumed = problem().resume(run.checkpoint(), Taylor::new()).unwrap();
    found.extend(times(resumed.advance(2.5).unwrap().samples()));
    let expected: Vec<f64> = (0..8).map(|k| START + 0.25 * f64::from(k)).collect();
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (t, expected) in found.iter().zip(&expected) {
        assert!((t - expected).abs() < 1e-14, "{found:?}");
    }
}

/// What lies before the start is refused by every part, and a state that is changed is another one than that at the end of a step.
#[test]
fn times_before_the_start_are_refused() {
    let problem = Problem::new(Oscillator, start()).save([0.1, 0.9]);
    let mut run = problem.start(Taylor::new()).unwrap();
    let error = run.advance(1.0).unwrap_err().error();
    let expected = IntegrationError::OutsideSpan {
        time: 0.1,
        start: START,
        end: 1.0,
    };
    assert_eq!(error, expected);
}

#[test]
fn a_changed_state_is_kept_beside_the_end_of_the_step() {
    let problem = Problem::new(Oscillator, start()).save(StepEnds);
    let mut run = problem.start(RungeKutta::classical(0.1)).unwrap();
    let before = times(run.advance(0.9).unwrap().samples());
    run.change(|x, _| x.x[1] = 2.0).unwrap();
    let after = run.advance(1.0).unwrap().samples().to_vec();
    assert_eq!(before.last(), Some(&after[0].t));
    assert!((after[0].x[1] - 2.0).abs() < 1e-15 && after.len() == 2);
}

/// Samples that lie far ahead cost nothing until the motion comes there: 10¹² of them are asked for.
#[test]
fn samples_of_a_far_end_are_not_listed() {
    let problem = || Problem::new(Oscillator, start()).save(Every(1e-3));
    let mut run = problem().start(Taylor::new()).unwrap();
    let mut samples = Vec::new();
    for _ in 0..20 {
        let step = run.step(1e9).unwrap().unwrap();
        samples.extend_from_slice(step.samples());
    }
    let last = run.state().t;
    let expected = problem().solve(last, Taylor::new()).unwrap();
    assert_eq!(samples.len(), expected.samples().len());
    for (found, expected) in samples.iter().zip(expected.samples()) {
        assert_eq!(found.t.to_bits(), expected.t.to_bits());
        assert!((found.x - expected.x).amax() < 1e-13);
    }
    let limited = problem().max_steps(5).solve(1e9, Taylor::new()).unwrap();
    assert_eq!(limited.reason, StopReason::StepLimit);
}
