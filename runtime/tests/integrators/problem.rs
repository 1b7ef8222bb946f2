//! Problems: what is saved is what the motion passes; reactions, runs, mistakes and other scalars.

use core::ops::ControlFlow;

use lagrangian::Lanes;
use lagrangian::nalgebra::SVector;
use lagrangian::prelude::*;

use crate::settings::{LEDGE, STONE, Stone, start};

/// Samples from the start to the end, the last one exactly there where it differs by rounding alone.
#[test]
fn intervals_begin_at_the_start_and_end_at_the_end() {
    for (from, to, interval, count) in [
        (0.0_f64, 1.0_f64, 0.1, 11),
        (0.0, 0.95, 0.1, 10),
        (1.0, 0.0, 0.1, 11),
        (1e3, 1e3 + 0.3, 0.1, 4),
        (0.0, 0.05, 0.1, 1),
        (0.0, 0.0, 0.1, 1),
    ] {
        let start = State::new(from, [5.0], [0.0]);
        let motion = Problem::new(&STONE, start)
            .save(Every(interval))
            .solve(to, Dop853::new());
        let motion = motion.unwrap();
        assert_eq!(motion.t.to_bits(), to.to_bits());
        let times: Vec<f64> = motion.samples().iter().map(|state| state.t).collect();
        assert_eq!(times.len(), count, "{times:?}");
        assert_eq!(times[0].to_bits(), from.to_bits());
        for (k, t) in (0..).zip(&times) {
            let exact = from + (to - from).signum() * interval * f64::from(k);
            assert!(k == 0 || (t - exact).abs() < 1e-12);
        }
        let last = times[count - 1];
        assert!(
            (last - to).abs() >= 0.04 || last.to_bits() == to.to_bits(),
            "{times:?}"
        );
    }
}

#[test]
fn samples_steps_and_the_dense_motion_agree() {
    let top = |t: f64| 5.0 - 5.0 * t * t;
    let steps = Problem::new(&STONE, start())
        .save(StepEnds)
        .solve(1.0, Dop853::new())
        .unwrap();
    assert_eq!(steps.samples().len() as u64, steps.statistics.steps + 1);
    let times: Vec<f64> = steps.samples().iter().map(|state| state.t).collect();
    let dense = Problem::new(&STONE, start())
        .save(Dense)
        .solve(1.0, Dop853::new())
        .unwrap();
    assert_eq!(dense.times().collect::<Vec<_>>(), times);
    let sampled = Problem::new(&STONE, start())
        .save(&times)
        .solve(1.0, Dop853::new())
        .unwrap();
    assert_eq!(sampled.samples(), steps.samples());
    for t in [0.0, 0.123, 0.77, 1.0] {
        assert!((dense.at(t).unwrap().q[0] - top(t)).abs() < 1e-13);
        assert!((dense.derivative(t).unwrap().unwrap().q[0] + 10.0 * t).abs() < 1e-12);
    }
    assert!(matches!(
        dense.at(1.5),
        Err(IntegrationError::OutsideSolution { .. })
    ));
}

/// A jump is behind `at` and before `before`.
#[test]
fn reactions_change_the_state_and_the_model() {
    let bounce = Problem::new(&STONE, start())
        .on(Stone::FLOOR)
        .falling()
        .then(|x| x.v[0] *= -0.5)
        .save(Dense)
        .solve(1.25, Taylor::new())
        .unwrap();
    let floor = bounce.events()[0].t;
    assert!((floor - 1.0).abs() < 1e-15);
    assert!((bounce.before(floor).unwrap().v[0] + 10.0).abs() < 1e-13);
    assert!((bounce.at(floor).unwrap().v[0] - 5.0).abs() < 1e-13);
    // Gravitation ends at the ledge.
    let end = Problem::new(STONE, start())
        .when(|x| x.q[0] - 2.0)
        .falling()
        .then_with(|_, stone| stone.change(|stone| stone.g = 0.0))
        .solve(1.5, Taylor::new())
        .unwrap();
    let expected = 2.0 - 10.0 * LEDGE * (1.5 - LEDGE);
    assert!((end.q[0] - expected).abs() < 1e-12);
    // The third bounce ends it.
    let mut bounces = 0;
    let end = Problem::new(&STONE, start())
        .on(Stone::FLOOR)
        .falling()
        .then(|x| {
            x.v[0] *= -0.5;
            bounces += 1;
            if bounces == 3 {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        })
        .solve(10.0, Taylor::new())
        .unwrap();
    assert_eq!((end.reason, end.events().len()), (StopReason::Condition, 3));
    assert!((end.t - 2.5).abs() < 1e-13);
}

/// What cannot be is an error with what was set.
#[test]
fn mistakes_in_what_is_saved_are_errors() {
    for interval in [0.0, -1.0, f64::NAN, f64::INFINITY, f64::MIN_POSITIVE] {
        let refused = Problem::new(&STONE, start())
            .save(Every(interval))
            .solve(1.0, Dop853::new());
        let error = refused.unwrap_err().error();
        assert!(
            matches!(error, IntegrationError::InvalidSampleInterval { .. }),
            "{error}"
        );
    }
    for times in [[-0.5, 0.5], [0.5, 1.5]] {
        let refused = Problem::new(&STONE, start())
            .save(times)
            .solve(1.0, Dop853::new());
        let error = refused.unwrap_err().error();
        assert!(
            matches!(error, IntegrationError::OutsideSpan { .. }),
            "{error}"
        );
    }
    let refused = Problem::new(&STONE, start())
        .save([0.5, 0.25])
        .solve(1.0, Dop853::new());
    let error = refused.unwrap_err().error();
    assert!(
        matches!(error, IntegrationError::UnorderedTimes { .. }),
        "{error}"
    );
}

#[test]
fn an_end_that_is_no_time_is_an_error() {
    for end in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let problem = Problem::new(&STONE, start());
        let errors = [
            problem
                .clone()
                .solve(end, Dop853::new())
                .unwrap_err()
                .error(),
            (problem.clone().save(Every(0.5)).solve(end, Dop853::new()))
                .unwrap_err()
                .error(),
            (problem.save([0.5]).solve(end, Dop853::new()))
                .unwrap_err()
                .error(),
        ];
        for error in errors {
            assert!(
                matches!(error, IntegrationError::NonFiniteTime { .. }),
                "{error}"
            );
        }
    }
}

/// ẋ = x² reaches infinity at t = 1, but for the error of the integration.
#[test]
fn nothing_is_lost_of_the_motion_before_an_error() {
    let failed = Problem::new(
        Blowup,
        At {
            t: 0.0,
            x: SVector::from([1.0]),
        },
    )
    .save(Every(0.25))
    .solve(2.0, Dop853::new())
    .unwrap_err();
    let known = failed.solution();
    assert_eq!(known.samples().len(), 5, "{failed}");
    assert!((known.samples()[3][0] - 4.0).abs() < 1e-7);
    assert!((known.t - 1.0).abs() < 1e-8 && known.reason == StopReason::Error);
    assert_eq!(format!("{failed:?}"), failed.to_string());
}

#[derive(Debug)]
struct Blowup;

impl Dynamics for Blowup {
    type State = SVector<f64, 1>;

    fn derivative(&self, _: f64, x: &Self::State) -> Self::State {
        SVector::from([x[0] * x[0]])
    }
}

/// Parts of a motion are the motion, to the last bit; a change begins anew.
#[test]
fn a_run_is_advanced_stored_and_changed() {
    let problem = Problem::new(&STONE, start()).on(Stone::LEDGE).record();
    let method = Dop853::new().max_step(0.1);
    let whole = problem.clone().solve(1.0, method).unwrap();
    let mut run = problem.clone().start(method).unwrap();
    let mut steps = 0;
    while let Some(step) = run.step(1.0).unwrap() {
        steps += 1;
        assert!(run.previous_time() < step.t);
        let middle = 0.5 * (run.previous_time() + run.state().t);
        assert!((run.at(middle).unwrap().q[0] - (5.0 - 5.0 * middle * middle)).abs() < 1e-12);
    }
    assert_eq!(steps, whole.statistics.steps);
    assert_eq!(run.state(), whole.last);
    assert!(run.at(0.1).is_err());
    // From a checkpoint within it.
    let mut run = problem.clone().start(method).unwrap();
    while run.state().t < 0.5 {
        run.step(1.0).unwrap();
    }
    let stored = run.checkpoint();
    let mut resumed = problem.resume(stored, method).unwrap();
    let end = resumed.advance(1.0).unwrap();
    assert_eq!((end.last, end.events().len()), (whole.last, 1));
    // Upwards again, under half of the weight.
    let mut run = Problem::new(STONE, start()).start(Taylor::new()).unwrap();
    run.advance(1.0).unwrap();
    run.change(|x, stone| {
        x.v[0] = 5.0;
        stone.change(|stone| stone.g = 5.0);
    })
    .unwrap();
    let end = run.advance(2.0).unwrap();
    assert!((end.q[0] - 2.5).abs() < 1e-13 && end.v[0].abs() < 1e-13);
    assert_eq!(run.dynamics().model().g.to_bits(), 5.0_f64.to_bits());
}

/// An observer sees each sample once, the one at the end too, and none where none are asked for.
#[test]
fn samples_are_observed_once() {
    let mut seen = Vec::new();
    let observed = Problem::new(&STONE, start()).each_step(|progress| {
        if progress.kind == ObservationKind::Sample {
            seen.push(progress.t);
        }
    });
    observed.solve(1.0, Dop853::new()).unwrap();
    assert!(seen.is_empty());
    let observed = Problem::new(&STONE, start()).each_step(|progress| {
        if progress.kind == ObservationKind::Sample {
            seen.push(progress.t);
        }
    });
    let kept = observed.save([0.5, 1.0]).solve(1.0, Dop853::new());
    assert_eq!(kept.unwrap().samples().len(), 2);
    assert_eq!(seen, [0.5, 1.0]);
}

/// A reaction of a run that is advanced by hand.
#[test]
fn a_run_reacts() {
    let mut run = Problem::new(&STONE, start())
        .on(Stone::FLOOR)
        .falling()
        .then(|x| x.v[0] *= -1.0)
        .start(Taylor::new())
        .unwrap();
    let mut bounces = 0;
    for k in 1..=80 {
        bounces += run.advance(0.1 * f64::from(k)).unwrap().events().len();
    }
    assert_eq!(bounces, 4);
    assert!((run.state().q[0] - 5.0).abs() < 1e-11);
}

/// Other scalars: f32, and lanes whose motions go on together.
#[test]
fn events_are_functions_on_the_scalar() {
    let start = State::new(0.0_f32, [5.0], [0.0]);
    let end = Problem::new(&STONE, start)
        .when(|x| x.q[0])
        .falling()
        .stop();
    let end = end
        .solve(2.0, Dop853::new().relative_tolerance(1e-5))
        .unwrap();
    assert!((end.t - 1.0).abs() < 1e-5);
    let heights = Lanes([5.0, 20.0]);
    let start = State::new(Lanes([0.0; 2]), [heights], [Lanes([0.0; 2])]);
    let end = Problem::new(&STONE, start)
        .when(|x| x.q[0].0[0])
        .falling()
        .stop();
    let end = end.solve(2.0, Dop853::new()).unwrap();
    assert!((end.t.0[0] - 1.0).abs() < 1e-9);
    assert!((end.q[0].0[1] - 15.0).abs() < 1e-8);
}

/// A change that fails leaves the state, and what follows has the dynamics that it has left.
#[test]
fn a_change_that_fails_keeps_the_state() {
    let problem = Problem::new(STONE.clone(), start());
    let mut run = problem.start(Dop853::new()).unwrap();
    let before = run.advance(0.5).unwrap().last;
    let change = run.change(|x, stone| {
        x.v[0] = f64::NAN;
        stone.change(|stone| stone.g = 0.0);
    });
    assert!(matches!(
        change,
        Err(IntegrationError::NonFiniteState { .. })
    ));
    assert_eq!(run.state(), before);
    let end = run.advance(1.0).unwrap();
    assert!((end.q[0] - (before.q[0] + 0.5 * before.v[0])).abs() < 1e-14);
}
